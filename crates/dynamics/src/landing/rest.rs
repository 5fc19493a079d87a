//! Rest by energy: motion has subsided once the vehicle has had too little energy to topple for a while.
//!
//! To topple over the line between two feet the CG has to rise until it is over that line. What is left to move the vehicle
//! is judged against the least of these rises. Struts and pads that still push back add to it: the while gives them time to.

use libm::sqrt;
use nalgebra::Vector3;

use crate::energy::kinetic;
use crate::extremes::least;
use crate::kinematics::Surface;
use crate::motion::{Footing, Motion};
use crate::per_leg::PerLeg;
use crate::scene::Scene;
use crate::state::State;
use crate::vehicle::{Ring, Vehicle};

use super::trajectory::Trajectory;

/// Share of the energy that toppling takes up to which there is too little.
const SHARE: f64 = 0.5;
/// How long there is, in free falls of the CG from its height on extended legs.
const WHILE: f64 = 0.4;

/// Since when a vehicle has had too little energy to topple.
#[derive(Debug, Clone)]
pub(crate) struct RestByEnergy {
    /// For how long it must have, s.
    needed: f64,
    /// Height of each footpad's pivot over the surface when the pad stands on its ground, ft.
    stances: PerLeg<f64>,
    ring: Ring,
    since: Option<f64>,
}

impl RestByEnergy {
    /// For a vehicle in a scene.
    pub(crate) fn new(vehicle: &Vehicle, scene: &Scene) -> Self {
        let legs = vehicle.legs();
        let free_fall = sqrt(2.0 * vehicle.standing_height() / scene.gravity(vehicle));
        Self {
            needed: WHILE * free_fall,
            stances: PerLeg::from_fn(legs.len(), |j| {
                legs[j].design().footpad.height + scene.conditions().ground.leg(j).pad.height
            }),
            ring: vehicle.ring().clone(),
            since: None,
        }
    }

    /// Takes note of a state at a time (s), of which a thrust that changes no more leaves this `weight` (lb): whether the
    /// vehicle is at rest.
    pub(crate) fn note(
        &mut self,
        time: f64,
        motion: &Motion<f64>,
        state: &State<f64>,
        weight: Option<f64>,
    ) -> bool {
        let has_little = weight.is_some_and(|weight| {
            kinetic(motion, state) <= weight * self.height_to_spare(motion, state)
        });
        self.since = has_little.then(|| self.since.unwrap_or(time));
        self.since.is_some_and(|since| time - since >= self.needed)
    }

    /// Height to which too little energy may lift the CG, less that by which it can still come down, ft.
    fn height_to_spare(&self, motion: &Motion<f64>, state: &State<f64>) -> f64 {
        let footing = motion.footing(state);
        let surface: &Surface<f64> = motion.surface();
        let Footing { feet, depth, .. } = &footing;
        let heights = feet.iter().zip(self.stances.iter());
        let lowest = least(heights.map(|(foot, stance)| -depth - surface.depth(foot) - stance));
        let rises = (self.ring.iter().zip(self.ring.iter().cycle().skip(1)))
            .map(|(&foot, &next)| rise_over(&feet[foot], &feet[next]));
        SHARE * least(rises) - lowest.max(0.0)
    }
}

impl Trajectory<'_> {
    /// Whether the vehicle is at rest by its energy.
    #[cold]
    #[inline(never)]
    pub(super) fn is_at_rest(&self, rest: &mut RestByEnergy) -> bool {
        let weight = self.weight_at_rest();
        rest.note(self.time, &self.motion, &self.step.before, weight)
    }
}

/// How far the CG rises until it is over the line between two feet, `to` being the next in the ring, ft; the way back,
/// negative, where it is beyond. Feet are seen from the CG, in ground axes.
fn rise_over(from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let span = to - from;
    let along = span / sqrt(span.norm_squared());
    let nearest = from - along * from.dot(&along);
    let upright = sqrt(nearest.norm_squared() * (1.0 - along.z * along.z).max(0.0));
    let rise = upright - nearest.z;
    let is_inboard = from.y * to.x - from.x * to.y > 0.0;
    if is_inboard { rise } else { -rise }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extremes::greatest;

    #[test]
    fn the_rise_over_a_level_line_is_that_of_a_pendulum_turned_over() {
        // Feet 3 ft ahead of the CG and 4 ft below it: the CG turns about them on a circle of 5 ft.
        let [from, to] = [[-2.0, 3.0, 4.0], [2.0, 3.0, 4.0]].map(Vector3::from);
        assert_eq!(rise_over(&from, &to), 1.0);
        assert_eq!(rise_over(&to, &from), -1.0);
    }

    #[test]
    fn the_rise_over_an_inclined_line_is_that_of_all_turns_about_it() {
        let (from, to) = (Vector3::new(-2.0, 1.0, 3.5), Vector3::new(2.5, 0.5, 4.5));
        let axis = nalgebra::Unit::new_normalize(to - from);
        let height = |angle: f64| {
            let turned = nalgebra::Rotation3::from_axis_angle(&axis, angle) * -from;
            -(from + turned).z
        };
        let highest = greatest((0..100_000).map(|k| height(f64::from(k) * 1e-4)));
        assert!((rise_over(&from, &to) - highest).abs() < 1e-7);
    }
}
