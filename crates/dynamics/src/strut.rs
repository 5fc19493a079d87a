//! The shock absorber (42)-(45) and what it does to the lower link: working, or on its extension
//! stop on or off the surface (model chapter 5).

use crate::integrator::event::{Bounds, Exit};
use crate::profile::Profile;
use crate::scalar::Real;
use crate::vehicle;

/// Link rate γ̇ below which damping and seal friction fade in, rad/s.
const SMOOTHING_RATE: f64 = 0.2;
/// Stroke at and below which an extending leg is on its stop, ft.
const STOP_STROKE: f64 = 1e-6;
/// Rate at which an airborne link's γ̇ runs down, 1/s, and the rate left over, rad/s.
const RUN_DOWN: f64 = 75.0;
const RESIDUAL_RATE: f64 = 0.001;
/// Slacks of the guards: stroke (ft), rate (rad/s), torque on the link (ft·lb).
const STROKE_SLACK: f64 = 1e-13;
const RATE_SLACK: f64 = 1e-11;
const TORQUE_SLACK: f64 = 1e-9;

/// Coefficients of the active piece of the strut law: with spring F_s = p0 + p1 δ + q m(δ)(δ − δ_E)
/// and resistance R = ν|F_s| + d(δ) l̇², F = F_s ∓ c R against the motion, c = 1 − (1 − |γ̇|/0.2)³.
#[derive(Debug, Clone, Copy)]
pub struct StrutPiece<S> {
    base: [S; 2],
    growth: S,
    multiplier: Kinked<S>,
    elastic_limit: S,
    friction_fraction: S,
    compression: Kinked<S>,
    rebound: [S; 2],
}

/// A stretch of a piecewise-linear function together with the two neighbouring stretches: kinks
/// this gentle are not worth an event, so a step may run over them.
#[derive(Debug, Clone, Copy)]
struct Kinked<S> {
    offset: S,
    slope: S,
    /// Kinks at the lower and upper end: where, and what the slope loses (below) or gains (above).
    kinks: [[S; 2]; 2],
}

impl<S: Real> Kinked<S> {
    /// Zero everywhere.
    fn zero() -> Self {
        let zero = S::zero();
        Self {
            offset: zero,
            slope: zero,
            kinks: [[zero; 2]; 2],
        }
    }

    #[inline(always)]
    fn at(&self, x: S) -> S {
        let [[lower, loss], [upper, gain]] = self.kinks;
        self.offset
            + self.slope * x
            + loss * (lower - x).max(S::zero())
            + gain * (x - upper).max(S::zero())
    }
}

impl<S: Real> StrutPiece<S> {
    /// No force.
    pub fn slack() -> Self {
        let zero = S::zero();
        Self {
            base: [zero; 2],
            growth: zero,
            multiplier: Kinked::zero(),
            elastic_limit: zero,
            friction_fraction: zero,
            compression: Kinked::zero(),
            rebound: [zero; 2],
        }
    }

    /// Axial force F, lb, compression positive, at stroke δ (ft), link rate γ̇ (rad/s) and lever
    /// dl_D/dγ (ft).
    #[inline(always)]
    pub fn force(&self, stroke: S, link_rate: S, lever: S) -> S {
        let (spring, shortfall, damping) = self.parts(stroke, link_rate);
        let strut_rate = lever * link_rate;
        let resistance = self.friction_fraction * spring.abs() + damping * strut_rate * strut_rate;
        let engaged = S::one() - shortfall * shortfall * shortfall;
        spring - link_rate.signed_like(engaged * resistance)
    }

    /// −∂F/∂γ̇, lb·s: how the force opposes a change of the link rate.
    #[inline(always)]
    pub fn damping(&self, stroke: S, link_rate: S, lever: S) -> S {
        let (spring, shortfall, damping) = self.parts(stroke, link_rate);
        let strut_rate = lever * link_rate;
        let resistance = self.friction_fraction * spring.abs() + damping * strut_rate * strut_rate;
        let engaged = S::one() - shortfall * shortfall * shortfall;
        let engaging = S::constant(3.0 / SMOOTHING_RATE) * shortfall * shortfall;
        let two = S::constant(2.0);
        engaging * resistance + engaged * two * damping * lever * lever * link_rate.abs()
    }

