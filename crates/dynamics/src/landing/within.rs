//! States and signals between the ends of a step.

use pulp::NullaryFnOnce;

use super::trajectory::Trajectory;
use crate::integrator::step::Step;
use crate::motion::{FreeFlight, Motion, Pieces, Signals};
use crate::registers::{Registers, Single};
use crate::state::State;

/// A step between its ends.
#[derive(Clone, Copy)]
pub(super) struct Between<'a> {
    pub(super) step: &'a Step<f64, State<f64>>,
    /// In free flight that is known exactly.
    pub(super) free: Option<&'a FreeFlight>,
}

impl Between<'_> {
    /// Writes the state at fraction θ.
    #[inline(always)]
    fn at(&self, theta: f64, state: &mut State<f64>) {
        match self.free {
            Some(flight) => *state = flight.at(theta * self.step.length),
            None => self.step.at(theta, state),
        }
    }

    /// Writes what moves at fraction θ.
    #[inline(always)]
    pub(super) fn motion_at(&self, theta: f64, state: &mut State<f64>) {
        match self.free {
            Some(flight) => *state = flight.at(theta * self.step.length),
            None => self.step.motion_at(theta, state),
        }
    }
}

/// Evaluates the signals within a step.
pub(super) struct Look<'a> {
    pub(super) motion: &'a Motion<f64>,
    pub(super) pieces: &'a Pieces<f64>,
    pub(super) between: Between<'a>,
    pub(super) with_torques: bool,
}

impl Look<'_> {
    /// Writes the signals at fraction θ of the step. Compiled once, for all that look: code that is called from
    /// everywhere stays in the cache of instructions.
    #[inline(never)]
    pub(super) fn at(&self, registers: Single, theta: f64, signals: &mut Signals<f64>) {
        registers.dispatch(LookAt(self, theta, signals));
    }
}

struct LookAt<'a>(&'a Look<'a>, f64, &'a mut Signals<f64>);

impl NullaryFnOnce for LookAt<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(look, theta, signals) = self;
        let mut state = State::zero(look.motion.leg_count());
        look.between.motion_at(theta, &mut state);
        (look.motion).look(&state, look.pieces, look.with_torques, signals);
    }
}

/// Writes the state at fraction θ of a step.
struct StateAt<'a>(Between<'a>, f64, &'a mut State<f64>);

impl NullaryFnOnce for StateAt<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(between, theta, state) = self;
        between.at(theta, state);
    }
}

/// Writes what moves at fraction θ of a step.
struct MotionAt<'a>(Between<'a>, f64, &'a mut State<f64>);

impl NullaryFnOnce for MotionAt<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(between, theta, state) = self;
        between.motion_at(theta, state);
    }
}

impl Trajectory<'_> {
    /// Goes to fraction θ of the step.
    pub(super) fn move_to(&mut self, theta: f64) {
        let state = self.state_at(theta);
        self.step.before.assign(&state);
    }

    /// The step between its ends.
    pub(super) fn between(&self) -> Between<'_> {
        Between {
            step: &self.step,
            free: self.free.as_ref(),
        }
    }

    /// The state at fraction θ of the step.
    pub(super) fn state_at(&self, theta: f64) -> State<f64> {
        let mut state = State::zero(self.leg_count());
        (self.registers).dispatch(StateAt(self.between(), theta, &mut state));
        state
    }

    /// What moves at fraction θ of the step; the work integrals may be zero.
    pub(super) fn motion_at(&self, theta: f64) -> State<f64> {
        let mut state = State::zero(self.leg_count());
        (self.registers).dispatch(MotionAt(self.between(), theta, &mut state));
        state
    }

    /// The signals at fraction θ of the step.
    pub(super) fn signals_at(&mut self, theta: f64) -> Signals<f64> {
        self.evaluations += 1;
        let mut signals = Signals::blank(self.leg_count());
        let look = Look {
            motion: &self.motion,
            pieces: &self.pieces,
            between: self.between(),
            with_torques: false,
        };
        look.at(self.registers, theta, &mut signals);
        signals
    }
}
