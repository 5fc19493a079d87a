//! Numbers side by side, each in a lane of a register.
//!
//! The equations are straight lines of arithmetic, the same for every leg of a vehicle and for every landing, so
//! [`Lanes`] computes them together. Each lane is computed exactly as a single `f64` would be, with the same operations
//! in the same order and none contracted. So a landing comes out the same, bit for bit, whatever the processor's
//! registers and whatever is in the other lanes.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::SMatrix;
use num_traits::{One, Zero};

use crate::scalar::Real;

/// `N` numbers, each in its own lane.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(f))
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

macro_rules! lanewise {
    ($($operator:ident $method:ident $assign:ident $assign_method:ident)*) => {$(
        impl<const N: usize> $operator for Lanes<N> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, $operator::$method)
            }
        }

        impl<const N: usize> $assign for Lanes<N> {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    )*};
}

lanewise! {
    Add add AddAssign add_assign
    Sub sub SubAssign sub_assign
    Mul mul MulAssign mul_assign
    Div div DivAssign div_assign
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

impl<const N: usize> Zero for Lanes<N> {
    #[inline(always)]
    fn zero() -> Self {
        Self([0.0; N])
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<const N: usize> One for Lanes<N> {
    #[inline(always)]
    fn one() -> Self {
        Self([1.0; N])
    }
}

impl<const N: usize> Real for Lanes<N> {
    const LANES: usize = N;

    /// If several rounds are taken together, their numbers are gathered from everywhere, at several times the cost.
    #[inline(always)]
    fn keep_rounds_apart() {
        std::hint::black_box(());
    }

    /// The numbers go through memory. Pairs stay together without that, and run faster.
    #[inline(always)]
    fn keep_lanes_together<T>(numbers: T) -> T {
        if N > 2 {
            std::hint::black_box(numbers)
        } else {
            numbers
        }
    }

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, Real::max)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline(always)]
    fn signed_like(self, magnitude: Self) -> Self {
        self.zip(magnitude, Real::signed_like)
    }

    #[inline(always)]
    fn where_negative(self, below: Self, above: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].where_negative(below.0[i], above.0[i])
        }))
    }

    #[inline(always)]
    fn where_zero(self, at_zero: Self, elsewhere: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].where_zero(at_zero.0[i], elsewhere.0[i])
        }))
    }

    #[inline(always)]
    fn round(self) -> Self {
        self.map(Real::round)
    }

    #[inline(always)]
    fn is_within(self, limit: f64) -> bool {
        self.0
            .iter()
            .fold(true, |within, x| within & (x.abs() <= limit))
    }

    #[cold]
    #[inline(never)]
    fn exp(self) -> Self {
        // Most lanes need no exponential.
        self.map(|x| if x == 0.0 { 1.0 } else { Real::exp(x) })
    }

    #[inline(always)]
    fn by_parity(self, even: Self, odd: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].by_parity(even.0[i], odd.0[i])
        }))
    }
}

/// Types whose numbers can stand side by side in lanes.
pub trait PerLane: Sized {
    /// `N` of them, with their numbers in lanes.
    type Lanes<const N: usize>;

    /// Puts them side by side.
    fn from_lanes<const N: usize>(ones: [&Self; N]) -> Self::Lanes<N>;

    /// The item in a lane.
    fn lane<const N: usize>(wide: &Self::Lanes<N>, lane: usize) -> Self;

    /// Writes itself into a lane.
    fn set_lane<const N: usize>(&self, wide: &mut Self::Lanes<N>, lane: usize);

    /// This item in all lanes.
    #[inline(always)]
    fn splat<const N: usize>(&self) -> Self::Lanes<N> {
        Self::from_lanes([self; N])
    }
}

impl PerLane for f64 {
    type Lanes<const N: usize> = Lanes<N>;

    #[inline(always)]
    fn from_lanes<const N: usize>(ones: [&Self; N]) -> Lanes<N> {
        Lanes(ones.map(|value| *value))
    }

    #[inline(always)]
    fn lane<const N: usize>(wide: &Lanes<N>, lane: usize) -> Self {
        wide.0[lane]
    }

    #[inline(always)]
    fn set_lane<const N: usize>(&self, wide: &mut Lanes<N>, lane: usize) {
        wide.0[lane] = *self;
    }
}

impl<T: PerLane, const M: usize> PerLane for [T; M] {
    type Lanes<const N: usize> = [T::Lanes<N>; M];

