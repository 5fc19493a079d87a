//! Landings of which the report prints more than the outcome: Table 4-3, and the free flight of the
//! tipped vehicle at two azimuths.

use std::fmt::Write;

use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::landing::{Instant, Landing};
use touchdown_dynamics::scene::Settings;
use touchdown_dynamics::vehicle::Vehicle;

use super::answer::{signed, speed};
use super::results::Results;
use super::special::runs::scene;
use touchdown::terminal::Failure;

/// Table 4-3 of the report.
const TABLE_4_3: &str = include_str!("../../../dynamics/tests/reference/table-4-3.csv");
/// Horizontal velocity at which the report compares two azimuths, ft/s.
pub const AZIMUTH_SPEED: f64 = 11.0;
/// Time between instants, s: the times of Table 4-3 are multiples of it.
pub(super) const INTERVAL: f64 = 0.005;
/// Conditions of all these landings.
const COMMON: [(&str, f64); 3] = [
    ("vertical_velocity_fps", 14.0),
    ("slope_deg", 15.0),
    ("friction", 1.0),
];

/// A landing with the instants of its history that are compared.
pub struct LandingRun {
    pub landing: Landing,
    pub moments: Vec<Moment>,
}

/// An instant of a landing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Time, s.
    pub time: f64,
    /// Horizontal velocities across and up the slope, ft/s.
    pub velocity: [f64; 2],
    /// Pitch angle, deg, and angular velocity about the vehicle's x axis, deg/s.
    pub pitch: f64,
    pub pitch_rate: f64,
    /// Whether nothing presses on the surface.
    pub is_free: bool,
}

/// A stretch of free flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeFlight {
    pub start: Moment,
    pub end: Moment,
}

impl LandingRun {
    /// The longest stretch in which nothing touches the surface.
    pub fn longest_flight(&self) -> Option<FreeFlight> {
        self.moments
            .chunk_by(|a, b| a.is_free == b.is_free)
            .filter(|run| run[0].is_free)
            .map(|run| FreeFlight {
                start: run[0],
                end: run[run.len() - 1],
            })
            .max_by(|a, b| (a.end.time - a.start.time).total_cmp(&(b.end.time - b.start.time)))
    }

    fn at(&self, time: f64) -> Option<&Moment> {
        self.moments
            .iter()
            .find(|moment| (moment.time - time).abs() < 0.1 * INTERVAL)
    }
}

fn compute(vehicle: &Vehicle, conditions: &[(&str, f64)]) -> Result<LandingRun, Failure> {
    let scene = scene(COMMON.iter().chain(conditions).copied())?;
    let settings = Settings::default();
    let mut moments = Vec::new();
    let mut observe = |instant: &Instant| moments.push(moment(instant));
    let landing = land_observed(vehicle, &scene, &settings, INTERVAL, &mut observe);
    Ok(LandingRun { landing, moments })
}

fn moment(instant: &Instant) -> Moment {
    let touches = |normal: f64| normal != 0.0;
    Moment {
        time: instant.time,
        velocity: [instant.velocity.x, instant.velocity.y],
        pitch: instant.attitude.euler().pitch.to_degrees(),
        pitch_rate: instant.angular_velocity.x.to_degrees(),
        is_free: !instant
            .legs
            .iter()
            .any(|leg| touches(leg.pad_normal) || touches(leg.block_normal)),
    }
}

/// The vehicle tipped by 9 deg, straight downhill at [`AZIMUTH_SPEED`].
pub fn tipped(vehicle: &Vehicle, azimuth: f64) -> Result<LandingRun, Failure> {
    let conditions = [
        ("horizontal_velocity_fps", AZIMUTH_SPEED),
        ("cross_slope_deg", 180.0),
        ("tip_deg", 9.0),
        ("tip_azimuth_deg", azimuth),
    ];
    compute(vehicle, &conditions)
}

/// What Table 4-3 prints: time, s, and velocities across and up the slope, ft/s.
pub(super) fn printed() -> Result<Vec<(f64, [f64; 2])>, Failure> {
    let mut printed = Vec::new();
    for record in csv::Reader::from_reader(TABLE_4_3.as_bytes()).records() {
        let record = record.map_err(Failure::running)?;
        let number = |column: usize| record[column].parse::<f64>().map_err(Failure::running);
        printed.push((number(0)?, [number(1)?, number(2)?]));
    }
    Ok(printed)
}

/// A row of Table 4-3: time, and the printed and computed velocities across and along.
type Row = (f64, [f64; 2], [f64; 2]);

