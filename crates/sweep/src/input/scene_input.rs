//! Touchdown conditions as named numbers.
//!
//! Sweep files, tables of cases and the command line all fill the same table of named numbers and build a scene from
//! it. An axis of a sweep replaces one of the numbers.

mod attitude;
mod footing;
mod thrust;

use thiserror::Error;
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::method::Method;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::rules::ContactRule;
use touchdown_dynamics::scene::{Conditions, Scene, Settings};
use touchdown_dynamics::thrust::MOST_KNOTS;
use touchdown_dynamics::vehicle::Vehicle;

use crate::input_error::InputError;
use crate::section::{LocatedValue, Section};

use footing::FOOTING_NAMES;
pub(crate) use footing::{FOOTING, FOOTING_KEYS};
use thrust::THRUST_NAMES;
pub(crate) use thrust::{THRUST, THRUST_KEYS};

/// Names of the touchdown conditions of the whole vehicle, with units. Those of the ground under each leg are
/// `footing[1].height_ft` etc.
pub const NAMES: [&str; 16] = [
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
    "gravity_fps2",
];
/// Alternative to the acceleration of gravity: the body on which the vehicle lands.
const GRAVITY: &str = "gravity";
/// Bodies, each with its acceleration of gravity, m/s²: standard gravity, and surface gravities from NASA's planetary
/// fact sheets and the Dawn mission.
pub(crate) const BODIES: [(&str, f64); 4] = [
    ("moon", 1.62),
    ("mars", 3.71),
    ("earth", 9.80665),
    ("ceres", 0.284),
];
/// The condition varied by a boundary search.
pub const HORIZONTAL_VELOCITY: &str = "horizontal_velocity_fps";

const METRES_PER_FOOT: f64 = 0.3048;

/// Greatest angle, a hundred turns, deg: precision is lost beyond it.
const GREATEST_ANGLE: f64 = 36_000.0;

/// Number of all conditions.
const COUNT: usize = NAMES.len() + THRUST_NAMES.len() + MOST_LEGS * FOOTING_KEYS.len();

/// Names of all conditions of vehicles with `legs` legs.
pub(crate) fn names(legs: usize) -> impl Iterator<Item = &'static str> {
    let of_legs = FOOTING_NAMES.iter().take(legs).flatten();
    NAMES.iter().chain(&THRUST_NAMES).chain(of_legs).copied()
}

/// Keys of a table [scene].
pub(crate) fn scene_keys() -> Vec<&'static str> {
    [&NAMES[..], &[GRAVITY, FOOTING, THRUST]].concat()
}

/// A table of named touchdown conditions; velocities in ft/s, lengths in ft, angles in deg, rates in deg/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamedConditions {
    values: [Option<f64>; COUNT],
    /// Knots of the thrust, s and lb, and their number.
    thrust: ([[f64; 2]; MOST_KNOTS], usize),
}

impl Default for NamedConditions {
    fn default() -> Self {
        Self {
            values: [None; COUNT],
            thrust: ([[0.0; 2]; MOST_KNOTS], 0),
        }
    }
}

/// Finds a condition in a table [scene].
pub(crate) fn find<'d>(scene: &Section<'d>, name: &str) -> Option<LocatedValue<'d>> {
    let of_ground = || footing::find(scene, name);
    let of_thrust = || thrust::find(scene, name);
    scene.optional(name).or_else(of_ground).or_else(of_thrust)
}

/// A missing or invalid condition.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{name}: expected {allowed}")]
pub struct SceneFault {
    /// Name of the condition.
    pub name: &'static str,
    /// Its value; `None` if missing.
    pub value: Option<f64>,
    /// Allowed values.
    pub allowed: String,
}

impl SceneFault {
    /// Error about the condition under this name.
    pub fn error(&self) -> InputError {
        match self.value {
            Some(value) => InputError::value(self.name, value, &self.allowed),
            None => InputError::missing(self.name, &self.allowed),
        }
    }
}

