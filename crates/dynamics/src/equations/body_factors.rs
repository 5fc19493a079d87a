//! Factors of the six equations of the body that an implicit stage leaves once legs are eliminated.

use nalgebra::{Matrix6, Vector6};

use crate::scalar::Real;

/// L and U in place, with ones on the diagonal of L and the inverse of that of U. Rows keep their order, as mass, inertia and what
/// resists motion stand on the diagonal; should a pivot vanish, numbers are not finite, and the step is refused.
#[derive(Debug, Clone, Copy)]
pub struct BodyFactors<S>(Matrix6<S>);

impl<S: Real> BodyFactors<S> {
    /// Room for factors.
    pub fn none() -> Self {
        Self(Matrix6::from([[S::zero(); 6]; 6]))
    }

    /// Factors a matrix.
    #[inline(always)]
    pub fn of(mut matrix: Matrix6<S>) -> Self {
        for pivot in 0..6 {
            let inverse = S::one() / matrix[(pivot, pivot)];
            matrix[(pivot, pivot)] = inverse;
            for row in pivot + 1..6 {
                matrix[(row, pivot)] *= inverse;
            }
            for column in pivot + 1..6 {
                let above = matrix[(pivot, column)];
                for row in pivot + 1..6 {
                    let product = matrix[(row, pivot)] * above;
                    matrix[(row, column)] -= product;
                }
            }
        }
        Self(matrix)
    }

    /// Puts the solution of the equations in the place of their right sides.
    #[inline(always)]
    pub fn solve(&self, right: &mut Vector6<S>) {
        let Self(factors) = self;
        for column in 0..5 {
            for row in column + 1..6 {
                let product = factors[(row, column)] * right[column];
                right[row] -= product;
            }
        }
        for column in (0..6).rev() {
            right[column] *= factors[(column, column)];
            for row in 0..column {
                let product = factors[(row, column)] * right[column];
                right[row] -= product;
            }
        }
    }
}