    /// Spring force F_s (lb), 1 − |γ̇|/0.2 or 0, damping of the present direction (lb·s²/ft²).
    #[inline(always)]
    fn parts(&self, stroke: S, link_rate: S) -> (S, S, S) {
        let spring = self.base[0]
            + self.base[1] * stroke
            + self.growth * self.multiplier.at(stroke) * (stroke - self.elastic_limit);
        let speed = link_rate.abs() * S::constant(1.0 / SMOOTHING_RATE);
        let shortfall = (S::one() - speed).max(S::zero());
        let compression = self.compression.at(stroke);
        let rebound = self.rebound[0] + self.rebound[1] * stroke;
        (
            spring,
            shortfall,
            link_rate.where_negative(compression, rebound),
        )
    }
}

/// Coefficients of the link equation: γ̈ = free·(torque/I_γ) − run_down (γ̇ − 0.001), and γ moves at
/// moving·γ̇.
#[derive(Debug, Clone, Copy)]
pub struct LinkPiece<S> {
    /// 1 where the torque turns the link, else 0.
    pub free: S,
    run_down: S,
    /// 1 where γ follows its rate, 0 where the link is frozen.
    pub moving: S,
}

impl<S: Real> LinkPiece<S> {
    /// Link acceleration γ̈, rad/s².
    #[inline(always)]
    pub fn acceleration(&self, torque_over_inertia: S, link_rate: S) -> S {
        self.free * torque_over_inertia - self.run_down * (link_rate - S::constant(RESIDUAL_RATE))
    }
}

/// A stretch of stroke over which tables and spring law keep one piece.
#[derive(Debug, Clone, Copy)]
struct StrokeSegment {
    upper: f64,
    /// Beyond the elastic limit.
    is_plastic: bool,
    /// Whether a step may run over the upper end: the law only bends a little there.
    is_gentle_above: bool,
    /// S_K = offset + slope δ.
    multiplier: [f64; 2],
    /// Compression damping R_c S_D = offset + slope δ.
    compression: [f64; 2],
}

/// What becomes of the gentle kinks of the law: table knots beyond the elastic limit and the ends of
/// the zone in which resistance fades in. The law is evaluated rightly across them either way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kinks {
    /// They are located like any event: a step sees a smooth law.
    Located,
    /// Steps run over them, and error control sees to it that they do no harm.
    SteppedOver,
}

/// The law of one strut.
#[derive(Debug, Clone)]
pub struct StrutLaw {
    kinks: Kinks,
    segments: Vec<StrokeSegment>,
    structural_stiffness: f64,
    preload: f64,
    spring_constant: f64,
    elastic_limit: f64,
    /// Rebound damping R_R (1 + SRL δ) = offset + slope δ.
    rebound: [f64; 2],
    friction_fraction: f64,
    bottoming_stroke: f64,
}

impl StrutLaw {
    /// The law of a strut, cut where any of its pieces changes.
    pub fn new(strut: &vehicle::Strut, kinks: Kinks) -> Self {
        let elastic_limit = strut.preload / strut.structural_stiffness;
        let tables = [&strut.spring_profile, &strut.damping_profile];
        let mut knots: Vec<f64> = tables
            .iter()
            .flat_map(|p| p.knots()[1..p.knots().len() - 1].iter().map(|k| k[0]))
            .chain([0.0, STOP_STROKE, elastic_limit, f64::INFINITY])
            .collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        let mut lower = f64::NEG_INFINITY;
        let segments = knots
            .into_iter()
            .map(|upper| {
                let line = |profile: &Profile, factor: f64| {
                    let s = profile.segment_at(lower);
                    [factor * s.offset, factor * s.slope]
                };
                let segment = StrokeSegment {
                    upper,
                    is_plastic: lower >= elastic_limit,
                    is_gentle_above: kinks == Kinks::SteppedOver
                        && upper.is_finite()
                        && (lower >= elastic_limit
                            || upper == 0.0 && strut.damping_profile.knots()[0][1] == 1.0),
                    multiplier: line(&strut.spring_profile, 1.0),
                    compression: if upper <= 0.0 {
                        [strut.compression_damping, 0.0]
                    } else {
                        line(&strut.damping_profile, strut.compression_damping)
                    },
                };
                lower = upper;
                segment
            })
            .collect();
        Self {
            kinks,
            segments,
            structural_stiffness: strut.structural_stiffness,
            preload: strut.preload,
            spring_constant: strut.spring_constant,
            elastic_limit,
            rebound: [
                strut.rebound_damping,
                strut.rebound_damping * strut.rebound_growth,
            ],
            friction_fraction: strut.friction_fraction,
            bottoming_stroke: strut.extended_length - strut.minimum_length,
        }
    }

    /// Stroke at which the strut bottoms, ft.
    pub fn bottoming_stroke(&self) -> f64 {
        self.bottoming_stroke
    }

