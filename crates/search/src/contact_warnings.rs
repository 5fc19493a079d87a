//! Warnings of effects that the model allows but no real material shows.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::Class;

/// Contact warnings of landings whose energy balance closes.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactWarnings {
    /// Greatest energy that crushing elements gave to the motion, ft·lb ([`Energies::given_by_contact`]); zero if at
    /// most a thousandth of the kinetic energy at first contact.
    ///
    /// Any vehicle gains that little, as friction acts against the velocity of a footpad's hinge and not of its face.
    ///
    /// [`Energies::given_by_contact`]: touchdown_dynamics::landing::Energies::given_by_contact
    pub given: f64,
    /// True if a footpad was crushed beyond its hinge in a landing that did not end as bottomed.
    pub is_crushed_through: bool,
    /// True if a cartridge was crushed beyond its crush table, which ends short of the stroke of the strut.
    pub is_beyond_table: bool,
}

impl ContactWarnings {
    /// Warnings of one landing.
    pub fn of(landing: &Landing) -> Self {
        const SHARE: f64 = 1e-3;
        let given = landing.energies.given_by_contact();
        let is_much = given > SHARE * landing.energies.initial_kinetic;
        let is_bottomed = landing.outcome.class() == Class::Bottomed;
        let is_crushed_through = landing.max_pad_crush_share.iter().any(|share| *share > 1.0);
        Self {
            given: if is_much { given } else { 0.0 },
            is_crushed_through: is_crushed_through && !is_bottomed,
            is_beyond_table: (landing.max_stroke_table_share.iter()).any(|share| *share > 1.0),
        }
    }

    /// Combines two warnings.
    pub fn and(self, other: Self) -> Self {
        Self {
            given: self.given.max(other.given),
            is_crushed_through: self.is_crushed_through || other.is_crushed_through,
            is_beyond_table: self.is_beyond_table || other.is_beyond_table,
        }
    }
}
