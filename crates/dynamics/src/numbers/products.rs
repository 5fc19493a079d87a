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

/// M N.
#[inline(always)]
pub fn product<S: Real>(m: &Matrix3<S>, n: &Matrix3<S>) -> Matrix3<S> {
    let mut product = *n;
    for k in 0..3 {
        let column = times(m, &Vector3::new(n[(0, k)], n[(1, k)], n[(2, k)]));
        product.set_column(k, &column);
    }
    product
}

/// v wᵀ.
#[inline(always)]
pub fn outer<S: Real>(v: &Vector3<S>, w: &Vector3<S>) -> Matrix3<S> {
    Matrix3::from_columns(&[v * w.x, v * w.y, v * w.z])
}

/// The matrix by which v × w is that times w.
#[inline(always)]
pub fn cross_matrix<S: Real>(v: &Vector3<S>) -> Matrix3<S> {
    let zero = S::zero();
    Matrix3::new(zero, -v.z, v.y, v.z, zero, -v.x, -v.y, v.x, zero)
}

/// M⁻¹; not finite where M is singular.
#[inline(always)]
pub fn inverse<S: Real>(m: &Matrix3<S>) -> Matrix3<S> {
    let first = Vector3::new(m.m11, m.m12, m.m13);
    let second = Vector3::new(m.m21, m.m22, m.m23);
    let third = Vector3::new(m.m31, m.m32, m.m33);
    let column = second.cross(&third);
    let scale = S::one() / first.dot(&column);
    Matrix3::from_columns(&[
        column * scale,
        third.cross(&first) * scale,
        first.cross(&second) * scale,
    ])
}
