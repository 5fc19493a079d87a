//! Pads that press on a stop of their hinge, where the angle α falls behind what α̇ has turned (`hinge`; model chapter 6).
//!
//! The equations of a leg take the angle. Seldom does a pad press on a stop, so that is told here, beside them:
//! before, angles in place of turns, and after, how fast the turns go on.

use super::pieces::GroupPieces;
use super::{Glance, GlancesAbreast, Motion, MotionsAbreast, Pieces, Signal};
use crate::hinge::HingePiece;
use crate::state::{LegState, State};
use crate::wide::Wide;

impl<const LEGS: usize> Motion<LEGS> {
    /// The state with angles in place of turns, if it is another one.
    #[inline(always)]
    pub(super) fn bend(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
    ) -> Option<State<f64, LEGS>> {
        pieces.press_stops().then(|| bent(state, pieces))
    }

    /// Puts right how fast turns go on.
    #[inline(always)]
    pub(super) fn turn(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
        derivative: &mut State<f64, LEGS>,
    ) {
        if pieces.press_stops() {
            turn(state, pieces, derivative);
        }
    }

    /// Puts right what is seen of turns.
    #[inline(always)]
    pub(super) fn tell_turns(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
        signals: &mut Glance<LEGS>,
    ) {
        if pieces.press_stops() {
            for j in 0..LEGS {
                signals.set(j, Signal::PadTurn, state.leg(j).pad_turn);
            }
        }
    }
}

impl<const N: usize, const LEGS: usize> MotionsAbreast<N, LEGS> {
    /// Whether any pad presses on a stop.
    #[inline(always)]
    pub fn press_stops(&self) -> bool {
        press_stops(&self.pieces)
    }

    /// Leg `leg`, the angle of its pad in place of the turn.
    #[inline(always)]
    pub(super) fn bend(&self, leg: usize, state: LegState<Wide<N>>) -> LegState<Wide<N>> {
        let GroupPieces { legs, pressed } = &self.pieces[leg];
        if !pressed.stops {
            return state;
        }
        LegState {
            pad_turn: angle(&legs.hinge, state.pad_turn),
            ..state
        }
    }

    /// Puts right how fast turns go on.
    #[inline(always)]
    pub(super) fn turn(
        &self,
        states: &State<Wide<N>, LEGS>,
        derivatives: &mut State<Wide<N>, LEGS>,
    ) {
        for (leg, GroupPieces { legs, pressed }) in self.pieces.iter().enumerate() {
            if pressed.stops {
                let turning = legs
                    .hinge
                    .turning(derivatives.pad_turn(leg), states.pad_rate(leg));
                derivatives.set_pad_turn(leg, turning);
            }
        }
    }

    /// Puts right what is seen of turns.
    #[inline(always)]
    pub(super) fn tell_turns(
        &self,
        states: &State<Wide<N>, LEGS>,
        glances: &mut GlancesAbreast<N, LEGS>,
    ) {
        for (leg, pieces) in self.pieces.iter().enumerate() {
            if pieces.pressed.stops {
                glances.set(leg, Signal::PadTurn, states.pad_turn(leg));
            }
        }
    }
}

/// Angles of pads that have turned like this, rad.
#[cold]
#[inline(never)]
fn angle<const N: usize>(hinge: &HingePiece<Wide<N>>, turn: Wide<N>) -> Wide<N> {
    hinge.angle(turn)
}

/// Whether any pad presses on a stop.
#[inline(always)]
pub(super) fn press_stops<S>(groups: &[GroupPieces<S>]) -> bool {
    groups.iter().any(|group| group.pressed.stops)
}

#[cold]
#[inline(never)]
fn bent<const LEGS: usize>(state: &State<f64, LEGS>, pieces: &Pieces<LEGS>) -> State<f64, LEGS> {
    let mut bent = *state;
    for (index, group) in pieces.groups.iter().enumerate() {
        let mut legs = state.legs_abreast(index);
        legs.pad_turn = group.legs.hinge.angle(legs.pad_turn);
        bent.set_legs_abreast(index, &legs);
    }
    bent
}

#[cold]
#[inline(never)]
fn turn<const LEGS: usize>(
    state: &State<f64, LEGS>,
    pieces: &Pieces<LEGS>,
    derivative: &mut State<f64, LEGS>,
) {
    for (index, group) in pieces.groups.iter().enumerate() {
        let rate = state.legs_abreast(index).pad_rate;
        let mut legs = derivative.legs_abreast(index);
        legs.pad_turn = group.legs.hinge.turning(legs.pad_turn, rate);
        derivative.set_legs_abreast(index, &legs);
    }
}
