//! A sweep in numbers, added up point by point.

use touchdown_dynamics::outcome::Class;

use crate::boundary::{Boundary, Transition};

/// Counts over the points of a sweep.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// Points.
    pub points: usize,
    /// Landings computed.
    pub landings: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Bands found.
    pub bands: usize,
    /// Intervals looked into for hidden bands.
    pub looks: u64,
    /// Hidden bands found.
    pub finds: u64,
    /// The lowest first transition, and its point.
    pub lowest: Option<(usize, Transition)>,
    kinds: [usize; 4],
}

/// First transitions that are told apart, in the order in which they are told.
const KINDS: [Option<Class>; 4] = [
    Some(Class::Unstable),
    Some(Class::Bottomed),
    Some(Class::Failure),
    None,
];

impl Tally {
    /// Adds a point; points come in grid order.
    pub fn add(&mut self, point: usize, boundary: &Boundary) {
        self.points += 1;
        self.landings += boundary.landings;
        self.evaluations += boundary.evaluations;
        self.bands += boundary.bands.len();
        self.looks += boundary.looks;
        self.finds += boundary.finds;
        let kind = boundary.transition.map(|transition| transition.to);
        if let Some(index) = KINDS.iter().position(|known| *known == kind) {
            self.kinds[index] += 1;
        }
        let is_lower = |transition: Transition| match self.lowest {
            Some((_, lowest)) => transition.speed() < lowest.speed(),
            None => true,
        };
        if let Some(transition) = boundary.transition
            && is_lower(transition)
        {
            self.lowest = Some((point, transition));
        }
    }

    /// Number of points for each kind of first transition that occurs, `none` last.
    pub fn kinds(&self) -> Vec<(String, usize)> {
        let name = |kind: Option<Class>| kind.map_or("none".to_owned(), |class| class.to_string());
        let counted = KINDS.into_iter().map(name).zip(self.kinds);
        counted.filter(|(_, count)| *count > 0).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_and_the_first_of_the_lowest_are_kept() {
        let at = |to, speed| Boundary {
            transition: Some(Transition {
                to,
                low: speed,
                high: speed,
            }),
            landings: 10,
            ..Boundary::default()
        };
        let mut tally = Tally::default();
        let boundaries = [
            Boundary::default(),
            at(Class::Bottomed, 12.0),
            at(Class::Unstable, 11.0),
            at(Class::Unstable, 11.0),
        ];
        for (point, boundary) in boundaries.iter().enumerate() {
            tally.add(point, boundary);
        }
        assert_eq!(tally.lowest.map(|(point, _)| point), Some(2));
        assert_eq!((tally.points, tally.landings), (4, 30));
        let expected = [("unstable", 2), ("bottomed", 1), ("none", 1)];
        assert_eq!(
            tally.kinds(),
            expected.map(|(kind, n)| (kind.to_owned(), n))
        );
    }
}
