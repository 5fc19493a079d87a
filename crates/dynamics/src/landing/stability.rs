//! Stability angle, critical feet and the quantities that decide outcomes (2.7, model chapter 7).

use arrayvec::ArrayVec;
use libm::{atan2, hypot};
use nalgebra::Vector3;
use num_traits::Zero;

use super::hull::Hull;
use crate::critical_feet::{CriticalFeet, critical_feet};
use crate::extremes::greatest;
use crate::integrator::event::{Bounds, Guard, SignalValues};
use crate::integrator::ranges::{LANES, Quad, Ranges};
use crate::motion::{Footing, Motion};
use crate::outcome::Outcome;
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::rules::{RestRule, Rules, TopplingRule};
use crate::scene::Scene;
use crate::state::{Body, State};
use crate::vehicle::{Ring, Vehicle};

/// Speed below which the CG has no direction of its own, ft/s.
const DIRECTIONLESS: f64 = 0.001;
/// Least magnitude of the denominator of (76), ft²/s.
const LEAST_DENOMINATOR: f64 = 1e-4;
/// Calm: speed (ft/s) and angular rate (rad/s) components below which motion has subsided.
const CALM_SPEED: f64 = 2.0;
const CALM_RATE: f64 = 0.1;
/// Height over that of the extended vehicle within which subsided motion stays, ft.
const CALM_MARGIN: f64 = 0.5;
/// Rock-back: σ has been below the first (rad), and has risen from its least value by the second (rad).
#[allow(
    clippy::approx_constant,
    reason = "the listing's rounded number, not a quarter of π"
)]
const ROCKED_UP: f64 = 0.7854;
const ROCKED_BACK: f64 = 0.874;
/// Tangent of the angle by which the CG's horizontal velocity may turn from one observation to the next. σ follows that
/// direction, and the velocity of a CG that almost stands still turns round within milliseconds.
const MOST_TURN: f64 = 0.05;
/// Slacks: foot side (ft²/s or ft), stability angle (rad), the rest (ft/s, rad/s, ft).
const SIDE_SLACK: f64 = 1e-9;
const ANGLE_SLACK: f64 = 1e-12;
const CALM_SLACK: f64 = 1e-11;

/// CG height over the surface above which motion has not subsided, ft, with the highest ground under a footpad.
fn calm_height(vehicle: &Vehicle, scene: &Scene) -> f64 {
    let ground = &scene.conditions().ground;
    let heights = (0..vehicle.leg_count()).map(|leg| ground.leg(leg).pad.height);
    let highest = greatest(heights);
    vehicle.standing_height() + CALM_MARGIN + highest
}

/// Reference for judging toppling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Reference {
    /// The line through the critical feet, in a plane.
    Plane(Plane),
    /// The hull of all feet.
    Hull,
}

/// The plane in which toppling is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Plane {
    /// Plane of the CG's horizontal velocity.
    Motion,
    /// Plane of the steepest slope, while the CG hardly moves sideways.
    Slope,
}

/// The quantities that decide outcomes, at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Observation {
    /// Quantities with a range: σ, those that have to calm down, and the side of each foot, positive left of the plane.
    ranged: [[f64; LANES]; QUADS],
    legs: usize,
    /// Stability angle σ, rad (79); positive inboard of the critical feet.
    pub angle: f64,
    /// Least height of the lower hardpoints over the surface (71), ft.
    pub clearance: f64,
}

/// Number of quantities that have to calm down: Ẋ, Ẏ, Ż in ft/s, ω in rad/s, CG height over the surface in ft.
const CALM: usize = 7;
/// Indices of σ, the first quantity that has to calm down, and the first side of a foot in `ranged`.
const ANGLE: usize = 0;
const FIRST_CALM: usize = 1;
const FIRST_SIDE: usize = FIRST_CALM + CALM;
/// Number of quads in `ranged`.
const QUADS: usize = (FIRST_SIDE + MOST_LEGS).div_ceil(LANES);

impl Observation {
    #[inline(always)]
    fn new(sides: &[f64], angle: f64, calm: [f64; CALM], clearance: f64) -> Self {
        let mut ranged = [[0.0; LANES]; QUADS];
        let numbers = ranged.as_flattened_mut();
        numbers[ANGLE] = angle;
        numbers[FIRST_CALM..][..CALM].copy_from_slice(&calm);
        numbers[FIRST_SIDE..][..sides.len()].copy_from_slice(sides);
        Self {
            ranged,
            legs: sides.len(),
            angle,
            clearance,
        }
    }

