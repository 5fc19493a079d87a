//! Stances of a strut and its link: hanging, on the extension stop, or working.

use super::law::StrutLaw;
use super::{LinkPiece, RESIDUAL_RATE, SMOOTHING_RATE, STOP_STROKE, StrutPiece};
use crate::crush::PressureLine;
use crate::integrator::event::{Bounds, Exit};

/// Rate at which an airborne link's γ̇ runs down, 1/s.
const RUN_DOWN: f64 = 75.0;
/// Slacks of the guards: stroke (ft), rate (rad/s), torque on the link (ft·lb).
const STROKE_SLACK: f64 = 1e-13;
const RATE_SLACK: f64 = 1e-11;
const TORQUE_SLACK: f64 = 1e-9;

/// Stance of the strut and its link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stance {
    /// Extended and off the surface: the link is frozen, and its rate state runs down while it is above 0.001 rad/s.
    Hanging {
        /// True while the rate runs down.
        running_down: bool,
    },
    /// Extended, on the surface and not stroking: the stop carries the load that would extend it further.
    Stopped {
        /// True if the surface pushes the link in.
        pushed: bool,
    },
    /// The strut law holds.
    Working {
        /// Segment of the stroke or, across a gentle kink, the one next to it.
        segment: usize,
    },
}

/// Gentle kinks of the strut law on either side of a leg's state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GentleKinks {
    /// Strokes δ at which a table bends, ft.
    pub strokes: Bounds,
    /// Link rates γ̇ at which the link turns or resistance is complete, rad/s.
    pub link_rates: Bounds,
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

    /// Stance of a leg, on or off the surface, at a stroke δ (ft) and link rate γ̇ (rad/s). On its stop on the surface
    /// it is not pushed: the sign of the torque decides.
    pub fn at(law: &StrutLaw, on_surface: bool, stroke: f64, link_rate: f64) -> Self {
        if link_rate >= 0.0 && stroke <= STOP_STROKE {
            return Self::extended(on_surface, link_rate);
        }
        Self::Working {
            segment: law.segment_at(stroke),
        }
    }

    /// Returns whether the link is on its stop, and nothing pushes it in. (One that is pushed may have been in by less than
    /// the stroke at which the strut sets in, and come back.)
    pub fn is_on_stop(&self) -> bool {
        matches!(self, Self::Hanging { .. } | Self::Stopped { pushed: false })
    }

    /// Returns whether the link hangs still.
    pub fn is_hanging(&self) -> bool {
        matches!(self, Self::Hanging { .. })
    }

    /// Returns whether the leg is on its extension stop.
    pub fn is_extended(&self) -> bool {
        !matches!(self, Self::Working { .. })
    }

    /// Coefficients of the active pieces. The cartridge, if any, is on this line of load (lb) against stroke.
    pub fn pieces(
        &self,
        law: &StrutLaw,
        load: &PressureLine<f64>,
    ) -> (StrutPiece<f64>, LinkPiece<f64>) {
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
            Self::Working { segment } => (
                law.piece(segment, load),
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
        let Self::Working { segment } = *self else {
            return Bounds::FREE;
        };
        let [first, last] = span(law, segment);
        let upper = law.upper(last).min(law.bottoming_stroke());
        Bounds::between(law.lower(first), upper).widened(STROKE_SLACK)
    }

    /// Range of the link rate over which the active piece holds.
    pub fn rate_bounds(&self, law: &StrutLaw) -> Bounds {
        match *self {
            Self::Hanging { .. } => Bounds::FREE,
            Self::Stopped { .. } => Bounds::above(0.0).widened(RATE_SLACK),
            Self::Working { segment } if law.is_on_stop(segment) => {
                Bounds::below(0.0).widened(RATE_SLACK)
            }
            Self::Working { .. } => Bounds::FREE,
        }
    }

    /// The gentle kinks next to the stroke and the link rate γ̇ (rad/s) of a working strut.
    pub fn gentle_kinks(&self, law: &StrutLaw, link_rate: f64) -> Option<GentleKinks> {
        let Self::Working { segment } = *self else {
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
            link_rates: between_turns(link_rate, law.turning_slack()),
        })
    }

    /// Follows the stroke over a gentle kink or off the stop. The law stays the same; its coefficients are centred on
    /// the segment of the stroke. Returns whether they changed.
    pub fn follow(&mut self, law: &StrutLaw, stroke: f64) -> bool {
        let Self::Working { segment } = self else {
            return false;
        };
        if law.is_on_stop(*segment) && stroke > law.upper(*segment) {
            *segment = law.segment_at(stroke);
            true
        } else if law.is_gentle_above(*segment) && stroke > law.upper(*segment) {
            *segment += 1;
            true
        } else if law.is_gentle_below(*segment) && stroke < law.lower(*segment) {
            *segment -= 1;
            true
        } else {
            false
        }
    }

    /// Range of the surface's torque on the link over which the stop keeps carrying, or not. A torque up to `least`
    /// (ft·lb) does not yet push the link in.
    pub fn torque_bounds(&self, least: f64) -> Bounds {
        match self {
            Self::Stopped { pushed: true } => Bounds::below(0.0).widened(TORQUE_SLACK),
            Self::Stopped { pushed: false } => Bounds::above(-least).widened(TORQUE_SLACK),
            _ => Bounds::FREE,
        }
    }

    /// Handles a stroke that left its range (other than by bottoming).
    pub fn cross_stroke(&mut self, law: &StrutLaw, exit: Exit, on_surface: bool, link_rate: f64) {
        if let Self::Working { segment } = self {
            let [first, last] = span(law, *segment);
            *segment = match exit {
                Exit::Above => last + 1,
                Exit::Below => first - 1,
            };
            if law.is_on_stop(*segment) && link_rate >= 0.0 {
                *self = Self::extended(on_surface, link_rate);
            }
        }
    }

    /// Handles a link rate that left its range.
    pub fn cross_rate(&mut self, law: &StrutLaw, on_surface: bool, stroke: f64, link_rate: f64) {
        match self {
            Self::Stopped { .. } => {
                *self = Self::Working {
                    segment: law.segment_at(stroke),
                };
            }
            Self::Working { segment } if stroke > STOP_STROKE => {
                *segment = law.segment_at(stroke);
            }
            Self::Working { segment } if law.is_on_stop(*segment) => {
                *self = Self::extended(on_surface, link_rate);
            }
            Self::Hanging { .. } | Self::Working { .. } => {}
        }
    }

    /// Handles a change of sign of the surface's torque on the link on the stop.
    pub fn cross_torque(&mut self, exit: Exit) {
        if let Self::Stopped { pushed } = self {
            *pushed = exit == Exit::Below;
        }
    }
}

