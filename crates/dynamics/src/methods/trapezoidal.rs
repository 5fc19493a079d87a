//! The trapezoidal method at a fixed interval: Euler's prediction, corrected once by the mean of
//! the slopes at both ends.

use super::system::{Evaluator, Start, Stepper, System, Taken, Vector};

/// The method.
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
