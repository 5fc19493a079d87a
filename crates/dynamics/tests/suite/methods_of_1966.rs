//! Orders and manners of the integrators of 1966 on motions known in closed form.

use crate::common::scenes::pressed_in;
use crate::common::{level_scene, settings, table_4_1};
use nalgebra::Vector3;
use touchdown_dynamics::contact::Sets;
use touchdown_dynamics::methods::{
    BouncingBall, ErrorCheck, Evaluator, ForceModel, Intervals, Milne, RungeKutta, Start,
    StepDoubling, Stepper, System, Trapezoidal, Vector,
};
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;

/// Steps through `time` seconds at intervals no longer than `longest`.
fn march<S: System>(
    system: &S,
    state: S::State,
    memory: S::Memory,
    stepper: &mut impl Stepper<S>,
    (time, longest): (f64, f64),
) -> (S::State, Vec<f64>) {
    let mut evaluator = Evaluator {
        system,
        memory,
        evaluations: 0,
    };
    let (mut state, mut gone, mut lengths) = (state, 0.0, Vec::new());
    while time - gone > 1e-12 {
        let slope = evaluator.slope(&state);
        let start = Start { state, slope };
        let taken = stepper.advance(&start, longest.min(time - gone), &mut evaluator);
        state = taken.state;
        gone += taken.length;
        lengths.push(taken.length);
    }
    (state, lengths)
}

const BALL: BouncingBall = BouncingBall {
    gravity: 5.31,
    stiffness: 4000.0,
};

/// Limits of the ball's errors, ft and ft/s per second, and intervals, s.
fn control(limit: f64, first: f64, least: f64) -> (ErrorCheck, Intervals) {
    let check = ErrorCheck::new(vec![limit, limit]);
    (check, Intervals { first, least })
}

fn doubling(limit: f64, first: f64, least: f64) -> StepDoubling {
    let (check, intervals) = control(limit, first, least);
    StepDoubling::new(check, intervals)
}

fn milne(limit: f64, first: f64, least: f64) -> Milne<[f64; 2], ()> {
    let (check, intervals) = control(limit, first, least);
    Milne::new(check, intervals)
}

/// Error of a ball deep in contact after 0.02 s, in ft/s, at a number of intervals.
fn in_contact<St: Stepper<BouncingBall>>(count: u32, stepper: impl Fn(f64) -> St) -> f64 {
    let frequency = BALL.stiffness.sqrt();
    let rest = -BALL.gravity / BALL.stiffness;
    let time = 0.02;
    let interval = time / f64::from(count);
    let start = [rest - 0.02, -1.0];
    let (end, lengths) = march(&BALL, start, (), &mut stepper(interval), (time, interval));
    assert_eq!(lengths.len(), count as usize);
    let (sine, cosine) = (frequency * time).sin_cos();
    let exact = 0.02 * frequency * sine - cosine;
    (end[1] - exact).abs()
}

fn order(errors: [f64; 2]) -> f64 {
    (errors[0] / errors[1]).log2()
}

#[test]
fn orders_are_those_of_the_text_books() {
    let runge_kutta = [20, 40].map(|n| in_contact(n, |interval| RungeKutta { interval }));
    let trapezoidal = [20, 40].map(|n| in_contact(n, |interval| Trapezoidal { interval }));
    let doubled = [20, 40].map(|n| in_contact(n, |h| doubling(f64::INFINITY, h, h)));
    // Nothing is small enough to double the interval, and it cannot be cut.
    let milne = [40, 80].map(|n| in_contact(n, |h| milne(1e-12, h, h)));
    println!("{runge_kutta:?} {trapezoidal:?} {doubled:?} {milne:?}");
    assert!((order(runge_kutta) - 4.0).abs() < 0.2);
    assert!((order(trapezoidal) - 2.0).abs() < 0.2);
    // The difference of the two results makes it one order more.
    assert!((order(doubled) - 5.0).abs() < 0.3);
    assert!((order(milne) - 4.0).abs() < 0.4);
}

