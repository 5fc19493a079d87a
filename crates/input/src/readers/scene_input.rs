//! Touchdown conditions as named numbers.
//!
//! Sweep files, tables of cases and the command line all fill the same table of named numbers and build a scene from
//! it. An axis of a sweep replaces one of the numbers.

mod attitude;
mod footing;
mod soil;
mod thrust;

use std::fmt;
use std::sync::LazyLock;

use thiserror::Error;
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::method::Method;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantities::{self, CONDITIONS};
use touchdown_dynamics::quantity::{IfMissing, Quantity};
use touchdown_dynamics::rules::ContactRule;
use touchdown_dynamics::scene::{Conditions, Scene, Settings};
use touchdown_dynamics::thrust::MOST_KNOTS;
use touchdown_dynamics::vehicle::{Legs, Vehicle};

use crate::documents::document::dotted;
use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};
use crate::readers::numbers::explanation;
use crate::readers::settings_input::choice_beside_three_struts;

use attitude::{EULER, TIP};
pub(crate) use footing::{FOOTING, FOOTING_KEYS};
pub use soil::soil_names;
pub(crate) use soil::{SOIL, SOIL_KEYS};
pub(crate) use thrust::{THRUST, THRUST_KEYS};

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
pub const HORIZONTAL_VELOCITY: &str = quantities::HORIZONTAL_VELOCITY.key;

const METRES_PER_FOOT: f64 = 0.3048;

/// A condition of a touchdown.
pub(crate) struct Condition {
    /// Its name in results and as an axis, such as `slope_deg` or `footing[1].height_ft`.
    pub(crate) name: String,
    /// Its entry in the catalogue.
    pub(crate) quantity: &'static Quantity,
}

/// Number of conditions that do not belong to a leg, and of all.
const OF_ALL_LEGS: usize = CONDITIONS.len() + quantities::THRUST.len() + quantities::SOIL.len();
const COUNT: usize = OF_ALL_LEGS + MOST_LEGS * quantities::FOOTING.len();

/// All conditions: of the whole vehicle, of the thrust, of the soil, of the ground under leg 1, under leg 2, ...
static ALL: LazyLock<Vec<Condition>> = LazyLock::new(|| {
    let of = |table: String, quantities: &'static [Quantity]| {
        quantities.iter().map(move |quantity| Condition {
            name: dotted(&table, quantity.key),
            quantity,
        })
    };
    let of_legs =
        (1..=MOST_LEGS).flat_map(|leg| of(format!("{FOOTING}[{leg}]"), quantities::FOOTING));
    of(String::new(), CONDITIONS)
        .chain(of(THRUST.to_owned(), quantities::THRUST))
        .chain(of(SOIL.to_owned(), quantities::SOIL))
        .chain(of_legs)
        .collect()
});

/// All conditions of vehicles with `legs` legs.
pub(crate) fn conditions(legs: usize) -> &'static [Condition] {
    &ALL[..OF_ALL_LEGS + legs * quantities::FOOTING.len()]
}

/// Their names.
pub(crate) fn names(legs: usize) -> impl Iterator<Item = &'static str> {
    conditions(legs)
        .iter()
        .map(|condition| condition.name.as_str())
}

/// Keys of a table [scene].
pub(crate) fn scene_keys() -> Vec<&'static str> {
    let keys = CONDITIONS.iter().map(|quantity| quantity.key);
    keys.chain([GRAVITY, SOIL, FOOTING, THRUST]).collect()
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
    let of_soil = || soil::find(scene, name);
    let of_tables = || of_ground().or_else(of_thrust).or_else(of_soil);
    scene.optional(name).or_else(of_tables)
}

/// A missing or invalid condition.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{name}: expected {allowed}")]
pub struct SceneFault {
    /// Name of the condition.
    pub name: &'static str,
    /// Its value; `None` if missing.
    pub value: Option<FaultyValue>,
    /// Allowed values.
    pub allowed: String,
}

/// The value of a condition, or of a choice of the solver, that is not allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FaultyValue {
    /// A number in program units.
    Number(f64),
    /// A word.
    Word(&'static str),
}

