//! Touchdown conditions as named numbers.
//!
//! Sweep files, tables of cases and the command line all fill the same table of named numbers and
//! build a scene from it; an axis of a sweep replaces one of the numbers.

use touchdown_dynamics::attitude::{Attitude, Euler, Tip};
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::scene::{Conditions, Scene};

use crate::input_error::InputError;
use crate::section::Section;

/// Names of all touchdown conditions, with their units.
pub const NAMES: [&str; 15] = [
    "vertical_velocity_fps",
    "horizontal_velocity_fps",
    "cross_slope_deg",
    "slope_deg",
    "friction",
    "block_friction",
    "pitch_deg",
    "yaw_deg",
    "roll_deg",
    "tip_deg",
    "tip_azimuth_deg",
    "nominal_roll_deg",
    "angular_velocity_x_dps",
    "angular_velocity_y_dps",
    "angular_velocity_z_dps",
];
/// The condition that a boundary search varies.
pub const HORIZONTAL_VELOCITY: &str = "horizontal_velocity_fps";

const EULER: [&str; 3] = ["pitch_deg", "yaw_deg", "roll_deg"];
const TIP: [&str; 3] = ["tip_deg", "tip_azimuth_deg", "nominal_roll_deg"];

/// Greatest angle, a hundred turns, deg: beyond it digits are lost.
const GREATEST_ANGLE: f64 = 36_000.0;

/// A table of named touchdown conditions; velocities in ft/s, angles in deg, rates in deg/s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NamedConditions {
    values: [Option<f64>; NAMES.len()],
}

/// A condition that is missing or not allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneFault {
    /// Name of the condition, as in [`NAMES`].
    pub name: &'static str,
    /// Its value; `None` when it is missing.
    pub value: Option<f64>,
    /// What is allowed.
    pub allowed: String,
}

impl NamedConditions {
    /// Takes conditions from a table [scene].
    pub(crate) fn read(scene: &Section) -> Result<Self, InputError> {
        let mut conditions = Self::default();
        for name in NAMES {
            if let Some(value) = scene.optional_number(name)? {
                conditions.set(name, value);
            }
        }
        Ok(conditions)
    }

    /// Index of a name in [`NAMES`], if it is one.
    pub fn position(name: &str) -> Option<usize> {
        NAMES.iter().position(|known| *known == name)
    }

    /// Gives a condition a value; a name that is not in [`NAMES`] changes nothing.
    pub fn set(&mut self, name: &str, value: f64) {
        if let Some(index) = Self::position(name) {
            self.values[index] = Some(value);
        }
    }

    /// The value of a condition, if it was given one.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.values[Self::position(name)?]
    }

    /// Removes the attitude if `names` give it in its other form.
    pub fn replace_attitude_form(&mut self, names: &[&str]) {
        for (form, other) in [(EULER, TIP), (TIP, EULER)] {
            if form.iter().any(|name| names.contains(name)) {
                for index in other.into_iter().filter_map(Self::position) {
                    self.values[index] = None;
                }
            }
        }
    }

    /// The conditions given, and those that follow from them by default, by name.
    pub fn resolved(&self) -> Vec<(&'static str, f64)> {
        NAMES
            .into_iter()
            .filter_map(|name| Some((name, self.get(name).or_else(|| self.default_of(name))?)))
            .collect()
    }

    /// Whether the attitude is given by tip and azimuth instead of Euler angles.
    fn is_tipped(&self) -> bool {
        TIP.iter().any(|name| self.get(name).is_some())
    }

    fn default_of(&self, name: &str) -> Option<f64> {
        match name {
            "block_friction" => self.get("friction"),
            "pitch_deg" | "yaw_deg" | "roll_deg" if !self.is_tipped() => Some(0.0),
            "nominal_roll_deg" if self.is_tipped() => Some(0.0),
            "angular_velocity_x_dps" | "angular_velocity_y_dps" | "angular_velocity_z_dps" => {
                Some(0.0)
            }
            _ => None,
        }
    }

    /// The value of a condition, given or by default.
    fn need(&self, name: &'static str) -> Result<f64, SceneFault> {
        let fault = |value, allowed: &str| SceneFault {
            name,
            value,
            allowed: allowed.to_owned(),
        };
        match self.get(name).or_else(|| self.default_of(name)) {
            Some(value) if name.ends_with("_deg") && value.abs() > GREATEST_ANGLE => {
                Err(fault(Some(value), "-36000 ≤ value ≤ 36000"))
            }
            Some(value) if value.is_finite() => Ok(value),
            Some(value) => Err(fault(Some(value), "a finite number")),
            None => Err(fault(None, meaning(name))),
        }
    }

    /// The scene that these conditions describe.
    ///
    /// # Errors
    /// Names the first condition that is missing, not allowed, or at odds with another.
    pub fn scene(&self) -> Result<Scene, SceneFault> {
        let conditions = Conditions {
            vertical_velocity: self.need("vertical_velocity_fps")?,
            horizontal_velocity: self.need(HORIZONTAL_VELOCITY)?,
            cross_slope: self.need("cross_slope_deg")?.to_radians(),
            slope: self.need("slope_deg")?.to_radians(),
            pad_friction: self.need("friction")?,
            block_friction: self.need("block_friction")?,
            attitude: self.attitude()?,
            angular_velocity: [
                self.need("angular_velocity_x_dps")?.to_radians(),
                self.need("angular_velocity_y_dps")?.to_radians(),
                self.need("angular_velocity_z_dps")?.to_radians(),
            ],
        };
        Scene::new(conditions).map_err(|invalid| self.fault(invalid))
    }

    fn attitude(&self) -> Result<Attitude, SceneFault> {
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

    fn fault(&self, invalid: Invalid) -> SceneFault {
        // Block friction that follows from friction is wrong where friction is.
        let named = match NAMES.into_iter().find(|name| *name == invalid.quantity) {
            Some("block_friction") if self.get("block_friction").is_none() => Some("friction"),
            named => named,
        };
        let name = named.unwrap_or("angular_velocity_x_dps");
        SceneFault {
            name,
            // As given, which the way to radians and back may have changed in the last digit.
            value: self.get(name).or(Some(invalid.value)),
            allowed: invalid.allowed,
        }
    }
}

