//! Points and directions in the plane of a leg, where its geometry lies.

use nalgebra::Vector3;

use crate::scalar::Real;

/// A point in the plane of a leg, relative to the centre, ft.
#[derive(Debug, Clone, Copy)]
pub struct PlanePoint<S> {
    /// Distance from the centreline.
    pub reach: S,
    /// Depth below the centre along the centreline.
    pub drop: S,
}

/// A direction or an offset in the plane of a leg.
#[derive(Debug, Clone, Copy)]
pub struct PlaneDirection<S> {
    /// Component outboard.
    pub(super) outboard: S,
    /// Component along the centreline, down.
    pub(super) down: S,
}

impl<S: Real> PlaneDirection<S> {
    /// Zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            outboard: S::zero(),
            down: S::zero(),
        }
    }

    /// Adds factor · other.
    #[inline(always)]
    pub fn add(&mut self, factor: S, other: &Self) {
        self.outboard += factor * other.outboard;
        self.down += factor * other.down;
    }

    /// Turned by a right angle from outboard to down, as y'' into z''.
    #[inline(always)]
    pub fn turned(&self) -> Self {
        Self {
            outboard: -self.down,
            down: self.outboard,
        }
    }

    /// The direction as a vector in leg axes.
    #[inline(always)]
    pub fn in_leg_axes(&self) -> Vector3<S> {
        Vector3::new(self.outboard, S::zero(), self.down)
    }

    /// Scalar product with a vector in leg axes.
    #[inline(always)]
    pub fn dot(&self, vector: &Vector3<S>) -> S {
        self.outboard * vector.x + self.down * vector.z
    }
}

impl<S: Real> PlanePoint<S> {
    /// The point as a vector in leg axes, ft.
    #[inline(always)]
    pub fn in_leg_axes(&self) -> Vector3<S> {
        Vector3::new(self.reach, S::zero(), self.drop)
    }

    /// Moment about the centre of a force at this point, leg axes, ft·lb.
    #[inline(always)]
    pub fn moment(&self, force: &Vector3<S>) -> Vector3<S> {
        Vector3::new(
            -self.drop * force.y,
            self.drop * force.x - self.reach * force.z,
            self.reach * force.y,
        )
    }
}

/// Motion of an offset (leg axes) as the plane of the leg turns from outboard to down, per rad: its part in that plane,
/// turned by a right angle.
#[inline(always)]
pub fn turned<S: Real>(offset: &Vector3<S>) -> Vector3<S> {
    Vector3::new(-offset.z, S::zero(), offset.x)
}
