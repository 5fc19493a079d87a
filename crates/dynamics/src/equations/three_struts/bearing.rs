//! Friction of the bearings on which the piston of a primary strut slides in its cylinder (docs/model.md, "Bearings of a
//! cantilever's primary strut").
//!
//! Secondary struts that end at a collar of the cylinder push the foot sideways by a load T. The piston passes it to the
//! cylinder at two bearings: the lower one, at the end of the cylinder, bears T (1 + e/d), the upper one T e/d, with the
//! overhang e of the foot and the overlap d of the bearings. Friction is μ T (1 + 2 e/d) against the stroke, and fades
//! out where the strut stands still.

use nalgebra::Vector3;

use crate::lanes::per_lane;
use crate::scalar::Real;
use crate::three_struts::{Arrangement, ThreeStrutDesign};

/// Rate of the stroke at which friction is 1/√2 of what it becomes, ft/s.
const FADING: f64 = 0.05;
/// The floor only keeps 0/0 out, lb².
const LEAST_SQUARE: f64 = 1e-30;

/// The bearings of one leg, or of a group of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bearings<S> {
    friction: S,
    /// Overhang of the foot and overlap of the bearings at rest, ft.
    overhang: S,
    overlap: S,
}

per_lane!(Bearings {
    friction,
    overhang,
    overlap,
});

/// Friction of bearings at one instant.
#[derive(Debug, Clone, Copy)]
pub(super) struct BearingFriction<S> {
    /// Load on the strut against its stroke, lb.
    pub(super) load: S,
    /// Change of that load with the rate of the stroke, lb·s/ft.
    pub(super) damping: S,
    /// Change of that load with the force that pushes the foot sideways, vehicle axes.
    pub(super) by_side_force: Vector3<S>,
}

impl Bearings<f64> {
    pub(super) fn new(design: &ThreeStrutDesign) -> Self {
        match design.arrangement {
            Arrangement::Cantilever(telescope) if telescope.bearing_friction > 0.0 => Self {
                friction: telescope.bearing_friction,
                overhang: telescope.bearing_overhang,
                overlap: telescope.bearing_overlap,
            },
            _ => Self {
                friction: 0.0,
                overhang: 0.0,
                overlap: f64::INFINITY,
            },
        }
    }
}

impl<S: Real> Bearings<S> {
    /// Friction per lateral load at a stroke (ft) and its rate (ft/s), and the change with that rate (s/ft).
    #[inline(always)]
    fn per_side_load(&self, stroke: S, rate: S) -> [S; 2] {
        let lever = (self.overhang - stroke) / (self.overlap + stroke);
        let full = self.friction * (S::one() + lever + lever);
        let fading = S::constant(FADING * FADING);
        let squared = rate * rate + fading;
        let per_speed = full / squared.sqrt();
        [per_speed * rate, per_speed * fading / squared]
    }

    /// Friction at a stroke (ft) and its rate (ft/s) under this force on the foot across the strut (vehicle axes, lb).
    #[inline(always)]
    pub(super) fn friction(&self, stroke: S, rate: S, across: &Vector3<S>) -> BearingFriction<S> {
        let [share, change] = self.per_side_load(stroke, rate);
        let side_load = across.dot(across).max(S::constant(LEAST_SQUARE)).sqrt();
        BearingFriction {
            load: share * side_load,
            damping: change * side_load,
            by_side_force: across * (share / side_load),
        }
    }

    /// Upper limit of the damping at a stroke (ft) and its rate (ft/s) under forces across the strut that sum up to this, lb·s/ft.
    #[inline(always)]
    pub(super) fn greatest_damping(&self, stroke: S, rate: S, across: S) -> S {
        self.per_side_load(stroke, rate)[1] * across
    }
}
