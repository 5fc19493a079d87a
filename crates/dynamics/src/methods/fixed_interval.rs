//! The methods at a fixed interval: classical Runge-Kutta of order 4, and trapezoidal.

use super::{Evaluator, Start, Stepper, System, Taken, Vector};

/// Takes one step of Runge-Kutta; `look` gives derivatives.
pub(super) fn step<V: Vector>(start: &Start<V>, length: f64, mut look: impl FnMut(&V) -> V) -> V {
    let Start { state, slope: k1 } = start;
    let half = 0.5 * length;
    let k2 = look(&state.advanced([half], [k1]));
    let k3 = look(&state.advanced([half], [&k2]));
    let k4 = look(&state.advanced([length], [&k3]));
    let sixth = length / 6.0;
    state.advanced(
        [sixth, 2.0 * sixth, 2.0 * sixth, sixth],
        [k1, &k2, &k3, &k4],
    )
}

/// The classical Runge-Kutta method of order 4.
#[derive(Debug, Clone, Copy)]
pub struct RungeKutta {
    /// Interval, s.
    pub interval: f64,
}

impl<S: System> Stepper<S> for RungeKutta {
    fn advance(
        &mut self,
        start: &Start<S::State>,
        longest: f64,
        evaluator: &mut Evaluator<S>,
    ) -> Taken<S::State> {
        let length = self.interval.min(longest);
        let state = step(start, length, |state| evaluator.slope(state));
        Taken { length, state }
    }
}

/// The trapezoidal method: Euler's prediction, corrected once by the mean of the slopes at both ends.
#[derive(Debug, Clone, Copy)]
pub struct Trapezoidal {
    /// Interval, s.
    pub interval: f64,
}

impl<S: System> Stepper<S> for Trapezoidal {
    fn advance(
        &mut self,
        start: &Start<S::State>,
        longest: f64,
        evaluator: &mut Evaluator<S>,
    ) -> Taken<S::State> {
        let length = self.interval.min(longest);
        let predicted = start.state.advanced([length], [&start.slope]);
        let slope = evaluator.slope(&predicted);
        let half = 0.5 * length;
        let state = start.state.advanced([half, half], [&start.slope, &slope]);
        Taken { length, state }
    }
}
