//! When steps are stiff, and the derivatives of the forces there.

use super::step_attempt::Respond;
use crate::motion::{Motion, Pieces};
use crate::registers::{Registers, Single};
use crate::response::Response;
use crate::state::State;

/// Greatest rate of decay times step length above which steps are implicit, at a tolerance of 1e-4: explicit ones
/// would be near their limit of stability. At tighter tolerances accuracy limits steps first, and the explicit method,
/// which has the higher order, is left to do more.
const STIFF: f64 = 2.5;
/// The most that it may be at any tolerance.
const EXPLICIT_LIMIT: f64 = 6.3;
/// Share of the limit below which a step is far from stiff.
const FAR: f64 = 0.5;
/// Steps from one test to the next, unless a law changes, far from the limit and near it.
const STEPS_FAR: u32 = 17;
const STEPS_NEAR: u32 = 4;

/// Whether steps are stiff, tested as seldom as possible.
pub(super) struct Stiffness {
    response: Response<f64>,
    limit: f64,
    /// Explicit steps left until the next test.
    mild_steps: u32,
}

impl Stiffness {
    pub(super) fn new(motion: &Motion<f64>, tolerance: f64) -> Self {
        Self {
            response: motion.response(),
            limit: EXPLICIT_LIMIT.min(STIFF * (1e-4 / tolerance).max(1.0).sqrt().sqrt()),
            mild_steps: 0,
        }
    }

    /// Forgets the last test, as laws have changed.
    pub(super) fn forget(&mut self) {
        self.mild_steps = 0;
    }

    /// Derivatives of the forces where a step was last found to be stiff.
    pub(super) fn response(&self) -> &Response<f64> {
        &self.response
    }

    /// Whether a step of this length (s) from `state` is stiff.
    pub(super) fn exceeds(
        &mut self,
        registers: Single,
        length: f64,
        motion: &Motion<f64>,
        state: &State<f64>,
        pieces: &Pieces<f64>,
    ) -> bool {
        if self.mild_steps > 0 {
            self.mild_steps -= 1;
            return false;
        }
        let rate = registers.dispatch(Respond(motion, state, pieces, &mut self.response));
        self.exceeds_at(rate, length)
    }

    /// The same where no velocity decays faster than at a `rate` (1/s).
    pub(super) fn exceeds_at(&mut self, rate: f64, length: f64) -> bool {
        let stiffness = length * rate / self.limit;
        if stiffness > 1.0 {
            return true;
        }
        let steps = if stiffness < FAR {
            STEPS_FAR
        } else {
            STEPS_NEAR
        };
        self.mild_steps = steps - 1;
        false
    }
}
