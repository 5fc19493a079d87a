//! Energies of a vehicle in motion, ft·lb.

use crate::state::State;
use crate::vehicle::Vehicle;

/// Kinetic energy of body and lower links.
pub fn kinetic<const LEGS: usize>(vehicle: &Vehicle<LEGS>, state: &State<f64, LEGS>) -> f64 {
    let body = state.body();
    let translation = vehicle.mass() * body.velocity.norm_squared();
    let rotation = body.rate.dot(&(vehicle.inertia() * body.rate));
    let links: f64 = (0..LEGS)
        .map(|j| {
            let rate = state.leg(j).link_rate;
            vehicle.legs()[j].design().linkage.inertia * rate * rate
        })
        .sum();
    0.5 * (translation + rotation + links)
}

/// Potential energy released between two states.
pub fn released<const LEGS: usize>(
    vehicle: &Vehicle<LEGS>,
    from: &State<f64, LEGS>,
    to: &State<f64, LEGS>,
) -> f64 {
    let descent = to.body().position.z - from.body().position.z;
    vehicle.mass() * vehicle.gravity() * descent
}
