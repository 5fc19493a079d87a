//! The least and the greatest of many numbers.
//!
//! By choices instead of `f64::min` and `f64::max`: of loops with those LLVM 22.1 loses terms with some settings of the
//! compiler, and results would depend on the settings.

/// The least of these numbers, infinite if there are none.
#[inline(always)]
pub fn least(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(
        f64::INFINITY,
        |least, one| if one < least { one } else { least },
    )
}

/// The greatest of these numbers, −∞ if there are none.
#[inline(always)]
pub fn greatest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(f64::NEG_INFINITY, |greatest, one| {
        if one > greatest { one } else { greatest }
    })
}
