//! A step seen from within: states and signals between its ends.

use std::ops::Deref;

use pulp::NullaryFnOnce;

use super::Flight;
use crate::integrator::step::Step;
use crate::motion::{FreeFlight, Glance, Motion, Pieces};
use crate::record::Instant;
use crate::registers::Registers;
use crate::state::State;
use crate::vehicle::Vehicle;

/// The course of a step between its ends.
#[derive(Clone, Copy)]
pub(super) struct Between<'a, const LEGS: usize> {
    pub(super) step: &'a Step<f64, LEGS>,
    /// In free flight that is known exactly.
    pub(super) free: Option<&'a FreeFlight<LEGS>>,
}

impl<const LEGS: usize> Between<'_, LEGS> {
    /// Writes the state at fraction θ.
    #[inline(always)]
    fn write(&self, theta: f64, state: &mut State<f64, LEGS>) {
        match self.free {
            Some(flight) => flight.write(theta * self.step.length, state),
            None => *state = self.step.at(theta),
        }
    }

    /// Writes what moves at fraction θ; the work integrals may be those before it.
    #[inline(always)]
    fn write_motion(&self, theta: f64, state: &mut State<f64, LEGS>) {
        match self.free {
            Some(flight) => flight.write(theta * self.step.length, state),
            None => *state = self.step.motion_at(theta),
        }
    }
}

/// A look at the signals within a step.
pub(super) struct Look<'a, const LEGS: usize> {
    pub(super) motion: &'a Motion<LEGS>,
    pub(super) pieces: &'a Pieces<LEGS>,
    pub(super) between: Between<'a, LEGS>,
    /// Fraction of the step.
    pub(super) theta: f64,
    pub(super) with_torques: bool,
    pub(super) signals: &'a mut Glance<LEGS>,
}

impl<const LEGS: usize> NullaryFnOnce for Look<'_, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let mut state = State::zero();
        self.between.write_motion(self.theta, &mut state);
        let Self {
            motion,
            pieces,
            with_torques,
            signals,
            ..
        } = self;
        motion.look(&state, pieces, with_torques, signals);
    }
}

/// What moves at fraction θ of a step, or all of its state there.
struct Within<'a, const WHOLE: bool, const LEGS: usize> {
    between: Between<'a, LEGS>,
    theta: f64,
    state: &'a mut State<f64, LEGS>,
}

impl<const WHOLE: bool, const LEGS: usize> NullaryFnOnce for Within<'_, WHOLE, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        if WHOLE {
            self.between.write(self.theta, self.state);
        } else {
            self.between.write_motion(self.theta, self.state);
        }
    }
}

impl<V, O, const LEGS: usize> Flight<V, O, LEGS>
where
    V: Deref<Target = Vehicle<LEGS>>,
    O: FnMut(&Instant<LEGS>),
{
    /// Goes to fraction θ of the step.
    pub(super) fn go_to(&mut self, theta: f64) {
        self.step.before = self.state_at(theta);
    }

    /// The course of the step.
    fn between(&self) -> Between<'_, LEGS> {
        Between {
            step: &self.step,
            free: self.free.as_ref(),
        }
    }

    /// The state at fraction θ of the step.
    pub(super) fn state_at(&self, theta: f64) -> State<f64, LEGS> {
        self.within::<true>(theta)
    }

    /// What moves at fraction θ of the step.
    pub(super) fn motion_at(&self, theta: f64) -> State<f64, LEGS> {
        self.within::<false>(theta)
    }

    fn within<const WHOLE: bool>(&self, theta: f64) -> State<f64, LEGS> {
        let mut state = State::zero();
        self.motion.registers().dispatch(Within::<WHOLE, LEGS> {
            between: self.between(),
            theta,
            state: &mut state,
        });
        state
    }

    /// The signals at fraction θ of the step.
    pub(super) fn look_at(&mut self, theta: f64) -> Glance<LEGS> {
        let mut signals = Glance::blank();
        self.motion.registers().dispatch(Look {
            motion: &self.motion,
            pieces: &self.pieces,
            between: self.between(),
            theta,
            with_torques: false,
            signals: &mut signals,
        });
        self.evaluations += 1;
        signals
    }
}
