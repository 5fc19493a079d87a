//! The response is what forces do when the motion changes a little.

use crate::common::bare::{Bare, pressed_by, pressed_on};
use crate::common::{off_center, table_4_1};
use nalgebra::{Vector3, Vector4};
use touchdown_dynamics::integrator::rosenbrock::StageEquations;
use touchdown_dynamics::integrator::step::StateVector;
use touchdown_dynamics::motion::Signal;
use touchdown_dynamics::response::Factors;
use touchdown_dynamics::rules::ContactRule;
use touchdown_dynamics::soil::{Bearing, Soil};
use touchdown_dynamics::state::{LegState, State, quaternion_rate};

const STILL: LegState<f64> = LegState {
    link_angle: 0.0,
    link_rate: 0.0,
    pad_turn: 0.0,
    pad_rate: 0.0,
    work: [0.0; 6],
};

fn of_leg(j: usize, leg: LegState<f64>) -> State<f64> {
    let mut state = State::zero(3);
    state.set_leg(j, &leg);
    state
}

/// Changes of one kind: velocities of the body along and about three axes, its displacements, and for each leg the
/// rates of link and pad and their angles.
fn changes(quaternion: &Vector4<f64>) -> Vec<State<f64>> {
    let mut changes = Vec::new();
    for kind in 0..4 {
        for axis in [Vector3::x(), Vector3::y(), Vector3::z()] {
            let mut body = State::<f64>::zero(3).body();
            match kind {
                0 => body.velocity = axis,
                1 => body.rate = axis,
                2 => body.position = axis,
                _ => body.quaternion = quaternion_rate(quaternion, &axis),
            }
            changes.push(State::new(&body, &[STILL; 3]));
        }
    }
    for j in 0..3 {
        let mut of_kind = |change: &dyn Fn(&mut LegState<f64>)| {
            let mut leg = STILL;
            change(&mut leg);
            changes.push(of_leg(j, leg));
        };
        of_kind(&|leg| leg.link_rate = 1.0);
        of_kind(&|leg| leg.pad_rate = 1.0);
        of_kind(&|leg| leg.link_angle = 1.0);
        of_kind(&|leg| leg.pad_turn = 1.0);
    }
    changes
}

fn greatest(s: &State<f64>) -> f64 {
    State::greatest_error([1.0], [s], &State::zero(3), &State::zero(3))[0]
}

/// Change of the slope per change of the state along `u`.
fn answered(bare: &Bare, state: &State<f64>, u: &State<f64>) -> State<f64> {
    let epsilon = 1e-6 / greatest(u);
    let [up, down] = [epsilon, -epsilon].map(|epsilon| {
        let mut slope = State::zero(3);
        bare.derivative(&state.advanced_motion([epsilon], [u]), &mut slope);
        slope
    });
    let mut change = State::zero(3);
    change.set_mean_rate(&down, &up, 2.0 * epsilon);
    change
}

#[test]
fn implicit_stages_solve_the_equations_of_small_motions() {
    let tau = 3e-4;
    // Stuck and sliding at either branch of friction; with blocks pressed in as well.
    let cases = [(0.06, 0.01), (0.06, 0.4), (0.06, 4.0), (0.9, 0.01)];
    let all = cases.map(|case| [(table_4_1(), case), (off_center(table_4_1()), case)]);
    let rules = [ContactRule::Pivot, ContactRule::Face];
    let all = (all.into_iter().flatten()).flat_map(|case| rules.map(|rule| (rule, case.clone())));
    for (rule, (vehicle, (depth, sliding))) in all {
        // No pad is crushed beyond its height where that ends a landing.
        let depth = match rule {
            ContactRule::Pivot => depth,
            ContactRule::Face => f64::min(depth, 0.5),
        };
        let (bare, state) = pressed_by(&vehicle, depth, sliding, rule);
        let response = bare.response(&state);
        let mut factors = Factors::none(3);
        let system = response.over(tau, &mut factors);
        let rotations = 9..12;
        let mut answers = 0;
        for (k, r) in changes(&state.body().quaternion).iter().enumerate() {
            let mut u = State::zero(3);
            system.solve(r, &mut u);
            let answered = answered(&bare, &state, &u);
            let off = State::zero(3).advanced([1.0 / tau, -1.0, -1.0], [&u, &answered, r]);
            let off = greatest(&off);
            let answered = greatest(&answered);
            // As the body turns, levers of all forces turn with it, which is left out: it is not stiff.
            let bound = if rotations.contains(&k) {
                2000.0
            } else {
                5e-3 * answered.max(1.0)
            };
            assert!(
                off < bound,
                "{rule:?}, {depth} ft deep at {sliding} ft/s, change {k}: off {off:e} of {answered:e}"
            );
            answers += u32::from(answered > 0.1);
        }
        // All but displacements along the surface and, where friction does not know of them, speeds of the pads.
        let least = match rule {
            ContactRule::Pivot => 20,
            ContactRule::Face => 23,
        };
        assert!(answers >= least, "{rule:?}: {answers}");
    }
}

