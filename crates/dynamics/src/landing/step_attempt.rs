//! An attempted step, explicit or implicit, of one landing or of several in lanes. Here the integrator's method, the equations
//! of motion and the registers meet.

use pulp::NullaryFnOnce;

use crate::integrator::rosenbrock::{GAMMA, TIMES};
use crate::integrator::step::{Step, Weights};
use crate::integrator::{dormand_prince, rosenbrock};
use crate::motion::{Motion, Pieces, Signals};
use crate::registers::Registers;
use crate::response::Response;
use crate::scalar::Real;
use crate::state::State;

/// Kind of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepKind {
    Explicit,
    Implicit,
}

impl StepKind {
    /// Evaluations of the derivative in such a step.
    pub(crate) fn evaluations(self) -> u64 {
        match self {
            Self::Explicit => dormand_prince::EVALUATIONS,
            Self::Implicit => rosenbrock::EVALUATIONS,
        }
    }

    /// Weights of its slopes.
    pub(crate) fn weights(self) -> Weights<f64> {
        match self {
            Self::Explicit => dormand_prince::weights(),
            Self::Implicit => rosenbrock::weights(),
        }
    }
}

/// A step to attempt.
pub(crate) struct TakeStep<'a, R, S> {
    pub(crate) registers: R,
    pub(crate) kind: StepKind,
    pub(crate) motion: &'a Motion<S>,
    pub(crate) pieces: &'a Pieces<S>,
    /// Derivatives of the forces at its start, for an implicit step.
    pub(crate) response: &'a Response<S>,
    pub(crate) step: &'a mut Step<S, State<S>>,
    /// When it starts, s after first contact.
    pub(crate) time: S,
    /// Length of the step, s.
    pub(crate) length: S,
    /// Overwritten by the stages of an implicit step.
    pub(crate) stages: &'a mut [State<S>; 6],
    /// Where the signals in the middle of an implicit step go.
    pub(crate) middle: &'a mut Signals<S>,
    /// Where the signals at its end go.
    pub(crate) signals: &'a mut Signals<S>,
}

impl<R: Registers, S: Real> NullaryFnOnce for TakeStep<'_, R, S> {
    /// Estimated error of the step ([`Step::error`]).
    type Output = [S; 2];

    #[inline(always)]
    fn call(self) -> [S; 2] {
        let Self {
            registers,
            kind,
            motion,
            pieces,
            response,
            step,
            time,
            length,
            stages,
            middle,
            signals,
        } = self;
        let is_full = motion.is_full(pieces);
        let at = |fraction: f64| time + S::constant(fraction) * length;
        let derivative = |fraction: f64, state: &State<S>, slope: &mut State<S>| {
            let time = at(fraction);
            if is_full {
                registers.dispatch(Derive::<true, S>(motion, time, state, pieces, slope));
            } else {
                registers.dispatch(Derive::<false, S>(motion, time, state, pieces, slope));
            }
        };
        let evaluate =
            |fraction: f64, state: &State<S>, slope: &mut State<S>, signals: &mut Signals<S>| {
                let time = at(fraction);
                if is_full {
                    registers.dispatch(Evaluate::<true, S>(
                        motion, time, state, pieces, slope, signals,
                    ));
                } else {
                    registers.dispatch(Evaluate::<false, S>(
                        motion, time, state, pieces, slope, signals,
                    ));
                }
            };
        let last = |state: &State<S>, slope: &mut State<S>| evaluate(1.0, state, slope, signals);
        match kind {
            StepKind::Explicit => step.take_explicit(length, derivative, last),
            StepKind::Implicit => {
                let system = response.over(S::constant(GAMMA) * length);
                let midway = |state: &State<S>, slope: &mut State<S>| {
                    evaluate(0.5, state, slope, middle);
                };
                let start = (!pieces.thrust().is_none()).then(|| {
                    let more = pieces.thrust().rate() * S::constant(TIMES[0]) * length;
                    let mut start = step.slopes[0];
                    motion.add_thrust(more, &step.before, &mut start);
                    start
                });
                step.take_implicit(
                    length,
                    &system,
                    stages,
                    start.as_ref(),
                    derivative,
                    midway,
                    last,
                );
            }
        }
        step.error()
    }
}

/// The derivative at a time and a state.
struct Derive<'a, const FULL: bool, S>(
    &'a Motion<S>,
    S,
    &'a State<S>,
    &'a Pieces<S>,
    &'a mut State<S>,
);

impl<const FULL: bool, S: Real> NullaryFnOnce for Derive<'_, FULL, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, time, state, pieces, slope) = self;
        motion.derivative::<FULL>(time, state, pieces, slope);
    }
}

/// The derivative and the signals at a time and a state.
pub(super) struct Evaluate<'a, const FULL: bool, S>(
    pub(super) &'a Motion<S>,
    pub(super) S,
    pub(super) &'a State<S>,
    pub(super) &'a Pieces<S>,
    pub(super) &'a mut State<S>,
    pub(super) &'a mut Signals<S>,
);

impl<const FULL: bool, S: Real> NullaryFnOnce for Evaluate<'_, FULL, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, time, state, pieces, slope, signals) = self;
        motion.evaluate::<FULL>(time, state, pieces, slope, signals);
    }
}

/// The derivatives of the forces at a state.
pub(crate) struct Respond<'a, S>(
    pub(crate) &'a Motion<S>,
    pub(crate) &'a State<S>,
    pub(crate) &'a Pieces<S>,
    pub(crate) &'a mut Response<S>,
);

impl<S: Real> NullaryFnOnce for Respond<'_, S> {
    /// Rate (1/s) that no decay of a velocity exceeds.
    type Output = S;

    #[inline(always)]
    fn call(self) -> S {
        let Self(motion, state, pieces, response) = self;
        motion.respond(state, pieces, response);
        response.greatest_rate()
    }
}
