//! Methods of integration to choose from, with the intervals, and the accuracy of those that check errors (3.3, card 12 to 16).

use crate::invalid::Invalid;
use crate::quantities::{FIRST_INTERVAL, INTERVAL, LEAST_INTERVAL, field};
use crate::quantity::{Field, Range, check};

const POSITIVE: Range = Range::POSITIVE;

/// Method of integrating the equations of motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Method {
    /// Every change of a law is located in time: module `landing`.
    #[default]
    Located,
    /// The report's step doubling.
    Report(ErrorControl),
    /// Runge-Kutta of order 4 at a fixed interval.
    RungeKutta(FixedInterval),
    /// Trapezoidal at a fixed interval.
    Trapezoidal(FixedInterval),
    /// Milne's predictor and corrector.
    Milne(ErrorControl),
}

/// A checked fixed interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FixedInterval(f64);

impl FixedInterval {
    /// Checks an interval, s.
    ///
    /// # Errors
    /// It must lie in [1e-6, 1] s.
    pub fn new(seconds: f64) -> Result<Self, Invalid> {
        INTERVAL.check("", seconds)?;
        Ok(Self(seconds))
    }

    /// The interval, s.
    pub fn seconds(self) -> f64 {
        self.0
    }
}

impl Default for FixedInterval {
    /// That of section 4.1.2.
    fn default() -> Self {
        Self(const { INTERVAL.default_number().unwrap() })
    }
}

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

/// Error limits per second of the methods `"report"` and `"milne"`; the defaults are those of 4.1.4.
pub const ERROR_LIMITS: [Field<ErrorLimits>; 7] = [
    field!(pad_angle: new("pad_angle_deg", POSITIVE, "limit of footpad angles α").by_default("6")),
    field!(link_rate: new("link_rate_dps", POSITIVE, "limit of link rates γ̇").by_default("2")),
    field!(link_angle: new("link_angle_deg", POSITIVE, "limit of link angles γ").by_default("4")),
    field!(velocity: new("velocity_fps", POSITIVE, "limit of velocities of the CG").by_default("1/6")),
    field!(position: new("position_ft", POSITIVE, "limit of positions of the CG").by_default("1/6")),
    field!(angular_velocity: new(
        "angular_velocity_dps", POSITIVE, "limit of angular velocities")
        .by_default("1/6")),
    field!(attitude: new("attitude_deg", POSITIVE, "limit of Euler angles").by_default("2/3")),
];

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
    pub const FIRST_INTERVAL: f64 = FIRST_INTERVAL.default_number().unwrap();
    /// Least interval of the sample run, s; later runs had 1e-5 s.
    pub const LEAST_INTERVAL: f64 = LEAST_INTERVAL.default_number().unwrap();

    /// Checks limits (per second), first interval (s) and least interval (s), which is not cut further.
    ///
    /// # Errors
    /// Names the first number outside its range, in the words of the sweep file.
    pub fn new(
        limits: ErrorLimits,
        first_interval: f64,
        least_interval: f64,
    ) -> Result<Self, Invalid> {
        check("error_per_second", &ERROR_LIMITS, &limits)?;
        LEAST_INTERVAL.check("", least_interval)?;
        FIRST_INTERVAL.check("", first_interval)?;
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