impl fmt::Display for FaultyValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Word(word) => write!(f, "\"{word}\""),
        }
    }
}

impl From<f64> for FaultyValue {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
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
        for key in CONDITIONS.iter().map(|quantity| quantity.key) {
            if let Some(value) = scene.optional_number(key)? {
                conditions.set(key, value);
            }
        }
        if let Some(found) = scene.optional(GRAVITY) {
            if conditions.get(quantities::GRAVITY.key).is_some() {
                return Err(found.complain_that("also given as a number: expected one of them"));
            }
            let word = found.text().ok();
            let body = BODIES.iter().find(|(name, _)| Some(*name) == word);
            let Some((_, gravity)) = body else {
                return Err(found.complain(
                    "\"moon\", \"mars\", \"earth\" or \"ceres\", or a number as gravity_fps2 or gravity_mps2",
                ));
            };
            conditions.set(quantities::GRAVITY.key, gravity / METRES_PER_FOOT);
        }
        conditions.read_thrust(scene)?;
        conditions.read_soil(scene)?;
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
        let value = |name| self.get(name).or_else(|| self.default_of(name));
        let of_vehicle = CONDITIONS.iter().map(|quantity| quantity.key);
        let resolved = of_vehicle.filter_map(|name| Some((name, value(name)?)));
        let others = conditions(MOST_LEGS).iter().skip(CONDITIONS.len());
        let given = others.filter_map(|one| Some((one.name.as_str(), self.get(&one.name)?)));
        resolved.chain(given).collect()
    }

    /// Default of a condition of the whole vehicle, if it has one. One form of the attitude is as good as the other; the
    /// form that is not given has no defaults.
    fn default_of(&self, name: &str) -> Option<f64> {
        if name == quantities::BLOCK_FRICTION.key {
            return self.get(quantities::PAD_FRICTION.key);
        }
        let is_of_other_form = match self.is_tipped() {
            true => EULER.contains(&name),
            false => TIP.contains(&name),
        };
        match quantity(name)?.if_missing {
            IfMissing::Number(default) if !is_of_other_form => Some(default),
            _ => None,
        }
    }

    /// Value of a condition, given or default.
    fn need(&self, name: &'static str) -> Result<f64, SceneFault> {
        let value = self.get(name).or_else(|| self.default_of(name));
        let quantity = quantity(name);
        match (value, quantity) {
            (Some(value), Some(quantity)) if !quantity.range.contains(value) => Err(SceneFault {
                name,
                value: Some(value.into()),
                allowed: quantity.range.to_string(),
            }),
            (Some(value), _) => Ok(value),
            (None, _) => Err(SceneFault {
                name,
                value: None,
                allowed: quantity.map_or_else(String::new, explanation),
            }),
        }
    }

    /// Builds the scene of these conditions for a vehicle and settings.
    ///
    /// # Errors
    /// As [`NamedConditions::scene`]; also if there is ground under a leg that the vehicle lacks, if the method does
    /// not support thrust or the edges of footpads, if the contact rule does not support hinge damping, or if the legs
    /// do not support the method or a rule.
    pub fn scene_for(&self, vehicle: &Vehicle, settings: &Settings) -> Result<Scene, SceneFault> {
        if matches!(vehicle.legs(), Legs::ThreeStrut(_))
            && let Some((name, word, allowed)) = choice_beside_three_struts(settings)
        {
            return Err(SceneFault {
                name,
                value: Some(FaultyValue::Word(word)),
                allowed: format!("\"{allowed}\": legs of three struts land by nothing else"),
            });
        }
        let is_located = settings.method() == Method::Located;
        if !self.thrust_knots().is_empty() && !is_located {
            return Err(SceneFault {
                name: thrust::SCALE,
                value: Some(self.get(thrust::SCALE).unwrap_or(1.0).into()),
                allowed: "no thrust: only the method \"located\" knows it".to_owned(),
            });
        }
        let footpads = || {
            vehicle
                .hinged_legs()
                .iter()
                .map(|leg| &leg.design().footpad)
        };
        if settings.rules(vehicle).contact == ContactRule::Pivot
            && let Some(damped) = footpads().find(|footpad| footpad.hinge_damping > 0.0)
        {
            return Err(SceneFault {
                name: "vehicle.footpad.hinge_damping_ftlb_s",
                value: Some(damped.hinge_damping.into()),
                allowed: "no damping: only the contact rule \"face\" knows it".to_owned(),
            });
        }
        let edge = footpads().find_map(|footpad| footpad.edge);
        if let Some(edge) = edge.filter(|_| !is_located) {
            return Err(SceneFault {
                name: "vehicle.footpad.edge_load_lb",
                value: Some(edge.load.into()),
                allowed: "footpads without an edge: only the method \"located\" knows it"
                    .to_owned(),
            });
        }
        let legs = vehicle.leg_count();
        let beyond = names(MOST_LEGS).skip(conditions(legs).len());
        if let Some(name) = beyond.into_iter().find(|name| self.get(name).is_some()) {
            return Err(SceneFault {
                name,
                value: self.get(name).map(Into::into),
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
        let need = |quantity: &Quantity| self.need(quantity.key);
        let angle = |quantity: &Quantity| need(quantity).map(f64::to_radians);
        let conditions = Conditions {
            vertical_velocity: need(&quantities::VERTICAL_VELOCITY)?,
            horizontal_velocity: need(&quantities::HORIZONTAL_VELOCITY)?,
            cross_slope: angle(&quantities::CROSS_SLOPE)?,
            slope: angle(&quantities::SLOPE)?,
            pad_friction: need(&quantities::PAD_FRICTION)?,
            block_friction: need(&quantities::BLOCK_FRICTION)?,
            static_friction_ratio: self.given(&quantities::STATIC_FRICTION_RATIO)?,
            attitude: self.attitude()?,
            angular_velocity: [
                angle(&quantities::ANGULAR_VELOCITY_X)?,
                angle(&quantities::ANGULAR_VELOCITY_Y)?,
                angle(&quantities::ANGULAR_VELOCITY_Z)?,
            ],
            soil: self.soil()?,
            ground: self.ground()?,
            gravity: self.given(&quantities::GRAVITY)?,
            thrust: self.thrust()?,
        };
        Scene::new(conditions).map_err(|invalid| self.fault(invalid))
    }

    /// Value of a condition, if it is given.
    fn given(&self, quantity: &Quantity) -> Result<Option<f64>, SceneFault> {
        let name = quantity.key;
        self.get(name).map(|_| self.need(name)).transpose()
    }

    fn fault(&self, invalid: Invalid) -> SceneFault {
        let [pad, block] = [quantities::PAD_FRICTION.key, quantities::BLOCK_FRICTION.key];
        // Block friction that defaults to friction is reported as friction.
        let name = match names(MOST_LEGS).find(|name| *name == invalid.quantity) {
            Some(name) if name == block && self.get(block).is_none() => pad,
            Some(name) => name,
            None => pad,
        };
        SceneFault {
            name,
            // The value as given: conversion to radians and back may change its last digit.
            value: Some(self.get(name).unwrap_or(invalid.value).into()),
            allowed: invalid.allowed,
        }
    }
}

/// Conditions of every touchdown without default.
pub(crate) fn required() -> impl Iterator<Item = &'static Quantity> {
    CONDITIONS
        .iter()
        .filter(|quantity| quantity.if_missing == IfMissing::Required)
}

/// Entry in the catalogue of the condition with a name.
pub(crate) fn quantity(name: &str) -> Option<&'static Quantity> {
    let found = NamedConditions::position(name)?;
    Some(ALL[found].quantity)
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
        assert_eq!(required().count(), 5);
        for name in required().map(|quantity| quantity.key) {
            let mut named = baseline();
            named.values[NamedConditions::position(name).unwrap()] = None;
            let fault = named.scene().unwrap_err();
            assert_eq!((fault.name, fault.value), (name, None));
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
            assert_eq!((fault.name, fault.value), (name, Some(value.into())));
        }
    }
}
