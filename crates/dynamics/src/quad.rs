//! Four numbers side by side, for the legs of a vehicle.

use crate::wide::Wide;

/// Numbers in a [`Quad`].
pub const LANES: usize = 4;

/// A number of each of four legs.
pub type Quad = Wide<LANES>;

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
