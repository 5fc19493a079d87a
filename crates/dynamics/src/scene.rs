//! The touchdown: speed, direction, attitude, slope and friction, and how to compute it.

use crate::attitude::Attitude;
use crate::friction::FrictionProfile;
use crate::invalid::{Invalid, non_negative, require};
use crate::methods::Method;

/// Touchdown conditions as an input says them; foot, second, radian.
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
        non_negative("vertical_velocity_fps", conditions.vertical_velocity)?;
        non_negative("horizontal_velocity_fps", conditions.horizontal_velocity)?;
        require(
            "cross_slope_deg",
            conditions.cross_slope.to_degrees(),
            "a finite number",
            |_| true,
        )?;
        for rate in conditions.angular_velocity {
            require(
                "angular_velocity_dps",
                rate.to_degrees(),
                "a finite number",
                |_| true,
            )?;
        }
        require(
            "slope_deg",
            conditions.slope.to_degrees(),
            "-90 < value < 90",
            |v| v.abs() < 90.0,
        )?;
        non_negative("friction", conditions.pad_friction)?;
        non_negative("block_friction", conditions.block_friction)?;
        Ok(Self(conditions))
    }

    /// The conditions.
    pub fn conditions(&self) -> &Conditions {
        &self.0
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

/// When an element may crush further (model chapter 4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CrushRule {
    /// The 1966 program's: only while the pad pivot (block centre) moves into the ground.
    #[default]
    PivotRate,
    /// Plain maximum-penetration hysteresis of the element itself.
    Section,
}

/// How a landing is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    tolerance: f64,
    time_limit: f64,
    crush_rule: CrushRule,
    method: Method,
    friction_profile: FrictionProfile,
}

impl Settings {
    /// Tolerance of a single landing when none is given: trajectories to 1e-6 ft. At 3e-6 two of
    /// the 400 reference landings are off by more than they may be, one by a contact, one by its energy.
    pub const DEFAULT_TOLERANCE: f64 = 1e-6;
    /// Tolerance of a search for the boundary when none is given: the loosest at which every
    /// transition of the level grid lies well within 5e-4 ft/s of the converged one
    /// (`results/work-precision.csv`).
    pub const BOUNDARY_TOLERANCE: f64 = 3e-5;
    /// Time limit t_f of the report's runs, s.
    pub const DEFAULT_TIME_LIMIT: f64 = 40.0;

    /// Checks solver settings: relative tolerance, time limit (s) and crush rule.
    ///
    /// # Errors
    /// The tolerance must lie in [1e-12, 1e-2], the time limit in (0, 10000] s.
    pub fn new(tolerance: f64, time_limit: f64, crush_rule: CrushRule) -> Result<Self, Invalid> {
        require("tolerance", tolerance, "1e-12 ≤ value ≤ 1e-2", |v| {
            (1e-12..=1e-2).contains(&v)
        })?;
        require("time_limit_s", time_limit, "0 < value ≤ 10000", |v| {
            v > 0.0 && v <= 1e4
        })?;
        Ok(Self {
            tolerance,
            time_limit,
            crush_rule,
            method: Method::default(),
            friction_profile: FrictionProfile::default(),
        })
    }

    /// The same settings under another crush rule.
    pub fn with_crush_rule(self, crush_rule: CrushRule) -> Self {
        Self { crush_rule, ..self }
    }

    /// The same settings with another onset of friction.
    pub fn with_friction_profile(self, friction_profile: FrictionProfile) -> Self {
        Self {
            friction_profile,
            ..self
        }
    }

    /// How friction sets in near rest.
    pub fn friction_profile(&self) -> FrictionProfile {
        self.friction_profile
    }

    /// The same settings with another method.
    pub fn with_method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// Method of integration.
    pub fn method(&self) -> Method {
        self.method
    }

    /// Relative error tolerance per step of the method that locates events.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Time at which a landing without an outcome is given up, s.
    pub fn time_limit(&self) -> f64 {
        self.time_limit
    }

    /// Crush rule.
    pub fn crush_rule(&self) -> CrushRule {
        self.crush_rule
    }
}
