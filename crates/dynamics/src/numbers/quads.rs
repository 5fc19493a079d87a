//! Legs in the lanes of registers: four legs of one landing computed together.

use arrayvec::ArrayVec;
use nalgebra::{Matrix3, Vector3};

use crate::lanes::{Lanes, PerLane};
use crate::per_leg::{MOST_LEGS, PerLeg};

/// Legs side by side.
pub const LANES: usize = 4;
/// Most groups of so many legs.
pub const QUADS: usize = MOST_LEGS / LANES;

/// A number for each of four legs.
pub type Quad = Lanes<LANES>;

/// Items of four legs each, in the order of the vehicle's legs. Lanes beyond the last leg repeat the first leg.
pub type Quads<T> = ArrayVec<T, QUADS>;

/// Returns so many legs' number of groups.
#[inline(always)]
pub fn quads(legs: usize) -> usize {
    legs.div_ceil(LANES)
}

/// Number of the legs in group `quad` of so many.
#[inline(always)]
pub fn legs_in(quad: usize, legs: usize) -> usize {
    (legs - LANES * quad).min(LANES)
}

/// Leg in a lane of a group: the first one beyond the last.
#[inline(always)]
pub fn leg_in(quad: usize, lane: usize, legs: usize) -> usize {
    let leg = LANES * quad + lane;
    if leg < legs { leg } else { 0 }
}

/// The items of these legs side by side.
pub fn side_by_side<T: PerLane>(items: &PerLeg<T>) -> Quads<T::Lanes<LANES>> {
    let legs = items.len();
    (0..quads(legs))
        .map(|quad| T::from_lanes(std::array::from_fn(|lane| &items[leg_in(quad, lane, legs)])))
        .collect()
}

/// Sum over the first `legs` lanes, in order.
#[inline(always)]
pub fn sum(numbers: Quad, legs: usize) -> f64 {
    let mut sum = numbers.0[0];
    for lane in 1..legs {
        sum += numbers.0[lane];
    }
    sum
}

/// Sum of each component over the first `legs` lanes.
#[inline(always)]
pub fn vector_sum(vectors: &Vector3<Quad>, legs: usize) -> Vector3<f64> {
    Vector3::new(
        sum(vectors.x, legs),
        sum(vectors.y, legs),
        sum(vectors.z, legs),
    )
}

/// Sum of each element over the first `legs` lanes.
#[inline(always)]
pub fn matrix_sum(matrices: &Matrix3<Quad>, legs: usize) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| sum(matrices[(row, column)], legs))
}
