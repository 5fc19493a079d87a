//! The footpad hinge and its stops (model chapter 6): α between an inner and an outer stop.
//!
//! Beyond a stop and moving outward, dα/dt = α̇ (1 − 1000·overrun), so that α comes to rest 0.001 rad
//! beyond it, while the state α̇ keeps integrating and holds the pad there until it changes sign.
//! |dα/dt| never exceeds 100 rad/s.
//!
//! That has a closed form: overrun = (1 − e^(−1000 Θ))/1000, with Θ = ∫|α̇| dt the angle that α̇ has turned since the
//! stop. So a pad that presses on a stop has a *turn* in place of its angle, stop ± Θ, which follows α̇ and is not
//! stiff. Methods that choose pieces anew at every evaluation take dα/dt as written.
//!
//! Under [`ContactRule::Face`] all of that is plain mechanics: a pad that arrives at a stop is one with its link until
//! the torque on it pulls it off.

use libm::log1p;

use crate::integrator::event::{Bounds, Exit};
use crate::lanes::per_lane;
use crate::rules::ContactRule;
use crate::scalar::Real;

/// Fading of the rate beyond a stop, 1/rad: its inverse is the greatest overrun.
const FADING: f64 = 1000.0;
/// Most e-foldings of the distance from the resting place in one step. With 16 the force of a pad on its way to its
/// stop hides between two stages, and with 8 its share of the error still shows at tight tolerances.
const E_FOLDINGS: f64 = 4.0;
/// Greatest |dα/dt|, rad/s.
const FASTEST: f64 = 100.0;
/// Slacks of the guards on turn (rad), rate state (rad/s), hinge speed (rad/s) and torque on a pad at a stop (ft·lb).
const ANGLE_SLACK: f64 = 1e-14;
const RATE_SLACK: f64 = 1e-10;
const SPEED_SLACK: f64 = 1e-9;
const TORQUE_SLACK: f64 = 1e-9;

/// Coefficients of the active piece: unclipped speed = (gain + fading α) α̇, and
/// dα/dt = follow · unclipped speed + clip.
#[derive(Debug, Clone, Copy)]
pub struct HingePiece<S> {
    gain: S,
    fading: S,
    follow: S,
    clip: S,
    /// −1 or +1 if the pad presses on its inner or outer stop and follows α̇ by the closed form, else 0.
    pressed: S,
    /// That stop, rad.
    stop: S,
}

per_lane!(HingePiece {
    gain,
    fading,
    follow,
    clip,
    pressed,
    stop,
});

impl<S: Real> HingePiece<S> {
    /// A footpad that does not move.
    pub fn still() -> Self {
        let zero = S::zero();
        Self {
            gain: zero,
            fading: zero,
            follow: zero,
            clip: zero,
            pressed: zero,
            stop: zero,
        }
    }

    /// 1 if the pad turns by itself, 0 if it is one with its link, under [`ContactRule::Face`].
    #[inline(always)]
    pub fn swings(&self) -> S {
        self.gain
    }

    /// Rate at which the pad turns in the vehicle under [`ContactRule::Face`], from outboard to down, rad/s: that of
    /// its link less the opening of its hinge.
    #[inline(always)]
    pub fn pad_turning(&self, link_rate: S, pad_rate: S) -> S {
        link_rate - self.gain * pad_rate
    }

    /// Returns whether a pad presses on a stop.
    #[inline(always)]
    pub fn is_pressed(&self) -> bool {
        !self.pressed.is_zero()
    }

    /// Angle α of a pad with this turn, rad.
    #[inline(always)]
    pub fn angle(&self, turn: S) -> S {
        let fading = S::constant(FADING) * self.pressed;
        let left = (fading * (self.stop - turn)).exp();
        let overrun = (S::one() - left) * S::constant(1.0 / FADING);
        self.pressed
            .where_zero(turn, self.stop + self.pressed * overrun)
    }

    /// Hinge speed before the clip, rad/s.
    #[inline(always)]
    pub fn unclipped_speed(&self, angle: S, rate: S) -> S {
        self.gain_at(angle) * rate
    }

    /// Rate of the pad's turn, rad/s: dα/dt, or α̇ while it presses on a stop.
    #[inline(always)]
    pub fn turning(&self, speed: S, rate: S) -> S {
        self.pressed.where_zero(speed, rate)
    }

    /// Gain on α̇ and offset (rad/s) of the pad's turning rate in this hinge mode.
    #[inline(always)]
    pub fn turning_by_rate(&self) -> [S; 2] {
        let by_rate = self.pressed.where_zero(self.follow * self.gain, S::one());
        [by_rate, self.clip]
    }

