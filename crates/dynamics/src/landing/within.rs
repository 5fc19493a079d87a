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
    /// Its closed form in free flight.
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

    /// Writes the motion at fraction θ.
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
}

impl Look<'_> {
    /// Writes the signals and the motion at fraction θ of the step. Compiled once for all callers, so that it stays in
    /// the instruction cache.
    #[inline(never)]
    pub(super) fn at(
        &self,
        registers: Single,
        theta: f64,
        state: &mut State<f64>,
        signals: &mut Signals<f64>,
    ) {
        registers.dispatch(LookAt(self, theta, state, signals));
    }
}

struct LookAt<'a>(&'a Look<'a>, f64, &'a mut State<f64>, &'a mut Signals<f64>);

impl NullaryFnOnce for LookAt<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(look, theta, state, signals) = self;
        look.between.motion_at(theta, state);
        // Always with torques, so that one copy of the equations serves all.
        (look.motion).look(state, look.pieces, true, signals);
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

/// Writes the motion at fraction θ of a step.
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
    fn between(&self) -> Between<'_> {
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

    /// Motion at fraction θ of the step; the work integrals may be zero.
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
            between: Between {
                step: &self.step,
                free: self.free.as_ref(),
            },
        };
        look.at(self.registers, theta, &mut self.within, &mut signals);
        signals
    }
}
