//! When a law changes its active piece, and what holds from then on.

use super::Flight;
use super::advance::Look;
use crate::integrator::event::{Node, Watch, first_exit};
use crate::motion::{LegSignals, Pieces, Signal};
use crate::outcome::{Failure, Outcome};
use crate::record::Instant;

/// Changes of laws at one instant before they are called chattering.
const MOST_CHANGES: usize = 64;

impl<O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'_, O, LEGS> {
    /// The first point of the step at which a law changes its active piece.
    pub(super) fn find_event(&mut self) -> Option<Node<[LegSignals<f64>; LEGS]>> {
        let (before, start, end) = (
            self.signals.before(),
            self.signals.now(),
            self.signals.ahead(),
        );
        let watches = if let Some(earlier) = &self.earlier {
            let ratio = self.step.length / earlier.length;
            let suspect = |watch: &&Watch| !watch.is_quiet(before, start, end, ratio);
            self.suspects.clear();
            self.suspects.extend(self.watches.iter().filter(suspect));
            if self.suspects.is_empty() {
                return None;
            }
            &self.suspects
        } else {
            &self.watches
        };
        let torque = Signal::LinkTorque as usize;
        let with_torques = self
            .watches
            .iter()
            .any(|w| w.signal % Signal::COUNT == torque);
        let mut looks = 0;
        let mut look = |theta: f64| {
            looks += 1;
            self.motion.arch().dispatch(Look {
                motion: &self.motion,
                pieces: &self.pieces,
                step: &self.step,
                theta,
                with_torques,
            })
        };
        let start = Node {
            theta: 0.0,
            signals: *start,
        };
        let middle = Node {
            theta: 0.5,
            signals: look(0.5),
        };
        let resolution = self.event_resolution / self.step.length;
        let end = Node {
            theta: 1.0,
            signals: *end,
        };
        let found = first_exit(&start, &middle, &end, watches, resolution, &mut look);
        self.evaluations += looks;
        found
    }

    /// Puts the laws in place that hold from the present state on. One change can bring another
    /// with it, so this goes on until every signal lies in its range.
    pub(super) fn settle(&mut self) -> Result<(), Outcome> {
        for _ in 0..MOST_CHANGES {
            self.choose_pieces();
            self.evaluate();
            self.note_contacts();
            if !self.cross()? {
                return Ok(());
            }
        }
        Err(Outcome::Failure(Failure::Chattering))
    }

    /// Centres the coefficients of laws that bend gently; the laws themselves stay.
    pub(super) fn follow(&mut self) {
        let mut changed = false;
        for j in 0..LEGS {
            changed |= self.modes[j].follow(&self.laws[j], &self.signals.now()[j]);
        }
        if changed {
            self.choose_pieces();
        }
    }

    /// The pieces and ranges of the present modes.
    fn choose_pieces(&mut self) {
        let pieces = std::array::from_fn(|j| self.modes[j].pieces(&self.laws[j]));
        self.pieces = Pieces::new(&pieces);
        self.stiffness.forget();
        self.watches.clear();
        for j in 0..LEGS {
            self.modes[j].watch(&self.laws[j], j, &mut self.watches);
        }
    }

    /// Lets each leg follow the first of its signals that is out of its range; whether any was.
    /// Only the first, because the ranges of the others may change with it.
    pub(super) fn cross(&mut self) -> Result<bool, Outcome> {
        let mut crossed = [false; LEGS];
        for &Watch { signal, range } in &self.watches {
            let (leg, index) = (signal / Signal::COUNT, signal % Signal::COUNT);
            let Some(exit) = range.exit(self.signals.now()[leg][index]) else {
                continue;
            };
            if !crossed[leg] {
                crossed[leg] = true;
                self.events += 1;
                let signal = Signal::ALL[index];
                self.modes[leg].cross(
                    &self.laws[leg],
                    leg,
                    signal,
                    exit,
                    &self.signals.now()[leg],
                )?;
            }
        }
        Ok(crossed.contains(&true))
    }

    fn note_contacts(&mut self) {
        for j in 0..LEGS {
            if self.modes[j].pad_in_contact() {
                self.pad_contact[j].get_or_insert(self.time);
            }
            if self.modes[j].block_in_contact() {
                self.block_contact[j].get_or_insert(self.time);
            }
        }
    }
}
