//! Attempts of a step, explicit or implicit, compiled for the registers of a single landing.

use pulp::NullaryFnOnce;

use super::simulation::Simulation;
use crate::equations::three_struts::{Motion, Pieces, Response, Signals, StageFactors, State};
use crate::integrator::dormand_prince;
use crate::integrator::rosenbrock::{self, GAMMA, StageEquations, TIMES};
use crate::registers::{Registers, Single};

/// Rate of decay and angular frequency of the fastest motion of a foot, times the length of a step, from which on the step is
/// implicit: an explicit one would be near its limit of stability.
const STIFF: [f64; 2] = [3.0, 1.6];

impl Simulation<'_> {
    /// Attempts a step of this length (s). Returns its error in units of the tolerance.
    pub(super) fn attempt(&mut self, length: f64) -> f64 {
        let registers = self.registers;
        registers.dispatch(Attempt(self, length))
    }

    /// Body of `attempt`, compiled for any registers. What is computed more than once in it is in functions of their own, which
    /// stay in the instruction cache.
    #[inline(always)]
    fn attempt_in_registers(&mut self, length: f64) -> f64 {
        let fastest = self.motion.fastest(&self.signals[0], &self.pieces);
        match (0..2).any(|k| length * fastest[k] > STIFF[k]) {
            true => self.take_implicit(length),
            false => self.take_explicit(length),
        }
        let [motion, work] = self.step.error();
        if motion.is_nan() {
            return f64::INFINITY;
        }
        (motion / self.settings.tolerance()).max(work / self.work_error)
    }

    #[inline(always)]
    fn take_explicit(&mut self, length: f64) {
        let registers = self.registers;
        let Self {
            motion,
            pieces,
            step,
            stages: [at_half, ..],
            signals: [_, at_middle, at_end],
            thrust,
            ..
        } = self;
        let thrust_at = |fraction: f64| thrust.at(self.time + fraction * length);
        step.take_explicit(
            length,
            |fraction, state, slope| {
                let thrust = thrust_at(fraction);
                registers.dispatch(Derive(motion, thrust, state, pieces, slope));
            },
            |state, slope| {
                let thrust = thrust_at(1.0);
                registers.dispatch(Evaluate(motion, thrust, state, pieces, slope, at_end));
            },
        );
        step.motion_at(0.5, at_half);
        *at_middle = motion.signals(at_half, pieces);
        self.evaluations += dormand_prince::EVALUATIONS + 1;
    }

    #[inline(always)]
    fn take_implicit(&mut self, length: f64) {
        let registers = self.registers;
        let Self {
            motion,
            pieces,
            step,
            stages,
            signals,
            thrust,
            ..
        } = self;
        let response = registers.dispatch(Respond(motion, &step.before, pieces));
        let factors = registers.dispatch(Factor(&response, GAMMA * length));
        let equations = InRegisters { registers, factors };
        let thrust_at = |fraction: f64| thrust.at(self.time + fraction * length);
        let [_, at_middle, at_end] = signals;
        let mut unread = *at_end;
        let start = (!thrust.is_none()).then(|| {
            let mut start = step.slopes[0];
            let thrust = thrust_at(TIMES[0]);
            motion.evaluate(thrust, &step.before, pieces, &mut start, &mut unread);
            start
        });
        step.take_implicit(
            length,
            &equations,
            stages,
            start.as_ref(),
            |fraction, state, slope| {
                let thrust = thrust_at(fraction);
                registers.dispatch(Derive(motion, thrust, state, pieces, slope));
            },
            |state, slope| {
                let thrust = thrust_at(0.5);
                registers.dispatch(Evaluate(motion, thrust, state, pieces, slope, at_middle));
            },
            |state, slope| {
                let thrust = thrust_at(1.0);
                registers.dispatch(Evaluate(motion, thrust, state, pieces, slope, at_end));
            },
        );
        self.evaluations += rosenbrock::EVALUATIONS + u64::from(start.is_some());
    }
}

/// Stage equations solved in a function compiled for registers.
struct InRegisters<'a> {
    registers: Single,
    factors: StageFactors<'a>,
}

impl StageEquations<f64, State> for InRegisters<'_> {
    #[inline(always)]
    fn solve(&self, r: &State, u: &mut State) {
        self.registers.dispatch(Solve(&self.factors, r, u));
    }

    #[inline(always)]
    fn accumulate(
        &self,
        before: &State,
        h: f64,
        slopes: [&State; 3],
        after: &mut State,
        error: &mut State,
    ) {
        self.factors.accumulate(before, h, slopes, after, error);
    }
}

/// An attempt of a step.
struct Attempt<'a, 'o>(&'a mut Simulation<'o>, f64);

impl NullaryFnOnce for Attempt<'_, '_> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        let Self(simulation, length) = self;
        simulation.attempt_in_registers(length)
    }
}

/// The derivative of a state under a thrust.
struct Derive<'a>(&'a Motion, f64, &'a State, &'a Pieces, &'a mut State);

impl NullaryFnOnce for Derive<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, thrust, state, pieces, slope) = self;
        motion.derive(thrust, state, pieces, slope);
    }
}

/// The derivative of a state under a thrust, and the signals.
struct Evaluate<'a>(
    &'a Motion,
    f64,
    &'a State,
    &'a Pieces,
    &'a mut State,
    &'a mut Signals,
);

impl NullaryFnOnce for Evaluate<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(motion, thrust, state, pieces, slope, signals) = self;
        motion.evaluate(thrust, state, pieces, slope, signals);
    }
}

/// The derivatives of the forces at a state.
struct Respond<'a>(&'a Motion, &'a State, &'a Pieces);

impl NullaryFnOnce for Respond<'_> {
    type Output = Response;

    #[inline(always)]
    fn call(self) -> Response {
        let Self(motion, state, pieces) = self;
        motion.respond(state, pieces)
    }
}

/// The equations of a stage of this weight, factored.
struct Factor<'a>(&'a Response, f64);

impl<'a> NullaryFnOnce for Factor<'a> {
    type Output = StageFactors<'a>;

    #[inline(always)]
    fn call(self) -> StageFactors<'a> {
        let Self(response, tau) = self;
        response.over(tau)
    }
}

/// The solution of a stage.
struct Solve<'a>(&'a StageFactors<'a>, &'a State, &'a mut State);

impl NullaryFnOnce for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(factors, r, u) = self;
        factors.solve(r, u);
    }
}