    fn segment_at(&self, stroke: f64) -> usize {
        let last = self.segments.len() - 1;
        self.segments
            .iter()
            .position(|s| stroke < s.upper)
            .unwrap_or(last)
    }

    /// Lower end of a segment.
    fn lower(&self, segment: usize) -> f64 {
        match segment {
            0 => f64::NEG_INFINITY,
            _ => self.segments[segment - 1].upper,
        }
    }

    /// Whether a leg that extends in this segment is on its stop.
    fn is_on_stop(&self, segment: usize) -> bool {
        self.segments[segment].upper <= STOP_STROKE
    }

    /// Whether a step may run over the lower end of this segment.
    fn is_gentle_below(&self, segment: usize) -> bool {
        segment > 0 && self.segments[segment - 1].is_gentle_above
    }

    /// Whether a step may run over the upper end of this segment.
    fn is_gentle_above(&self, segment: usize) -> bool {
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

    /// Coefficients over a segment.
    fn piece(&self, segment: usize) -> StrutPiece<f64> {
        let (base, growth) = if self.segments[segment].is_plastic {
            ([self.preload, 0.0], self.spring_constant)
        } else {
            ([0.0, self.structural_stiffness], 0.0)
        };
        StrutPiece {
            base,
            growth,
            multiplier: self.kinked(segment, |s| s.multiplier),
            elastic_limit: self.elastic_limit,
            friction_fraction: self.friction_fraction,
            compression: self.kinked(segment, |s| s.compression),
            rebound: self.rebound,
        }
    }
}

/// Direction and speed range of the link, between kinks of the law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Travel {
    FastStroke,
    SlowStroke,
    SlowRebound,
    FastRebound,
}

impl Travel {
    fn at(link_rate: f64) -> Self {
        if link_rate < -SMOOTHING_RATE {
            Self::FastStroke
        } else if link_rate < 0.0 {
            Self::SlowStroke
        } else if link_rate < SMOOTHING_RATE {
            Self::SlowRebound
        } else {
            Self::FastRebound
        }
    }

    fn bounds(self) -> Bounds {
        match self {
            Self::FastStroke => Bounds::below(-SMOOTHING_RATE),
            Self::SlowStroke => Bounds::between(-SMOOTHING_RATE, 0.0),
            Self::SlowRebound => Bounds::between(0.0, SMOOTHING_RATE),
            Self::FastRebound => Bounds::above(SMOOTHING_RATE),
        }
    }

    fn neighbour(self, exit: Exit) -> Self {
        match (self, exit) {
            (Self::FastStroke, _) | (Self::SlowRebound, Exit::Below) => Self::SlowStroke,
            (Self::SlowStroke, Exit::Below) => Self::FastStroke,
            (Self::SlowStroke, Exit::Above) | (Self::FastRebound, _) => Self::SlowRebound,
            (Self::SlowRebound, Exit::Above) => Self::FastRebound,
        }
    }
}

/// What the strut and its link are doing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stance {
    /// Extended and off the surface: the link is frozen, its rate state runs down while it is
    /// above 0.001 rad/s.
    Hanging {
        /// Whether the rate is running down.
        running_down: bool,
    },
    /// Extended, on the surface and not stroking: the stop carries what would extend it further.
    Stopped {
        /// Whether the surface pushes the link in.
        pushed: bool,
    },
    /// The strut law holds.
    Working(Working),
}

/// The active piece of the strut law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Working {
    /// The segment the stroke is in or, across a gentle kink, next to.
    segment: usize,
    travel: Travel,
}

impl Stance {
    /// An extended leg on its stop at link rate γ̇, on or off the surface.
    pub fn extended(on_surface: bool, link_rate: f64) -> Self {
        if on_surface {
            Self::Stopped { pushed: false }
        } else {
            Self::Hanging {
                running_down: link_rate > RESIDUAL_RATE,
            }
        }
    }

    /// What a leg does, on or off the surface, at a stroke δ (ft) and link rate γ̇ (rad/s). On its
    /// stop on the surface it is not pushed: the torque has yet to say.
    pub fn at(law: &StrutLaw, on_surface: bool, stroke: f64, link_rate: f64) -> Self {
        if link_rate >= 0.0 && stroke <= STOP_STROKE {
            return Self::extended(on_surface, link_rate);
        }
        Self::Working(Working {
            segment: law.segment_at(stroke),
            travel: Travel::at(link_rate),
        })
    }

    /// Whether the leg is on its extension stop.
    pub fn is_extended(&self) -> bool {
        !matches!(self, Self::Working(_))
    }

