//! One item for each leg of a vehicle.

use std::fmt;
use std::ops::{Deref, DerefMut};

/// Most legs of a vehicle.
pub const MOST_LEGS: usize = 8;

/// One item for each leg, in the order of the vehicle's legs. Behaves as a slice with one item per leg.
///
/// There is room for [`MOST_LEGS`], so that structures of such items are contiguous. Places beyond the last leg repeat
/// the item of the first and mean nothing.
#[derive(Clone, Copy)]
pub struct PerLeg<T> {
    items: [T; MOST_LEGS],
    legs: usize,
}

impl<T: Copy> PerLeg<T> {
    /// The same item for each of `legs` legs.
    ///
    /// # Panics
    /// With no leg, or with more than [`MOST_LEGS`].
    #[inline(always)]
    pub fn same(legs: usize, item: T) -> Self {
        assert!((1..=MOST_LEGS).contains(&legs), "1 to {MOST_LEGS} legs");
        Self {
            items: [item; MOST_LEGS],
            legs,
        }
    }

    /// One item for each of `legs` legs, made from its index, in order.
    ///
    /// # Panics
    /// As [`PerLeg::same`].
    #[inline(always)]
    pub fn from_fn(legs: usize, mut item: impl FnMut(usize) -> T) -> Self {
        let mut all = Self::same(legs, item(0));
        for leg in 1..legs {
            all.items[leg] = item(leg);
        }
        all
    }

    /// All the room, also beyond the last leg.
    #[inline(always)]
    pub(crate) fn room(&self) -> &[T; MOST_LEGS] {
        &self.items
    }

    /// All the room, mutable.
    #[inline(always)]
    pub(crate) fn room_mut(&mut self) -> &mut [T; MOST_LEGS] {
        &mut self.items
    }

    /// Maps each item, in order.
    #[inline(always)]
    pub fn map<U: Copy>(&self, mut f: impl FnMut(T) -> U) -> PerLeg<U> {
        PerLeg::from_fn(self.legs, |leg| f(self.items[leg]))
    }
}

impl<T: Copy, const LEGS: usize> From<[T; LEGS]> for PerLeg<T> {
    fn from(items: [T; LEGS]) -> Self {
        const { assert!(LEGS >= 1 && LEGS <= MOST_LEGS) };
        Self::from_fn(LEGS, |leg| items[leg])
    }
}

impl<T> Deref for PerLeg<T> {
    type Target = [T];

    #[inline(always)]
    fn deref(&self) -> &[T] {
        &self.items[..self.legs]
    }
}

impl<T> DerefMut for PerLeg<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.legs]
    }
}

impl<T: Copy> IntoIterator for PerLeg<T> {
    type Item = T;
    type IntoIter = std::iter::Take<std::array::IntoIter<T, MOST_LEGS>>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter().take(self.legs)
    }
}

impl<'a, T> IntoIterator for &'a PerLeg<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: PartialEq> PartialEq for PerLeg<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: PartialEq, const LEGS: usize> PartialEq<[T; LEGS]> for PerLeg<T> {
    fn eq(&self, other: &[T; LEGS]) -> bool {
        **self == *other
    }
}

/// A sequence of one item for each leg.
#[cfg(feature = "serde")]
impl<T: serde::Serialize> serde::Serialize for PerLeg<T> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self)
    }
}

#[cfg(feature = "serde")]
impl<'de, T: serde::Deserialize<'de> + Copy> serde::Deserialize<'de> for PerLeg<T> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let items = Vec::<T>::deserialize(deserializer)?;
        match items.len() {
            1..=MOST_LEGS => Ok(Self::from_fn(items.len(), |leg| items[leg])),
            legs => {
                let allowed = &"one item for each of 1 to 8 legs";
                Err(serde::de::Error::invalid_length(legs, allowed))
            }
        }
    }
}

impl<T: fmt::Debug> fmt::Debug for PerLeg<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_beyond_the_last_leg_are_not_there() {
        let numbers = PerLeg::from_fn(3, |leg| leg * leg);
        assert_eq!(*numbers, [0, 1, 4]);
        assert_eq!(numbers.into_iter().sum::<usize>(), 5);
        assert_eq!(
            numbers.map(|n| n + 1),
            PerLeg::from_fn(3, |leg| leg * leg + 1)
        );
        assert_ne!(numbers, PerLeg::from_fn(4, |leg| leg * leg));
        assert_eq!(format!("{numbers:?}"), "[0, 1, 4]");
    }

    #[test]
    #[should_panic(expected = "1 to 8 legs")]
    fn nine_legs_find_no_room() {
        PerLeg::same(9, 0);
    }
}
