//! Test for stiff steps.

use crate::friction::FrictionLaw;
use crate::rules::ContactRule;
use crate::scene::Settings;

/// Greatest rate of decay times step length above which steps are implicit, at a tolerance of 1e-4: explicit steps
/// would be near their stability limit. At tighter tolerances accuracy limits steps first, and more are left to the
/// explicit method, which has the higher order.
const STIFF: f64 = 2.5;
/// Greatest value of that limit at any tolerance. The rate is the sum of all.
const EXPLICIT_LIMIT: f64 = 6.3;
/// Share of the limit below which a step is far from stiff.
const FAR: f64 = 0.5;
/// Steps between tests, unless a law changes, far from the limit and near it.
const STEPS_FAR: u32 = 17;
const STEPS_NEAR: u32 = 4;

/// Stiffness test, made as seldom as possible.
pub(super) struct Stiffness {
    limit: f64,
    /// Explicit steps left until the next test.
    mild_steps: u32,
}

impl Stiffness {
    pub(super) fn new(settings: &Settings, contact: ContactRule, friction: &FrictionLaw) -> Self {
        let tolerance = settings.tolerance();
        // One rate is nearly all of the sum where friction sets in faster than that of 1966, or slows a light pad in its
        // hinge. Explicit steps would be held at their stability limit and never be found stiff.
        let is_one_rate = contact == ContactRule::Face || *friction != FrictionLaw::default();
        let most = if is_one_rate { STIFF } else { EXPLICIT_LIMIT };
        Self {
            limit: most.min(STIFF * (1e-4 / tolerance).max(1.0).sqrt().sqrt()),
            mild_steps: 0,
        }
    }

    /// Forgets the last test, as laws have changed.
    pub(super) fn forget(&mut self) {
        self.mild_steps = 0;
    }

    /// Returns whether the next explicit step is known not to be stiff, from a test a few steps ago.
    pub(super) fn is_known_mild(&mut self) -> bool {
        let is_mild = self.mild_steps > 0;
        self.mild_steps = self.mild_steps.saturating_sub(1);
        is_mild
    }

    /// Returns whether a step of this length (s) is stiff. No velocity decays faster than at `rate` (1/s).
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
