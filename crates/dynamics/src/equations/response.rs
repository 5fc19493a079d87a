//! Derivatives of the forces with respect to the motion, and (`stage`) the linear equations of an implicit step.
//!
//! The motion is stiff through few quantities: a foot stuck by friction resists sliding (at rates of thousands per
//! second, model chapter 5), an element pressed into the surface resists going deeper, a strut resists stroking.
//! Derivatives describe their forces. The rest (attitude factors, levers of the body, gyroscopic torques) changes
//! slowly, and the stages of a step take it as it is.

mod factors;
mod stage;

use nalgebra::{Matrix3, Vector4, Vector6};

use crate::per_leg::PerLeg;
use crate::scalar::Real;

pub use factors::Factors;
pub use stage::System;
pub(super) use stage::turn;

/// A small change of displacements or velocities of the body and one leg, or forces on them.
#[derive(Debug, Clone, Copy)]
pub struct Coordinates<S> {
    /// Translation (ft), then rotation (rad) of the body, vehicle axes.
    pub body: Vector6<S>,
    /// Angle of the lower link, rad.
    pub link: S,
    /// Pad: of displacements the angle α, rad; of velocities and forces those of the pad against the link.
    pub pad: S,
}

impl<S: Real> Coordinates<S> {
    /// No change.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            body: none(),
            link: S::zero(),
            pad: S::zero(),
        }
    }

    /// Scalar product with changes of body, link and pad.
    #[inline(always)]
    fn dot(&self, body: &Vector6<S>, link: S, pad: S) -> S {
        product(&self.body, body) + self.link * link + self.pad * pad
    }

    /// Adds factor · other.
    #[inline(always)]
    pub fn add(&mut self, factor: S, other: &Self) {
        self.body += other.body * factor;
        self.link += factor * other.link;
        self.pad += factor * other.pad;
    }
}

/// Forces per unit of one quantity: sliding in one direction, or an interference.
#[derive(Debug, Clone, Copy)]
pub struct ForceDerivative<S> {
    /// Forces per unit of the quantity.
    pub force: Coordinates<S>,
    /// The quantity per velocity.
    pub velocity: Coordinates<S>,
    /// The quantity per displacement.
    pub displacement: Coordinates<S>,
}

impl<S: Real> ForceDerivative<S> {
    /// No force.
    #[inline(always)]
    pub fn none() -> Self {
        Self {
            force: Coordinates::zero(),
            velocity: Coordinates::zero(),
            displacement: Coordinates::zero(),
        }
    }
}

/// Most derivatives of forces on a leg.
const MOST: usize = 12;

/// Derivatives of the forces on one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegResponse<S> {
    /// Those of pad and block with respect to sliding along and across, to interference and, on soil with drag, to its rate (of
    /// each section by itself if it acts at its face), and of a damped hinge. Pads or blocks that carry no pressure in any lane
    /// are left out.
    derivatives: [ForceDerivative<S>; MOST],
    count: usize,
    /// Further torque on the link per displacement, ft·lb.
    pub link_torque: Coordinates<S>,
    /// Further torque on the pad's hinge per displacement, ft·lb.
    pub hinge_torque: Coordinates<S>,
    /// Torque against the link per link rate, ft·lb·s.
    pub link_damping: S,
    /// dγ/dt per link rate: 1, or 0 for a frozen link.
    pub link_moves: S,
    /// Change of the pad's turn per α̇ and time, and of α per turn: beyond a stop α falls behind.
    pub pad_turn: [S; 2],
    /// Speed of the hinge before its clip per α̇: 0 for a pad at rest on a stop.
    pub hinge_gain: S,
    /// Share of the error of the pad's rate that counts.
    pub pad_error_share: S,
    /// True if any pad of the group is not at rest on a stop.
    pub swings_pads: bool,
    /// Inertia of link and pad, slug·ft².
    pub inertia: [S; 2],
}