    /// Coefficients of the active pieces.
    pub fn pieces(&self, law: &StrutLaw) -> (StrutPiece<f64>, LinkPiece<f64>) {
        match *self {
            Self::Hanging { running_down } => (
                StrutPiece::slack(),
                LinkPiece {
                    free: 0.0,
                    run_down: if running_down { RUN_DOWN } else { 0.0 },
                    moving: 0.0,
                },
            ),
            Self::Stopped { pushed } => (
                StrutPiece::slack(),
                LinkPiece {
                    free: if pushed { 1.0 } else { 0.0 },
                    run_down: 0.0,
                    moving: 1.0,
                },
            ),
            Self::Working(Working { segment, .. }) => (
                law.piece(segment),
                LinkPiece {
                    free: 1.0,
                    run_down: 0.0,
                    moving: 1.0,
                },
            ),
        }
    }

    /// Range of the stroke over which the active piece holds, bottoming included.
    pub fn stroke_bounds(&self, law: &StrutLaw) -> Bounds {
        let Self::Working(Working { segment, .. }) = *self else {
            return Bounds::FREE;
        };
        let first = segment - usize::from(law.is_gentle_below(segment));
        let last = segment + usize::from(law.is_gentle_above(segment));
        let upper = law.segments[last].upper.min(law.bottoming_stroke);
        Bounds::between(law.lower(first), upper).widened(STROKE_SLACK)
    }

    /// Range of the link rate over which the active piece holds.
    pub fn rate_bounds(&self, law: &StrutLaw) -> Bounds {
        match *self {
            Self::Hanging { .. } => Bounds::FREE,
            Self::Stopped { .. } => Bounds::above(0.0).widened(RATE_SLACK),
            Self::Working(Working { segment, travel }) => match law.kinks {
                _ if law.is_on_stop(segment) => Bounds::below(0.0).widened(RATE_SLACK),
                Kinks::Located => travel.bounds().widened(RATE_SLACK),
                Kinks::SteppedOver => Bounds::FREE,
            },
        }
    }

    /// Follows the stroke over a gentle kink: the law stays the same, its coefficients are centred
    /// on the segment the stroke is in.
    /// Whether they changed.
    pub fn follow(&mut self, law: &StrutLaw, stroke: f64) -> bool {
        let Self::Working(Working { segment, .. }) = self else {
            return false;
        };
        if law.is_gentle_above(*segment) && stroke > law.segments[*segment].upper {
            *segment += 1;
            true
        } else if law.is_gentle_below(*segment) && stroke < law.lower(*segment) {
            *segment -= 1;
            true
        } else {
            false
        }
    }

    /// Range of the surface's torque on the link over which the stop keeps carrying, or not.
    pub fn torque_bounds(&self) -> Bounds {
        match self {
            Self::Stopped { pushed: true } => Bounds::below(0.0).widened(TORQUE_SLACK),
            Self::Stopped { pushed: false } => Bounds::above(0.0).widened(TORQUE_SLACK),
            _ => Bounds::FREE,
        }
    }

    /// The stroke left its range (other than by bottoming).
    pub fn cross_stroke(&mut self, law: &StrutLaw, exit: Exit, on_surface: bool, link_rate: f64) {
        if let Self::Working(Working { segment, travel }) = self {
            if law.is_on_stop(*segment) {
                *travel = Travel::at(link_rate);
            }
            *segment = match exit {
                Exit::Above => *segment + 1 + usize::from(law.is_gentle_above(*segment)),
                Exit::Below => *segment - 1 - usize::from(law.is_gentle_below(*segment)),
            };
            if law.is_on_stop(*segment) && link_rate >= 0.0 {
                *self = Self::extended(on_surface, link_rate);
            }
        }
    }

    /// The link rate left its range.
    pub fn cross_rate(
        &mut self,
        law: &StrutLaw,
        exit: Exit,
        on_surface: bool,
        stroke: f64,
        link_rate: f64,
    ) {
        match self {
            Self::Hanging { .. } => {}
            Self::Stopped { .. } => {
                *self = Self::Working(Working {
                    segment: law.segment_at(stroke),
                    travel: Travel::SlowStroke,
                });
            }
            Self::Working(Working { segment, .. }) if law.is_on_stop(*segment) => {
                *self = Self::extended(on_surface, link_rate);
            }
            Self::Working(Working { travel, .. }) => *travel = travel.neighbour(exit),
        }
    }

    /// The surface's torque on the link changed sign on the stop.
    pub fn cross_torque(&mut self, exit: Exit) {
        if let Self::Stopped { pushed } = self {
            *pushed = exit == Exit::Below;
        }
    }
}
