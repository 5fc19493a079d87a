//! The pieces of a leg's laws chosen afresh from a state, for methods that locate no events.

use super::{LegLaws, Sets};
use crate::crush::PressureLine;
use crate::friction::Sliding;
use crate::hinge::Hinge;
use crate::integrator::event::Exit;
use crate::leg_pieces::{EdgePiece, LegPieces};
use crate::outcome::{Failure, Outcome};
use crate::rules::CrushRule;
use crate::signal::{LegSignals, Signal};
use crate::strut::Stance;

/// The pieces that a leg's laws choose at one state.
#[derive(Debug, Clone, Copy)]
pub struct Choice {
    /// Plastic sets after the choice.
    pub sets: Sets,
    /// True if a section of the footpad is in contact.
    pub pad_in_contact: bool,
    /// True if the block is in contact.
    pub block_in_contact: bool,
    stance: Stance,
}

impl Choice {
    /// Returns whether the leg rests on its extension stop on the surface: it is not yet known whether the torque of
    /// the surface pushes the link in.
    pub fn awaits_torque(&self) -> bool {
        self.stance == Stance::Stopped { pushed: false }
    }

    /// Lets the torque of the surface push the link off its stop.
    pub fn push(&mut self, laws: &LegLaws, pieces: &mut LegPieces<f64>) {
        self.stance.cross_torque(Exit::Below);
        pieces.link = self.stance.pieces(&laws.strut, &PressureLine::slack()).1;
    }
}

impl LegLaws {
    /// Writes the pieces that hold at these signals into `pieces`, given the kept `sets` of the elements.
    pub fn choose(
        &self,
        sets: Sets,
        signals: &LegSignals<f64>,
        pieces: &mut LegPieces<f64>,
    ) -> Choice {
        let value = |signal: Signal| signals[signal as usize];
        let driven = |rate: Signal| self.rule == CrushRule::Section || value(rate) >= 0.0;
        let sliding =
            |signal: Signal| Sliding::at(&self.friction, value(signal)).piece(&self.friction);
        let section = |k: usize, signal: Signal| {
            self.pad
                .state_at(sets.pad[k], value(signal), driven(Signal::PivotRate))
        };
        let pad = [
            section(0, Signal::OuterInterference),
            section(1, Signal::InnerInterference),
        ];
        let block = self.block.state_at(
            sets.block,
            value(Signal::BlockInterference),
            driven(Signal::BlockCentreRate),
        );
        let cartridge = self.cartridge.state_at(
            sets.strut,
            value(Signal::Stroke),
            value(Signal::StrokeRate) >= 0.0,
        );
        let pad_in_contact = pad.iter().any(|section| section.in_contact);
        let stance = Stance::at(
            &self.strut,
            pad_in_contact || block.in_contact,
            value(Signal::Stroke),
            value(Signal::LinkRate),
        );
        let hinge = Hinge::at(self.stops, value(Signal::PadTurn), value(Signal::PadRate));
        let (strut, link) = stance.pieces(&self.strut, &cartridge.line);
        *pieces = LegPieces {
            pad: pad.map(|section| section.line),
            edge: EdgePiece::on_face(),
            block: block.line,
            pad_friction: sliding(Signal::PadSliding),
            block_friction: sliding(Signal::BlockSliding),
            strut,
            link,
            hinge: hinge.piece_as_written(self.stops),
        };
        Choice {
            sets: Sets {
                pad: [pad[0].set, pad[1].set],
                block: block.set,
                strut: cartridge.set,
            },
            pad_in_contact,
            block_in_contact: block.in_contact,
            stance,
        }
    }

    /// Outcome of the landing by leg `leg`, if any: bottomed, or its loaded footpad inclined beyond the laws of the
    /// model.
    pub fn end(
        &self,
        leg: usize,
        pieces: &LegPieces<f64>,
        signals: &LegSignals<f64>,
    ) -> Option<Outcome> {
        if signals[Signal::Stroke as usize] > self.strut.bottoming_stroke() {
            return Some(Outcome::Bottomed { leg });
        }
        let loaded = pieces.pad.iter().any(|line| !line.is_slack());
        let inclined = signals[Signal::PadInclination as usize] < self.least_inclination;
        (loaded && inclined).then_some(Outcome::Failure(Failure::PadInclination { leg }))
    }
}
