//! The ground under each leg: the tables [[scene.footing]], and axes such as `footing[1].height_ft`.

use touchdown_dynamics::ground::{Ground, LegFooting, Patch};
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantities;

use super::{NamedConditions, SceneFault, conditions};
use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};
use crate::readers::numbers::keys_of;

/// The table of the ground under one leg, and its keys.
pub(crate) const FOOTING: &str = "footing";
pub(crate) const FOOTING_KEYS: [&str; 7] = keys_of(quantities::FOOTING);

/// Names of the conditions of the ground under leg `index`, from 0, in the order of [`FOOTING_KEYS`].
fn names_of(index: usize) -> [&'static str; FOOTING_KEYS.len()] {
    let first = conditions(index).len();
    std::array::from_fn(|key| conditions(index + 1)[first + key].name.as_str())
}

/// Finds one of these numbers in a table [scene].
pub(super) fn find<'d>(scene: &Section<'d>, name: &str) -> Option<LocatedValue<'d>> {
    let (leg, key) = (0..MOST_LEGS).find_map(|leg| {
        let key = names_of(leg).iter().position(|known| *known == name)?;
        Some((leg, FOOTING_KEYS[key]))
    })?;
    scene
        .sections(FOOTING, &FOOTING_KEYS)
        .ok()?
        .get(leg)?
        .optional(key)
}

impl NamedConditions {
    pub(super) fn read_footing(&mut self, scene: &Section) -> Result<(), InputError> {
        let footing = scene.sections(FOOTING, &FOOTING_KEYS)?;
        if footing.len() > MOST_LEGS
            && let Some(found) = scene.optional(FOOTING)
        {
            return Err(found.complain_that(&format!(
                "{} tables: expected at most one for each leg",
                footing.len()
            )));
        }
        for (index, leg) in footing.iter().enumerate() {
            for (key, name) in FOOTING_KEYS.iter().zip(names_of(index)) {
                if let Some(value) = leg.optional_number(key)? {
                    self.set(name, value);
                }
            }
        }
        Ok(())
    }

    /// The ground under the legs. The ground under a block defaults to that under its footpad.
    pub(super) fn ground(&self) -> Result<Ground, SceneFault> {
        let mut footing = Vec::with_capacity(MOST_LEGS);
        for names in (0..MOST_LEGS).map(names_of) {
            let given = |name| self.get(name).map(|_| self.need(name)).transpose();
            let patch = |names: &[&'static str], default: Patch| -> Result<Patch, SceneFault> {
                let angle = |name| given(name).map(|angle| angle.map(f64::to_radians));
                Ok(Patch {
                    height: given(names[0])?.unwrap_or(default.height),
                    tilt_along: angle(names[1])?.unwrap_or(default.tilt_along),
                    tilt_across: angle(names[2])?.unwrap_or(default.tilt_across),
                })
            };
            let [of_pad @ .., _, _, _, factor] = &names;
            let pad = patch(of_pad, Patch::default())?;
            let block = patch(&names[of_pad.len()..], pad)?;
            let bearing_factor = given(factor)?.unwrap_or(LegFooting::SURFACE.bearing_factor);
            footing.push(LegFooting {
                pad,
                block,
                bearing_factor,
            });
        }
        Ground::new(&footing).map_err(|invalid| self.fault(invalid))
    }
}
