//! Counts over the points of a sweep.

use touchdown_dynamics::outcome::Class;
use touchdown_input::points::design::Design;
use touchdown_input::sweeps::sweep_file::{Job, Sweep};
use touchdown_search::boundary::{Boundary, Skipped, Transition};
use touchdown_search::certainty::Certainty;
use touchdown_search::contact_warnings::ContactWarnings;
use touchdown_search::hidden_band_checks::HiddenBandChecks;

use crate::sensitivity::{Dependence, Sensitivity, Slope};
use crate::summary::findings::Finding;
use crate::summary::probabilities::{Count, Probabilities};
use crate::summary::transition_statistics::TransitionStatistics;

/// Counts over the points of a sweep.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct SweepCounts {
    /// Points.
    pub points: usize,
    /// Landings computed.
    pub landings: u64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Bands.
    pub bands: usize,
    /// Checks for hidden bands.
    pub checks: HiddenBandChecks,
    /// Landings saved by shortcuts of the search.
    pub skipped: Skipped,
    /// Transitions searched again at a tighter tolerance.
    pub searched_again: u64,
    /// Disputed transitions, among all tested.
    pub disputed_in_all: u64,
    /// Landings spent on testing transitions.
    pub tests: u64,
    /// Landings for sensitivities.
    pub sensitivity_landings: u64,
    /// Number of sensitivities, and of those with a derivative.
    pub slopes: [usize; 2],
    /// The lowest first transition, and its point.
    pub lowest: Option<(usize, Transition)>,
    /// Points with their first transition at or below the lowest speed searched.
    pub at_or_below: usize,
    /// Points with a disputed first transition.
    pub disputed: usize,
    /// Points with stable landings among others above the first transition.
    pub patchy: usize,
    /// Points with a transition to, or a band of, landings that could not be computed; below, that were undecided at
    /// the time limit.
    pub with_failures: usize,
    /// The same, undecided ones.
    pub with_undecided: usize,
    /// Points where crushing elements gave energy to the motion of a landing.
    pub with_given: usize,
    /// Greatest energy given, ft·lb, and its point.
    pub most_given: Option<(usize, f64)>,
    /// Points where a footpad was crushed beyond its hinge in a landing.
    pub with_crushed_through: usize,
    /// Points with struts crushed beyond their crush tables.
    pub with_beyond_table: usize,
    /// Cells of a map.
    pub coarse_cells: CoarseCells,
    /// Outcomes, for a sweep of single landings.
    pub outcomes: Option<Count>,
    /// Outcomes over bins of the axes, for a sample.
    pub probabilities: Option<Probabilities>,
    /// Transition velocities, for a sample.
    pub transitions: Option<TransitionStatistics>,
    kinds: [usize; 5],
}

/// Number of map cells that the budget leaves coarser than requested.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CoarseCells {
    /// All cells of a map that is refined to an error.
    pub cells: usize,
    /// Cells that would be refined further and whose estimated error is above the one sought, or unknown.
    pub coarse: usize,
    /// Greatest estimated error of these, ft/s.
    pub worst: f64,
}

/// Kinds of first transitions in listing order.
const KINDS: [Option<Class>; 5] = [
    Some(Class::Unstable),
    Some(Class::Bottomed),
    Some(Class::Failure),
    Some(Class::Undecided),
    None,
];

impl SweepCounts {
    /// Empty counts for a sweep.
    pub fn of(sweep: &Sweep) -> Self {
        let is_of_landings = matches!(sweep.job, Job::Outcome { .. });
        let probabilities = match &sweep.design {
            Design::Sample(sample) if is_of_landings => Some(Probabilities::none(sweep, sample)),
            _ => None,
        };
        // Open ends can be sorted only if all points are searched over the same range.
        let varies = (sweep.axes.iter())
            .any(|axis| ["search.from_fps", "search.to_fps"].contains(&axis.program_name()));
        let transitions = match (&sweep.job, &sweep.design) {
            (Job::Boundary(search), Design::Sample(_)) if !varies => {
                Some(TransitionStatistics::none(search))
            }
            _ => None,
        };
        Self {
            outcomes: is_of_landings.then(Count::default),
            probabilities,
            transitions,
            ..Self::default()
        }
    }

