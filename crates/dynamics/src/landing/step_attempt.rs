//! An attempted step, explicit or implicit, of one landing or of several in lanes. It brings together the integrator's
//! method, the equations of motion and the registers.

use pulp::NullaryFnOnce;

use crate::integrator::rosenbrock::{GAMMA, StageEquations, TIMES};
use crate::integrator::step::{Step, Weights};
use crate::integrator::{dormand_prince, rosenbrock};
use crate::motion::{Motion, Pieces, Signals};
use crate::registers::Registers;
use crate::response::{Factors, Response, System};
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

/// Scratch space of implicit steps.
pub(crate) struct Workspace<S> {
    /// Derivatives of the forces at the start.
    response: Response<S>,
    /// Upper bound of the decay rates of velocities there, 1/s.
    pub(crate) greatest_decay: S,
    factors: Factors<S>,
    stages: [State<S>; 6],
}

impl<S: Real> Workspace<S> {
    /// For vehicles such as this one.
    pub(crate) fn new(motion: &Motion<S>) -> Self {
        Self {
            response: motion.response(),
            greatest_decay: S::zero(),
            factors: Factors::none(motion.leg_count()),
            stages: [State::zero(motion.leg_count()); 6],
        }
    }
}

/// A step to attempt.
pub(crate) struct TakeStep<'a, R, S> {
    pub(crate) registers: R,
    pub(crate) kind: StepKind,
    pub(crate) motion: &'a Motion<S>,
    pub(crate) pieces: &'a Pieces<S>,
    pub(crate) step: &'a mut Step<S, State<S>>,
    /// Start, s after first contact.
    pub(crate) time: S,
    /// Length of the step, s.
    pub(crate) length: S,
    pub(crate) workspace: &'a mut Workspace<S>,
    /// Receives the signals in the middle of an implicit step.
    pub(crate) middle: &'a mut Signals<S>,
    /// Receives the signals at its end.
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
            step,
            time,
            length,
            workspace:
                Workspace {
                    response,
                    greatest_decay,
                    factors,
                    stages,
                },
            middle,
            signals,
        } = self;
        let is_full = motion.is_full(pieces);
        let acts_at_face = motion.acts_at_face();
        let at = |fraction: f64| time + S::constant(fraction) * length;
        let derivative = |fraction: f64, state: &State<S>, slope: &mut State<S>| {
            let time = at(fraction);
            if acts_at_face {
                registers.dispatch(Derive::<true, true, S>(motion, time, state, pieces, slope));
            } else if is_full {
                registers.dispatch(Derive::<true, false, S>(motion, time, state, pieces, slope));
            } else {
                registers.dispatch(Derive::<false, false, S>(
                    motion, time, state, pieces, slope,
                ));
            }
        };
        let evaluate =
            |fraction: f64, state: &State<S>, slope: &mut State<S>, signals: &mut Signals<S>| {
                let time = at(fraction);
                if acts_at_face {
                    registers.dispatch(Evaluate::<true, true, S>(
                        motion, time, state, pieces, slope, signals,
                    ));
                } else if is_full {
                    registers.dispatch(Evaluate::<true, false, S>(
                        motion, time, state, pieces, slope, signals,
                    ));
                } else {
                    registers.dispatch(Evaluate::<false, false, S>(
                        motion, time, state, pieces, slope, signals,
                    ));
                }
            };
        let last = |state: &State<S>, slope: &mut State<S>| evaluate(1.0, state, slope, signals);
        match kind {
            StepKind::Explicit => step.take_explicit(length, derivative, last),
            StepKind::Implicit => {
                *greatest_decay = if acts_at_face {
                    registers.dispatch(Respond::<true, S>(motion, &step.before, pieces, response))
                } else {
                    registers.dispatch(Respond::<false, S>(motion, &step.before, pieces, response))
                };
                let system = Dispatched {
                    registers,
                    system: &response.over(S::constant(GAMMA) * length, factors),
                };
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
struct Derive<'a, const FULL: bool, const FACE: bool, S>(
    &'a Motion<S>,
    S,
    &'a State<S>,
    &'a Pieces<S>,
    &'a mut State<S>,
);

impl<const FULL: bool, const FACE: bool, S: Real> NullaryFnOnce for Derive<'_, FULL, FACE, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, time, state, pieces, slope) = self;
        motion.derivative::<FULL, FACE>(time, state, pieces, slope);
    }
}

/// The derivative and the signals at a time and a state.
pub(super) struct Evaluate<'a, const FULL: bool, const FACE: bool, S>(
    pub(super) &'a Motion<S>,
    pub(super) S,
    pub(super) &'a State<S>,
    pub(super) &'a Pieces<S>,
    pub(super) &'a mut State<S>,
    pub(super) &'a mut Signals<S>,
);

impl<const FULL: bool, const FACE: bool, S: Real> NullaryFnOnce for Evaluate<'_, FULL, FACE, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, time, state, pieces, slope, signals) = self;
        motion.evaluate::<FULL, FACE>(time, state, pieces, slope, signals);
    }
}

/// Stage equations of an implicit step, solved in a function of their own that stays in the instruction cache from
/// stage to stage.
struct Dispatched<'a, R, S> {
    registers: R,
    system: &'a System<'a, S>,
}

impl<R: Registers, S: Real> StageEquations<S, State<S>> for Dispatched<'_, R, S> {
    #[inline(always)]
    fn solve(&self, r: &State<S>, u: &mut State<S>) {
        self.registers.dispatch(Solve(self.system, r, u));
    }

    #[inline(always)]
    fn accumulate(
        &self,
        before: &State<S>,
        h: S,
        slopes: [&State<S>; 3],
        after: &mut State<S>,
        error: &mut State<S>,
    ) {
        self.system.accumulate(before, h, slopes, after, error);
    }
}

/// The solution of a stage.
struct Solve<'a, S>(&'a System<'a, S>, &'a State<S>, &'a mut State<S>);

impl<S: Real> NullaryFnOnce for Solve<'_, S> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(system, r, u) = self;
        system.solve(r, u);
    }
}

/// The derivatives of the forces at a state.
struct Respond<'a, const FACE: bool, S>(
    &'a Motion<S>,
    &'a State<S>,
    &'a Pieces<S>,
    &'a mut Response<S>,
);

impl<const FACE: bool, S: Real> NullaryFnOnce for Respond<'_, FACE, S> {
    /// Upper bound of the decay rates of velocities, 1/s.
    type Output = S;

    #[inline(always)]
    fn call(self) -> S {
        let Self(motion, state, pieces, response) = self;
        motion.respond::<FACE>(state, pieces, response);
        response.greatest_decay()
    }
}

/// Decay of velocities at a state.
pub(super) struct Decay<'a, const FACE: bool, S>(
    pub(super) &'a Motion<S>,
    pub(super) &'a State<S>,
    pub(super) &'a Pieces<S>,
);

impl<const FACE: bool, S: Real> NullaryFnOnce for Decay<'_, FACE, S> {
    /// Upper bound of the decay rates of velocities, 1/s.
    type Output = S;

    #[inline(always)]
    fn call(self) -> S {
        let Self(motion, state, pieces) = self;
        motion.greatest_decay::<FACE>(state, pieces)
    }
}
