//! The touchdown: speed, direction, attitude, slope and friction; and settings of the computation.

use super::ground::Ground;
pub use super::settings::{Settings, Stop};
use super::thrust::Thrust;
use super::vehicle::Vehicle;
use crate::attitude::Attitude;
use crate::friction::FrictionLaw;
pub use crate::rules::CrushRule;

use crate::invalid::Invalid;
use crate::quantities::{
    ANGULAR_VELOCITY_X, ANGULAR_VELOCITY_Y, ANGULAR_VELOCITY_Z, BLOCK_FRICTION, CROSS_SLOPE,
    GRAVITY, HORIZONTAL_VELOCITY, PAD_FRICTION, SLOPE, STATIC_FRICTION_RATIO, VERTICAL_VELOCITY,
};
use crate::soil::Soil;

/// Touchdown conditions as an input gives them; foot, second, radian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// Downward velocity V_V of the CG, ft/s, ≥ 0.
    pub vertical_velocity: f64,
    /// Horizontal speed V_H of the CG, ft/s, ≥ 0.
    pub horizontal_velocity: f64,
    /// Cross-slope λ: direction of V_H, rad; π is straight downhill, 0 uphill.
    pub cross_slope: f64,
    /// Attitude at first contact.
    pub attitude: Attitude,
    /// Angular velocity in vehicle axes, rad/s.
    pub angular_velocity: [f64; 3],
    /// Slope θs of the surface, rad, |θs| < π/2.
    pub slope: f64,
    /// Nominal friction coefficient μ0 under the footpads.
    pub pad_friction: f64,
    /// Nominal friction coefficient μ0 under the body blocks.
    pub block_friction: f64,
    /// Static friction near rest as a multiple of μ0, ≥ 1, if it is not that of the friction profiles of 1966. Verdicts count on
    /// it only if it is given.
    pub static_friction_ratio: Option<f64>,
    /// Material of the ground.
    pub soil: Soil,
    /// The ground under each leg, if it is not the surface.
    pub ground: Ground,
    /// Acceleration of gravity, ft/s², if not that of the vehicle's file.
    pub gravity: Option<f64>,
    /// Thrust of the engine after first contact.
    pub thrust: Thrust,
}

/// Checked touchdown conditions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scene(Conditions);

impl Conditions {
    /// Material of the ground under leg `index`.
    pub fn soil_under(&self, index: usize) -> Soil {
        self.soil
            .strengthened(self.ground.leg(index).bearing_factor)
    }
}

impl Scene {
    /// Checks touchdown conditions.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the sweep file.
    pub fn new(conditions: Conditions) -> Result<Self, Invalid> {
        let given = &conditions;
        VERTICAL_VELOCITY.check("", given.vertical_velocity)?;
        HORIZONTAL_VELOCITY.check("", given.horizontal_velocity)?;
        CROSS_SLOPE.check_radians("", given.cross_slope)?;
        let rates = [ANGULAR_VELOCITY_X, ANGULAR_VELOCITY_Y, ANGULAR_VELOCITY_Z];
        for (quantity, rate) in rates.iter().zip(given.angular_velocity) {
            quantity.check_radians("", rate)?;
        }
        SLOPE.check_radians("", given.slope)?;
        PAD_FRICTION.check("", given.pad_friction)?;
        BLOCK_FRICTION.check("", given.block_friction)?;
        if let Some(ratio) = given.static_friction_ratio {
            STATIC_FRICTION_RATIO.check("", ratio)?;
        }
        given.ground.check_on(given.slope, &given.soil)?;
        if let Some(gravity) = given.gravity {
            GRAVITY.check("", gravity)?;
        }
        Ok(Self(conditions))
    }

    /// The conditions.
    pub fn conditions(&self) -> &Conditions {
        &self.0
    }

    /// Friction of footpads and blocks over their sliding speed.
    pub(crate) fn friction_law(&self, settings: &Settings) -> FrictionLaw {
        FrictionLaw::new(settings.friction_profile(), self.0.static_friction_ratio)
    }

    /// Acceleration of gravity that acts on a vehicle, ft/s².
    pub fn gravity(&self, vehicle: &Vehicle) -> f64 {
        self.0.gravity.unwrap_or(vehicle.gravity())
    }

    /// The same touchdown at another horizontal speed.
    ///
    /// # Errors
    /// When the speed is negative or not finite.
    pub fn with_horizontal_velocity(&self, speed: f64) -> Result<Self, Invalid> {
        Self::new(Conditions {
            horizontal_velocity: speed,
            ..self.0
        })
    }
}
