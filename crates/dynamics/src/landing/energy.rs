//! Energies of a vehicle in motion, ft·lb.

use crate::motion::Motion;
use crate::state::State;

/// Kinetic energy of body and lower links.
pub fn kinetic(motion: &Motion<f64>, state: &State<f64>) -> f64 {
    let body = state.body();
    let translation = motion.mass() * body.velocity.norm_squared();
    let rotation = body.rate.dot(&(motion.inertia() * body.rate));
    let links: f64 = (0..motion.leg_count())
        .map(|j| {
            let rate = state.link_rate(j);
            motion.link_inertia(j) * rate * rate
        })
        .sum();
    0.5 * (translation + rotation + links)
}

/// Potential energy released between two states.
pub fn released(motion: &Motion<f64>, from: &State<f64>, to: &State<f64>) -> f64 {
    let descent = to.body().position.z - from.body().position.z;
    motion.mass() * motion.gravity() * descent
}