impl<S: Real> LegResponse<S> {
    /// A leg without forces.
    pub fn none() -> Self {
        let zero = S::zero();
        Self {
            derivatives: [ForceDerivative::none(); MOST],
            count: 0,
            link_torque: Coordinates::zero(),
            hinge_torque: Coordinates::zero(),
            link_damping: zero,
            link_moves: zero,
            pad_turn: [zero; 2],
            hinge_gain: zero,
            pad_error_share: S::one(),
            swings_pads: false,
            inertia: [S::one(); 2],
        }
    }

    /// Removes all derivatives and torques.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.count = 0;
        self.link_torque = Coordinates::zero();
        self.hinge_torque = Coordinates::zero();
    }

    /// Adds a derivative.
    #[inline(always)]
    pub fn push(&mut self, derivative: &ForceDerivative<S>) {
        self.derivatives[self.count] = *derivative;
        self.count += 1;
    }

    /// The derivatives.
    #[inline(always)]
    fn derivatives(&self) -> &[ForceDerivative<S>] {
        &self.derivatives[..self.count]
    }
}

/// Derivatives of all forces at one state.
#[derive(Debug, Clone, Copy)]
pub struct Response<S> {
    /// Attitude B, vehicle to ground.
    pub rotation: Matrix3<S>,
    /// Its quaternion (w, x, y, z), of any length.
    pub quaternion: Vector4<S>,
    /// Mass, slug.
    pub mass: S,
    /// Inertia of the body about the CG, slug·ft².
    pub inertia: Matrix3<S>,
    /// The legs.
    pub legs: PerLeg<LegResponse<S>>,
}

impl<S: Real> Response<S> {
    /// Upper bound of the decay rates of velocities, 1/s ([`crate::motion::Motion::greatest_decay`]).
    #[inline(always)]
    pub fn greatest_decay(&self) -> S {
        let per_body = inverse_inertias(self.mass, &self.inertia);
        let mut greatest = S::zero();
        for leg in &self.legs {
            let per_leg = leg.inertia.map(|inertia| S::one() / inertia);
            let [per_link, _] = per_leg;
            let mut decay = leg.link_damping.max(S::zero()) * per_link;
            for ForceDerivative {
                force, velocity, ..
            } in leg.derivatives()
            {
                decay += greatest_decay(force, velocity, &per_body, per_leg);
            }
            greatest += decay;
        }
        greatest
    }
}

/// Inverses of mass and moments of inertia of a body, for its six coordinates.
#[inline(always)]
pub fn inverse_inertias<S: Real>(mass: S, inertia: &Matrix3<S>) -> [S; 6] {
    let mut inverses = [mass; 6];
    for i in 0..3 {
        inverses[3 + i] = inertia[(i, i)];
    }
    for inverse in &mut inverses {
        *inverse = S::one() / *inverse;
    }
    inverses
}

/// Upper bound of the decay rates of velocities (1/s) by a force that grows with that `velocity`, with these inverses
/// of the inertias of body, link and pad.
#[inline(always)]
pub fn greatest_decay<S: Real>(
    force: &Coordinates<S>,
    velocity: &Coordinates<S>,
    per_body: &[S; 6],
    [per_link, per_pad]: [S; 2],
) -> S {
    let on_pad = force.pad * velocity.pad * per_pad;
    let mut growth = force.link * velocity.link * per_link + on_pad;
    for (i, &per_body) in per_body.iter().enumerate() {
        S::keep_rounds_apart();
        growth += force.body[i] * velocity.body[i] * per_body;
    }
    (-growth).max(S::zero())
}

/// Scalar product.
#[inline(always)]
fn product<S: Real>(a: &Vector6<S>, b: &Vector6<S>) -> S {
    (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]) + (a[4] * b[4] + a[5] * b[5])
}

/// Zero vector.
#[inline(always)]
fn none<S: Real>() -> Vector6<S> {
    Vector6::from([S::zero(); 6])
}
