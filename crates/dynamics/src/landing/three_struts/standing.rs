//! A vehicle on legs of three struts as the judge of rest sees it.

use arrayvec::ArrayVec;
use nalgebra::Vector3;

use super::simulation::Simulation;
use crate::landing::rest::{Pull, Standing, Support, Supports};
use crate::laws::three_struts::SLIDING;

impl Standing for Simulation<'_> {
    fn time(&self) -> f64 {
        self.time
    }

    fn mass(&self) -> f64 {
        self.motion.total_mass()
    }

    fn kinetic_energy(&self) -> f64 {
        self.motion.kinetic(&self.step.before)
    }

    fn velocity(&self) -> Vector3<f64> {
        self.step.before.body().velocity
    }

    fn farthest_foot(&self) -> f64 {
        let feet = self.motion.feet(&self.step.before);
        feet.iter().map(Vector3::norm).fold(0.0, f64::max)
    }

    fn pull_at_rest(&self) -> Option<Pull> {
        let weight = self.motion.total_mass() * self.motion.gravity();
        let thrust = self.thrust.at(self.time);
        if self.next_knot != f64::INFINITY || thrust >= weight {
            return None;
        }
        if thrust == 0.0 {
            return Some(Pull::of_weight(weight));
        }
        let (moment, along) = self.motion.thrust_line(&self.step.before);
        Pull::of_weight_and_thrust(weight, &(along * thrust), &(moment * thrust))
    }

    fn supports(&self, pull: &Pull) -> Supports {
        let feet = self.motion.feet(&self.step.before);
        let mut supports = ArrayVec::new();
        for (leg, foot) in feet.iter().enumerate() {
            let gap = self.modes[leg].pad_gap(&self.laws[leg], &self.signals[0].leg(leg));
            let normal = self.motion.ground_normal(leg);
            supports.extend(pull.support(leg, true, foot, normal, gap));
        }
        supports
    }

    fn sticks(&self, support: &Support) -> bool {
        let speed_squared = self.signals[0].of(support.leg, SLIDING);
        self.laws[support.leg].friction().is_viscous(speed_squared)
    }

    fn bears(&self, support: &Support, load: f64, creep: f64) -> bool {
        let leg = support.leg;
        let (mode, laws, signals) = (&self.modes[leg], &self.laws[leg], &self.signals[0].leg(leg));
        let present = (self.motion).forces(leg, &self.signals[0], &self.pieces);
        if mode.pad_crushes(creep, signals) && present.normal < load {
            return false;
        }
        // The struts push the foot down with what the ground bears.
        let down = Vector3::new(0.0, 0.0, load);
        let loads = self.motion.loads_for(leg, &self.step.before, &down);
        mode.struts_bear(laws, &loads, &present.struts, creep, signals)
    }
}