impl NamedConditions {
    /// A table of conditions by name.
    pub fn of<'n>(given: impl IntoIterator<Item = (&'n str, f64)>) -> Self {
        let mut conditions = Self::default();
        for (name, value) in given {
            conditions.set(name, value);
        }
        conditions
    }

    /// Reads conditions from a table [scene].
    pub(crate) fn read(scene: &Section) -> Result<Self, InputError> {
        let mut conditions = Self::default();
        for name in NAMES {
            if let Some(value) = scene.optional_number(name)? {
                conditions.set(name, value);
            }
        }
        if let Some(found) = scene.optional(GRAVITY) {
            if conditions.get("gravity_fps2").is_some() {
                return Err(found.complain_that("also given as a number: expected one of them"));
            }
            let word = found.text().ok();
            let body = BODIES.iter().find(|(name, _)| Some(*name) == word);
            let Some((_, gravity)) = body else {
                return Err(found.complain(
                    "\"moon\", \"mars\", \"earth\" or \"ceres\", or a number as gravity_fps2 or gravity_mps2",
                ));
            };
            conditions.set("gravity_fps2", gravity / METRES_PER_FOOT);
        }
        conditions.read_thrust(scene)?;
        conditions.read_footing(scene)?;
        Ok(conditions)
    }

    /// Index of the condition with a name, if any.
    pub fn position(name: &str) -> Option<usize> {
        names(MOST_LEGS).position(|known| known == name)
    }

    /// Sets a condition; ignores unknown names.
    pub fn set(&mut self, name: &str, value: f64) {
        if let Some(index) = Self::position(name) {
            self.values[index] = Some(value);
        }
    }

    /// Value of a condition, if given.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.values[Self::position(name)?]
    }

    /// The given conditions and those that default from them, by name.
    pub fn resolved(&self) -> Vec<(&'static str, f64)> {
        names(MOST_LEGS)
            .filter_map(|name| Some((name, self.get(name).or_else(|| self.default_of(name))?)))
            .collect()
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

    /// Value of a condition, given or default.
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

    /// Builds the scene of these conditions for a vehicle and settings.
    ///
    /// # Errors
    /// As [`NamedConditions::scene`]; also if there is ground under a leg that the vehicle lacks, if the method does
    /// not support thrust or the edges of footpads, or if the contact rule does not support hinge damping.
    pub fn scene_for(&self, vehicle: &Vehicle, settings: &Settings) -> Result<Scene, SceneFault> {
        let is_located = settings.method() == Method::Located;
        if !self.thrust_knots().is_empty() && !is_located {
            return Err(SceneFault {
                name: THRUST_NAMES[0],
                value: self.get(THRUST_NAMES[0]).or(Some(1.0)),
                allowed: "no thrust: only the method \"located\" knows it".to_owned(),
            });
        }
        let footpads = || vehicle.legs().iter().map(|leg| &leg.design().footpad);
        if settings.rules(vehicle).contact == ContactRule::Pivot
            && let Some(damped) = footpads().find(|footpad| footpad.hinge_damping > 0.0)
        {
            return Err(SceneFault {
                name: "vehicle.footpad.hinge_damping_ftlb_s",
                value: Some(damped.hinge_damping),
                allowed: "no damping: only the contact rule \"face\" knows it".to_owned(),
            });
        }
        let edge = footpads().find_map(|footpad| footpad.edge);
        if let Some(edge) = edge.filter(|_| !is_located) {
            return Err(SceneFault {
                name: "vehicle.footpad.edge_load_lb",
                value: Some(edge.load),
                allowed: "footpads without an edge: only the method \"located\" knows it"
                    .to_owned(),
            });
        }
        let legs = vehicle.legs().len();
        let beyond = FOOTING_NAMES.iter().skip(legs).flatten();
        if let Some(name) = beyond.copied().find(|name| self.get(name).is_some()) {
            return Err(SceneFault {
                name,
                value: self.get(name),
                allowed: format!("the number of a leg: the vehicle has {legs}"),
            });
        }
        self.scene()
    }

    /// Builds the scene of these conditions.
    ///
    /// # Errors
    /// Names the first condition that is missing, not allowed, or in conflict with another.
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
            ground: self.ground()?,
            gravity: self.gravity()?,
            thrust: self.thrust()?,
        };
        Scene::new(conditions).map_err(|invalid| self.fault(invalid))
    }

    fn gravity(&self) -> Result<Option<f64>, SceneFault> {
        let name = "gravity_fps2";
        self.get(name).map(|_| self.need(name)).transpose()
    }

    fn fault(&self, invalid: Invalid) -> SceneFault {
        // Block friction that defaults to friction is reported as friction.
        let named = match names(MOST_LEGS).find(|name| *name == invalid.quantity) {
            Some("block_friction") if self.get("block_friction").is_none() => Some("friction"),
            named => named,
        };
        let name = named.unwrap_or("angular_velocity_x_dps");
        SceneFault {
            name,
            // The value as given: conversion to radians and back may change its last digit.
            value: self.get(name).or(Some(invalid.value)),
            allowed: invalid.allowed,
        }
    }
}

/// Conditions of every touchdown without default.
pub(crate) const REQUIRED: [&str; 5] = [
    "vertical_velocity_fps",
    HORIZONTAL_VELOCITY,
    "cross_slope_deg",
    "slope_deg",
    "friction",
];

/// Meaning of a condition without default.
pub(crate) fn meaning(name: &str) -> &'static str {
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
        NamedConditions::of([
            ("vertical_velocity_fps", 14.0),
            ("horizontal_velocity_fps", 11.25),
            ("cross_slope_deg", 180.0),
            ("slope_deg", 15.0),
            ("friction", 0.8),
        ])
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
