//! The set of finished points, one bit each.

/// A set of the numbers below a count.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointSet {
    bits: Vec<u64>,
    count: usize,
    members: usize,
}

impl PointSet {
    /// The empty set of numbers below `count`.
    pub fn none(count: usize) -> Self {
        Self {
            bits: vec![0; count.div_ceil(64)],
            count,
            members: 0,
        }
    }

    /// Adds a number below the count; returns whether it was new.
    pub fn insert(&mut self, number: usize) -> bool {
        let (word, bit) = (number / 64, 1 << (number % 64));
        let is_new = number < self.count && self.bits[word] & bit == 0;
        if is_new {
            self.bits[word] |= bit;
            self.members += 1;
        }
        is_new
    }

    /// Number of members.
    pub fn len(&self) -> usize {
        self.members
    }

    /// True if it has no members.
    pub fn is_empty(&self) -> bool {
        self.members == 0
    }

    /// True if a number is a member.
    pub fn contains(&self, number: usize) -> bool {
        number < self.count && self.bits[number / 64] >> (number % 64) & 1 == 1
    }

    /// Members in ascending order.
    pub fn members(&self) -> impl Iterator<Item = usize> {
        let words = self.bits.iter().enumerate();
        words.flat_map(|(word, bits)| {
            let has = move |bit: &usize| bits >> bit & 1 == 1;
            (0..64).filter(has).map(move |bit| 64 * word + bit)
        })
    }

    /// Numbers below the count that are not members, in ascending order.
    pub fn missing(&self) -> impl Iterator<Item = usize> {
        (0..self.count).filter(|number| !self.contains(*number))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_and_what_is_missing_make_up_the_count() {
        let mut set = PointSet::none(130);
        assert!(set.insert(0) && set.insert(64) && set.insert(129));
        assert!(!set.insert(64) && !set.insert(130));
        assert_eq!(set.len(), 3);
        let missing: Vec<usize> = set.missing().collect();
        assert_eq!(missing.len(), 127);
        assert!(missing.iter().all(|number| !set.contains(*number)));
        assert_eq!((missing[0], missing[126]), (1, 128));
        assert_eq!(set.members().collect::<Vec<_>>(), [0, 64, 129]);
    }
}