    /// Adds a point; points must come in order.
    pub fn add(&mut self, sweep: &Sweep, point: usize, finding: &Finding) {
        self.points += 1;
        self.add_warnings(point, finding.warnings());
        match finding {
            Finding::Boundary(boundary) => self.add_boundary(point, boundary),
            Finding::Sensitive {
                boundary,
                sensitivity,
            } => {
                self.add_boundary(point, boundary);
                self.add_sensitivity(sensitivity);
            }
            Finding::Landing(landing) => {
                let class = landing.outcome.class();
                self.landings += 1;
                self.evaluations += finding.evaluations();
                if let Some(outcomes) = &mut self.outcomes {
                    outcomes.add(class);
                }
                if let Some(probabilities) = &mut self.probabilities {
                    probabilities.add(&sweep.design.coordinates(point), class);
                }
            }
        }
    }

    fn add_warnings(&mut self, point: usize, warnings: ContactWarnings) {
        self.with_crushed_through += usize::from(warnings.is_crushed_through);
        self.with_beyond_table += usize::from(warnings.is_beyond_table);
        if warnings.given > 0.0 {
            self.with_given += 1;
            if (self.most_given).is_none_or(|(_, most)| warnings.given > most) {
                self.most_given = Some((point, warnings.given));
            }
        }
    }

    /// True if the points so far are enough, so that the rest is skipped.
    pub fn is_enough(&self, sweep: &Sweep) -> bool {
        match (sweep.job, &self.outcomes) {
            (
                Job::Outcome {
                    enough: Some(width),
                },
                Some(known),
            ) => known.is_enough(width),
            _ => false,
        }
    }

    fn add_boundary(&mut self, point: usize, boundary: &Boundary) {
        self.landings += boundary.landings;
        self.evaluations += boundary.evaluations;
        self.bands += boundary.bands.len();
        self.checks += boundary.checks;
        self.skipped += boundary.skipped;
        self.searched_again += boundary.searched_again;
        self.disputed_in_all += boundary.disputed;
        self.tests += boundary.tests;
        if let Some(transitions) = &mut self.transitions {
            transitions.add(boundary);
        }
        let kind = boundary.transition.map(|transition| transition.to);
        if let Some(index) = KINDS.iter().position(|known| *known == kind) {
            self.kinds[index] += 1;
        }
        let has =
            |class| kind == Some(class) || boundary.bands.iter().any(|band| band.class == class);
        self.with_failures += usize::from(has(Class::Failure));
        self.with_undecided += usize::from(has(Class::Undecided));
        if let Some(transition) = boundary.transition {
            self.at_or_below += usize::from(transition.low.is_none());
            let is_disputed = matches!(transition.certainty, Certainty::Disputed(_));
            self.disputed += usize::from(is_disputed);
            self.patchy += usize::from(boundary.patchy.is_some());
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

    fn add_sensitivity(&mut self, finding: &Sensitivity) {
        self.sensitivity_landings += finding.landings;
        self.landings += finding.landings;
        self.evaluations += finding.evaluations;
        let is_smooth = |slope: &&Slope| matches!(slope.dependence, Dependence::Smooth { .. });
        self.slopes[0] += finding.slopes.len();
        self.slopes[1] += finding.slopes.iter().filter(is_smooth).count();
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
                low: Some(speed),
                high: speed,
                tolerance: 3e-5,
                certainty: Certainty::Untested,
            }),
            landings: 10,
            ..Boundary::default()
        };
        let mut counts = SweepCounts::default();
        let boundaries = [
            Boundary::default(),
            at(Class::Bottomed, 12.0),
            at(Class::Unstable, 11.0),
            at(Class::Unstable, 11.0),
        ];
        for (point, boundary) in boundaries.iter().enumerate() {
            counts.points += 1;
            counts.add_boundary(point, boundary);
        }
        assert_eq!(counts.lowest.map(|(point, _)| point), Some(2));
        assert_eq!((counts.points, counts.landings), (4, 30));
        let expected = [("unstable", 2), ("bottomed", 1), ("none", 1)];
        assert_eq!(
            counts.kinds(),
            expected.map(|(kind, n)| (kind.to_owned(), n))
        );
    }
}
