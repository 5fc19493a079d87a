//! The touchdown: speed, direction, attitude, slope and friction; and settings of the computation.

use super::ground::Ground;
pub use super::settings::Settings;
use super::thrust::Thrust;
use super::vehicle::Vehicle;
use crate::attitude::Attitude;
pub use crate::rules::CrushRule;

use crate::invalid::{Invalid, bounded, positive, require};

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

impl Scene {
    /// Checks touchdown conditions.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the sweep file.
    pub fn new(conditions: Conditions) -> Result<Self, Invalid> {
        let speed = |name, speed| {
            require(name, speed, "0 ≤ value ≤ 10000", |v| {
                (0.0..=1e4).contains(&v)
            })
        };
        speed("vertical_velocity_fps", conditions.vertical_velocity)?;
        speed("horizontal_velocity_fps", conditions.horizontal_velocity)?;
        bounded("cross_slope_deg", conditions.cross_slope.to_degrees())?;
        for rate in conditions.angular_velocity {
            require(
                "angular_velocity_dps",
                rate.to_degrees(),
                "-36000 ≤ value ≤ 36000",
                |v| v.abs() <= 36_000.0 * (1.0 + 1e-12),
            )?;
        }
        require(
            "slope_deg",
            conditions.slope.to_degrees(),
            "-90 < value < 90",
            |v| v.abs() < 90.0,
        )?;
        let friction = |name, coefficient| {
            require(name, coefficient, "0 ≤ value ≤ 1000", |v| {
                (0.0..=1000.0).contains(&v)
            })
        };
        friction("friction", conditions.pad_friction)?;
        friction("block_friction", conditions.block_friction)?;
        conditions.ground.check_on(conditions.slope)?;
        if let Some(gravity) = conditions.gravity {
            positive("gravity_fps2", gravity)?;
        }
        Ok(Self(conditions))
    }

    /// The conditions.
    pub fn conditions(&self) -> &Conditions {
        &self.0
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
