//! 4.1.1: the free return of a strut, and the report's approximation of it.

use std::fmt::Write;

use touchdown_dynamics::contact::Sets;
use touchdown_dynamics::methods::{Evaluator, ForceModel, RungeKutta, Start, Stepper};
use touchdown_dynamics::per_leg::PerLeg;
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_figures::line_chart::{Axis, Curve, Panel, Stroke};

use super::chapter::{Chapter, chart};
use super::runs::{sample_run, settings};
use touchdown::terminal::Failure;
use touchdown_dynamics::methods::Method;

/// How far the freed leg is pressed in, rad.
const DEPRESSION: f64 = 0.35;
/// Height over the surface that keeps the vehicle off it meanwhile, ft.
const HEIGHT: f64 = 20.0;
/// Interval, s; the link settles into its creep in a few milliseconds.
const INTERVAL: f64 = 1e-5;
/// Depression at which the stop has the link, rad: its stroke is 1e-6 ft.
const AT_STOP: f64 = 3e-6;
/// Longest return looked at, s.
const LONGEST: f64 = 2.0;
/// Depressions over which the approximation is fitted, fractions of the first.
const FITTED: (f64, f64) = (0.02, 0.97);

/// Depression of the link, rad, and rate γ̇, rad/s, against time, s.
struct Point {
    time: f64,
    depression: f64,
    rate: f64,
}

/// The return of leg 1, the vehicle falling freely.
fn freed(vehicle: &Vehicle) -> Result<Vec<Point>, Failure> {
    let scene = sample_run(None)?;
    let model = ForceModel::new(vehicle, &scene, &settings(Method::Located));
    let mut state = touchdown(vehicle, &scene, model.motion());
    let mut body = state.body();
    body.position.z -= HEIGHT;
    body.velocity *= 0.0;
    state.set_body(&body);
    let extended = vehicle.hinged_legs()[0].extended_angle();
    let mut leg = state.leg(0);
    leg.link_angle = extended - DEPRESSION;
    state.set_leg(0, &leg);

    let mut stepper = RungeKutta { interval: INTERVAL };
    let mut evaluator = Evaluator {
        system: &model,
        memory: PerLeg::same(vehicle.leg_count(), Sets::default()),
        evaluations: 0,
    };
    let mut points = Vec::new();
    let mut time = 0.0;
    while time < LONGEST {
        let leg = state.leg(0);
        let depression = extended - leg.link_angle;
        points.push(Point {
            time,
            depression,
            rate: leg.link_rate,
        });
        if depression < AT_STOP {
            break;
        }
        let slope = evaluator.slope(&state);
        let start: Start<State<f64>> = Start { state, slope };
        let taken = stepper.advance(&start, INTERVAL, &mut evaluator);
        state = taken.state;
        time += taken.length;
    }
    Ok(points)
}

/// a and b of γ̇² = a (depression) + b, by least squares.
fn fit(points: &[Point]) -> (f64, f64) {
    let (low, high) = (FITTED.0 * DEPRESSION, FITTED.1 * DEPRESSION);
    let fitted: Vec<(f64, f64)> = points
        .iter()
        .filter(|p| (low..high).contains(&p.depression))
        .map(|p| (p.depression, p.rate * p.rate))
        .collect();
    let count = fitted.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| fitted.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x));
    (slope, y - slope * x)
}

/// The chapter.
pub fn chapter(vehicle: &Vehicle) -> Result<Chapter, Failure> {
    let points = freed(vehicle)?;
    let (a, b) = fit(&points);
    // γ̇ = √(a·depression + b) falls by a/2 every second from its first value.
    let first = (a * DEPRESSION + b).sqrt();
    let end = points.last().map_or(0.0, |p| p.time);
    let rate = |time: f64| (first - 0.5 * a * time).max(0.0);
    let angle = |time: f64| (rate(time).powi(2) - b) / a;
    let extended = vehicle.hinged_legs()[0].extended_angle();
    let shown: Vec<&Point> = points.iter().step_by(200).chain(points.last()).collect();
    let exact = |of: &dyn Fn(&Point) -> f64| shown.iter().map(|p| (p.time, of(p))).collect();
    let returns = ((first - b.max(0.0).sqrt()) / (0.5 * a)).min(end);
    let fitted = |of: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=100)
            .map(|k| f64::from(k) * 0.01 * returns)
            .map(|time| (time, of(time)))
            .collect()
    };
    let worst = points
        .iter()
        .map(|p| (p.depression - angle(p.time)).abs())
        .fold(0.0, f64::max)
        .to_degrees();
    let degrees = |depression: f64| (extended - depression).to_degrees();
    let names = ["equation of the link", "approximation"];
    let picture = chart(
        "4.1.1: free return of a strut",
        "lower link freed at rest, pad off the surface; Figure 4-1 of the report",
        Axis::linear("time, s"),
        vec![
            Panel::new(
                Axis::linear("link angle, deg"),
                vec![
                    Curve::new(names[0], Stroke::Line, exact(&|p| degrees(p.depression))),
                    Curve::new(names[1], Stroke::Dashes, fitted(&|t| degrees(angle(t)))),
                ],
            ),
            Panel::new(
                Axis::linear("link rate, deg/s"),
                vec![
                    Curve::new(names[0], Stroke::Line, exact(&|p| p.rate.to_degrees())),
                    Curve::new(names[1], Stroke::Dashes, fitted(&|t| rate(t).to_degrees())),
                ],
            ),
        ],
    );
    let mut text =
        "## 4.1.1 Free strut return\n\n![Free strut return](study-4-1-1.svg)\n\n".to_owned();
    let _ = writeln!(
        text,
        "Freed {:.1} deg below its stop with its pad in the air, the lower link is back after {end:.3} s: \
         within milliseconds spring and rebound damping balance, and the rate follows the root of what is \
         left of the spring force. The report's approximation, the square of the rate = a·depression + b, \
         fits with a = {a:.2} rad/s² and b = {b:.3} rad²/s² and stays within {worst:.2} deg of the link's \
         equation all the way. Adequate it was, as the report says; it is not needed here, where the stiff \
         balance costs no more than any other motion, and the report itself removed it for generality.",
        DEPRESSION.to_degrees()
    );
    Ok(Chapter {
        text,
        pictures: vec![("study-4-1-1", picture)],
    })
}
