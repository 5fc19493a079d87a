//! 4.1.3: how the report's strategy adjusts its intervals.

use std::fmt::Write;

use touchdown_dynamics::methods::{
    ErrorControl, ErrorLimits, Evaluator, ForceModel, IntegrationSummary, Method, Start,
    StepDoubling, Stepper, Taken, check, land_by,
};
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::state::State;
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_figures::line_chart::{Axis, Curve, Panel, Stroke};

use super::chapter::{Chapter, chart};
use super::runs::{Run, first_intervals, report, sample_run, scene, settings};
use touchdown::terminal::Failure;

/// First intervals tried for one that leads onto the printed branch: one in seven does.
const CANDIDATES: usize = 100;

/// The report's method with its intervals on record.
struct Recorded {
    method: StepDoubling,
    time: f64,
    /// Start and length of each interval, s.
    intervals: Vec<(f64, f64)>,
}

impl Stepper<ForceModel> for Recorded {
    fn advance(
        &mut self,
        start: &Start<State<f64>>,
        longest: f64,
        evaluator: &mut Evaluator<ForceModel>,
    ) -> Taken<State<f64>> {
        let taken = self.method.advance(start, longest, evaluator);
        self.intervals.push((self.time, taken.length));
        self.time += taken.length;
        taken
    }
}

fn land(
    vehicle: &Vehicle,
    scene: &Scene,
    first: f64,
) -> Result<(IntegrationSummary, Vec<(f64, f64)>), Failure> {
    let control = report(ErrorLimits::default(), first)?;
    let mut stepper = Recorded {
        method: StepDoubling::new(check(&control, vehicle.leg_count()), control.intervals()),
        time: 0.0,
        intervals: Vec::new(),
    };
    let settings = settings(Method::Report(control));
    land_by(
        &mut stepper,
        (vehicle, scene),
        &settings,
        f64::INFINITY,
        &mut |_| {},
    );
    Ok((stepper.method.into_summary(), stepper.intervals))
}

/// A first interval that leads onto the branch printed in 1966, s.
fn printed_branch(vehicle: &Vehicle, scene: &Scene) -> Result<f64, Failure> {
    for first in first_intervals(CANDIDATES) {
        let settings = settings(Method::Report(report(ErrorLimits::default(), first)?));
        if Run::of(vehicle, scene, &settings, f64::INFINITY).is_as_printed() {
            return Ok(first);
        }
    }
    Err(Failure::running(
        "no run of the sample leads onto the printed branch",
    ))
}

/// The level vehicle of Section IV straight downhill, and its Table 4-3.
fn level(speed: f64, cross_slope: f64, roll: f64) -> Result<Scene, Failure> {
    scene([
        ("vertical_velocity_fps", 14.0),
        ("horizontal_velocity_fps", speed),
        ("cross_slope_deg", cross_slope),
        ("slope_deg", 15.0),
        ("roll_deg", roll),
        ("friction", 1.0),
    ])
}

/// The chapter: `sample` is the vehicle of the sample run, `level_vehicle` that of Section IV.
pub fn chapter(sample: &Vehicle, level_vehicle: &Vehicle) -> Result<Chapter, Failure> {
    let mut text = "\
## 4.1.3 Interval adjustment

![Intervals of the sample run](study-4-1-3.svg)

Intervals by decade from 0.1 s down, and by the number of cuts they took. Print: what the sample run of
3.4.5 printed, where the scan can be read.

| run | intervals | mean, s | 0.1 | 0.01 | 0.001 | 1e-4 | 1e-5 | 1e-6 | 0 cuts | 1 | 2 | 3 | 4 | more | uncut | critical: link rates | angular velocities | others |
|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|
| print | 537 | 0.00525 | | | 350 | 110 | | | | | 46 | 26 | | | | | | |
"
    .to_owned();
    let mut curves = Vec::new();
    let mut uncut = Vec::new();
    let sample_scene = sample_run(None)?;
    let printed = printed_branch(sample, &sample_scene)?;
    let usual = ErrorControl::FIRST_INTERVAL;
    let (straight, table) = (level(11.25, 180.0, 0.0)?, level(12.0, 170.0, -10.0)?);
    let runs = [
        (
            "sample run on the printed branch",
            sample,
            &sample_scene,
            printed,
        ),
        (
            "sample run, first interval 0.0005 s",
            sample,
            &sample_scene,
            usual,
        ),
        ("baseline, V_H 11.25 ft/s", level_vehicle, &straight, usual),
        ("Table 4-3", level_vehicle, &table, usual),
    ];
    for (name, vehicle, scene, first) in runs {
        let (summary, intervals) = land(vehicle, scene, first)?;
        let count =
            |variables: std::ops::Range<usize>| -> u64 { summary.critical[variables].iter().sum() };
        let (links, body) = (count(6..9), count(18..21));
        let share = summary.by_cuts[0] as f64 / summary.intervals as f64;
        uncut.push(share);
        let decades: String = summary.by_decade[..6]
            .iter()
            .map(|n| format!(" {n} |"))
            .collect();
        let cuts: String = summary.by_cuts[..5]
            .iter()
            .map(|n| format!(" {n} |"))
            .collect();
        let _ = writeln!(
            text,
            "| {name} | {} | {:.5} |{decades}{cuts} {} | {:.0} % | {links} | {body} | {} |",
            summary.intervals,
            summary.mean_interval(),
            summary.by_cuts[5..].iter().sum::<u64>(),
            100.0 * share,
            summary.critical.iter().sum::<u64>() - links - body,
        );
        if curves.len() < 2 {
            curves.push(Curve::new(name, Stroke::Line, intervals));
        }
    }
    let (least, greatest) = uncut.iter().fold((1.0f64, 0.0f64), |(low, high), share| {
        (low.min(*share), high.max(*share))
    });
    let _ = writeln!(
        text,
        "\nOn its branch the distributions are those of the print. Of the steps {:.0} to {:.0} % went uncut, where the report \
         has over half. The rule (2 − u)·h is why: with a fifth-order \
         error the interval it proposes after a smooth one is too long as often as not, so it tries, fails \
         and halves, in turns. The link rates restrict the interval most and the angular velocities much \
         less, as 4.1.4 says.",
        100.0 * least,
        100.0 * greatest
    );
    let picture = chart(
        "4.1.3: intervals of the report's method",
        "every interval at its start",
        Axis::linear("time, s"),
        vec![Panel::new(Axis::logarithmic("interval, s"), curves)],
    );
    Ok(Chapter {
        text,
        pictures: vec![("study-4-1-3", picture)],
    })
}
