//! The attitude in either form: pitch, yaw and roll, or tip, azimuth and nominal roll.

use touchdown_dynamics::attitude::{Attitude, Euler, Tip};

use super::{NamedConditions, SceneFault};

const EULER: [&str; 3] = ["pitch_deg", "yaw_deg", "roll_deg"];
const TIP: [&str; 3] = ["tip_deg", "tip_azimuth_deg", "nominal_roll_deg"];

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
            return Ok(Attitude::from_euler(Euler {
                pitch: angle("pitch_deg")?,
                yaw: angle("yaw_deg")?,
                roll: angle("roll_deg")?,
            }));
        }
        if let Some(name) = EULER.into_iter().find(|name| self.get(name).is_some()) {
            return Err(SceneFault {
                name,
                value: self.get(name),
                allowed: format!(
                    "either {} or {}, not both",
                    EULER.join(", "),
                    TIP.join(", ")
                ),
            });
        }
        let tip = self.need("tip_deg")?;
        if !(0.0..=180.0).contains(&tip) {
            return Err(SceneFault {
                name: "tip_deg",
                value: Some(tip),
                allowed: "0 ≤ value ≤ 180; the azimuth says where to".to_owned(),
            });
        }
        Ok(Attitude::from_tip(Tip {
            tip: tip.to_radians(),
            azimuth: angle("tip_azimuth_deg")?,
            nominal_roll: angle("nominal_roll_deg")?,
        }))
    }
}
