//! Changes of a law's active piece, and the laws in force from then on.

use super::trajectory::Trajectory;
use super::within::{Between, Look};
use crate::contact::LegMode;
use crate::integrator::cubic::{Prediction, StepEnds};
use crate::integrator::event::{Guard, Sample, first_exit};
use crate::motion::{Signal, Signals};
use crate::outcome::{Failure, Outcome};

/// Law changes at one instant that count as chattering.
pub(super) const MOST_CHANGES: usize = 64;

impl Trajectory<'_> {
    /// Finds the first fraction of the step at which a law changes its active piece, and the one of the `buffers` with
    /// the signals there.
    #[inline(always)]
    pub(super) fn find_event(&mut self) -> Option<(f64, usize)> {
        let [before, start, end] = [
            self.signals.previous(),
            self.signals.start(),
            self.signals.end(),
        ];
        let (registers, length) = (self.registers, self.step.length);
        let suspects = &mut self.suspects;
        if let Some(earlier) = &self.earlier
            && (self.ranges).keep(
                [before, start, end],
                length / earlier.length,
                length,
                suspects,
            )
        {
            return None;
        }
        let within = Look {
            motion: &self.motion,
            pieces: &self.pieces,
            between: Between {
                step: &self.step,
                free: self.free.as_ref(),
            },
        };
        let mut looks = 0;
        let mut look = |theta: f64, signals: &mut Signals<f64>| {
            looks += 1;
            within.at(registers, theta, &mut self.within, signals);
        };
        let resolution = self.event_resolution / length;
        let is_explicit = !self.is_middle_seen;
        let predict = |suspects: &[Guard]| {
            if is_explicit {
                StepEnds::new([start, end], length, suspects).prediction()
            } else {
                Prediction::Doubtful
            }
        };
        // No earlier step shows how signals bend under new laws, so the middle has to be evaluated.
        let are_laws_new = self.earlier.is_none();
        let mut prediction = if are_laws_new {
            Prediction::Doubtful
        } else {
            predict(suspects)
        };
        if prediction == Prediction::Doubtful {
            if is_explicit {
                look(0.5, &mut self.middle);
                self.is_middle_seen = true;
            }
            (self.ranges).guard_suspects([start, &self.middle, end], suspects);
            if are_laws_new {
                prediction = predict(suspects);
            }
        }
        let found = match prediction {
            Prediction::Stays => None,
            Prediction::Leaves => {
                let ends = StepEnds::new([start, end], length, suspects);
                Some(ends.exit(resolution, &mut self.buffers, &mut look))
            }
            Prediction::Doubtful => {
                let seen = |theta, signals| Sample { theta, signals };
                let looks = [seen(0.0, start), seen(0.5, &self.middle), seen(1.0, end)];
                first_exit(looks, suspects, resolution, &mut self.buffers, &mut look)
            }
        };
        self.evaluations += looks;
        found
    }

    /// Sets the laws that hold from the present state on. One change can bring another, so this repeats until every
    /// signal lies in its range.
    pub(super) fn settle(&mut self) -> Result<(), Outcome> {
        for _ in 0..MOST_CHANGES {
            self.evaluate();
            self.note_contacts();
            if !self.cross()? {
                return Ok(());
            }
        }
        Err(Outcome::Failure(Failure::Chattering))
    }

    /// Refuses a leg's own ground that reaches into the body at first contact.
    pub(super) fn refuse_ground_in_body(&self) -> Result<(), Outcome> {
        let signals = self.signals.start();
        let is_inside = |&leg: &usize| {
            self.motion.has_ground_of_its_own(leg) && signals.of(leg, Signal::HardpointDepth) > 0.0
        };
        match (0..self.leg_count()).find(is_inside) {
            Some(leg) => Err(Outcome::Failure(Failure::GroundInBody { leg })),
            None => Ok(()),
        }
    }

    /// Recentres the coefficients of laws that bend gently; the laws themselves stay.
    #[inline(always)]
    pub(super) fn follow(&mut self) {
        for j in 0..self.leg_count() {
            let stroke = self.signals.start().of(j, Signal::Stroke);
            if self.modes[j].follow(&self.laws[j], stroke) {
                self.choose_pieces(j);
            }
        }
    }

    /// Sets pieces and ranges of leg `j` for its present mode.
    fn choose_pieces(&mut self, j: usize) {
        let (mode, laws) = (&self.modes[j], &self.laws[j]);
        self.pieces.set_leg(j, &mode.pieces(laws));
        self.changes[j] += 1;
        self.ranges.set(j, &mode.ranges(laws));
        self.stiffness.forget();
    }

    /// Takes each leg past the first of its signals that is out of range. Returns whether any was. Only the first,
    /// because the ranges of the others change with it.
    pub(super) fn cross(&mut self) -> Result<bool, Outcome> {
        let signals = self.signals.start();
        let exits = self.ranges.exits(signals);
        for (leg, exit) in exits.iter().enumerate() {
            if let Some((signal, exit)) = *exit {
                self.events += 1;
                let laws = &self.laws[leg];
                let signals = *self.signals.start().leg(leg);
                let before = self.modes[leg];
                self.modes[leg].cross(laws, leg, signal, exit, &signals)?;
                self.turn_pad(leg, &before);
                self.stop_link(leg);
                self.choose_pieces(leg);
            }
        }
        Ok(exits.iter().any(Option::is_some))
    }

    /// Restates the turn of a pad whose hinge has changed its mode. A pad that reached a stop goes on with its link.
    fn turn_pad(&mut self, leg: usize, before: &LegMode) {
        let (mode, laws) = (&self.modes[leg], &self.laws[leg]);
        if !mode.has_other_hinge(before) {
            return;
        }
        let mut state = self.step.before.leg(leg);
        state.pad_turn = mode.pad_turn(laws, before.pad_angle(laws, state.pad_turn));
        if mode.pad_is_on_stop() {
            let link_is_free = mode.pieces(laws).link.free != 0.0;
            self.motion.stop_pad(leg, link_is_free, &mut state);
        }
        self.step.before.set_leg(leg, &state);
    }

    /// Ends the rate of a link that has arrived at its extension stop.
    fn stop_link(&mut self, leg: usize) {
        let mode = &self.modes[leg];
        if !mode.is_held_by_stop(&self.laws[leg]) {
            return;
        }
        let mut state = self.step.before.leg(leg);
        if state.link_rate > 0.0 {
            let pad_swings = !mode.pad_is_on_stop();
            self.motion.stop_link(leg, pad_swings, &mut state);
            self.step.before.set_leg(leg, &state);
        }
    }

    fn note_contacts(&mut self) {
        for j in 0..self.leg_count() {
            if self.modes[j].pad_in_contact() {
                self.pad_contact[j].get_or_insert(self.time);
            }
            if self.modes[j].block_in_contact() {
                self.block_contact[j].get_or_insert(self.time);
            }
        }
    }
}
