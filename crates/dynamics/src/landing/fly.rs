//! Free flight, step by step: where it leads is known, so steps only have to show what happens on the way.

use std::ops::Deref;

use super::{Course, Flight};
use crate::contact::LegMode;
use crate::integrator::step_control::{LONGEST, SHORTEST};
use crate::outcome::{Failure, Outcome};
use crate::record::Instant;
use crate::vehicle::Vehicle;

/// How far the body turns in a step, rad, over the fourth root of the tolerance: the cubics through the depths of its feet at
/// both ends are then right to about half of the tolerance.
const TURN: f64 = 2.0;

impl<V, O, const LEGS: usize> Flight<V, O, LEGS>
where
    V: Deref<Target = Vehicle<LEGS>>,
    O: FnMut(&Instant<LEGS>),
{
    /// Flies while all legs hang in the air; whether they did.
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    #[inline(always)]
    pub(super) fn fly(&mut self, course: &mut Course<LEGS>) -> Result<bool, Outcome> {
        let mut flew = false;
        while self.modes.iter().all(LegMode::is_hanging) {
            flew = true;
            self.fly_on(course)?;
        }
        Ok(flew)
    }

    /// A step of free flight.
    #[cold]
    #[inline(never)]
    fn fly_on(&mut self, course: &mut Course<LEGS>) -> Result<(), Outcome> {
        let left = self.time_left(course)?;
        let flight = (self.motion).free_flight(&self.step.before, &self.pieces);
        let turn = TURN * self.settings.tolerance().sqrt().sqrt();
        let longest = LONGEST
            .min(turn / self.step.before.body().rate.norm())
            .min(self.longest_step());
        let length = flight.reach(longest).min(left);
        if length < SHORTEST {
            return Err(Outcome::Failure(Failure::StepCollapse));
        }
        self.step.length = length;
        flight.write(length, &mut self.step.after);
        self.free = Some(flight);
        self.kinks = [None; LEGS];
        self.is_middle_seen = false;
        self.evaluate_end();
        let ended = self.go_on(course);
        self.free = None;
        ended.map(|_| ())
    }
}