    /// Blank observation of a vehicle with this many legs.
    pub(super) fn none(legs: usize) -> Self {
        Self::new(&PerLeg::same(legs, 0.0), 0.0, [0.0; CALM], 0.0)
    }

    /// Quads in use.
    #[inline(always)]
    fn ranged(&self) -> &[[f64; LANES]] {
        &self.ranged[..(FIRST_SIDE + self.legs).div_ceil(LANES)]
    }

    fn sides(&self) -> PerLeg<f64> {
        PerLeg::from_fn(self.legs, |leg| self.get(FIRST_SIDE + leg))
    }

    fn calm(&self) -> [f64; CALM] {
        std::array::from_fn(|k| self.get(FIRST_CALM + k))
    }
}

impl SignalValues for Observation {
    #[inline(always)]
    fn get(&self, index: usize) -> f64 {
        self.ranged.as_flattened()[index]
    }
}

/// Verdict on a vehicle at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// All feet on one side of the plane.
    Yaw,
    /// σ ≤ 0.
    Pitch,
    /// The CG has left the hull of the feet for good.
    Toppled,
    /// Rocked up and came back.
    Rockback,
    /// Motion subsided.
    Subsided,
}

impl From<Verdict> for Outcome {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Yaw => Self::UnstableYaw,
            Verdict::Pitch => Self::UnstablePitch,
            Verdict::Toppled => Self::UnstableToppled,
            Verdict::Rockback => Self::StableRockback,
            Verdict::Subsided => Self::StableSubsided,
        }
    }
}

/// Judge of stability: plane, critical feet, and the limits that the motion is within.
#[derive(Debug, Clone)]
pub struct StabilityMonitor {
    /// Sign that makes X_fp the side of a foot on the plane of steepest slope.
    slope_side: f64,
    /// Present where limits tell whether motion has subsided and whether the vehicle has rocked back.
    limits: Option<Limits>,
    ring: Ring,
    reference: Reference,
    feet: CriticalFeet,
    ranges: Ranges<QUADS>,
    guards: ArrayVec<Guard, { QUADS * LANES }>,
}

/// The limits of 1966 for subsided motion.
#[derive(Debug, Clone, Copy)]
struct Limits {
    /// CG height over the surface above which it has not, ft.
    calm_height: f64,
    /// True if the vehicle can come to rest under the present thrust.
    may_rest: bool,
}

impl Plane {
    /// Stability angle σ (76)-(79) between the vertical and the line from the CG to the point A
    /// where the line joining the critical feet meets the plane. A lies in the plane, so its
    /// horizontal part has the direction of motion and σ is a plain polar angle.
    #[inline(always)]
    fn angle(self, from: &Vector3<f64>, to: &Vector3<f64>, vx: f64, vy: f64) -> f64 {
        let span = to - from;
        let denominator = match self {
            Self::Motion => vx * span.y - vy * span.x,
            Self::Slope => 0.0,
        };
        let along = if denominator.abs() >= LEAST_DENOMINATOR {
            (vy * from.x - vx * from.y) / denominator
        } else if span.x != 0.0 {
            -from.x / span.x
        } else {
            0.5
        };
        let a = from + span * along;
        match self {
            Self::Motion => {
                let speed = (vx * vx + vy * vy).sqrt();
                atan2((a.x * vx + a.y * vy) / speed, a.z)
            }
            Self::Slope => atan2(hypot(a.x, a.y), a.z),
        }
    }
}

impl StabilityMonitor {
    /// A monitor of a vehicle in a scene under these rules, before plane and critical feet are chosen.
    pub fn new(rules: Rules, vehicle: &Vehicle, scene: &Scene) -> Self {
        let slope = scene.conditions().slope;
        Self {
            slope_side: if slope == 0.0 { 1.0 } else { -slope.signum() },
            limits: (rules.rest == RestRule::Limits).then(|| Limits {
                calm_height: calm_height(vehicle, scene),
                may_rest: true,
            }),
            ring: vehicle.ring().clone(),
            reference: match rules.toppling {
                TopplingRule::CriticalFeet => Reference::Plane(Plane::Motion),
                TopplingRule::Hull => Reference::Hull,
            },
            feet: CriticalFeet {
                negative: 0,
                positive: 1,
            },
            ranges: Ranges::free(),
            guards: ArrayVec::new(),
        }
    }

