//! The unit of the speeds of a table.

use std::fmt;

/// Columns in m/s, one of which is in every table of speeds in SI. Axes may be in m/s in any table.
const METRES: [&str; 2] = ["first_transition_mps", "to_mps"];

/// The unit of speeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SpeedUnit {
    /// ft/s.
    #[default]
    FeetPerSecond,
    /// m/s.
    MetresPerSecond,
}

impl SpeedUnit {
    /// Unit of a table (CSV).
    pub fn of_table(csv: &str) -> Self {
        let heading = csv.lines().next().unwrap_or_default();
        match heading.split(',').any(|name| METRES.contains(&name)) {
            true => Self::MetresPerSecond,
            false => Self::FeetPerSecond,
        }
    }

    /// Suffix of names of speeds in this unit.
    pub fn ending(self) -> &'static str {
        match self {
            Self::FeetPerSecond => "_fps",
            Self::MetresPerSecond => "_mps",
        }
    }
}

impl fmt::Display for SpeedUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::FeetPerSecond => "ft/s",
            Self::MetresPerSecond => "m/s",
        })
    }
}
