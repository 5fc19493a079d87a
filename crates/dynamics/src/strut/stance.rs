//! What a strut and its link are doing: hanging, on the extension stop, or working.

use super::law::{Kinks, StrutLaw};
use super::{LinkPiece, RESIDUAL_RATE, SMOOTHING_RATE, STOP_STROKE, StrutPiece};
use crate::integrator::event::{Bounds, Exit};

/// Rate at which an airborne link's γ̇ runs down, 1/s.
const RUN_DOWN: f64 = 75.0;
/// Slacks of the guards: stroke (ft), rate (rad/s), torque on the link (ft·lb).
const STROKE_SLACK: f64 = 1e-13;
const RATE_SLACK: f64 = 1e-11;
const TORQUE_SLACK: f64 = 1e-9;

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

    /// Range of the link rate, up to `slack` past standstill.
    fn bounds(self, slack: f64) -> Bounds {
        match self {
            Self::FastStroke => Bounds::below(-SMOOTHING_RATE),
            Self::SlowStroke => Bounds::between(-SMOOTHING_RATE, slack),
            Self::SlowRebound => Bounds::between(-slack, SMOOTHING_RATE),
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

/// Between which gentle kinks of the strut law a leg is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GentleKinks {
    /// Strokes δ at which a table bends, ft.
    pub strokes: Bounds,
    /// Link rates γ̇ at which the link turns or resistance is fully there, rad/s.
    pub link_rates: Bounds,
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
        let upper = law.upper(last).min(law.bottoming_stroke());
        Bounds::between(law.lower(first), upper).widened(STROKE_SLACK)
    }

    /// Range of the link rate over which the active piece holds.
    pub fn rate_bounds(&self, law: &StrutLaw) -> Bounds {
        match *self {
            Self::Hanging { .. } => Bounds::FREE,
            Self::Stopped { .. } => Bounds::above(0.0).widened(RATE_SLACK),
            Self::Working(Working { segment, travel }) => match law.kinks() {
                _ if law.is_on_stop(segment) => Bounds::below(0.0).widened(RATE_SLACK),
                Kinks::Located => travel.bounds(law.turning_slack()).widened(RATE_SLACK),
                Kinks::Foreseen | Kinks::SteppedOver => Bounds::FREE,
            },
        }
    }

    /// The gentle kinks next to the stroke and the link rate γ̇ (rad/s) of a working strut.
    pub fn gentle_kinks(&self, law: &StrutLaw, link_rate: f64) -> Option<GentleKinks> {
        let Self::Working(Working { segment, .. }) = *self else {
            return None;
        };
        if law.is_on_stop(segment) {
            return None;
        }
        let mut strokes = Bounds::FREE;
        if law.is_gentle_below(segment) {
            strokes.lower = law.lower(segment);
        }
        if law.is_gentle_above(segment) {
            strokes.upper = law.upper(segment);
        }
        Some(GentleKinks {
            strokes,
            link_rates: Travel::at(link_rate).bounds(0.0),
        })
    }

    /// Follows the stroke over a gentle kink: the law stays the same, its coefficients are centred
    /// on the segment the stroke is in.
    /// Whether they changed.
    pub fn follow(&mut self, law: &StrutLaw, stroke: f64) -> bool {
        let Self::Working(Working { segment, .. }) = self else {
            return false;
        };
        if law.is_gentle_above(*segment) && stroke > law.upper(*segment) {
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
