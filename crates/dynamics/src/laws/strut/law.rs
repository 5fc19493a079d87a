//! The law of one strut, cut into stretches of stroke over which it keeps one piece: the Surveyor's shock absorber
//! (42)-(45), or friction alone if a cartridge with its own law ([`crate::crush`]) carries the load.

use std::sync::Arc;

use super::{Kinked, STOP_STROKE, StrutPiece};
use crate::crush::PressureLine;
use crate::parts::{self, StrutElement};
use crate::profile::Profile;

/// A stretch of stroke over which tables and spring law keep one piece.
#[derive(Debug, Clone, Copy, PartialEq)]
struct StrokeSegment {
    upper: f64,
    /// True beyond the elastic limit.
    is_plastic: bool,
    /// True if the law bends only a little at the upper end.
    is_gentle_above: bool,
    /// True if it does not bend there at all.
    goes_on_above: bool,
    /// S_K = offset + slope δ.
    multiplier: [f64; 2],
    /// Compression damping R_c S_D = offset + slope δ.
    compression: [f64; 2],
}

/// The law of one strut.
#[derive(Debug, Clone, PartialEq)]
pub struct StrutLaw {
    segments: Arc<[StrokeSegment]>,
    spring: Spring,
    friction_fraction: f64,
    bottoming_stroke: f64,
    /// Rate past standstill up to which a link counts as not turned, rad/s.
    turning_slack: f64,
}

/// Spring and damper of a strut.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Spring {
    structural_stiffness: f64,
    preload: f64,
    spring_constant: f64,
    elastic_limit: f64,
    /// Rebound damping R_R (1 + SRL δ) = offset + slope δ.
    rebound: [f64; 2],
}

impl Spring {
    /// No spring and no damper.
    const NONE: Self = Self {
        structural_stiffness: 0.0,
        preload: 0.0,
        spring_constant: 0.0,
        elastic_limit: 0.0,
        rebound: [0.0; 2],
    };

    fn of(damper: &parts::Damper) -> Self {
        Self {
            structural_stiffness: damper.structural_stiffness,
            preload: damper.preload,
            spring_constant: damper.spring_constant,
            elastic_limit: damper.preload / damper.structural_stiffness,
            rebound: [
                damper.rebound_damping,
                damper.rebound_damping * damper.rebound_growth,
            ],
        }
    }
}

/// Turning slack: at least this (rad/s), and this times the tolerance. Where the link turns round, force and damping
/// are continuous and only curvature jumps. A link that trembles about standstill by less does not turn.
const TURNING_SLACK: f64 = 1e-11;
const TURNING_SLACK_PER_TOLERANCE: f64 = 10.0;

impl StrutLaw {
    /// The law of a strut, cut at every change of its pieces.
    pub fn new(strut: &parts::Strut) -> Self {
        let (segments, spring) = match &strut.element {
            StrutElement::Damper(damper) => {
                let spring = Spring::of(damper);
                (segments_of(damper, spring.elastic_limit), spring)
            }
            StrutElement::Honeycomb(_) => {
                // A cartridge bears from the first stroke on, however little: only at zero stroke is it on its stop.
                let uppers = [0.0, f64::INFINITY];
                (uppers.map(StrokeSegment::slack).into(), Spring::NONE)
            }
        };
        Self {
            segments,
            spring,
            friction_fraction: strut.friction_fraction,
            bottoming_stroke: strut.extended_length - strut.minimum_length,
            turning_slack: TURNING_SLACK,
        }
    }

    /// The same law, with turns of the link no more exact than landings at this tolerance need.
    pub fn within(self, tolerance: f64) -> Self {
        Self {
            turning_slack: TURNING_SLACK.max(TURNING_SLACK_PER_TOLERANCE * tolerance),
            ..self
        }
    }

    /// Rate past standstill up to which a link counts as not turned, rad/s.
    pub(super) fn turning_slack(&self) -> f64 {
        self.turning_slack
    }

    /// Stroke at which the strut bottoms, ft.
    pub fn bottoming_stroke(&self) -> f64 {
        self.bottoming_stroke
    }

    /// Force of the resting spring (42)(43) at a stroke (ft), lb.
    pub fn static_force(&self, stroke: f64) -> f64 {
        let spring = &self.spring;
        let segment = &self.segments[self.segment_at(stroke)];
        if segment.is_plastic {
            let [offset, slope] = segment.multiplier;
            let growth = spring.spring_constant * (offset + slope * stroke);
            spring.preload + growth * (stroke - spring.elastic_limit)
        } else {
            spring.structural_stiffness * stroke
        }
    }

    pub(super) fn segment_at(&self, stroke: f64) -> usize {
        let last = self.segments.len() - 1;
        self.segments
            .iter()
            .position(|s| stroke < s.upper)
            .unwrap_or(last)
    }

