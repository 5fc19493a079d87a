//! The coefficients that the equations of motion work with.

use super::stops::press_stops;
use crate::crush::PressureLine;
use crate::friction::FrictionPiece;
use crate::hinge::HingePiece;
use crate::quad::{GROUPS, LANES, Quad};
use crate::scalar::Real;
use crate::strut::{LinkPiece, StrutPiece};
use crate::wide::{Abreast, abreast};

/// Coefficients of the active piece of every law of one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegPieces<S> {
    /// Pressure on the outboard and inboard pad sections.
    pub pad: [PressureLine<S>; 2],
    /// Pressure on the block.
    pub block: PressureLine<S>,
    /// Friction under the pad.
    pub pad_friction: FrictionPiece<S>,
    /// Friction under the block.
    pub block_friction: FrictionPiece<S>,
    /// Shock absorber.
    pub strut: StrutPiece<S>,
    /// Lower link.
    pub link: LinkPiece<S>,
    /// Footpad hinge.
    pub hinge: HingePiece<S>,
}

abreast!(LegPieces {
    pad,
    block,
    pad_friction,
    block_friction,
    strut,
    link,
    hinge,
});

impl LegPieces<f64> {
    /// Of a leg that is not there: it neither pushes nor moves.
    pub(super) fn absent() -> Self {
        Self {
            pad: [PressureLine::slack(); 2],
            block: PressureLine::slack(),
            pad_friction: FrictionPiece::none(),
            block_friction: FrictionPiece::none(),
            strut: StrutPiece::slack(),
            link: LinkPiece::still(),
            hinge: HingePiece::still(),
        }
    }
}

/// What presses on any leg of a group.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressed {
    /// A footpad on the surface.
    pub(super) pads: bool,
    /// A block on the surface.
    pub(super) blocks: bool,
    /// A footpad on a stop of its hinge.
    pub(super) stops: bool,
}

impl Pressed {
    /// Of the legs with these coefficients.
    #[inline(always)]
    pub(super) fn of<S: Real>(legs: &LegPieces<S>) -> Self {
        let [outer, inner] = &legs.pad;
        Self {
            pads: !(outer.is_slack() && inner.is_slack()),
            blocks: !legs.block.is_slack(),
            stops: legs.hinge.is_pressed(),
        }
    }
}

/// Coefficients of a group of legs, side by side.
#[derive(Debug, Clone, Copy)]
pub(super) struct GroupPieces<S> {
    pub(super) legs: LegPieces<S>,
    pub(super) pressed: Pressed,
}

impl<S: Real> GroupPieces<S> {
    pub(super) fn new(legs: LegPieces<S>) -> Self {
        Self {
            pressed: Pressed::of(&legs),
            legs,
        }
    }
}

/// Coefficients of all legs, side by side.
#[derive(Debug, Clone, Copy)]
pub struct Pieces<const LEGS: usize> {
    /// As many groups as there can be; lanes beyond the last leg hold none.
    pub(super) groups: [GroupPieces<Quad>; GROUPS],
}

impl<const LEGS: usize> Pieces<LEGS> {
    /// Lays the coefficients of the legs side by side. Lanes beyond the last leg hold none.
    pub fn new(legs: &[LegPieces<f64>; LEGS]) -> Self {
        let absent = GroupPieces::new(LegPieces::absent().shared());
        let mut pieces = Self {
            groups: [absent; GROUPS],
        };
        for (j, leg) in legs.iter().enumerate() {
            pieces.set_leg(j, leg);
        }
        pieces
    }

    /// Sets the coefficients of leg `leg`.
    pub fn set_leg(&mut self, leg: usize, pieces: &LegPieces<f64>) {
        let GroupPieces { legs, pressed } = &mut self.groups[leg / LANES];
        pieces.set_lane(legs, leg % LANES);
        *pressed = Pressed::of(legs);
    }

    /// Whether any pad presses on a stop.
    #[inline(always)]
    pub(super) fn press_stops(&self) -> bool {
        press_stops(&self.groups)
    }

    /// The coefficients of leg `leg`.
    pub(super) fn leg(&self, leg: usize) -> LegPieces<f64> {
        LegPieces::lane(&self.groups[leg / LANES].legs, leg % LANES)
    }
}
