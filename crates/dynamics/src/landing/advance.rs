//! A step tried, and what is evaluated at its ends, compiled for each kind of register: sums over slopes are as wide as
//! the state.

use pulp::NullaryFnOnce;

use crate::formation::LegsAbreast;
use crate::integrator::rosenbrock::GAMMA;
use crate::integrator::step::Step;
use crate::motion::{Glance, Motion, Pieces, Signal};
use crate::response::Response;
use crate::state::State;

/// A step to try, explicit or implicit.
pub(super) struct Advance<'a, const LEGS: usize> {
    pub(super) motion: &'a Motion<LEGS>,
    pub(super) pieces: &'a Pieces<LEGS>,
    /// How forces answer at its start, when it is to be taken implicitly.
    pub(super) response: Option<&'a Response<LegsAbreast, LEGS>>,
    /// Length of the step, s.
    pub(super) length: f64,
    pub(super) tolerance: f64,
    /// Error allowed to a work integral, ft·lb.
    pub(super) greatest_work_error: f64,
    pub(super) step: &'a mut Step<f64, LEGS>,
    /// Where the signals in the middle of an implicit step go.
    pub(super) middle: &'a mut Glance<LEGS>,
    /// Where the signals at its end go.
    pub(super) signals: &'a mut Glance<LEGS>,
}

impl<const LEGS: usize> NullaryFnOnce for Advance<'_, LEGS> {
    /// Error of the step in units of the tolerance.
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        let Self {
            motion,
            pieces,
            step,
            ..
        } = self;
        let derivative = |state: &State<f64, LEGS>, slope: &mut State<f64, LEGS>| {
            motion.derivative(state, pieces, slope);
        };
        let last = |state: &State<f64, LEGS>, slope: &mut State<f64, LEGS>| {
            motion.evaluate(state, pieces, slope, &mut *self.signals);
        };
        if let Some(response) = self.response {
            let system = response.over(GAMMA * self.length);
            let middle = |state: &State<f64, LEGS>, slope: &mut State<f64, LEGS>| {
                motion.evaluate(state, pieces, slope, &mut *self.middle);
            };
            let mut stages = [State::zero(); 6];
            step.take_implicit(self.length, &system, &mut stages, derivative, middle, last);
            tell_pad_rates(step, [&mut *self.middle, &mut *self.signals]);
        } else {
            step.take_explicit(self.length, derivative, last);
        }
        let error = step.error();
        let motion = error.error_norm(&step.before, &step.after, self.tolerance);
        motion.max(error.greatest_work() / self.greatest_work_error)
    }
}

/// Rates of pads at rest are known only once an implicit step is taken: writes those of its middle and end.
#[inline(always)]
pub(super) fn tell_pad_rates<const LEGS: usize>(
    step: &Step<f64, LEGS>,
    [middle, end]: [&mut Glance<LEGS>; 2],
) {
    for (j, rate) in step.pad_rates_at(0.5).into_iter().enumerate() {
        middle.set(j, Signal::PadRate, rate);
        end.set(j, Signal::PadRate, step.after.leg(j).pad_rate);
    }
}

/// Derivative and signals at a state.
pub(super) struct Evaluate<'a, const LEGS: usize> {
    pub(super) motion: &'a Motion<LEGS>,
    pub(super) pieces: &'a Pieces<LEGS>,
    pub(super) state: &'a State<f64, LEGS>,
    pub(super) slope: &'a mut State<f64, LEGS>,
    pub(super) signals: &'a mut Glance<LEGS>,
}

impl<const LEGS: usize> NullaryFnOnce for Evaluate<'_, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.motion
            .evaluate(self.state, self.pieces, self.slope, self.signals);
    }
}
