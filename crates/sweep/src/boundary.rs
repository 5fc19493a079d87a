//! The first speed at which a lander does no longer land stably.
//!
//! Outcomes can re-enter: above the speed at which a lander topples it may be stable again. A
//! bisection over the whole range could then settle on any of the changes, so the range is
//! scanned upward in steps first and only the step in which the outcome changes is bisected.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::outcome::{Class, Outcome};

use crate::bands::Band;

/// Where to search, ft/s, and how closely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Search {
    /// Lowest speed, ft/s.
    pub from: f64,
    /// Highest speed, ft/s.
    pub to: f64,
    /// Step of the scan, ft/s.
    pub scan_step: f64,
    /// Greatest width of the final bracket, ft/s.
    pub tolerance: f64,
    /// How much of the range is searched.
    pub extent: Extent,
}

/// How much of the range of speeds a search goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Extent {
    /// Up to the first transition.
    #[default]
    First,
    /// All of it: every band between transitions.
    All,
}

/// What one landing told.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// How it ended.
    pub outcome: Outcome,
    /// Least stability angle on the way, rad.
    pub least_angle: f64,
    /// Evaluations of the equations of motion that it took.
    pub evaluations: u64,
}

/// The first change away from a stable landing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Transition {
    /// How landings end at `high`.
    pub to: Class,
    /// Highest speed known to be stable below the change, ft/s; equal to `high` when the lowest
    /// speed of the search was not stable already.
    pub low: f64,
    /// Lowest speed known not to be stable, ft/s.
    pub high: f64,
}

impl Transition {
    /// Middle of the bracket, ft/s.
    pub fn speed(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// What a search found, and what it cost.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Boundary {
    /// The first transition, if there is one in the range.
    pub transition: Option<Transition>,
    /// All bands of the range from below; none when only the first transition was asked for.
    pub bands: Vec<Band>,
    /// Intervals between equal outcomes that were looked into for a hidden band.
    pub looks: u64,
    /// How many of them held one.
    pub finds: u64,
    /// Landings computed.
    pub landings: u64,
    /// Evaluations of the equations of motion in all of them.
    pub evaluations: u64,
}

impl Search {
    /// Number of speeds in the scan.
    pub fn scan_count(&self) -> u64 {
        ((self.to - self.from) / self.scan_step - 1e-9).ceil() as u64 + 1
    }

    /// The `index`-th speed of the scan, ft/s: full steps from below, and the upper end.
    pub fn scan_speed(&self, index: u64) -> f64 {
        (self.from + index as f64 * self.scan_step).min(self.to)
    }

    /// Most landings that one search can take.
    pub fn most_landings(&self) -> u64 {
        let halvings = (self.scan_step / self.tolerance).log2().ceil().max(0.0);
        self.scan_count() + halvings as u64
    }

    /// Searches as much of the range as [`Search::extent`] says with `land`, which lands at a given
    /// horizontal speed.
    ///
    /// # Errors
    /// Only what `land` gives up with, at once.
    pub fn boundary<Stop>(
        &self,
        land: impl FnMut(f64) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        match self.extent {
            Extent::First => self.first_transition(land),
            Extent::All => self.all_bands(land),
        }
    }

