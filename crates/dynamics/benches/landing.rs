//! How long one evaluation of the equations of motion and one landing take.
//!
//!     cargo bench -p touchdown-dynamics --bench landing
//!
//! The landings are those of Table 4-1's vehicle straight downhill: well stable, next to the
//! toppling boundary of 11.40 ft/s, where it rocks longest, and toppling; at the default tolerances of
//! boundary searches and of single landings. What each costs means little without its error, which is
//! printed first, against tolerance 1e-10.

#[path = "../tests/suite/common/mod.rs"]
mod common;

use common::bare::Bare;
use common::scenes::history;
use common::{level_scene, settings, table_4_1};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use pulp::NullaryFnOnce;
use touchdown_dynamics::land::land;
use touchdown_dynamics::lanes::Lanes;
use touchdown_dynamics::motion::{Motion, Pieces};
use touchdown_dynamics::registers::Registers;
#[cfg(target_arch = "x86_64")]
use touchdown_dynamics::registers::{Eight, Four};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;

/// V_H of the landings, ft/s.
const SPEEDS: [f64; 3] = [10.0, 11.38, 12.5];
/// Default tolerances.
const TOLERANCES: [f64; 2] = [Settings::BOUNDARY_TOLERANCE, Settings::DEFAULT_TOLERANCE];

fn scene(speed: f64) -> Scene {
    level_scene(180.0, 0.0, speed)
}

fn print_errors() {
    let vehicle = table_4_1();
    for speed in SPEEDS {
        let run = |tolerance: f64| history(&vehicle, &scene(speed), &settings(tolerance), 0.1);
        let (exact, exact_instants) = run(1e-10);
        for tolerance in TOLERANCES {
            let (landing, instants) = run(tolerance);
            // A second after first contact, or at the last tenth that both reached.
            let k = 10.min(instants.len().min(exact_instants.len()) - 2);
            let position = (instants[k].position - exact_instants[k].position).norm();
            let angle = landing.min_stability_angle - exact.min_stability_angle;
            println!(
                "{speed} ft/s at {tolerance:e}: {} at {:.4} s, {} steps, {} evaluations; position at \
                 {:.1} s off by {position:.1e} ft, least stability angle by {:.1e} deg",
                landing.outcome,
                landing.end_time,
                landing.steps,
                landing.evaluations,
                instants[k].time,
                angle.to_degrees().abs(),
            );
        }
    }
}

fn main() {
    print_errors();
    divan::main();
}

/// One foot pressed in and its strut stroking.
fn pressed_in() -> (Bare, State<f64>) {
    let vehicle = table_4_1();
    let scene = scene(11.0);
    let mut bare = Bare::new(&vehicle, &scene);
    let mut state = touchdown(&vehicle, &scene, &bare.motion);
    let mut body = state.body();
    body.position.z += 0.068;
    state.set_body(&body);
    let mut leg = state.leg(0);
    leg.link_rate = -1.0;
    leg.link_angle -= 0.02;
    state.set_leg(0, &leg);
    bare.settle(&state);
    (bare, state)
}

/// One right-hand side, one foot pressed in and its strut stroking.
#[divan::bench]
fn right_hand_side(bencher: Bencher) {
    let (bare, state) = pressed_in();
    let mut slope = State::zero(3);
    bencher.bench_local(|| {
        bare.derivative(black_box(&state), &mut slope);
        black_box(&slope);
    });
}

/// The same for several landings in the lanes of registers, per landing.
#[cfg(target_arch = "x86_64")]
#[divan::bench(args = [4, 8])]
fn right_hand_side_per_lane(bencher: Bencher, lanes: usize) {
    match lanes {
        4 => time_lanes::<_, 4>(bencher, Four::try_new()),
        8 => time_lanes::<_, 8>(bencher, Eight::try_new()),
        _ => {}
    }
}

#[cfg(target_arch = "x86_64")]
fn time_lanes<R: Registers, const N: usize>(bencher: Bencher, registers: Option<R>) {
    let Some(registers) = registers else {
        println!("this processor has no registers of {N} numbers");
        return;
    };
    let (bare, state) = pressed_in();
    let (motion, pieces) = bare.in_lanes::<N>();
    let mut states = State::zero(3);
    for lane in 0..N {
        states.set_lane(lane, &state);
    }
    let mut slopes = State::zero(3);
    bencher.counter(ItemsCount::new(N)).bench_local(|| {
        registers.dispatch(Derive(&motion, &pieces, black_box(&states), &mut slopes));
        black_box(&slopes);
    });
}

/// Derivatives in all lanes.
#[cfg(target_arch = "x86_64")]
struct Derive<'a, const N: usize>(
    &'a Motion<Lanes<N>>,
    &'a Pieces<Lanes<N>>,
    &'a State<Lanes<N>>,
    &'a mut State<Lanes<N>>,
);

#[cfg(target_arch = "x86_64")]
impl<const N: usize> NullaryFnOnce for Derive<'_, N> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0
            .derivative::<false, false>(Lanes([0.0; N]), self.2, self.1, self.3);
    }
}

/// A landing at the default tolerance of boundary searches.
#[divan::bench(args = SPEEDS)]
fn landing_of_a_search(bencher: Bencher, speed: f64) {
    time_landing(bencher, speed, Settings::BOUNDARY_TOLERANCE);
}

/// A landing at the default tolerance of single landings.
#[divan::bench(args = SPEEDS)]
fn single_landing(bencher: Bencher, speed: f64) {
    time_landing(bencher, speed, Settings::DEFAULT_TOLERANCE);
}

fn time_landing(bencher: Bencher, speed: f64, tolerance: f64) {
    let (vehicle, scene) = (table_4_1(), scene(speed));
    let settings = settings(tolerance);
    bencher.bench_local(|| land(&vehicle, black_box(&scene), &settings));
}
