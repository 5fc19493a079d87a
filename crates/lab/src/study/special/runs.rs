//! The landing that the special studies look at, by any method.

use touchdown_dynamics::land::land_with_summary;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::methods::{ErrorControl, ErrorLimits, IntegrationSummary, Method};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::readers::scene_input::NamedConditions;

use touchdown::terminal::Failure;

/// The sample run of 3.4.5.
const SAMPLE_RUN: [(&str, f64); 6] = [
    ("vertical_velocity_fps", 14.24567),
    ("horizontal_velocity_fps", 9.27685),
    ("cross_slope_deg", 180.0),
    ("slope_deg", 15.0),
    ("pitch_deg", 5.0),
    ("friction", 0.8),
];
/// First intervals that differ by nothing that matters lie between these, s.
const FIRST_INTERVALS: (f64, f64) = (0.0003, 0.0009);

/// The scene of these conditions; of one that is given twice the last value holds.
pub fn scene<'n>(given: impl IntoIterator<Item = (&'n str, f64)>) -> Result<Scene, Failure> {
    (NamedConditions::of(given).scene()).map_err(Failure::running)
}

/// The sample run at a friction coefficient, or that of the report.
pub fn sample_run(friction: Option<f64>) -> Result<Scene, Failure> {
    let friction = friction.map(|friction| ("friction", friction));
    scene(SAMPLE_RUN.into_iter().chain(friction))
}

/// Settings with a method.
pub fn settings(method: Method) -> Settings {
    Settings::default().with_method(method)
}

/// Settings with a method, at a tolerance of the one that locates events.
pub fn settings_at(tolerance: f64, method: Method) -> Result<Settings, Failure> {
    let settings = Settings::default().with_tolerance(tolerance);
    Ok(settings.map_err(Failure::running)?.with_method(method))
}

/// The report's method.
pub fn report(limits: ErrorLimits, first_interval: f64) -> Result<ErrorControl, Failure> {
    control(limits, first_interval, ErrorControl::LEAST_INTERVAL)
}

/// Error limits and intervals.
pub fn control(limits: ErrorLimits, first: f64, least: f64) -> Result<ErrorControl, Failure> {
    ErrorControl::new(limits, first, least).map_err(Failure::running)
}

/// `count` first intervals, s.
pub fn first_intervals(count: usize) -> impl Iterator<Item = f64> {
    let (from, to) = FIRST_INTERVALS;
    (0..count).map(move |k| from + (to - from) * (k as f64 + 0.5) / count as f64)
}

/// A landing with its history.
pub struct Run {
    pub landing: Landing,
    pub integration: IntegrationSummary,
    pub moments: Vec<Instant>,
}

impl Run {
    /// The landing, looked at every `interval` seconds.
    pub fn of(vehicle: &Vehicle, scene: &Scene, settings: &Settings, interval: f64) -> Self {
        let mut moments = Vec::new();
        let mut observe = |instant: &Instant| moments.push(instant.clone());
        let (landing, integration) =
            land_with_summary(vehicle, scene, settings, interval, &mut observe);
        Self {
            landing,
            integration,
            moments,
        }
    }

    /// Pitch against time, deg and s.
    pub fn pitch(&self) -> Vec<(f64, f64)> {
        let pitch = |moment: &Instant| moment.attitude.euler().pitch.to_degrees();
        self.moments.iter().map(|m| (m.time, pitch(m))).collect()
    }

    /// Evaluations per second of landing: what stands for computer time over problem time.
    pub fn cost(&self) -> f64 {
        self.landing.evaluations as f64 / self.landing.end_time
    }

    /// Whether this is the branch printed in 1966, below σ 16 deg.
    pub fn is_as_printed(&self) -> bool {
        self.landing.min_stability_angle.to_degrees() < BETWEEN_BRANCHES
    }
}

/// Least stability angle of the sample run between those of its two branches, deg.
const BETWEEN_BRANCHES: f64 = 16.0;

/// The middle of some numbers.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