    /// Change of that rate with α̇, and of α with the turn, at this α (rad).
    #[inline(always)]
    pub fn turn_changes(&self, angle: S) -> [S; 2] {
        let gain = self.gain_at(angle);
        let one = S::one();
        [
            self.pressed.where_zero(self.follow * gain, one),
            self.pressed.where_zero(one, gain),
        ]
    }

    /// Hinge speed before the clip per α̇ at this α (rad): 0 at rest on a stop.
    #[inline(always)]
    pub fn gain_at(&self, angle: S) -> S {
        self.gain + self.fading * angle
    }

    /// dα/dt, rad/s, from the speed before the clip.
    #[inline(always)]
    pub fn speed(&self, unclipped: S) -> S {
        self.follow * unclipped + self.clip
    }
}

/// The stops of one footpad, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stops {
    /// Least angle.
    pub inner: f64,
    /// Greatest angle.
    pub outer: f64,
    /// Distance from the resting place beyond a stop at which the pad counts as arrived.
    pub arrival: f64,
    /// Rule of the stops.
    pub rule: ContactRule,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Inner,
    Outer,
}

impl Side {
    /// +1 if outward is toward greater α, else −1.
    fn sign(self) -> f64 {
        match self {
            Self::Inner => -1.0,
            Self::Outer => 1.0,
        }
    }

