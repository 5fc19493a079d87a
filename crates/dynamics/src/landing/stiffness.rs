//! When the damping is stiff over a step, and what it is then.

use crate::damping::{DampedSolve, Damping, Inertia};
use crate::integrator::additive;
use crate::motion::{Motion, Pieces};
use crate::state::State;

/// Rate of decay times step length above which damping is taken implicitly, at a tolerance of
/// 1e-4. At tighter ones accuracy rather than stability limits steps, and the explicit method,
/// which has the higher order, is left to do more.
const STIFF: f64 = 2.5;
/// The most that it may be at any tolerance: explicit steps are then at their own limit of stability, and
/// would linger there while feet stick.
const EXPLICIT_LIMIT: f64 = 6.3;
/// Share of the limit below which so many more steps are taken before looking at the damping again,
/// unless a law changes.
const FAR_FROM_STIFF: f64 = 0.5;
const MILD_STEPS: u32 = 16;
/// Steps that one matrix serves unless a law changes: a step's order does not depend on how exact
/// it is.
const USES: u32 = 4;
/// Times the limit beyond which every step has a matrix of its own: the error estimate leaves out what
/// the damping kills, and what it kills that strongly has to be what there is.
const KEPT_UP_TO: f64 = 4.0;

/// The damping as steps see it: looked at as seldom as it may be.
pub(super) struct Stiffness<const LEGS: usize> {
    inertia: Inertia<f64, LEGS>,
    /// Rate of decay times step length above which damping is taken implicitly.
    limit: f64,
    /// Steps to come before the damping is looked at.
    mild_steps: u32,
    /// The damping when last looked at, and the steps it still serves.
    kept: Option<(Damping<f64, LEGS>, u32)>,
}

impl<const LEGS: usize> Stiffness<LEGS> {
    pub(super) fn new(motion: &Motion<LEGS>, tolerance: f64) -> Self {
        Self {
            inertia: motion.inertia(),
            limit: EXPLICIT_LIMIT.min(STIFF * (1e-4 / tolerance).max(1.0).sqrt().sqrt()),
            mild_steps: 0,
            kept: None,
        }
    }

    /// Takes note of a change of laws.
    pub(super) fn forget(&mut self) {
        self.mild_steps = 0;
        self.kept = None;
    }

    /// The damping over a step of this length (s) from `state`, if it is stiff.
    pub(super) fn over(
        &mut self,
        length: f64,
        motion: &Motion<LEGS>,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
    ) -> Option<DampedSolve<f64, LEGS>> {
        if self.mild_steps > 0 {
            self.mild_steps -= 1;
            return None;
        }
        let (damping, uses) = match &mut self.kept {
            Some((damping, uses)) if *uses > 0 => (damping, uses),
            kept => {
                let (damping, uses) = kept.insert((motion.damping(state, pieces), USES));
                (damping, uses)
            }
        };
        *uses -= 1;
        let stiffness = length * damping.greatest_rate(&self.inertia) / self.limit;
        if stiffness < FAR_FROM_STIFF {
            self.mild_steps = MILD_STEPS;
        }
        if !(FAR_FROM_STIFF..KEPT_UP_TO).contains(&stiffness) {
            *uses = 0;
        }
        (stiffness > 1.0).then(|| damping.factor(&self.inertia, additive::GAMMA * length))
    }
}