    /// Searches the first transition with `land`, which lands at a given horizontal speed.
    ///
    /// # Errors
    /// Only what `land` gives up with, at once.
    pub fn first_transition<Stop>(
        &self,
        mut land: impl FnMut(f64) -> Result<Trial, Stop>,
    ) -> Result<Boundary, Stop> {
        let mut boundary = Boundary::default();
        let mut count = |speed| {
            let trial = land(speed)?;
            boundary.landings += 1;
            boundary.evaluations += trial.evaluations;
            Ok(trial.outcome.class())
        };
        let mut low = self.from;
        for index in 0..self.scan_count() {
            let high = self.scan_speed(index);
            let class = count(high)?;
            if class != Class::Stable {
                let found = Transition {
                    to: class,
                    low,
                    high,
                };
                boundary.transition = Some(refine(found, self.tolerance, &mut count)?);
                break;
            }
            low = high;
        }
        Ok(boundary)
    }
}

/// Halves a bracket until it is at most `tolerance` wide, its lower end stable throughout.
fn refine<Stop>(
    mut bracket: Transition,
    tolerance: f64,
    class_at: &mut impl FnMut(f64) -> Result<Class, Stop>,
) -> Result<Transition, Stop> {
    while bracket.high - bracket.low > tolerance {
        let middle = bracket.speed();
        if middle <= bracket.low || middle >= bracket.high {
            break;
        }
        match class_at(middle)? {
            Class::Stable => bracket.low = middle,
            class => {
                bracket.high = middle;
                bracket.to = class;
            }
        }
    }
    Ok(bracket)
}

#[cfg(test)]
impl Trial {
    /// A landing that ended in a class somehow.
    pub(crate) fn example(class: Class, evaluations: u64) -> Self {
        use touchdown_dynamics::outcome::Failure;
        let outcome = match class {
            Class::Stable => Outcome::StableSubsided,
            Class::Unstable => Outcome::UnstablePitch,
            Class::Bottomed => Outcome::Bottomed { leg: 0 },
            Class::Failure => Outcome::Failure(Failure::StepLimit),
        };
        Self {
            outcome,
            least_angle: 0.5,
            evaluations,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    const SEARCH: Search = Search {
        from: 0.0,
        to: 25.0,
        scan_step: 0.25,
        tolerance: 0.001,
        extent: Extent::First,
    };

    fn find(search: Search, class: impl Fn(f64) -> Class) -> Boundary {
        let found: Result<_, Infallible> =
            search.first_transition(|speed| Ok(Trial::example(class(speed), 10)));
        match found {
            Ok(boundary) => boundary,
        }
    }

    #[test]
    fn single_boundary_is_bracketed_within_tolerance() {
        let boundary = find(SEARCH, |v| {
            if v < 11.4 {
                Class::Stable
            } else {
                Class::Unstable
            }
        });
        let found = boundary.transition.unwrap();
        assert_eq!(found.to, Class::Unstable);
        assert!(found.low < 11.4 && 11.4 <= found.high);
        assert!(found.high - found.low <= 0.001);
        assert_eq!(boundary.landings, 47 + 8);
        assert_eq!(boundary.evaluations, 550);
        assert!(boundary.landings <= SEARCH.most_landings());
    }

    #[test]
    fn re_entrant_outcomes_give_the_first_change() {
        let boundary = find(SEARCH, |v| match v {
            v if v < 12.1 => Class::Stable,
            v if v < 16.3 => Class::Unstable,
            v if v < 20.0 => Class::Stable,
            _ => Class::Bottomed,
        });
        let found = boundary.transition.unwrap();
        assert_eq!(found.to, Class::Unstable);
        assert!((found.speed() - 12.1).abs() <= 0.0005);
    }

    #[test]
    fn class_is_that_of_the_final_upper_end() {
        // The scan meets toppling at 12.25, but bottoming comes first.
        let boundary = find(SEARCH, |v| match v {
            v if v < 12.1 => Class::Stable,
            v if v < 12.2 => Class::Bottomed,
            _ => Class::Unstable,
        });
        assert_eq!(boundary.transition.unwrap().to, Class::Bottomed);
    }

    #[test]
    fn not_stable_at_the_start_is_a_transition_there() {
        let boundary = find(SEARCH, |_| Class::Failure);
        let found = boundary.transition.unwrap();
        assert_eq!(
            (found.to, found.low, found.high),
            (Class::Failure, 0.0, 0.0)
        );
        assert_eq!((found.speed(), boundary.landings), (0.0, 1));
    }

    #[test]
    fn none_when_all_is_stable_and_the_upper_end_is_looked_at() {
        assert_eq!(find(SEARCH, |_| Class::Stable).transition, None);
        let odd = Search { to: 1.1, ..SEARCH };
        assert_eq!(odd.scan_count(), 6);
        assert_eq!(odd.scan_speed(5), 1.1);
        let boundary = find(odd, |v| {
            if v < 1.05 {
                Class::Stable
            } else {
                Class::Unstable
            }
        });
        assert!((boundary.transition.unwrap().speed() - 1.05).abs() <= 0.0005);
    }

    #[test]
    fn stops_when_told_to() {
        let mut landings = 0;
        let stopped = SEARCH.first_transition(|_| {
            landings += 1;
            if landings > 3 {
                Err("stop")
            } else {
                Ok(Trial::example(Class::Stable, 1))
            }
        });
        assert_eq!((stopped, landings), (Err("stop"), 4));
    }
}
