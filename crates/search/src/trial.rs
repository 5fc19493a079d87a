//! Record of a landing within a search, with its margins against ending otherwise.

use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::per_leg::PerLeg;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::vehicle::{Legs, Vehicle};

use crate::contact_warnings::ContactWarnings;

/// Result of one landing.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// Outcome.
    pub outcome: Outcome,
    /// Class it counts as: a stable landing that comes too close to toppling counts as unstable.
    pub class: Class,
    /// Least stability angle during the landing, rad.
    pub least_angle: f64,
    /// Margins against ending otherwise.
    pub margins: Margins,
    /// Duration, in times of free fall of the CG from its height at touchdown.
    pub duration: f64,
    /// Solver tolerance.
    pub tolerance: f64,
    /// Evaluations of the equations of motion.
    pub evaluations: u64,
    /// Contact warnings.
    pub warnings: ContactWarnings,
}

/// Signed margins, positive on the side of a stable landing and continuous where only the speed decides.
///
/// A vehicle that rocks over its feet moves over a hill of potential energy. Where it turns back, its energy falls
/// short of the top in proportion to σ². Where it topples, the energy left beyond the top is proportional to the square
/// of the rate at which σ passes zero. Both run straight through zero with the speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Margins {
    /// Against toppling: square of the least σ, or minus the square of the rate of σ at its zero in radians per free
    /// fall, rad², less the square of the angle to be kept. `None` if all feet came to one side.
    pub toppling: Option<f64>,
    /// Against bottoming: least remaining stroke of a strut, or minus the stroke it would have needed beyond its stop,
    /// in units of the whole stroke. `None` if the strut did not slow down, or if a pad or block bottomed.
    pub bottoming: Option<f64>,
}

/// Scales that make margins dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Time of free fall of the CG from its height at touchdown, s.
    pub fall_time: f64,
    /// Stroke at which each strut bottoms, ft; `None` for legs of three struts, of which any may bottom.
    pub strokes: Option<PerLeg<f64>>,
}

impl Scales {
    /// The scales of a vehicle in a scene.
    pub fn of(vehicle: &Vehicle, scene: &Scene) -> Self {
        Self {
            fall_time: (2.0 * vehicle.standing_height() / scene.gravity(vehicle)).sqrt(),
            strokes: match vehicle.legs() {
                Legs::Hinged(legs) => Some(PerLeg::from_fn(legs.len(), |j| {
                    let strut = &legs[j].design().strut;
                    strut.extended_length - strut.minimum_length
                })),
                Legs::ThreeStrut(_) => None,
            },
        }
    }
}

impl Trial {
    /// Extracts the record of a landing that was computed at a tolerance. A stable landing keeps at least the stability
    /// angle `kept` (rad).
    pub fn of(landing: Landing, scales: &Scales, tolerance: f64, kept: f64) -> Self {
        let class = match landing.outcome.class() {
            Class::Stable if landing.min_stability_angle < kept => Class::Unstable,
            class => class,
        };
        Self {
            class,
            warnings: ContactWarnings::of(&landing),
            margins: Margins {
                toppling: toppling(&landing, scales).map(|margin| margin - kept * kept),
                bottoming: bottoming(&landing, scales),
            },
            least_angle: landing.min_stability_angle,
            duration: landing.end_time / scales.fall_time,
            tolerance,
            evaluations: landing.evaluations,
            outcome: landing.outcome,
        }
    }

    /// The margin that decides between two classes, positive in a stable landing.
    pub fn margin(&self, classes: [Class; 2]) -> Option<f64> {
        match classes {
            [Class::Stable, Class::Unstable] | [Class::Unstable, Class::Stable] => {
                self.margins.toppling
            }
            [Class::Stable, Class::Bottomed] | [Class::Bottomed, Class::Stable] => {
                self.margins.bottoming
            }
            _ => None,
        }
    }
}

fn toppling(landing: &Landing, scales: &Scales) -> Option<f64> {
    match landing.outcome {
        Outcome::UnstableYaw => None,
        Outcome::UnstablePitch | Outcome::UnstableToppled => {
            let rate = landing.final_rates.stability_angle? * scales.fall_time;
            Some(-rate * rate)
        }
        _ => Some(landing.min_stability_angle * landing.min_stability_angle),
    }
}

fn bottoming(landing: &Landing, scales: &Scales) -> Option<f64> {
    let strokes = scales.strokes.as_ref()?;
    match landing.outcome {
        Outcome::Bottomed { leg } => {
            let rates = &landing.final_rates;
            let (rate, braking) = (rates.strokes[leg], -rates.stroke_accelerations[leg]);
            let beyond = rate * rate / (2.0 * braking);
            return (braking > 0.0).then(|| -beyond / strokes[leg]);
        }
        // The struts' remaining stroke is no margin for these.
        Outcome::BottomedPad { .. } | Outcome::BottomedBlock { .. } => return None,
        _ => {}
    }
    let left = landing
        .max_stroke
        .iter()
        .zip(strokes)
        .map(|(stroke, whole)| 1.0 - stroke / whole);
    Some(left.fold(1.0, f64::min))
}

/// A landing of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Its horizontal speed, ft/s.
    pub speed: f64,
    /// Its result.
    pub trial: Trial,
    /// True if computed for a scan, at a looser tolerance or with an early end.
    pub(crate) is_loose: bool,
}

impl Sample {
    /// The class of its outcome.
    pub fn class(&self) -> Class {
        self.trial.class
    }
}

/// Greatest change of a margin across a bracket in which it runs through zero. At the regular transitions of the level
/// vehicle it is 0.0003 for a bracket of 0.001 ft/s.
pub(crate) const LEAST_JUMP: f64 = 0.01;

/// True if no margin decides the change between two landings, or if it jumps.
pub(crate) fn margin_jumps(low: &Sample, high: &Sample) -> bool {
    let classes = [low.class(), high.class()];
    match [low, high].map(|sample| sample.trial.margin(classes)) {
        [Some(a), Some(b)] => (a - b).abs() > LEAST_JUMP,
        _ => true,
    }
}

/// Index of the first landing that is not stable.
pub(crate) fn first_unstable(samples: &[Sample]) -> Option<usize> {
    samples
        .iter()
        .position(|sample| sample.class() != Class::Stable)
}

#[cfg(test)]
impl Trial {
    /// An example of a landing that ended in a class.
    pub(crate) fn example(class: Class, evaluations: u64) -> Self {
        use touchdown_dynamics::outcome::Failure;
        let outcome = match class {
            Class::Stable => Outcome::StableSubsided,
            Class::Unstable => Outcome::UnstablePitch,
            Class::Bottomed => Outcome::Bottomed { leg: 0 },
            Class::Failure => Outcome::Failure(Failure::StepLimit),
            Class::Undecided => Outcome::TimeExpired,
        };
        Self {
            outcome,
            class,
            least_angle: 0.5,
            margins: Margins::default(),
            duration: 3.0,
            tolerance: 3e-5,
            evaluations,
            warnings: ContactWarnings::default(),
        }
    }
}

#[cfg(test)]
impl Sample {
    /// A landing with this margin; it topples if the margin is negative.
    pub(crate) fn example(speed: f64, margin: f64) -> Self {
        let class = if margin > 0.0 {
            Class::Stable
        } else {
            Class::Unstable
        };
        let margins = Margins {
            toppling: Some(margin),
            bottoming: None,
        };
        let trial = Trial {
            margins,
            ..Trial::example(class, 1)
        };
        Self {
            speed,
            trial,
            is_loose: false,
        }
    }
}
