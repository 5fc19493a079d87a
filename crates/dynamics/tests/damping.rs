//! The damping matrix is what friction and struts do to the velocities.

mod common;

use common::bare::Bare;
use common::scenes::pressed_in;
use common::{level_scene, table_4_1};
use nalgebra::{Vector3, Vector6};
use touchdown_dynamics::damping::Velocities;
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;

/// All feet pressed in and stuck, struts stroking.
fn stuck() -> (Bare<3>, State<f64, 3>) {
    let vehicle = table_4_1();
    let scene = level_scene(170.0, -10.0, 11.0);
    let mut bare = Bare::new(&vehicle, &scene);
    let first = touchdown(&vehicle, &scene, &bare.motion);
    let mut state = pressed_in(first, [-1e-3, -2e-3, -4e-3], Vector3::zeros());
    let mut body = state.body();
    body.velocity = Vector3::new(0.01, 0.0, 0.0);
    state.set_body(&body);
    bare.settle(&state);
    (bare, state)
}

fn accelerations(bare: &Bare<3>, state: &State<f64, 3>) -> Velocities<f64, 3> {
    let mut slope = State::zero();
    bare.derivative(state, &mut slope);
    Velocities::of(&slope)
}

/// `one` along velocity `k`, `other` along the others.
fn along(k: usize, one: f64, other: f64) -> Velocities<f64, 3> {
    let mut v = Velocities {
        body: Vector6::repeat(other),
        links: [other; 3],
    };
    match k {
        0..6 => v.body[k] = one,
        _ => v.links[k - 6] = one,
    }
    v
}

fn greatest(v: &Velocities<f64, 3>) -> f64 {
    let all = v.body.iter().chain(&v.links);
    all.fold(0.0, |worst: f64, x| worst.max(x.abs()))
}

#[test]
fn accelerations_change_with_velocities_as_the_matrix_says() {
    let (bare, state) = stuck();
    let before = accelerations(&bare, &state);
    let tau = 1e-3;
    let damped = bare.damping(&state).factor(&bare.motion.inertia(), tau);
    for k in 0..9 {
        let r = along(k, 1.0, 0.1);
        // (M + τK) u = M r, so that M⁻¹K u = (r − u)/τ.
        let u = damped.solve(&r);
        let expected = r.plus(-1.0, &u);
        assert!(greatest(&expected) > 0.05, "nothing is damped");
        let epsilon = 1e-7;
        let mut pushed = state;
        Velocities::zero().plus(epsilon, &u).add_to(&mut pushed);
        let change = accelerations(&bare, &pushed).plus(-1.0, &before);
        let seen = Velocities::zero().plus(-tau / epsilon, &change);
        let off = greatest(&seen.plus(-1.0, &expected));
        assert!(
            off < 1e-3 * greatest(&expected),
            "{off:e} of {seen:?}, not {expected:?}"
        );
    }
}

#[test]
fn no_decay_is_faster_than_the_greatest_rate() {
    let (bare, state) = stuck();
    let (damping, inertia) = (bare.damping(&state), bare.motion.inertia());
    let rate = damping.greatest_rate(&inertia);
    assert!(rate > 1000.0, "{rate}");
    // A small implicit step takes away at most rate · τ of a velocity that is alone.
    let tau = 1e-3 / rate;
    let damped = damping.factor(&inertia, tau);
    for k in 0..9 {
        let r = along(k, 1.0, 0.0);
        let u = damped.solve(&r);
        let left = if k < 6 { u.body[k] } else { u.links[k - 6] };
        assert!((0.999..=1.0).contains(&left), "{left} of velocity {k}");
    }
}
