//! Sensitivities of one point, from perturbed inputs and their transitions.

use std::cell::Cell;

use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::points::parameter::Parameter;
use touchdown_input::sweeps::case::Case;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::{Boundary, Extent, Search};
use touchdown_search::certainty::{Certainty, Doubt};
use touchdown_search::follow::Near;
use touchdown_search::join_all;
use touchdown_search::trial::Trial;
use touchdown_search::variation::Variation;

use super::{Dependence, Sensitivity, Slope, difference, span};

/// Bracket width here, as a part of that of the search.
const FINER: f64 = 0.1;
/// Longest step, in scales of the parameter.
const LONGEST_STEP: f64 = 0.1;
/// Steepest change of a transition that is followed, in V_H per scale. Beyond it the transition jumps.
const STEEPEST: f64 = 4.0;
/// Expected change of the transition in the first step, as a part of the steepest change.
const EXPECTED: f64 = 1.0 / 16.0;
/// Scale of angles and of rates of turn, deg and deg/s.
const ANGULAR_SCALE: f64 = 30.0;

/// Computes the sensitivities of a point; the search of its `case` found `boundary`.
///
/// # Errors
/// Returns at once with the first error of `land`.
pub(crate) async fn of_point<Stop>(
    sweep: &Sweep,
    point: usize,
    (case, search): (&Case, &Search),
    boundary: &Boundary,
    land: &impl AsyncFn(&Case, f64, Variation) -> Result<Trial, Stop>,
) -> Result<Sensitivity, Stop> {
    let without_slopes = |speed, dependence| {
        let slopes = vec![Slope::new(None, dependence); sweep.sensitivity.len()];
        Sensitivity {
            speed,
            slopes,
            ..Sensitivity::default()
        }
    };
    let bracketed =
        (boundary.transition).and_then(|transition| Some((transition, transition.low?)));
    let Some((transition, low)) = bracketed else {
        return Ok(without_slopes(None, Dependence::NoTransition));
    };
    if let Certainty::Disputed(_) = transition.certainty {
        return Ok(without_slopes(None, Dependence::Disputed));
    }
    let [landings, evaluations] = [Cell::new(0), Cell::new(0)];
    let counted = async |case: &Case, speed, variation| {
        let trial = land(case, speed, variation).await?;
        landings.set(landings.get() + 1);
        evaluations.set(evaluations.get() + trial.evaluations);
        Ok(trial)
    };
    let width = FINER * search.tolerance;
    let at = Variation::At {
        tolerance: transition.tolerance,
        tilt: 0.0,
    };
    let near = Near {
        around: transition.speed(),
        within: 0.5 * (transition.high - low),
        reach: search.scan_step,
        to: transition.to,
        width,
    };
    let sensitivity = match near
        .follow(async |speed| counted(case, speed, at).await)
        .await?
    {
        // This time, landings at the ends of the bracket ended differently.
        None => without_slopes(None, Dependence::Disputed),
        Some(speed) => {
            let followed = FollowedTransition {
                speed,
                landed: counted(case, speed, at).await?,
                to: transition.to,
                width,
                resolution: width + transition.tolerance * speed,
                at,
            };
            let slope = |parameter| {
                followed.slope(sweep, point, (&*case.vehicle, search), parameter, &counted)
            };
            let slopes = join_all(sweep.sensitivity.iter().map(slope)).await?;
            Sensitivity {
                speed: Some(speed),
                slopes,
                ..Sensitivity::default()
            }
        }
    };
    Ok(Sensitivity {
        landings: landings.get(),
        evaluations: evaluations.get(),
        ..sensitivity
    })
}

/// The transition of a point.
struct FollowedTransition {
    /// Its speed, ft/s.
    speed: f64,
    /// The landing there.
    landed: Trial,
    /// Class above the transition.
    to: Class,
    /// Width of brackets, ft/s.
    width: f64,
    /// Error of transitions, ft/s.
    resolution: f64,
    /// Variation of its landings.
    at: Variation,
}