/// What a condition that has no default means.
fn meaning(name: &str) -> &'static str {
    match name {
        "vertical_velocity_fps" => "the downward velocity, ft/s, ≥ 0",
        HORIZONTAL_VELOCITY => "the horizontal velocity, ft/s, ≥ 0",
        "cross_slope_deg" => "the direction of travel, deg: 180 is straight downhill, 0 uphill",
        "slope_deg" => "the slope of the surface, deg, -90 < value < 90",
        "friction" => "the friction coefficient under the footpads, ≥ 0",
        "tip_deg" => "the angle between centreline and vertical, deg",
        "tip_azimuth_deg" => "the azimuth of the tip axis, deg",
        _ => "a finite number",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn baseline() -> NamedConditions {
        let mut named = NamedConditions::default();
        named.set("vertical_velocity_fps", 14.0);
        named.set("horizontal_velocity_fps", 11.25);
        named.set("cross_slope_deg", 180.0);
        named.set("slope_deg", 15.0);
        named.set("friction", 0.8);
        named
    }

    #[test]
    fn defaults_are_level_at_rest_and_one_friction() {
        let scene = baseline().scene().unwrap();
        let conditions = scene.conditions();
        assert_eq!(conditions.block_friction, 0.8);
        assert_eq!(conditions.angular_velocity, [0.0; 3]);
        assert_eq!(conditions.attitude.quaternion(), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(conditions.cross_slope, std::f64::consts::PI);
    }

    #[test]
    fn what_has_no_default_is_asked_for() {
        for name in &NAMES[..5] {
            let mut named = baseline();
            named.values[NamedConditions::position(name).unwrap()] = None;
            let fault = named.scene().unwrap_err();
            assert_eq!((fault.name, fault.value), (*name, None));
        }
    }

    #[test]
    fn both_attitude_forms_at_once_are_refused() {
        let mut named = baseline();
        named.set("tip_deg", 9.0);
        assert_eq!(named.scene().unwrap_err().name, "tip_azimuth_deg");
        named.set("tip_azimuth_deg", 90.0);
        assert!(named.scene().is_ok());
        named.set("roll_deg", 0.0);
        let fault = named.scene().unwrap_err();
        assert_eq!(fault.name, "roll_deg");
        assert!(fault.allowed.contains("not both"));
    }

    #[test]
    fn faults_carry_the_value_as_given() {
        for (name, value) in [
            ("slope_deg", 90.0),
            ("friction", -0.1),
            ("tip_deg", -3.0),
            ("cross_slope_deg", 1e300),
            ("roll_deg", -36_001.0),
        ] {
            let mut named = baseline();
            named.set(name, value);
            let fault = named.scene().unwrap_err();
            assert_eq!((fault.name, fault.value), (name, Some(value)));
        }
    }
}