    /// Feet at the ends of the edge over which a vehicle with this footing would topple: the chosen ones or, under the
    /// hull rule, those of the edge nearest to tipping.
    pub fn critical_feet(&self, footing: &Footing) -> [usize; 2] {
        match self.reference {
            Reference::Plane(_) => [self.feet.negative, self.feet.positive],
            Reference::Hull => critical_feet_of_hull(&footing.feet),
        }
    }

    /// Lets motion count as subsided from now on only if the vehicle `may_rest` under its thrust.
    pub fn set_thrust(&mut self, may_rest: bool) {
        if let Some(limits) = &mut self.limits {
            limits.may_rest = may_rest;
        }
        self.guards.clear();
    }

    /// Chooses plane and critical feet anew. σ is then measured against them until a signal leaves its range.
    ///
    /// # Errors
    /// [`Verdict::Yaw`] when all feet stand on one side of the plane.
    pub fn choose_plane(
        &mut self,
        motion: &Motion<f64>,
        state: &State<f64>,
    ) -> Result<Observation, Verdict> {
        self.guards.clear();
        if matches!(self.reference, Reference::Plane(_)) {
            let velocity = state.body().velocity;
            let slow = |speed: f64| speed.abs() < DIRECTIONLESS;
            self.reference = Reference::Plane(if slow(velocity.x) && slow(velocity.y) {
                Plane::Slope
            } else {
                Plane::Motion
            });
            let sides = self.observe(motion, state).sides();
            self.feet = critical_feet(&self.ring, |foot| sides[foot] >= 0.0).ok_or(Verdict::Yaw)?;
        }
        Ok(self.observe(motion, state))
    }

    /// Observes a state with the chosen plane and critical feet.
    pub fn observe(&self, motion: &Motion<f64>, state: &State<f64>) -> Observation {
        self.observe_footing(&motion.footing(state), &state.body())
    }

    /// Observes a known footing.
    #[inline(always)]
    pub fn observe_footing(&self, footing: &Footing, body: &Body<f64>) -> Observation {
        let Footing {
            feet,
            depth,
            hardpoint_depths,
        } = footing;
        let clearance = hardpoint_depths
            .iter()
            .fold(f64::INFINITY, |least, depth| least.min(-depth));
        let mut sides = PerLeg::same(feet.len(), 0.0);
        let angle = match self.reference {
            Reference::Plane(plane) => {
                let (vx, vy) = (body.velocity.x, body.velocity.y);
                for (side, foot) in sides.iter_mut().zip(feet) {
                    *side = match plane {
                        Plane::Motion => vy * foot.x - vx * foot.y,
                        Plane::Slope => self.slope_side * foot.x,
                    };
                }
                let [from, to] = [self.feet.negative, self.feet.positive].map(|foot| &feet[foot]);
                plane.angle(from, to, vx, vy)
            }
            Reference::Hull => Hull::of(feet).stability_angle(),
        };
        let (v, rate) = (&body.velocity, &body.rate);
        let calm = [v.x, v.y, v.z, rate.x, rate.y, rate.z, -depth];
        Observation::new(&sides, angle, calm, clearance)
    }

    /// Chooses the ranges over which the present plane, feet and verdict hold, given the present observation and the
    /// least σ so far. They stay until the next choice, except the end of rock-back.
    #[inline(always)]
    pub fn guard(&mut self, seen: &Observation, least_angle: f64) {
        let highest = if self.limits.is_some() && least_angle < ROCKED_UP {
            least_angle + ROCKED_BACK
        } else {
            f64::INFINITY
        };
        let angle = Bounds {
            lower: match self.reference {
                Reference::Plane(_) => 0.0,
                Reference::Hull => f64::NEG_INFINITY,
            },
            upper: highest + ANGLE_SLACK,
        };
        if self.guards.is_empty() {
            self.set_guard(ANGLE, angle);
            let is_in_plane = matches!(self.reference, Reference::Plane(_));
            if is_in_plane || self.limits.is_some() {
                let calm_height = self.calm_height();
                for (index, value) in seen.calm().into_iter().enumerate() {
                    let cell = calm_cell(calm_height, index, value).widened(CALM_SLACK);
                    self.set_guard(FIRST_CALM + index, cell);
                }
            }
            if is_in_plane {
                for (leg, side) in seen.sides().into_iter().enumerate() {
                    let range = if side >= 0.0 {
                        Bounds::above(0.0)
                    } else {
                        Bounds::below(0.0)
                    };
                    self.set_guard(FIRST_SIDE + leg, range.widened(SIDE_SLACK));
                }
            }
        } else {
            self.guards[ANGLE].range = angle;
            self.ranges.set(ANGLE, angle);
        }
    }

