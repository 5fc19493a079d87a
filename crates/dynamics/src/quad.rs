//! Four numbers side by side, for four legs at a time.
//!
//! The legs of a vehicle obey the same straight-line equations, so [`Quad`] runs them abreast in
//! the lanes of one register. Each lane is computed exactly as a single `f64` would be, with the
//! same operations in the same order and none contracted, so a landing comes out the same, bit for
//! bit, whatever registers a processor has.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use nalgebra::SMatrix;
use num_traits::{One, Zero};

use crate::scalar::Real;

/// Numbers in a [`Quad`].
pub const LANES: usize = 4;

/// Four numbers, each a lane of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct Quad(pub [f64; LANES]);

impl Quad {
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
        impl $operator for Quad {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, $operator::$method)
            }
        }

        impl $assign for Quad {
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

impl Neg for Quad {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

impl Zero for Quad {
    #[inline(always)]
    fn zero() -> Self {
        Self([0.0; LANES])
    }

    #[inline(always)]
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Quad {
    #[inline(always)]
    fn one() -> Self {
        Self([1.0; LANES])
    }
}

impl Real for Quad {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; LANES])
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
    fn round(self) -> Self {
        self.map(Real::round)
    }

    #[inline(always)]
    fn is_within(self, limit: f64) -> bool {
        self.0
            .iter()
            .fold(true, |within, x| within & (x.abs() <= limit))
    }

    #[inline(always)]
    fn by_parity(self, even: Self, odd: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].by_parity(even.0[i], odd.0[i])
        }))
    }
}

/// Groups of four that a vehicle may have legs for.
pub const GROUPS: usize = 1;
/// Legs that a vehicle may have.
pub const MOST_LEGS: usize = GROUPS * LANES;

/// Groups of four that so many legs fill, the last one perhaps in part.
#[inline(always)]
pub const fn groups_of(legs: usize) -> usize {
    assert!(legs >= 1 && legs <= MOST_LEGS);
    legs.div_ceil(LANES)
}

/// What `of` says of the legs in a group; lanes beyond the last of `LEGS` legs repeat it.
#[inline(always)]
pub fn members<T, const LEGS: usize>(group: usize, of: impl Fn(usize) -> T) -> [T; LANES] {
    std::array::from_fn(|lane| of((group * LANES + lane).min(LEGS - 1)))
}

/// What can be laid side by side for four legs.
pub trait Abreast: Sized {
    /// Four of them, their numbers in lanes.
    type Wide;

    /// Lays four side by side.
    fn abreast(legs: [&Self; LANES]) -> Self::Wide;

    /// The one in a lane.
    fn lane(wide: &Self::Wide, lane: usize) -> Self;

    /// Lays itself into a lane in place of what is there.
    fn set_lane(&self, wide: &mut Self::Wide, lane: usize);

    /// The same for all four.
    #[inline(always)]
    fn shared(&self) -> Self::Wide {
        Self::abreast([self; LANES])
    }
}

impl Abreast for f64 {
    type Wide = Quad;

    #[inline(always)]
    fn abreast(legs: [&Self; LANES]) -> Quad {
        Quad(legs.map(|value| *value))
    }

    #[inline(always)]
    fn lane(wide: &Quad, lane: usize) -> Self {
        wide.0[lane]
    }

    #[inline(always)]
    fn set_lane(&self, wide: &mut Quad, lane: usize) {
        wide.0[lane] = *self;
    }
}

impl<T: Abreast, const N: usize> Abreast for [T; N] {
    type Wide = [T::Wide; N];

    #[inline(always)]
    fn abreast(legs: [&Self; LANES]) -> Self::Wide {
        std::array::from_fn(|i| T::abreast(legs.map(|values| &values[i])))
    }

    #[inline(always)]
    fn lane(wide: &Self::Wide, lane: usize) -> Self {
        std::array::from_fn(|i| T::lane(&wide[i], lane))
    }

    #[inline(always)]
    fn set_lane(&self, wide: &mut Self::Wide, lane: usize) {
        for (one, wide) in self.iter().zip(wide) {
            one.set_lane(wide, lane);
        }
    }
}

impl<const R: usize, const C: usize> Abreast for SMatrix<f64, R, C> {
    type Wide = SMatrix<Quad, R, C>;

    #[inline(always)]
    fn abreast(legs: [&Self; LANES]) -> Self::Wide {
        SMatrix::from_fn(|row, column| f64::abreast(legs.map(|matrix| &matrix[(row, column)])))
    }

    #[inline(always)]
    fn lane(wide: &Self::Wide, lane: usize) -> Self {
        wide.map(|component| component.0[lane])
    }

    #[inline(always)]
    fn set_lane(&self, wide: &mut Self::Wide, lane: usize) {
        for (one, wide) in self.iter().zip(wide.iter_mut()) {
            one.set_lane(wide, lane);
        }
    }
}

/// Implements [`Abreast`] for structures over the number type, field by field.
macro_rules! abreast {
    ($($name:ident { $($field:ident),* $(,)? })*) => {$(
        impl $crate::quad::Abreast for $name<f64> {
            type Wide = $name<$crate::quad::Quad>;

            #[inline(always)]
            fn abreast(legs: [&Self; $crate::quad::LANES]) -> Self::Wide {
                $name {
                    $($field: $crate::quad::Abreast::abreast(legs.map(|leg| &leg.$field)),)*
                }
            }

            #[inline(always)]
            fn lane(wide: &Self::Wide, lane: usize) -> Self {
                $name {
                    $($field: $crate::quad::Abreast::lane(&wide.$field, lane),)*
                }
            }

            #[inline(always)]
            fn set_lane(&self, wide: &mut Self::Wide, lane: usize) {
                $($crate::quad::Abreast::set_lane(&self.$field, &mut wide.$field, lane);)*
            }
        }
    )*};
}
pub(crate) use abreast;

#[cfg(test)]
mod tests {
    use super::*;

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
                a.round(),
                a.round().by_parity(b, c),
                sine,
                cosine,
            ]
        }
        for shift in 0..SAMPLES.len() {
            let pick = |k: usize| SAMPLES[(k + shift) % SAMPLES.len()];
            let quad = |k: usize| Quad(std::array::from_fn(|i| pick(i + k)));
            let abreast = all(quad(0), quad(2), quad(5));
            for lane in 0..LANES {
                let alone = all(pick(lane), pick(lane + 2), pick(lane + 5));
                for (wide, one) in abreast.iter().zip(alone) {
                    assert_eq!(wide.0[lane].to_bits(), one.to_bits());
                }
            }
        }
    }
}
