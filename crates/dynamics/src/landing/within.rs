//! A step seen from within: states and signals between its ends.

use super::trajectory::Trajectory;
use crate::integrator::step::Step;
use crate::motion::{FreeFlight, Glance};
use crate::state::State;

/// The course of a step between its ends.
#[derive(Clone, Copy)]
pub(super) struct Between<'a> {
    pub(super) step: &'a Step<f64, State<f64>>,
    /// In free flight that is known exactly.
    pub(super) free: Option<&'a FreeFlight>,
}

impl Between<'_> {
    /// The state at fraction θ.
    fn at(&self, theta: f64) -> State<f64> {
        match self.free {
            Some(flight) => flight.at(theta * self.step.length),
            None => self.step.at(theta),
        }
    }

    /// What moves at fraction θ; the work integrals may be those before it.
    pub(super) fn motion_at(&self, theta: f64) -> State<f64> {
        match self.free {
            Some(flight) => flight.at(theta * self.step.length),
            None => self.step.motion_at(theta),
        }
    }
}

impl Trajectory<'_> {
    /// Goes to fraction θ of the step.
    pub(super) fn go_to(&mut self, theta: f64) {
        self.step.before = self.state_at(theta);
    }

    /// The course of the step.
    fn between(&self) -> Between<'_> {
        Between {
            step: &self.step,
            free: self.free.as_ref(),
        }
    }

    /// The state at fraction θ of the step.
    pub(super) fn state_at(&self, theta: f64) -> State<f64> {
        self.between().at(theta)
    }

    /// What moves at fraction θ of the step.
    pub(super) fn motion_at(&self, theta: f64) -> State<f64> {
        self.between().motion_at(theta)
    }

    /// The signals at fraction θ of the step.
    pub(super) fn look_at(&mut self, theta: f64) -> Glance<f64> {
        self.evaluations += 1;
        let state = self.motion_at(theta);
        self.motion.signals(&state, &self.pieces, false)
    }
}