    #[inline(always)]
    fn from_lanes<const N: usize>(ones: [&Self; N]) -> Self::Lanes<N> {
        std::array::from_fn(|i| T::from_lanes(ones.map(|values| &values[i])))
    }

    #[inline(always)]
    fn lane<const N: usize>(wide: &Self::Lanes<N>, lane: usize) -> Self {
        std::array::from_fn(|i| T::lane(&wide[i], lane))
    }

    #[inline(always)]
    fn set_lane<const N: usize>(&self, wide: &mut Self::Lanes<N>, lane: usize) {
        for (one, wide) in self.iter().zip(wide) {
            one.set_lane(wide, lane);
        }
    }
}

impl<const R: usize, const C: usize> PerLane for SMatrix<f64, R, C> {
    type Lanes<const N: usize> = SMatrix<Lanes<N>, R, C>;

    #[inline(always)]
    fn from_lanes<const N: usize>(ones: [&Self; N]) -> Self::Lanes<N> {
        SMatrix::from_fn(|row, column| f64::from_lanes(ones.map(|matrix| &matrix[(row, column)])))
    }

    #[inline(always)]
    fn lane<const N: usize>(wide: &Self::Lanes<N>, lane: usize) -> Self {
        wide.map(|component| component.0[lane])
    }

    #[inline(always)]
    fn set_lane<const N: usize>(&self, wide: &mut Self::Lanes<N>, lane: usize) {
        for (one, wide) in self.iter().zip(wide.iter_mut()) {
            one.set_lane(wide, lane);
        }
    }
}

/// Implements [`PerLane`] for structures over the number type, field by field.
macro_rules! per_lane {
    ($($name:ident { $($field:ident),* $(,)? })*) => {$(
        impl $crate::lanes::PerLane for $name<f64> {
            type Lanes<const N: usize> = $name<$crate::lanes::Lanes<N>>;

            #[inline(always)]
            fn from_lanes<const N: usize>(ones: [&Self; N]) -> Self::Lanes<N> {
                $name {
                    $($field: $crate::lanes::PerLane::from_lanes(ones.map(|one| &one.$field)),)*
                }
            }

            #[inline(always)]
            fn lane<const N: usize>(wide: &Self::Lanes<N>, lane: usize) -> Self {
                $name {
                    $($field: $crate::lanes::PerLane::lane(&wide.$field, lane),)*
                }
            }

            #[inline(always)]
            fn set_lane<const N: usize>(&self, wide: &mut Self::Lanes<N>, lane: usize) {
                $($crate::lanes::PerLane::set_lane(&self.$field, &mut wide.$field, lane);)*
            }
        }
    )*};
}
pub(crate) use per_lane;

#[cfg(test)]
mod tests {
    use super::*;

    const LANES: usize = 4;
    const SAMPLES: [f64; 8] = [-3.7, -1.0, -0.25, 0.0, 1e-9, 0.8, 2.0, 1234.5];

    /// Every operation, on each lane, gives the bits it gives on a number alone.
    #[test]
    fn lanes_are_what_numbers_alone_are() {
        fn all<S: Real>(a: S, b: S, c: S) -> Vec<S> {
            let (sine, cosine) = (a * b).sin_cos();
            let mut sum = a;
            sum += b;
            sum *= c;
            sum -= a;
            sum /= c + S::constant(7000.0);
            vec![
                a + b,
                a - b,
                a * b,
                a / (b + S::constant(9.0)),
                -a,
                sum,
                a.abs().sqrt(),
                a.max(b),
                a.signed_like(b.abs()),
                a.where_negative(b, c),
                a.where_zero(b, c),
                a.round(),
                a.round().by_parity(b, c),
                sine,
                cosine,
            ]
        }
        for shift in 0..SAMPLES.len() {
            let pick = |k: usize| SAMPLES[(k + shift) % SAMPLES.len()];
            let wide = |k: usize| Lanes::<LANES>(std::array::from_fn(|i| pick(i + k)));
            let in_lanes = all(wide(0), wide(2), wide(5));
            for lane in 0..LANES {
                let alone = all(pick(lane), pick(lane + 2), pick(lane + 5));
                for (wide, one) in in_lanes.iter().zip(alone) {
                    assert_eq!(wide.0[lane].to_bits(), one.to_bits());
                }
            }
        }
    }
}