    /// The stop on this side, rad.
    fn of(self, stops: Stops) -> f64 {
        match self {
            Self::Inner => stops.inner,
            Self::Outer => stops.outer,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Zone {
    /// Between the stops.
    Free,
    /// Beyond a stop and moving outward.
    Pressing(Side),
    /// At rest on a stop.
    Held(Side),
    /// Beyond a stop and moving back.
    Returning(Side),
    /// On a stop, one with the link ([`ContactRule::Face`]).
    OnStop(Side),
}

/// Mode of the hinge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    zone: Zone,
    /// Sign of the clipped speed, 0 when it is not clipped.
    clip: f64,
}

impl Hinge {
    /// A pad at rest between its stops.
    pub fn free() -> Self {
        Self {
            zone: Zone::Free,
            clip: 0.0,
        }
    }

    /// Mode of the hinge at an angle α (rad) and rate state α̇ (rad/s).
    pub fn at(stops: Stops, angle: f64, rate: f64) -> Self {
        let beyond = |side: Side, overrun: f64| match side.sign() * rate {
            outward if outward <= 0.0 => Zone::Returning(side),
            _ if overrun >= 1.0 / FADING => Zone::Held(side),
            _ => Zone::Pressing(side),
        };
        let zone = if angle > stops.outer {
            beyond(Side::Outer, angle - stops.outer)
        } else if angle < stops.inner {
            beyond(Side::Inner, stops.inner - angle)
        } else {
            Zone::Free
        };
        let unclipped = Self { zone, clip: 0.0 };
        let speed = unclipped.piece(stops).unclipped_speed(angle, rate);
        let clip = if speed.abs() > FASTEST {
            speed.signum()
        } else {
            0.0
        };
        Self { zone, clip }
    }

    /// Coefficients of the active piece.
    pub fn piece(&self, stops: Stops) -> HingePiece<f64> {
        let written = self.piece_as_written(stops);
        match self.zone {
            Zone::Pressing(side) if self.clip == 0.0 => HingePiece {
                pressed: side.sign(),
                stop: side.of(stops),
                ..written
            },
            _ => written,
        }
    }

    /// Piece of the hinge without the closed form: the pad's turn is its angle.
    pub fn piece_as_written(&self, stops: Stops) -> HingePiece<f64> {
        let (gain, fading) = match self.zone {
            Zone::Free | Zone::Returning(_) => (1.0, 0.0),
            Zone::Pressing(Side::Outer) => (1.0 + FADING * stops.outer, -FADING),
            Zone::Pressing(Side::Inner) => (1.0 - FADING * stops.inner, FADING),
            Zone::Held(_) | Zone::OnStop(_) => (0.0, 0.0),
        };
        let follow = if self.clip == 0.0 { 1.0 } else { 0.0 };
        HingePiece {
            gain,
            fading,
            follow,
            clip: FASTEST * self.clip,
            pressed: 0.0,
            stop: 0.0,
        }
    }

    /// Returns whether the pad is on a stop, one with its link.
    pub fn is_on_stop(&self) -> bool {
        matches!(self.zone, Zone::OnStop(_))
    }

    /// Angle α of a pad with this turn, rad.
    pub fn angle(&self, stops: Stops, turn: f64) -> f64 {
        self.piece(stops).angle(turn)
    }

    /// The turn of a pad at this angle α, rad.
    pub fn turn(&self, stops: Stops, angle: f64) -> f64 {
        if let Zone::OnStop(side) = self.zone {
            return side.of(stops);
        }
        let HingePiece { pressed, stop, .. } = self.piece(stops);
        if pressed == 0.0 {
            return angle;
        }
        // No turn suffices for more than that, which is past its arrival.
        let overrun = (pressed * (angle - stop)).min(1.0 / FADING - 0.5 * stops.arrival);
        stop - pressed * log1p(-FADING * overrun) / FADING
    }

    /// Range of the turn over which the active piece holds.
    pub fn turn_bounds(&self, stops: Stops) -> Bounds {
        // Distance of α from its stop on arrival, which is also the turn without the closed form.
        let resting = 1.0 / FADING - stops.arrival;
        let arrived = |side: Side| self.turn(stops, side.of(stops) + side.sign() * resting);
        match self.zone {
            Zone::Free => Bounds::between(stops.inner, stops.outer),
            Zone::Pressing(side @ Side::Outer) => Bounds::below(arrived(side)),
            Zone::Pressing(side @ Side::Inner) => Bounds::above(arrived(side)),
            Zone::Held(_) | Zone::OnStop(_) => Bounds::FREE,
            Zone::Returning(Side::Outer) => Bounds::above(stops.outer),
            Zone::Returning(Side::Inner) => Bounds::below(stops.inner),
        }
        .widened(ANGLE_SLACK)
    }

    /// Range of the rate state α̇ over which the active piece holds.
    pub fn rate_bounds(&self) -> Bounds {
        let outward = match self.zone {
            Zone::Free | Zone::OnStop(_) => return Bounds::FREE,
            Zone::Pressing(side) | Zone::Held(side) => side.sign(),
            Zone::Returning(side) => -side.sign(),
        };
        let bounds = if outward > 0.0 {
            Bounds::above(0.0)
        } else {
            Bounds::below(0.0)
        };
        bounds.widened(RATE_SLACK)
    }

    /// Range of the hinge's drive over which the active piece holds: of its unclipped speed, or of the torque on a pad
    /// that is one with its link.
    pub fn drive_bounds(&self, stops: Stops) -> Bounds {
        match self.zone {
            Zone::OnStop(Side::Outer) => return Bounds::above(0.0).widened(TORQUE_SLACK),
            Zone::OnStop(Side::Inner) => return Bounds::below(0.0).widened(TORQUE_SLACK),
            Zone::Held(_) => return Bounds::FREE,
            _ if stops.rule == ContactRule::Face => return Bounds::FREE,
            Zone::Free | Zone::Pressing(_) | Zone::Returning(_) => {}
        }
        if self.clip > 0.0 {
            Bounds::above(FASTEST)
        } else if self.clip < 0.0 {
            Bounds::below(-FASTEST)
        } else {
            Bounds::between(-FASTEST, FASTEST)
        }
        .widened(SPEED_SLACK)
    }

    /// Longest step that follows the pad into a stop, s, at a rate state α̇ (rad/s). In longer steps the arrival and
    /// its effect on the forces would go unseen.
    pub fn longest_step(&self, rate: f64) -> f64 {
        match self.zone {
            Zone::Pressing(_) if self.clip == 0.0 => E_FOLDINGS / (FADING * rate.abs()),
            _ => f64::INFINITY,
        }
    }

    /// Handles an exit of the turn.
    pub fn cross_turn(&mut self, stops: Stops, exit: Exit) {
        match self.zone {
            Zone::Free => {
                let side = match exit {
                    Exit::Above => Side::Outer,
                    Exit::Below => Side::Inner,
                };
                self.zone = match stops.rule {
                    ContactRule::Pivot => Zone::Pressing(side),
                    ContactRule::Face => Zone::OnStop(side),
                };
            }
            Zone::Pressing(side) => {
                *self = Self {
                    zone: Zone::Held(side),
                    clip: 0.0,
                }
            }
            Zone::Returning(_) => self.zone = Zone::Free,
            Zone::Held(_) | Zone::OnStop(_) => {}
        }
    }

    /// Handles a rate state that changed sign.
    pub fn cross_rate(&mut self) {
        self.zone = match self.zone {
            Zone::Free | Zone::OnStop(_) => self.zone,
            Zone::Pressing(side) | Zone::Held(side) => Zone::Returning(side),
            Zone::Returning(side) => Zone::Pressing(side),
        };
    }

    /// Handles an unclipped speed that crossed the clip, or a torque that pulls the pad off its stop.
    pub fn cross_drive(&mut self, exit: Exit) {
        if self.is_on_stop() {
            self.zone = Zone::Free;
            return;
        }
        self.clip = match (self.clip == 0.0, exit) {
            (true, Exit::Above) => 1.0,
            (true, Exit::Below) => -1.0,
            (false, _) => 0.0,
        };
    }
}