#[test]
fn held_pad_acceleration_makes_the_report_first_order() {
    let (vehicle, scene) = (table_4_1(), level_scene(170.0, -10.0, 11.0));
    let model = ForceModel::new(&vehicle, &scene, &settings(1e-6));
    let first = touchdown(&vehicle, &scene, model.motion());
    let state = pressed_in(first, [-1.0; 3], Vector3::new(0.4, -0.3, 0.2));
    let time = 5e-5;
    let sets = [Sets::default(); 3].into();
    let end =
        |stepper: &mut dyn FnMut(f64) -> State<f64>, count: u32| stepper(time / f64::from(count));
    let mut runge_kutta = |interval: f64| {
        let stepper = &mut RungeKutta { interval };
        march(&model, state, sets, stepper, (time, interval)).0
    };
    let mut report = |interval: f64| {
        let no_limits = ErrorCheck::new(Vec::new());
        let intervals = Intervals {
            first: interval,
            least: interval,
        };
        let stepper = &mut StepDoubling::new(no_limits, intervals);
        march(&model, state, sets, stepper, (time, interval)).0
    };
    let exact = end(&mut runge_kutta, 1024);
    let error = |state: State<f64>| {
        let angle = |s: &State<f64>, j: usize| s.leg(j).pad_rate;
        (0..3)
            .map(|j| (angle(&state, j) - angle(&exact, j)).abs())
            .fold(0.0, f64::max)
    };
    let fourth = [2, 4].map(|count| error(end(&mut runge_kutta, count)));
    let first = [2, 4].map(|count| error(end(&mut report, count)));
    println!("{fourth:?} {first:?}");
    assert!((order(fourth) - 4.0).abs() < 0.4, "{fourth:?}");
    assert!((order(first) - 1.0).abs() < 0.2, "{first:?}");
}

#[test]
fn free_flight_doubles_the_interval_and_contact_cuts_it() {
    let mut stepper = doubling(1e-3, 0.0005, 1e-6);
    let height = 2.0;
    let (_, lengths) = march(&BALL, [height, 0.0], (), &mut stepper, (0.9, 0.9));
    // Runge-Kutta is exact in free fall.
    for pair in lengths[..7].windows(2) {
        assert!((pair[1] / pair[0] - 2.0).abs() < 1e-6, "{lengths:?}");
    }
    let summary = stepper.into_summary();
    assert!(summary.by_cuts[2..].iter().sum::<u64>() > 0, "{summary:?}");
}

#[test]
fn at_the_least_interval_the_check_is_bypassed() {
    let mut stepper = doubling(1e-9, 0.01, 0.001);
    // Falling through the surface, where the push has a kink.
    let (_, lengths) = march(&BALL, [0.05, -2.0], (), &mut stepper, (0.06, 1.0));
    // An interval is not cut when its half is the least or less.
    let cut = &lengths[..lengths.len() - 1];
    assert!(cut.iter().all(|&length| length > 0.001), "{lengths:?}");
    let summary = stepper.into_summary();
    assert!(summary.bypassed > 0);
}

/// Energy of a ball after ten bounces over that at the start.
fn energy_ratio(stepper: &mut impl Stepper<BouncingBall>) -> f64 {
    let start = [1.0, 0.0];
    let time = 10.0 * BALL.period(1.0);
    let (end, _) = march(&BALL, start, (), stepper, (time, 1.0));
    BALL.energy(&end) / BALL.energy(&start)
}

#[test]
fn the_trapezoidal_method_generates_energy() {
    let gain = energy_ratio(&mut Trapezoidal { interval: 0.0005 });
    assert!(gain > 1.0001, "{gain}");
    let much = energy_ratio(&mut Trapezoidal { interval: 0.002 });
    assert!(much > 1.01, "{much}");
    let report = energy_ratio(&mut doubling(1e-3, 0.0005, 1e-6));
    let milne = energy_ratio(&mut milne(1e-3, 0.0005, 1e-6));
    let runge_kutta = energy_ratio(&mut RungeKutta { interval: 0.002 });
    println!("{gain} {much} {report} {milne} {runge_kutta}");
    for ratio in [report, milne, runge_kutta] {
        assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    }
}

#[test]
fn the_ball_returns_after_its_period() {
    let period = BALL.period(1.0);
    let stepper = &mut doubling(1e-7, 0.001, 1e-8);
    let (end, _) = march(&BALL, [1.0, 0.0], (), stepper, (3.0 * period, 1.0));
    let distance = end.advanced([-1.0], [&[1.0, 0.0]]);
    assert!(
        distance[0].abs() < 1e-6 && distance[1].abs() < 1e-4,
        "{distance:?}"
    );
}
