//! States and signals between the ends of a step.

use pulp::NullaryFnOnce;

use super::trajectory::Trajectory;
use crate::integrator::step::Step;
use crate::motion::{FreeFlight, Motion, Pieces, Signals};
use crate::registers::Registers;
use crate::state::State;

/// A step between its ends.
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
    #[inline(always)]
    fn motion_at(&self, theta: f64) -> State<f64> {
        match self.free {
            Some(flight) => flight.at(theta * self.step.length),
            None => self.step.motion_at(theta),
        }
    }
}

/// Evaluates the signals within a step.
pub(super) struct Look<'a> {
    pub(super) motion: &'a Motion<f64>,
    pub(super) pieces: &'a Pieces<f64>,
    pub(super) between: Between<'a>,
    /// Fraction of the step.
    pub(super) theta: f64,
    pub(super) with_torques: bool,
    pub(super) signals: &'a mut Signals<f64>,
}

impl NullaryFnOnce for Look<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let state = self.between.motion_at(self.theta);
        (self.motion).look(&state, self.pieces, self.with_torques, self.signals);
    }
}

/// What moves at fraction θ of a step.
struct MotionAt<'a>(Between<'a>, f64);

impl NullaryFnOnce for MotionAt<'_> {
    type Output = State<f64>;

    #[inline(always)]
    fn call(self) -> State<f64> {
        self.0.motion_at(self.1)
    }
}

impl Trajectory<'_> {
    /// Goes to fraction θ of the step.
    pub(super) fn move_to(&mut self, theta: f64) {
        self.step.before = self.state_at(theta);
    }

    /// The step between its ends.
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
        self.registers.dispatch(MotionAt(self.between(), theta))
    }

    /// The signals at fraction θ of the step.
    pub(super) fn signals_at(&mut self, theta: f64) -> Signals<f64> {
        self.evaluations += 1;
        let mut signals = Signals::blank(self.leg_count());
        self.registers.dispatch(Look {
            motion: &self.motion,
            pieces: &self.pieces,
            between: self.between(),
            theta,
            with_torques: false,
            signals: &mut signals,
        });
        signals
    }
}
