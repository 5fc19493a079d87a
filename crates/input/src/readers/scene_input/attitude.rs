//! The attitude in either form: pitch, yaw and roll, or tip, azimuth and nominal roll.

use touchdown_dynamics::attitude::{Attitude, Euler, Tip};
use touchdown_dynamics::quantities;

use super::{NamedConditions, SceneFault};

/// Conditions of either form.
pub(super) const EULER: [&str; 3] = [
    quantities::PITCH.key,
    quantities::YAW.key,
    quantities::ROLL.key,
];
pub(super) const TIP: [&str; 3] = [
    quantities::TIP.key,
    quantities::TIP_AZIMUTH.key,
    quantities::NOMINAL_ROLL.key,
];

impl NamedConditions {
    /// Removes the attitude in the form other than that of `names`.
    pub fn replace_attitude_form(&mut self, names: &[&str]) {
        for (form, other) in [(EULER, TIP), (TIP, EULER)] {
            if form.iter().any(|name| names.contains(name)) {
                for index in other.into_iter().filter_map(Self::position) {
                    self.values[index] = None;
                }
            }
        }
    }

    /// True if the attitude is given by tip and azimuth instead of Euler angles.
    pub(super) fn is_tipped(&self) -> bool {
        TIP.iter().any(|name| self.get(name).is_some())
    }

    pub(super) fn attitude(&self) -> Result<Attitude, SceneFault> {
        let angle = |name| self.need(name).map(f64::to_radians);
        if !self.is_tipped() {
            let [pitch, yaw, roll] = EULER.map(angle);
            return Ok(Attitude::from_euler(Euler {
                pitch: pitch?,
                yaw: yaw?,
                roll: roll?,
            }));
        }
        if let Some(name) = EULER.into_iter().find(|name| self.get(name).is_some()) {
            return Err(SceneFault {
                name,
                value: self.get(name).map(Into::into),
                allowed: format!(
                    "either {} or {}, not both",
                    EULER.join(", "),
                    TIP.join(", ")
                ),
            });
        }
        let [tip, azimuth, nominal_roll] = TIP.map(angle);
        Ok(Attitude::from_tip(Tip {
            tip: tip?,
            azimuth: azimuth?,
            nominal_roll: nominal_roll?,
        }))
    }
}
