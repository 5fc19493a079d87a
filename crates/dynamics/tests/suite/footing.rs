//! Signals and feet over many states.

use crate::common::bare::Bare;
use crate::common::{level_scene, off_center, table_4_1};
use touchdown_dynamics::motion::Footing;
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;

/// Feet pressed in by various depths, struts stroking and returning.
fn states(start: &State<f64>) -> Vec<State<f64>> {
    (0..40)
        .map(|k| {
            let k = f64::from(k);
            let mut state = *start;
            let mut body = state.body();
            body.position.z += 0.004 * k;
            body.velocity *= (0.3 * k).cos();
            body.rate.x += 0.1 * (0.7 * k).sin();
            body.rate.z -= 0.2 * (1.1 * k).sin();
            state.set_body(&body);
            for j in 0..3 {
                let mut leg = state.leg(j);
                leg.link_angle -= 0.001 * k * (1.0 + j as f64);
                leg.link_rate = (0.9 * k + j as f64).sin();
                leg.pad_turn += 0.05 * (0.4 * k + j as f64).cos();
                leg.pad_rate = (1.3 * k - j as f64).sin();
                state.set_leg(j, &leg);
            }
            state
        })
        .collect()
}

#[test]
fn signals_tell_where_the_feet_stand() {
    for vehicle in [table_4_1(), off_center(table_4_1())] {
        let scene = level_scene(170.0, -10.0, 11.0);
        let mut bare = Bare::new(&vehicle, &scene);
        let start = touchdown(&vehicle, &scene, &bare.motion);
        for state in states(&start) {
            bare.settle(&state);
            let seen = bare.motion.footing(&state);
            let depth = bare.motion.surface().depth(&state.body().position);
            assert_eq!(Footing::from_signals(&bare.signals(&state), depth), seen);
        }
    }
}
