//! The shock absorber (42)-(45) and what it does to the lower link: working, or on its extension
//! stop on or off the surface (model chapter 5).

use crate::integrator::event::{Bounds, Exit};
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

/// Coefficients of the active piece of the strut law. With spring F_s = s0 + s1 δ + s2 δ²:
/// F = F_s + c (dry F_s + (d0 + d1 δ) l̇²), c = 1 − fade (1 − gain γ̇)³.
#[derive(Debug, Clone, Copy)]
pub struct StrutPiece<S> {
    spring: [S; 3],
    dry: S,
    damping: [S; 2],
    fade: S,
    gain: S,
}

impl<S: Real> StrutPiece<S> {
    /// No force.
    pub fn slack() -> Self {
        let zero = S::zero();
        Self {
            spring: [zero; 3],
            dry: zero,
            damping: [zero; 2],
            fade: zero,
            gain: zero,
        }
    }

    /// Axial force F, lb, compression positive, at stroke δ (ft), link rate γ̇ (rad/s) and strut
    /// rate l̇ (ft/s).
    #[inline(always)]
    pub fn force(&self, stroke: S, link_rate: S, strut_rate: S) -> S {
        let spring = self.spring[0] + stroke * (self.spring[1] + stroke * self.spring[2]);
        let shortfall = S::one() - self.gain * link_rate;
        let engaged = S::one() - self.fade * shortfall * shortfall * shortfall;
        let viscous = (self.damping[0] + self.damping[1] * stroke) * strut_rate * strut_rate;
        spring + engaged * (self.dry * spring + viscous)
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

/// A stretch of stroke over which both tables and the spring law keep one piece.
#[derive(Debug, Clone, Copy)]
struct StrokeSegment {
    upper: f64,
    spring: [f64; 3],
    /// Compression damping R_c S_D = offset + slope δ.
    compression: [f64; 2],
}

/// The law of one strut.
#[derive(Debug, Clone)]
pub struct StrutLaw {
    segments: Vec<StrokeSegment>,
    /// Rebound damping R_R (1 + SRL δ) = offset + slope δ.
    rebound: [f64; 2],
    friction_fraction: f64,
    bottoming_stroke: f64,
}

impl StrutLaw {
    /// The law of a strut, cut where any of its pieces changes.
    pub fn new(strut: &vehicle::Strut) -> Self {
        let elastic_limit = strut.preload / strut.structural_stiffness;
        let mut knots: Vec<f64> = [&strut.spring_profile, &strut.damping_profile]
            .iter()
            .flat_map(|p| p.knots()[1..p.knots().len() - 1].iter().map(|k| k[0]))
            .chain([0.0, elastic_limit, f64::INFINITY])
            .collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        let mut lower = f64::NEG_INFINITY;
        let segments = knots
            .into_iter()
            .map(|upper| {
                let spring = if upper <= elastic_limit {
                    [0.0, strut.structural_stiffness, 0.0]
                } else {
                    // F_p + K_D (a + b δ)(δ − δ_E)
                    let s = strut.spring_profile.segment_at(lower);
                    let k = strut.spring_constant;
                    [
                        strut.preload - k * s.offset * elastic_limit,
                        k * (s.offset - s.slope * elastic_limit),
                        k * s.slope,
                    ]
                };
                let compression = if upper <= 0.0 {
                    [strut.compression_damping, 0.0]
                } else {
                    let s = strut.damping_profile.segment_at(lower);
                    [
                        strut.compression_damping * s.offset,
                        strut.compression_damping * s.slope,
                    ]
                };
                lower = upper;
                StrokeSegment {
                    upper,
                    spring,
                    compression,
                }
            })
            .collect();
        Self {
            segments,
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
}

/// Direction and speed range of the link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Travel {
    FastStroke,
    SlowStroke,
    SlowRebound,
    FastRebound,
}

impl Travel {
    fn is_rebound(self) -> bool {
        self >= Self::SlowRebound
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
            Self::Working(Working { segment, travel }) => {
                let StrokeSegment {
                    spring,
                    compression,
                    ..
                } = law.segments[segment];
                // The spring changes sign with the stroke; seal friction opposes the motion.
                let spring_sign = if law.segments[segment].upper <= 0.0 {
                    -1.0
                } else {
                    1.0
                };
                let (direction, damping) = if travel.is_rebound() {
                    (-1.0, law.rebound.map(|r| -r))
                } else {
                    (1.0, compression)
                };
                let (fade, gain) = match travel {
                    Travel::SlowStroke => (1.0, -1.0 / SMOOTHING_RATE),
                    Travel::SlowRebound => (1.0, 1.0 / SMOOTHING_RATE),
                    Travel::FastStroke | Travel::FastRebound => (0.0, 0.0),
                };
                let dry = direction * spring_sign * law.friction_fraction;
                (
                    StrutPiece {
                        spring,
                        dry,
                        damping,
                        fade,
                        gain,
                    },
                    LinkPiece {
                        free: 1.0,
                        run_down: 0.0,
                        moving: 1.0,
                    },
                )
            }
        }
    }

    /// Range of the stroke over which the active piece holds, bottoming included.
    pub fn stroke_bounds(&self, law: &StrutLaw) -> Bounds {
        let Self::Working(Working { segment, travel }) = *self else {
            return Bounds::FREE;
        };
        let lower = if segment == 0 {
            f64::NEG_INFINITY
        } else {
            law.segments[segment - 1].upper
        };
        let lower = if travel.is_rebound() {
            lower.max(STOP_STROKE)
        } else {
            lower
        };
        let upper = law.segments[segment].upper.min(law.bottoming_stroke);
        Bounds::between(lower, upper).widened(STROKE_SLACK)
    }

    /// Range of the link rate over which the active piece holds.
    pub fn rate_bounds(&self) -> Bounds {
        match self {
            Self::Hanging { .. } => Bounds::FREE,
            Self::Stopped { .. } => Bounds::above(0.0).widened(RATE_SLACK),
            Self::Working(Working { travel, .. }) => travel.bounds().widened(RATE_SLACK),
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
    pub fn cross_stroke(&mut self, exit: Exit, on_surface: bool, link_rate: f64) {
        if let Self::Working(Working { segment, travel }) = self {
            match exit {
                Exit::Above => *segment += 1,
                // In rebound the lower end of the first elastic piece is the stop.
                Exit::Below if travel.is_rebound() && *segment <= 1 => {
                    *self = Self::extended(on_surface, link_rate);
                }
                Exit::Below => *segment -= 1,
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
            Self::Working(Working { travel, .. }) => {
                *travel = travel.neighbour(exit);
                if travel.is_rebound() && stroke <= STOP_STROKE {
                    *self = Self::extended(on_surface, link_rate);
                }
            }
        }
    }

    /// The surface's torque on the link changed sign on the stop.
    pub fn cross_torque(&mut self, exit: Exit) {
        if let Self::Stopped { pushed } = self {
            *pushed = exit == Exit::Below;
        }
    }
}
