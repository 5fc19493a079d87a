//! Accuracy and intervals of the error-checking methods (3.3, card 12 to 16).

use crate::invalid::{Invalid, require};

/// Greatest truncation error per second of simulated time; foot, second, radian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorLimits {
    /// Footpad angles α.
    pub pad_angle: f64,
    /// Lower-link rates γ̇.
    pub link_rate: f64,
    /// Lower-link angles γ.
    pub link_angle: f64,
    /// CG velocity.
    pub velocity: f64,
    /// CG position.
    pub position: f64,
    /// Angular velocity ω.
    pub angular_velocity: f64,
    /// Pitch, yaw and roll angles.
    pub attitude: f64,
}

impl Default for ErrorLimits {
    /// The choice of 4.1.4, used for all parametric studies.
    fn default() -> Self {
        Self {
            pad_angle: 6f64.to_radians(),
            link_rate: 2f64.to_radians(),
            link_angle: 4f64.to_radians(),
            velocity: 1.0 / 6.0,
            position: 1.0 / 6.0,
            angular_velocity: (1.0f64 / 6.0).to_radians(),
            attitude: (2.0f64 / 3.0).to_radians(),
        }
    }
}

impl ErrorLimits {
    /// All limits multiplied by `factor`.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            pad_angle: self.pad_angle * factor,
            link_rate: self.link_rate * factor,
            link_angle: self.link_angle * factor,
            velocity: self.velocity * factor,
            position: self.position * factor,
            angular_velocity: self.angular_velocity * factor,
            attitude: self.attitude * factor,
        }
    }
}

/// Checked error limits and intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorControl {
    limits: ErrorLimits,
    intervals: Intervals,
}

impl ErrorControl {
    /// First interval of the report's runs, s.
    pub const FIRST_INTERVAL: f64 = 0.0005;
    /// Least interval of the sample run, s; later runs had 1e-5 s.
    pub const LEAST_INTERVAL: f64 = 1e-6;

    /// Checks limits (per second), first interval (s) and least interval (s), which is not cut further.
    ///
    /// # Errors
    /// Names the first number outside its range, in the words of the sweep file.
    pub fn new(
        limits: ErrorLimits,
        first_interval: f64,
        least_interval: f64,
    ) -> Result<Self, Invalid> {
        let named = [
            (
                "error_per_second.pad_angle_deg",
                limits.pad_angle.to_degrees(),
            ),
            (
                "error_per_second.link_rate_dps",
                limits.link_rate.to_degrees(),
            ),
            (
                "error_per_second.link_angle_deg",
                limits.link_angle.to_degrees(),
            ),
            ("error_per_second.velocity_fps", limits.velocity),
            ("error_per_second.position_ft", limits.position),
            (
                "error_per_second.angular_velocity_dps",
                limits.angular_velocity.to_degrees(),
            ),
            (
                "error_per_second.attitude_deg",
                limits.attitude.to_degrees(),
            ),
        ];
        for (name, limit) in named {
            require(name, limit, "value > 0", |v| v > 0.0)?;
        }
        let shortest = "1e-9 ≤ value ≤ 1";
        require("least_interval_s", least_interval, shortest, |v| {
            (1e-9..=1.0).contains(&v)
        })?;
        require("first_interval_s", first_interval, shortest, |v| {
            (1e-9..=1.0).contains(&v)
        })?;
        Ok(Self {
            limits,
            intervals: Intervals {
                first: first_interval,
                least: least_interval,
            },
        })
    }

    /// Error limits per second.
    pub fn limits(&self) -> ErrorLimits {
        self.limits
    }

    /// First and least interval.
    pub fn intervals(&self) -> Intervals {
        self.intervals
    }
}

/// Intervals of an error-checking method, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Intervals {
    /// The first to try.
    pub first: f64,
    /// An interval whose half is no longer than this is not cut.
    pub least: f64,
}

impl Default for ErrorControl {
    fn default() -> Self {
        Self {
            limits: ErrorLimits::default(),
            intervals: Intervals {
                first: Self::FIRST_INTERVAL,
                least: Self::LEAST_INTERVAL,
            },
        }
    }
}
