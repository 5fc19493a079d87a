//! The strut, shock absorber (42)-(45) or honeycomb, and its action on the lower link: working, or on its extension
//! stop on or off the surface (model chapter 5).

mod law;
mod stance;

use crate::lanes::per_lane;
use crate::scalar::Real;

pub use law::StrutLaw;
pub use stance::{GentleKinks, Stance};

/// Link rate γ̇ below which damping and seal friction fade in, rad/s.
const SMOOTHING_RATE: f64 = 0.2;
/// Stroke at and below which an extending leg is on its stop, ft.
pub const STOP_STROKE: f64 = 1e-6;
/// Rate that an airborne link's γ̇ runs down to, rad/s.
const RESIDUAL_RATE: f64 = 0.001;

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

per_lane!(StrutPiece {
    base,
    growth,
    multiplier,
    elastic_limit,
    friction_fraction,
    compression,
    rebound,
});

/// A stretch of a piecewise-linear function together with the two neighbouring stretches: kinks this gentle change no
/// piece.
#[derive(Debug, Clone, Copy)]
struct Kinked<S> {
    offset: S,
    slope: S,
    /// Kinks at the lower and upper end: place, and loss (below) or gain (above) of slope.
    kinks: [[S; 2]; 2],
}

per_lane!(Kinked {
    offset,
    slope,
    kinks,
});

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
        let parts = self.parts(stroke, link_rate, lever);
        parts.spring - link_rate.signed_like(parts.engaged * parts.resistance)
    }

    /// −∂F/∂γ̇, lb·s: resistance of the force to a change of the link rate.
    #[inline(always)]
    pub fn damping(&self, stroke: S, link_rate: S, lever: S) -> S {
        let parts = self.parts(stroke, link_rate, lever);
        let engaging = S::constant(3.0 / SMOOTHING_RATE) * parts.shortfall * parts.shortfall;
        let two = S::constant(2.0);
        engaging * parts.resistance
            + parts.engaged * two * parts.damping * lever * lever * link_rate.abs()
    }

    /// d(F lever)/dγ, ft·lb, from the change of the lever dl_D/dγ with the link angle (ft).
    #[inline(always)]
    pub fn torque_change(&self, stroke: S, link_rate: S, lever: S, lever_change: S) -> S {
        let parts = self.parts(stroke, link_rate, lever);
        let above = stroke - self.elastic_limit;
        let multiplier = self.multiplier.at(stroke) + self.multiplier.slope * above;
        let spring = self.base[1] + self.growth * multiplier;
        let strut_rate = lever * link_rate;
        let hardening = link_rate.where_negative(self.compression.slope, self.rebound[1]);
        let against = link_rate.signed_like(parts.engaged);
        let per_stroke = spring
            - against * (self.friction_fraction * spring + hardening * strut_rate * strut_rate);
        let two = S::constant(2.0);
        let per_lever = -(against * two * parts.damping * strut_rate * link_rate);
        let force = parts.spring - against * parts.resistance;
        (force + lever * per_lever) * lever_change - lever * lever * per_stroke
    }

    #[inline(always)]
    fn parts(&self, stroke: S, link_rate: S, lever: S) -> Parts<S> {
        let spring = self.base[0]
            + self.base[1] * stroke
            + self.growth * self.multiplier.at(stroke) * (stroke - self.elastic_limit);
        let compression = self.compression.at(stroke);
        let rebound = self.rebound[0] + self.rebound[1] * stroke;
        let damping = link_rate.where_negative(compression, rebound);
        let strut_rate = lever * link_rate;
        let speed = link_rate.abs() * S::constant(1.0 / SMOOTHING_RATE);
        let shortfall = (S::one() - speed).max(S::zero());
        Parts {
            spring,
            damping,
            resistance: self.friction_fraction * spring.abs() + damping * strut_rate * strut_rate,
            shortfall,
            engaged: S::one() - shortfall * shortfall * shortfall,
        }
    }
}

/// Parts of the strut force.
struct Parts<S> {
    /// Spring force F_s (42), (43), or load of the cartridge, lb.
    spring: S,
    /// Damping in the present direction, lb·s²/ft².
    damping: S,
    /// R = ν|F_s| + d l̇² (44), (45), lb.
    resistance: S,
    /// 1 − |γ̇|/0.2, or 0 above.
    shortfall: S,
    /// c = 1 − shortfall³.
    engaged: S,
}

/// Coefficients of the link equation: γ̈ = free·(torque/I_γ) − run_down (γ̇ − 0.001), and γ moves at
/// moving·γ̇.
#[derive(Debug, Clone, Copy)]
pub struct LinkPiece<S> {
    /// 1 if the torque turns the link, else 0.
    pub free: S,
    run_down: S,
    /// 1 if γ follows its rate, 0 if the link is frozen.
    pub moving: S,
}

per_lane!(LinkPiece {
    free,
    run_down,
    moving,
});

impl<S: Real> LinkPiece<S> {
    /// A link that does not move.
    pub fn still() -> Self {
        let zero = S::zero();
        Self {
            free: zero,
            run_down: zero,
            moving: zero,
        }
    }

    /// Rate (1/s) at which an airborne link's rate runs down.
    #[inline(always)]
    pub fn run_down(&self) -> S {
        self.run_down
    }

    /// Link rate γ̇ (rad/s) above the residual rate, rad/s.
    #[inline(always)]
    pub fn surplus(&self, link_rate: S) -> S {
        link_rate - S::constant(RESIDUAL_RATE)
    }

    /// Link acceleration γ̈, rad/s².
    #[inline(always)]
    pub fn acceleration(&self, torque_over_inertia: S, link_rate: S) -> S {
        self.free * torque_over_inertia - self.run_down * self.surplus(link_rate)
    }
}
