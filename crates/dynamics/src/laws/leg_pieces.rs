//! Coefficients of all laws of a leg, for the equations of motion.

use crate::crush::PressureLine;
use crate::friction::FrictionPiece;
use crate::hinge::HingePiece;
use crate::lanes::per_lane;
use crate::strut::{LinkPiece, StrutPiece};

/// Coefficients of the active piece of every law of one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegPieces<S> {
    /// Pressure on the outboard and inboard pad sections.
    pub pad: [PressureLine<S>; 2],
    /// Edge of the footpad.
    pub edge: EdgePiece<S>,
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

/// A footpad's edge.
#[derive(Debug, Clone, Copy)]
pub struct EdgePiece<S> {
    /// Load (lb) against its depth below the surface (ft).
    pub load: PressureLine<S>,
    /// 1 if the footpad is on its edge, 0 on its face.
    pub is_active: S,
}

per_lane!(EdgePiece { load, is_active });

impl EdgePiece<f64> {
    /// A footpad on its face.
    pub fn on_face() -> Self {
        Self {
            load: PressureLine::slack(),
            is_active: 0.0,
        }
    }
}

per_lane!(LegPieces {
    pad,
    edge,
    block,
    pad_friction,
    block_friction,
    strut,
    link,
    hinge,
});

impl LegPieces<f64> {
    /// An absent leg, which neither pushes nor moves.
    pub fn absent() -> Self {
        Self {
            pad: [PressureLine::slack(); 2],
            edge: EdgePiece::on_face(),
            block: PressureLine::slack(),
            pad_friction: FrictionPiece::none(),
            block_friction: FrictionPiece::none(),
            strut: StrutPiece::slack(),
            link: LinkPiece::still(),
            hinge: HingePiece::still(),
        }
    }
}