impl FollowedTransition {
    /// Computes the dependence of the transition on a parameter.
    async fn slope<Stop>(
        &self,
        sweep: &Sweep,
        point: usize,
        (vehicle, search): (&Vehicle, &Search),
        parameter: &Parameter,
        land: &impl AsyncFn(&Case, f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Slope, Stop> {
        let scaled = |value| Some((value, scale(parameter, value, vehicle)?));
        let Some((value, scale)) = sweep.value(point, parameter).and_then(scaled) else {
            return Ok(Slope::new(None, Dependence::NoStep));
        };
        let part = libm::cbrt(self.resolution / self.speed).min(LONGEST_STEP);
        let step = part * scale;
        let reach = STEEPEST * part * self.speed;
        let with = |change| sweep.case_with(point, parameter, value + change);
        let dependence = self.dependence((step, reach), &with, search, land).await?;
        let mut slope = Slope::new(Some(step), dependence);
        if !matches!(dependence, Dependence::Smooth { .. }) && dependence.has_span() {
            let span = span(parameter, value, step);
            for (end, change) in slope.ends.iter_mut().zip([-span, span]) {
                if let Ok(case) = with(change) {
                    *end = first_transition(&case, search, land).await?;
                }
            }
        }
        Ok(slope)
    }

    /// Computes the dependence from inputs `with` changes of up to `step` of the parameter; transitions are followed
    /// over `reach`, ft/s.
    async fn dependence<Refused, Stop>(
        &self,
        (step, reach): (f64, f64),
        with: &impl Fn(f64) -> Result<Case, Refused>,
        search: &Search,
        land: &impl AsyncFn(&Case, f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Dependence, Stop> {
        if self.is_alike([with(-step), with(step)], land).await? {
            return Ok(Dependence::Smooth {
                derivative: 0.0,
                error: 0.0,
            });
        }
        let mut speeds = [self.speed; 5];
        let mut within = EXPECTED * reach;
        // Each transition is expected on the straight line through two computed ones.
        let places = [
            (3, 0.5, [2, 2]),
            (1, -0.5, [2, 3]),
            (4, 1.0, [3, 2]),
            (0, -1.0, [1, 2]),
        ];
        for (place, steps, [near, other]) in places {
            let Ok(case) = with(steps * step) else {
                return Ok(Dependence::NotAllowed);
            };
            let near = Near {
                around: 2.0 * speeds[near] - speeds[other],
                within: within.max(2.0 * self.width),
                reach,
                to: self.to,
                width: self.width,
            };
            match near
                .follow(async |speed| land(&case, speed, self.at).await)
                .await?
            {
                Some(speed) => speeds[place] = speed,
                // An ordinary search tells whether it is elsewhere.
                None => {
                    return Ok(match first_transition(&case, search, land).await? {
                        Some(_) => Dependence::Jumps,
                        None => Dependence::Vanishes,
                    });
                }
            }
            within = 0.25 * (speeds[3] - speeds[2]).abs();
        }
        Ok(difference::judged(speeds, step, self.resolution))
    }

    /// True if the landing is the same, to the last bit, with both inputs.
    async fn is_alike<Refused, Stop>(
        &self,
        cases: [Result<Case, Refused>; 2],
        land: &impl AsyncFn(&Case, f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<bool, Stop> {
        for case in cases {
            let Ok(case) = case else {
                return Ok(false);
            };
            if land(&case, self.speed, self.at).await? != self.landed {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// Scale over which V_H changes with a parameter, in its unit; `None` for a parameter that is 0 with no reference
/// quantity of the vehicle.
fn scale(parameter: &Parameter, value: f64, vehicle: &Vehicle) -> Option<f64> {
    let name = parameter.program_name();
    if parameter.is_angular() {
        Some(parameter.in_own_unit(ANGULAR_SCALE))
    } else if value != 0.0 {
        Some(value.abs())
    } else if name.ends_with("_ft") {
        Some(parameter.in_own_unit(vehicle.standing_height()))
    } else if name.starts_with("vehicle.inertia_slug_ft2.") {
        Some(parameter.in_own_unit(vehicle.inertia().trace() / 3.0))
    } else {
        None
    }
}

/// First transition of a changed input by an ordinary search, ft/s.
async fn first_transition<Stop>(
    case: &Case,
    search: &Search,
    land: &impl AsyncFn(&Case, f64, Variation) -> Result<Trial, Stop>,
) -> Result<Option<f64>, Stop> {
    let search = Search {
        extent: Extent::First,
        doubt: Doubt::None,
        ..*search
    };
    let boundary = search
        .boundary(async |speed, variation| land(case, speed, variation).await)
        .await?;
    Ok(boundary.transition.map(|transition| transition.speed()))
}

#[cfg(test)]
#[path = "of_point_tests.rs"]
mod tests;
