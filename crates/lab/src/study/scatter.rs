//! How far the report's integration scatters the transition velocity: the same landings with first
//! intervals that differ by nothing that matters.

use std::fmt::Write;
use std::num::NonZeroUsize;
use std::sync::Arc;

use touchdown_dynamics::batch::Request;
use touchdown_dynamics::methods::{ErrorLimits, Method};
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_figures::boundary_table::Kind;
use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::threads::run::Workers;

use super::answer::signed;
use super::results::Results;
use super::special::runs::{self, control, first_intervals, settings};
use touchdown::terminal::{Failure, interrupt};

/// Name of the table.
pub const TABLE: &str = "scatter.csv";
const COLUMNS: &str =
    "figure,condition,value_deg,converged_fps,horizontal_velocity_fps,runs,toppled";
/// Speeds around the converged transition: half range and step, ft/s.
const AROUND: f64 = 0.75;
const STEP: f64 = 0.05;
/// Runs at each speed.
const RUNS: usize = 20;
/// Least interval of the report's studies after 4.1.5, s.
const LEAST_INTERVAL: f64 = 1e-5;
/// The tipped vehicle's figures, with the tip, and the azimuth looked at, deg.
const TIPPED: [(&str, f64); 2] = [("figure-4-23", 9.0), ("figure-4-24", 5.0)];
const AZIMUTH: f64 = 112.5;

/// A point of a figure whose transition topples.
struct Point {
    figure: &'static str,
    condition: &'static str,
    value: f64,
    converged: f64,
    scene: Scene,
}

fn scene(conditions: &[(&str, f64)]) -> Result<Scene, Failure> {
    let common = [
        ("vertical_velocity_fps", 14.0),
        ("horizontal_velocity_fps", 0.0),
        ("cross_slope_deg", 180.0),
        ("slope_deg", 15.0),
        ("friction", 1.0),
    ];
    runs::scene(common.iter().chain(conditions).copied())
}

fn points(results: &Results) -> Result<Vec<Point>, Failure> {
    let mut points = Vec::new();
    let figure = "figure-4-09";
    for (place, transition) in results.transitions(figure)?.points() {
        let Some(transition) = transition.filter(|transition| transition.kind == Kind::Unstable)
        else {
            continue;
        };
        points.push(Point {
            figure,
            condition: "roll_deg",
            value: place[0],
            converged: transition.speed,
            scene: scene(&[("roll_deg", place[0])])?,
        });
    }
    for (figure, tip) in TIPPED {
        for azimuth in [-AZIMUTH, AZIMUTH] {
            if let Some(transition) = results.transitions(figure)?.at(&[azimuth])? {
                points.push(Point {
                    figure,
                    condition: "tip_azimuth_deg",
                    value: azimuth,
                    converged: transition.speed,
                    scene: scene(&[("tip_deg", tip), ("tip_azimuth_deg", azimuth)])?,
                });
            }
        }
    }
    Ok(points)
}

/// Computes the table: some ten thousand landings.
///
/// # Errors
/// When a result is missing or the run is interrupted.
pub fn table(
    results: &Results,
    vehicle: &Vehicle,
    threads: Option<NonZeroUsize>,
) -> Result<Vec<u8>, Failure> {
    let points = points(results)?;
    let steps = (AROUND / STEP).round() as i32;
    let mut rows = Vec::new();
    let mut scenes = Vec::new();
    for point in &points {
        for step in -steps..=steps {
            // Whole steps, so that neighbouring points can be compared.
            let speed = ((point.converged / STEP).round() + f64::from(step)) * STEP;
            let speed = (speed * 1e6).round() / 1e6;
            let faster = point.scene.with_horizontal_velocity(speed);
            scenes.push(faster.map_err(Failure::running)?);
            rows.push((point, speed, 0));
        }
    }
    let workers = Workers::start(threads)?;
    let vehicle = Arc::new(vehicle.clone());
    let cancel = interrupt::flag()?;
    for first in first_intervals(RUNS) {
        let control = control(ErrorLimits::default(), first, LEAST_INTERVAL)?;
        let settings = settings(Method::Report(control));
        let request = |key: usize| Request {
            key,
            vehicle: Arc::clone(&vehicle),
            scene: scenes[key],
            settings,
        };
        let landings = workers.cases(scenes.len(), request, &(), &cancel)?;
        for (row, landing) in rows.iter_mut().zip(landings) {
            row.2 += usize::from(landing.outcome.class() == Class::Unstable);
        }
    }
    let mut text = format!("{COLUMNS}\n");
    for (point, speed, toppled) in rows {
        let _ = writeln!(
            text,
            "{},{},{},{},{speed},{RUNS},{toppled}",
            point.figure, point.condition, point.value, point.converged
        );
    }
    Ok(text.into_bytes())
}

