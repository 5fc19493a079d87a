//! The least and the greatest of many numbers.
//!
//! These use comparisons instead of `f64::min` and `f64::max`: LLVM 22.1 loses terms of loops with those under some
//! compiler settings, and results would depend on the settings.

/// Least of these numbers, infinite if there are none.
#[inline(always)]
pub fn least(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(
        f64::INFINITY,
        |least, one| if one < least { one } else { least },
    )
}

/// Greatest of these numbers, −∞ if there are none.
#[inline(always)]
pub fn greatest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(f64::NEG_INFINITY, |greatest, one| {
        if one > greatest { one } else { greatest }
    })
}