    /// Lower end of a segment.
    pub(super) fn lower(&self, segment: usize) -> f64 {
        match segment {
            0 => f64::NEG_INFINITY,
            _ => self.segments[segment - 1].upper,
        }
    }

    /// Upper end of a segment.
    pub(super) fn upper(&self, segment: usize) -> f64 {
        self.segments[segment].upper
    }

    /// Returns whether a leg that extends in this segment is on its stop.
    pub(super) fn is_on_stop(&self, segment: usize) -> bool {
        self.segments[segment].upper <= STOP_STROKE
    }

    /// Returns whether the law continues unchanged above the upper end of this segment.
    pub(super) fn goes_on_above(&self, segment: usize) -> bool {
        self.segments[segment].goes_on_above
    }

    /// Returns whether a step may run over the lower end of this segment.
    pub(super) fn is_gentle_below(&self, segment: usize) -> bool {
        segment > 0 && self.segments[segment - 1].is_gentle_above
    }

    /// Returns whether the law bends only a little at the upper end of this segment.
    pub(super) fn is_gentle_above(&self, segment: usize) -> bool {
        self.segments[segment].is_gentle_above
    }

    /// A table over a segment and, across gentle kinks, its neighbours.
    fn kinked(&self, segment: usize, table: impl Fn(&StrokeSegment) -> [f64; 2]) -> Kinked<f64> {
        let [offset, slope] = table(&self.segments[segment]);
        let slope_of = |other: usize| table(&self.segments[other])[1];
        let below = if self.is_gentle_below(segment) {
            [self.lower(segment), slope - slope_of(segment - 1)]
        } else {
            [0.0; 2]
        };
        let above = if self.is_gentle_above(segment) {
            [self.segments[segment].upper, slope_of(segment + 1) - slope]
        } else {
            [0.0; 2]
        };
        Kinked {
            offset,
            slope,
            kinks: [below, above],
        }
    }

    /// Coefficients over a segment. The strut's cartridge, if any, is on this line of load (lb) against stroke.
    pub(super) fn piece(&self, segment: usize, load: &PressureLine<f64>) -> StrutPiece<f64> {
        let spring = &self.spring;
        let ([offset, slope], growth) = if self.segments[segment].is_plastic {
            ([spring.preload, 0.0], spring.spring_constant)
        } else {
            ([0.0, spring.structural_stiffness], 0.0)
        };
        StrutPiece {
            base: [offset + load.at(0.0), slope + load.slope()],
            growth,
            multiplier: self.kinked(segment, |s| s.multiplier),
            elastic_limit: spring.elastic_limit,
            friction_fraction: self.friction_fraction,
            compression: self.kinked(segment, |s| s.compression),
            rebound: spring.rebound,
        }
    }
}

impl StrokeSegment {
    /// No spring and no damper.
    fn slack(upper: f64) -> Self {
        Self {
            upper,
            is_plastic: false,
            is_gentle_above: false,
            goes_on_above: upper.is_finite(),
            multiplier: [0.0; 2],
            compression: [0.0; 2],
        }
    }
}

/// The segments of a shock absorber with this elastic limit δ_E (ft).
fn segments_of(damper: &parts::Damper, elastic_limit: f64) -> Arc<[StrokeSegment]> {
    let tables = [&damper.spring_profile, &damper.damping_profile];
    let mut knots: Vec<f64> = tables
        .iter()
        .flat_map(|p| p.knots()[1..p.knots().len() - 1].iter().map(|k| k[0]))
        .chain([0.0, STOP_STROKE, elastic_limit, f64::INFINITY])
        .collect();
    let bends_at = |stroke: f64| {
        let mut bends = tables.iter().flat_map(|p| p.knots());
        stroke == elastic_limit || bends.any(|knot| knot[0] == stroke)
    };
    knots.sort_by(f64::total_cmp);
    knots.dedup();
    let mut lower = f64::NEG_INFINITY;
    knots
        .into_iter()
        .map(|upper| {
            let line = |profile: &Profile, factor: f64| {
                let s = profile.segment_at(lower);
                [factor * s.offset, factor * s.slope]
            };
            let segment = StrokeSegment {
                upper,
                is_plastic: lower >= elastic_limit,
                is_gentle_above: upper.is_finite()
                    && (lower >= elastic_limit
                        || upper == 0.0 && damper.damping_profile.knots()[0][1] == 1.0),
                goes_on_above: upper == STOP_STROKE && !bends_at(upper),
                multiplier: line(&damper.spring_profile, 1.0),
                compression: if upper <= 0.0 {
                    [damper.compression_damping, 0.0]
                } else {
                    line(&damper.damping_profile, damper.compression_damping)
                },
            };
            lower = upper;
            segment
        })
        .collect()
}