/// A speed at a point: converged transition, ft/s, speed, ft/s, and share of runs that topple.
struct Row {
    place: (String, String, f64),
    converged: f64,
    speed: f64,
    share: f64,
}

fn read(results: &Results) -> Result<Vec<Row>, InputError> {
    let file = results.folder().join(TABLE);
    let refuse = |complaint: String| InputError::in_file(&file, complaint);
    let text = std::fs::read_to_string(&file).map_err(|error| {
        refuse(format!(
            "cannot be read: {error}; expected what `touchdown-lab study scatter` writes"
        ))
    })?;
    let mut rows = Vec::new();
    for record in csv::Reader::from_reader(text.as_bytes()).records() {
        let record = record.map_err(|error| refuse(error.to_string()))?;
        let cell = |column: usize| {
            record
                .get(column)
                .ok_or_else(|| refuse(format!("columns are {COLUMNS}")))
        };
        let number = |column: usize| -> Result<f64, InputError> {
            let text = cell(column)?;
            let number = text.parse::<f64>();
            number.map_err(|_| refuse(format!("{text} is no number")))
        };
        rows.push(Row {
            place: (cell(0)?.to_owned(), cell(1)?.to_owned(), number(2)?),
            converged: number(3)?,
            speed: number(4)?,
            share: number(6)? / number(5)?,
        });
    }
    Ok(rows)
}

/// The section of `phase-2.md`.
///
/// # Errors
/// When the table cannot be read.
pub fn section(results: &Results) -> Result<String, InputError> {
    let rows = read(results)?;
    let mut text = format!(
        "\
## How far the report's own integration scatters

The report's integrator, `--method report`, on otherwise identical landings: {RUNS} runs at each speed, the
first interval varied between 0.0003 and 0.0009 s, every {STEP} ft/s within {AROUND} ft/s of the converged
transition (`touchdown-lab study scatter`, {TABLE}). Where the scatter is wider than that the ends are marked ≤ or ≥.

| figure | point | converged V_H | some run topples from | half of the runs topple from | all topple from | scatter |
|---|---:|---:|---:|---:|---:|---:|
"
    );
    let mut widest = (0.0, String::new());
    let mut early = 0;
    let mut count = 0;
    for group in rows.chunk_by(|a, b| a.place == b.place) {
        let (figure, _, value) = &group[0].place;
        let converged = group[0].converged;
        let first = group.iter().position(|row| row.share > 0.0);
        let half = group.iter().find(|row| row.share >= 0.5);
        let last_stable = group.iter().rposition(|row| row.share < 1.0);
        let from = match first {
            Some(0) => format!("≤ {:.2}", group[0].speed),
            Some(index) => format!("{:.2}", group[index].speed),
            None => "never".to_owned(),
        };
        let all = last_stable.map_or(Some(0), |index| {
            (index + 1 < group.len()).then_some(index + 1)
        });
        let all_from = match all {
            Some(index) => format!("{:.2}", group[index].speed),
            None => format!("≥ {:.2}", group[group.len() - 1].speed + STEP),
        };
        let end = all.map_or(group[group.len() - 1].speed, |index| group[index].speed);
        let start = first.map_or(end, |index| group[index].speed);
        let width = end - start;
        if width > widest.0 {
            widest = (width, format!("{figure} at {}", signed(*value)));
        }
        count += 1;
        early += usize::from(start < converged - STEP);
        let _ = writeln!(
            text,
            "| {figure} | {} | {converged:.2} | {from} | {} | {all_from} | {width:.2} |",
            signed(*value),
            half.map_or("never".to_owned(), |row| format!("{:.2}", row.speed)),
        );
    }
    let baseline: Vec<&Row> = rows
        .iter()
        .filter(|row| row.place.0 == "figure-4-09" && row.place.2 == 0.0)
        .filter(|row| (11.2..11.36).contains(&row.speed))
        .collect();
    let shares: Vec<String> = baseline
        .iter()
        .map(|row| format!("{:.0} % at {:.2}", 100.0 * row.share, row.speed))
        .collect();
    let printed = rows
        .iter()
        .find(|row| row.place.0 == TIPPED[0].0 && row.place.2 == AZIMUTH && row.speed == 11.0);
    let tipped = printed.map_or(String::new(), |row| {
        format!(
            " With the vehicle tipped 9 deg at azimuth {AZIMUTH}, {:.0} % of the runs topple at 11 ft/s, where \
             the report found it unstable and the converged landing is stable.",
            100.0 * row.share
        )
    });
    let _ = writeln!(
        text,
        "\nAt {early} of {count} points some run topples more than {STEP} ft/s below the converged transition; \
         the scatter is widest, {:.2} ft/s, for {}. At the baseline, below the converged transition, runs \
         topple: {} ft/s. The report's half-foot grid of single runs could not tell this scatter from a \
         boundary.{tipped}",
        widest.0,
        widest.1,
        shares.join(", ")
    );
    Ok(text)
}