    fn set_guard(&mut self, signal: usize, range: Bounds) {
        self.guards.push(Guard { signal, range });
        self.ranges.set(signal, range);
    }

    /// CG height over the surface above which motion has not subsided, ft; negative infinity where these limits do not
    /// apply.
    fn calm_height(&self) -> f64 {
        match self.limits {
            Some(Limits {
                calm_height,
                may_rest: true,
            }) => calm_height,
            _ => f64::NEG_INFINITY,
        }
    }

    /// Returns whether no range can have been left within a step, judged from observations at the start of the previous
    /// step and at the start and end of this one. `ratio` is this step's length over the previous one's.
    #[inline(always)]
    pub fn keep(&self, observations: [&Observation; 3], ratio: f64) -> bool {
        let looks = observations.map(Observation::ranged);
        let mut reach = [Quad::zero(); QUADS];
        self.ranges.keep(looks, ratio, &mut reach)
    }

    /// Share of a stretch of motion in which the plane of motion turns so little that observations at its ends show σ
    /// between them; 1 if that is all of it. The CG's velocity is taken to change evenly.
    #[inline(always)]
    pub fn share_within_turn(&self, start: &Observation, end: &Observation) -> f64 {
        let horizontal = |seen: &Observation| (seen.get(FIRST_CALM), seen.get(FIRST_CALM + 1));
        let ((ax, ay), (bx, by)) = (horizontal(start), horizontal(end));
        let (sine, cosine) = (ax * by - ay * bx, ax * bx + ay * by);
        let follows_motion = self.reference == Reference::Plane(Plane::Motion);
        if !follows_motion || sine.abs() <= MOST_TURN * cosine {
            return 1.0;
        }
        // Direction after the turn, and how far either end is off it.
        let turn = MOST_TURN.copysign(sine);
        let (dx, dy) = (ax - turn * ay, ay + turn * ax);
        let (before, after) = (ax * dy - ay * dx, bx * dy - by * dx);
        before / (before - after)
    }

    /// Returns whether the CG is beyond the hull of the feet.
    #[inline(always)]
    pub fn is_beyond_hull(&self, seen: &Observation) -> bool {
        self.reference == Reference::Hull && seen.angle <= 0.0
    }

    /// The ranges last chosen.
    pub fn guards(&self) -> &[Guard] {
        &self.guards
    }

    /// The verdict on the present observation, if there is one.
    pub fn verdict(&self, seen: &Observation, least_angle: f64) -> Option<Verdict> {
        let [vx, vy, vz, wx, wy, wz, height] = seen.calm();
        let calm = [vx, vy, vz].iter().all(|v| v.abs() <= CALM_SPEED)
            && [wx, wy, wz].iter().all(|w| w.abs() <= CALM_RATE)
            && height <= self.calm_height();
        if matches!(self.reference, Reference::Plane(_)) && seen.angle <= 0.0 {
            return Some(Verdict::Pitch);
        }
        if self.limits.is_some()
            && least_angle < ROCKED_UP
            && seen.angle - least_angle > ROCKED_BACK
        {
            Some(Verdict::Rockback)
        } else if calm {
            Some(Verdict::Subsided)
        } else {
            None
        }
    }
}

/// Feet at the ends of the edge of their hull over which the CG is nearest to tipping. They are seen from the CG in ground
/// axes.
pub fn critical_feet_of_hull(feet: &[Vector3<f64>]) -> [usize; 2] {
    Hull::of(feet).critical_supports()
}

/// The stretch between two neighbouring limits in which a calm quantity lies. A value at a limit lies beyond it, seen
/// from zero: a speed that is not below [`DIRECTIONLESS`] has a direction, and has to lose it before it gets the
/// opposite one.
fn calm_cell(calm_height: f64, index: usize, value: f64) -> Bounds {
    let limits: &[f64] = match index {
        0 | 1 => &[-CALM_SPEED, -DIRECTIONLESS, DIRECTIONLESS, CALM_SPEED],
        2 => &[-CALM_SPEED, CALM_SPEED],
        3..=5 => &[-CALM_RATE, CALM_RATE],
        _ => &[calm_height],
    };
    let mut cell = Bounds::FREE;
    for &limit in limits {
        if value > limit || value == limit && limit > 0.0 {
            cell.lower = limit;
        } else {
            cell.upper = limit;
            break;
        }
    }
    cell
}