fn rows(run: &LandingRun) -> Result<Vec<Row>, Failure> {
    let mut rows = Vec::new();
    for (time, print) in printed()? {
        let moment = run.at(time).ok_or_else(|| {
            Failure::running(format!("the landing of Table 4-3 ends before {time} s"))
        })?;
        rows.push((time, print, moment.velocity));
    }
    Ok(rows)
}

pub(super) fn table_4_3_landing(vehicle: &Vehicle) -> Result<LandingRun, Failure> {
    let conditions = [
        ("horizontal_velocity_fps", 12.0),
        ("cross_slope_deg", 170.0),
        ("roll_deg", -10.0),
    ];
    compute(vehicle, &conditions)
}

/// The landing of Table 4-3, and its greatest difference from a printed velocity, ft/s.
pub fn against_table_4_3(vehicle: &Vehicle) -> Result<(LandingRun, f64), Failure> {
    let run = table_4_3_landing(vehicle)?;
    let apart = rows(&run)?
        .into_iter()
        .flat_map(|(_, print, ours)| [print[0] - ours[0], print[1] - ours[1]])
        .fold(0.0, |greatest: f64, apart| greatest.max(apart.abs()));
    Ok((run, apart))
}

/// Table 4-3 side by side.
///
/// # Errors
/// When the landing cannot be computed.
pub fn table_4_3(vehicle: &Vehicle) -> Result<String, Failure> {
    let run = table_4_3_landing(vehicle)?;
    let mut text = "\
## Table 4-3 side by side

Cross-slope 170 deg, roll −10 deg, V_H 12 ft/s. Velocities across (Ẋ) and up the slope (Ẏ), ft/s, and
the cross-slope angle that they make, deg.

| time, s | Ẋ 1966 | Ẋ ours | Ẏ 1966 | Ẏ ours | cross-slope ours |
|---:|---:|---:|---:|---:|---:|
"
    .to_owned();
    for (time, print, [x, y]) in rows(&run)? {
        let cross_slope = (-x).atan2(y).to_degrees().rem_euclid(360.0);
        let cross_slope = if cross_slope > 180.0 {
            360.0 - cross_slope
        } else {
            cross_slope
        };
        let row = format!(
            "| {time:.2} | {} | {x:.3} | {} | {y:.3} | {cross_slope:.1} |",
            print[0], print[1]
        );
        let _ = writeln!(text, "{}", row.replace(" -", " \u{2212}"));
    }
    Ok(text)
}

/// The free flight at two azimuths, and at the mirror image of the second.
///
/// # Errors
/// When a result is missing or a landing cannot be computed.
pub fn azimuths(results: &Results, vehicle: &Vehicle) -> Result<String, Failure> {
    let transitions = results.transitions("figure-4-23")?;
    let mut text = "\
## Tip azimuth 90 against 112.5 deg

Tip 9 deg, cross-slope 180 deg, V_H 11 ft/s; the longest stretch in which nothing touches the surface.
The report lays the toppling at 112.5 to the pitch at the end of free flight and that to the pitch rate in
it, whose cause \"is not apparent\". The rate hardly changes in free flight: it is what the impacts before
leave. Between 90 and 112.5 it differs little; between 112.5 and its mirror image −112.5, which products
of inertia alone tell apart, it differs by a third.

| azimuth, deg | 1966 | 1966 pitch at its end | outcome | first transition | free flight, s | pitch from, deg | to, deg | ω_x from, deg/s | to, deg/s |
|---:|---|---:|---|---:|---|---:|---:|---:|---:|
"
    .to_owned();
    let printed = [
        (90.0, "stable", "−34.2"),
        (-90.0, "", ""),
        (112.5, "unstable", "−36.8"),
        (-112.5, "\"the same\"", ""),
    ];
    for (azimuth, outcome, pitch) in printed {
        let run = tipped(vehicle, azimuth)?;
        let Some(FreeFlight { start, end }) = run.longest_flight() else {
            continue;
        };
        let row = format!(
            "| {} | {outcome} | {pitch} | {} | {} | {:.2} to {:.2} | {:.1} | {:.1} | {:.1} | {:.1} |",
            signed(azimuth),
            run.landing.outcome,
            speed(transitions.at(&[azimuth])?),
            start.time,
            end.time,
            start.pitch,
            end.pitch,
            start.pitch_rate,
            end.pitch_rate,
        );
        let _ = writeln!(text, "{}", row.replace(" -", " \u{2212}"));
    }
    Ok(text)
}
