//! Products of 3×3 matrices and vectors, inlined so that they are compiled for their caller's registers.

use nalgebra::{Matrix3, Vector3};

use crate::scalar::Real;

/// M v.
#[inline(always)]
pub fn times<S: Real>(m: &Matrix3<S>, v: &Vector3<S>) -> Vector3<S> {
    Vector3::new(
        m.m11 * v.x + m.m12 * v.y + m.m13 * v.z,
        m.m21 * v.x + m.m22 * v.y + m.m23 * v.z,
        m.m31 * v.x + m.m32 * v.y + m.m33 * v.z,
    )
}

/// Mᵀ v.
#[inline(always)]
pub fn transposed_times<S: Real>(m: &Matrix3<S>, v: &Vector3<S>) -> Vector3<S> {
    Vector3::new(
        m.m11 * v.x + m.m21 * v.y + m.m31 * v.z,
        m.m12 * v.x + m.m22 * v.y + m.m32 * v.z,
        m.m13 * v.x + m.m23 * v.y + m.m33 * v.z,
    )
}
