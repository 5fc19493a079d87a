//! Coefficients for the equations of motion.

use crate::lanes::{Lanes, PerLane};
use crate::leg_pieces::LegPieces;
use crate::per_leg::PerLeg;
use crate::scalar::Real;
use crate::strut::StrutPiece;
use crate::thrust::ThrustLine;

/// Elements of a leg that press, in any lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressed {
    /// A footpad on the surface.
    pub(super) pads: bool,
    /// A block on the surface.
    pub(super) blocks: bool,
    /// A footpad on a stop of its hinge.
    pub(super) stops: bool,
    /// A footpad or a block that pushes soil aside.
    pub(super) drag: bool,
}

impl Pressed {
    /// Those pressed by these coefficients.
    #[inline(always)]
    pub(super) fn of<S: Real>(legs: &LegPieces<S>) -> Self {
        let [outer, inner] = &legs.pad;
        Self {
            pads: !(outer.is_slack() && inner.is_slack() && legs.edge.load.is_slack()),
            blocks: !legs.block.is_slack(),
            stops: legs.hinge.is_pressed(),
            drag: outer.has_drag() || inner.has_drag() || legs.block.has_drag(),
        }
    }
}

/// Active coefficients of a leg.
#[derive(Debug, Clone, Copy)]
pub(super) struct ActivePieces<S> {
    pub(super) leg: LegPieces<S>,
    pub(super) pressed: Pressed,
}

impl<S: Real> ActivePieces<S> {
    fn new(leg: LegPieces<S>) -> Self {
        Self {
            pressed: Pressed::of(&leg),
            leg,
        }
    }
}

/// Active coefficients of all legs.
#[derive(Debug, Clone, Copy)]
pub struct Pieces<S> {
    legs: PerLeg<ActivePieces<S>>,
    thrust: ThrustLine<S>,
}

impl<S: Real> Pieces<S> {
    /// Returns whether any pad presses on a stop.
    #[inline(always)]
    pub fn press_stops(&self) -> bool {
        self.legs.iter().any(|leg| leg.pressed.stops)
    }

    /// Returns whether any pad is on its edge.
    #[inline(always)]
    pub fn has_edges(&self) -> bool {
        !self.legs.iter().all(|leg| leg.leg.edge.is_active.is_zero())
    }

    /// Returns whether soil resists any leg by its inertia.
    #[inline(always)]
    pub fn have_drag(&self) -> bool {
        self.legs.iter().any(|leg| leg.pressed.drag)
    }

    /// Strut of leg `leg`.
    #[inline(always)]
    pub fn strut(&self, leg: usize) -> &StrutPiece<S> {
        &self.legs[leg].leg.strut
    }

    /// Thrust of the engine.
    #[inline(always)]
    pub fn thrust(&self) -> &ThrustLine<S> {
        &self.thrust
    }

    /// Leg `leg`.
    #[inline(always)]
    pub(super) fn leg(&self, leg: usize) -> &ActivePieces<S> {
        &self.legs[leg]
    }
}

impl Pieces<f64> {
    /// The coefficients of all legs.
    ///
    /// # Panics
    /// Without a leg, or with more than a vehicle may have.
    pub fn new(legs: &[LegPieces<f64>]) -> Self {
        Self {
            legs: PerLeg::from_fn(legs.len(), |leg| ActivePieces::new(legs[leg])),
            thrust: ThrustLine::none(),
        }
    }

    /// Sets the thrust.
    pub fn set_thrust(&mut self, line: ThrustLine<f64>) {
        self.thrust = line;
    }

    /// Sets the coefficients of leg `leg`.
    pub fn set_leg(&mut self, leg: usize, pieces: &LegPieces<f64>) {
        self.legs[leg] = ActivePieces::new(*pieces);
    }
}

impl<const N: usize> Pieces<Lanes<N>> {
    /// This many legs in the air, in all lanes.
    pub fn absent(legs: usize) -> Self {
        Self {
            legs: PerLeg::same(legs, ActivePieces::new(LegPieces::absent().splat())),
            thrust: ThrustLine::none(),
        }
    }

    /// Puts the coefficients of leg `leg`, and the thrust, into a lane.
    pub fn set_lane(&mut self, lane: usize, leg: usize, pieces: &Pieces<f64>) {
        let ActivePieces { leg: all, pressed } = &mut self.legs[leg];
        pieces.legs[leg].leg.set_lane(all, lane);
        *pressed = Pressed::of(all);
        pieces.thrust.set_lane(&mut self.thrust, lane);
    }
}