/// First and last segment of one law for a strut that works in `segment`: across gentle kinks, and while it leaves the
/// stop, where only the link must not turn.
fn span(law: &StrutLaw, segment: usize) -> [usize; 2] {
    let first = segment - usize::from(law.is_gentle_below(segment));
    let mut last = segment + usize::from(law.is_gentle_above(segment));
    while law.is_on_stop(segment) && law.goes_on_above(last) {
        last += 1;
    }
    [first, last]
}

/// Range of a link rate between standstill, with `slack` past it, and the rate at which resistance is complete, rad/s.
fn between_turns(link_rate: f64, slack: f64) -> Bounds {
    if link_rate < -SMOOTHING_RATE {
        Bounds::below(-SMOOTHING_RATE)
    } else if link_rate < 0.0 {
        Bounds::between(-SMOOTHING_RATE, slack)
    } else if link_rate < SMOOTHING_RATE {
        Bounds::between(-slack, SMOOTHING_RATE)
    } else {
        Bounds::above(SMOOTHING_RATE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rate_is_within_its_range_and_the_opposite_rate_in_the_mirrored_one() {
        const SLACK: f64 = 1e-4;
        for rate in [1e-9, 0.5, 2.0].map(|part| part * SMOOTHING_RATE) {
            let (one, other) = (between_turns(rate, SLACK), between_turns(-rate, SLACK));
            assert!(one.lower <= rate && rate <= one.upper, "{rate}: {one:?}");
            assert_eq!((one.lower, one.upper), (-other.upper, -other.lower));
        }
        assert_eq!(between_turns(0.0, SLACK).lower, -SLACK);
    }
}