/// Soil that is pushed aside damps: stages know of it but for what moves the centre of pressure, and about the hinge where forces
/// act at the pivot.
#[test]
fn implicit_stages_know_the_drag_of_soil() {
    let tau = 3e-4;
    let soil = Bearing::new(800.0, 0.16, 1.0, 0.01).unwrap();
    let soil = Soil::Yielding(soil.with_inertial_drag(3.0).unwrap());
    for (rule, share) in [(ContactRule::Pivot, 0.2), (ContactRule::Face, 0.04)] {
        let (bare, state) = pressed_on(&table_4_1(), [0.3, 0.4, 8.0], rule, soil);
        let response = bare.response(&state);
        let mut factors = Factors::none(3);
        let system = response.over(tau, &mut factors);
        let all = changes(&state.body().quaternion);
        let rotations = 9..12;
        for (k, r) in all
            .iter()
            .enumerate()
            .filter(|(k, _)| !rotations.contains(k))
        {
            let mut u = State::zero(3);
            system.solve(r, &mut u);
            let answered = answered(&bare, &state, &u);
            let off = State::zero(3).advanced([1.0 / tau, -1.0, -1.0], [&u, &answered, r]);
            let (off, answered) = (greatest(&off), greatest(&answered));
            assert!(
                off < share * answered.max(1.0),
                "{rule:?}, change {k}: off {off:e} of {answered:e}"
            );
        }
    }
}

#[test]
fn greatest_decay_is_the_trace_of_what_velocities_do() {
    for rule in [ContactRule::Pivot, ContactRule::Face] {
        let (bare, state) = pressed_by(&table_4_1(), 0.06, 0.01, rule);
        let trace: f64 = changes(&state.body().quaternion)
            .iter()
            .enumerate()
            .map(|(k, speed)| {
                let slope = answered(&bare, &state, speed);
                match k {
                    0..3 => slope.body().velocity[k],
                    3..6 => slope.body().rate[k - 3],
                    12 | 16 | 20 => slope.leg((k - 12) / 4).link_rate,
                    13 | 17 | 21 => slope.leg((k - 13) / 4).pad_rate,
                    _ => 0.0,
                }
            })
            .sum();
        let rate = bare.greatest_decay(&state);
        assert_eq!(rate, bare.response(&state).greatest_decay());
        assert!(rate > 1000.0, "{rate}");
        // Products of inertia are left out, and friction that falls with speed.
        let allowed = match rule {
            ContactRule::Pivot => 0.97..1.03,
            ContactRule::Face => 1.0..1.06,
        };
        assert!(allowed.contains(&(rate / -trace)), "{rate}, not {trace}");
    }
}

#[test]
fn signals_said_to_have_rates_change_at_those_rates() {
    const TIME: f64 = 1e-6;
    let cases = [(0.02, 1.0), (-0.03, 2.0)];
    let all = cases.map(|case| [(table_4_1(), case), (off_center(table_4_1()), case)]);
    let rules = [ContactRule::Pivot, ContactRule::Face];
    let all = (all.into_iter().flatten()).flat_map(|case| rules.map(|rule| (rule, case.clone())));
    for (rule, (vehicle, (depth, sliding))) in all {
        let (bare, state) = pressed_by(&vehicle, depth, sliding, rule);
        let told = bare.signals(&state);
        let mut slope = State::zero(3);
        bare.derivative(&state, &mut slope);
        let [before, after] =
            [-TIME, TIME].map(|time| bare.signals(&state.advanced_motion([time], [&slope])));
        for j in 0..3 {
            for k in 0..Signal::RATED {
                let [signal, rate] = [k, k + Signal::RATED].map(|k| Signal::ALL[k]);
                let change = (after.of(j, signal) - before.of(j, signal)) / (2.0 * TIME);
                let rate = told.of(j, rate);
                assert!(
                    (change - rate).abs() < 1e-7 * (1.0 + rate.abs()),
                    "{signal:?} of leg {j}: {change} instead of {rate}"
                );
            }
        }
        // Something
        assert!(told.of(0, Signal::OuterRate).abs() > 0.1);
    }
}
