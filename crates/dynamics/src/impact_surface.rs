//! The surface from the times at which the footpads struck it (2.8): slope, its direction and the
//! touchdown in customary ground axes, from attitude and motion before and impact times measured.
//!
//! The surface is the plane on which a landing of this vehicle gives the measured times. The report flew on with an
//! assumed slope after the first pad had touched; here the flight uses the slope found, by Newton's method on the
//! horizontal part of its normal. Times of three pads determine the surface; with more, it is their least-squares fit.

mod pads;

use std::fmt;

use libm::{atan, atan2, hypot, sincos};
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use crate::attitude::{Attitude, Euler};
use crate::contact;
use crate::ground::Ground;
use crate::invalid::{Invalid, require};
use crate::landing::{Landing, land_until_all_pads_touch};
use crate::methods::{Evaluator, ForceModel, RungeKutta, Start, Stepper};
use crate::outcome::Outcome;
use crate::per_leg::PerLeg;
use crate::scene::{Conditions, CrushRule, Scene, Settings};
use crate::soil::Soil;
use crate::thrust::Thrust;
use crate::touchdown::touchdown;
use crate::vehicle::Vehicle;

/// Tolerance of the landings.
const TOLERANCE: f64 = 1e-10;
/// Time that a landing is followed after the last impact, s.
const AFTERWARDS: f64 = 0.05;
/// Step of differences, and change at which the search ends, of the slope's tangent.
const DIFFERENCE: f64 = 1e-5;
const CLOSE: f64 = 1e-11;
/// Greatest residual of an impact time, s, if there are only as many times as determine a surface.
const TIMELY: f64 = 1e-8;
const DETERMINED: usize = 3;
/// Step of the tangent below which the least-squares fit of more times is found.
const SETTLED: f64 = 1e-7;
const MOST_HALVINGS: usize = 10;
/// Most landings of a search, several times as many as a successful one takes.
const MOST_LANDINGS: u64 = 60;
/// Tangent of the steepest surface looked for, 85 deg.
const STEEPEST: f64 = 11.43;
/// Tangent below which a surface is level, and horizontal speed (ft/s) below which there is no
/// direction of motion.
const LEVEL: f64 = 1e-9;
const NO_MOTION: f64 = 1e-9;
/// Area over the product of the sides below which three points lie on a line.
const COLLINEAR: f64 = 1e-6;
/// Interval of free flight, s.
const FLIGHT_STEP: f64 = 1e-3;
/// Height that keeps everything off the ground in free flight, ft.
const HIGH_UP: f64 = 1e4;

/// Attitude and motion at time zero, in any axes whose Z points down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// CG velocity, ft/s.
    pub velocity: Vector3<f64>,
    /// Attitude.
    pub attitude: Attitude,
    /// Angular velocity in vehicle axes, rad/s.
    pub angular_velocity: [f64; 3],
    /// Friction coefficient under pads and blocks.
    pub friction: f64,
}

/// The surface found, and the touchdown on it.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpactSurface {
    /// Slope θs, rad, ≥ 0.
    pub slope: f64,
    /// Rotation ζ about Z from the given to the customary ground axes (87), rad; `None` on level ground, where any
    /// serves and zero is used.
    pub rotation: Option<f64>,
    /// Cross-slope λ (86), rad; `None` on level ground or without horizontal motion.
    pub cross_slope: Option<f64>,
    /// Ψ, Φ, Ξ at first contact in the customary axes (88), rad.
    pub attitude: Euler,
    /// Downward and horizontal speed at first contact, ft/s.
    pub vertical_velocity: f64,
    /// See `vertical_velocity`.
    pub horizontal_velocity: f64,
    /// Points of impact (80) in the given axes, from the CG at time zero, ft.
    pub impact_points: PerLeg<Vector3<f64>>,
    /// Greatest difference between an impact time of the landing found and the given one, s.
    pub residual: f64,
    /// Landings computed.
    pub landings: u64,
}

/// Why there is no surface.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum NoSurface {
    /// An impact time or another input that cannot be used.
    Input(Invalid),
    /// The points of impact lie on a line.
    Collinear,
    /// The points of impact span a wall.
    Wall,
    /// This pad never touches the surface that the points of impact span.
    NeverTouches {
        /// Index of the leg, from 0.
        leg: usize,
        /// Outcome that ends the landing before.
        outcome: Outcome,
        /// Time of that, s after first contact.
        time: f64,
    },
    /// No slope gives these times: the least residual found, s.
    NotFound {
        /// Greatest residual of an impact time.
        residual: f64,
    },
}

impl fmt::Display for NoSurface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(invalid) => write!(
                f,
                "{} = {}: expected {}",
                invalid.quantity, invalid.value, invalid.allowed
            ),
            Self::Collinear => {
                f.write_str("the points of impact lie on a line: they span no surface")
            }
            Self::Wall => f.write_str("the points of impact span a wall, steeper than 85 deg"),
            Self::NeverTouches { leg, outcome, time } => write!(
                f,
                "footpad {} never touches the surface that the impact times suggest: the landing ends \
                 before, {outcome} {time:.3} s after first contact",
                leg + 1
            ),
            Self::NotFound { residual } => write!(
                f,
                "no slope gives these impact times: the nearest misses one by {residual:.2e} s"
            ),
        }
    }
}

impl std::error::Error for NoSurface {}

impl From<Invalid> for NoSurface {
    fn from(invalid: Invalid) -> Self {
        Self::Input(invalid)
    }
}

/// Finds the surface that the footpads struck at `impact_times`, s after time zero.
///
/// # Errors
/// When the times span no surface, or none gives them.
pub fn determine(
    vehicle: &Vehicle,
    approach: &Approach,
    impact_times: &[f64],
) -> Result<ImpactSurface, NoSurface> {
    for time in impact_times {
        require("impact_time_s", *time, "0 ≤ value ≤ 100", |v| {
            (0.0..=100.0).contains(&v)
        })?;
    }
    let legs = vehicle.leg_count();
    require(
        "impact_time_s (number of times)",
        impact_times.len() as f64,
        &format!("{legs} times, one for each leg"),
        |_| impact_times.len() == legs,
    )?;
    let times = PerLeg::from_fn(legs, |leg| impact_times[leg]);
    let mut search = Search::new(vehicle, *approach, times)?;
    let guess = search.plane_of_free_flight()?;
    let tangent = search.refine(guess)?;
    search.result(tangent)
}

/// The search for the horizontal tangent (∂Z/∂X, ∂Z/∂Y with the sign of the inward normal).
struct Search<'a> {
    vehicle: &'a Vehicle,
    approach: Approach,
    times: PerLeg<f64>,
    /// The pad that touches first.
    first: usize,
    /// Time from first contact until the first pad's contact counts, s.
    delay: f64,
    landings: u64,
}

/// A landing on a trial surface.
struct Trial {
    /// Contact times after the first, minus those given, s.
    residuals: PerLeg<f64>,
    landing: Landing,
}

impl Trial {
    fn squares(&self) -> f64 {
        self.residuals.iter().map(|r| r * r).sum()
    }

    fn worst(&self) -> f64 {
        self.residuals
            .iter()
            .fold(0.0, |worst, r| worst.max(r.abs()))
    }
}

/// Rotation about Z by ζ: from the customary axes to the given ones.
fn about_z(angle: f64) -> Matrix3<f64> {
    let (sine, cosine) = sincos(angle);
    Matrix3::new(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0)
}

/// ζ (87) of a tangent; zero on level ground.
fn rotation(tangent: &Vector2<f64>) -> f64 {
    if tangent.norm() < LEVEL {
        0.0
    } else {
        atan2(-tangent.x, tangent.y)
    }
}

impl<'a> Search<'a> {
    fn new(
        vehicle: &'a Vehicle,
        approach: Approach,
        times: PerLeg<f64>,
    ) -> Result<Self, NoSurface> {
        let search = Self {
            vehicle,
            approach,
            times,
            first: (0..times.len())
                .min_by(|a, b| times[*a].total_cmp(&times[*b]))
                .unwrap_or(0),
            delay: 0.0,
            landings: 0,
        };
        search.scene(&approach, &Vector2::zeros())?;
        Ok(search)
    }

    /// The touchdown of an approach on the surface of a tangent, in its customary axes.
    fn scene(&self, approach: &Approach, tangent: &Vector2<f64>) -> Result<Scene, Invalid> {
        let turn = about_z(-rotation(tangent));
        let velocity = turn * approach.velocity;
        let attitude = Attitude::from_matrix(&(turn * approach.attitude.matrix()));
        Scene::new(Conditions {
            vertical_velocity: velocity.z,
            horizontal_velocity: hypot(velocity.x, velocity.y),
            cross_slope: atan2(-velocity.x, velocity.y),
            attitude,
            angular_velocity: approach.angular_velocity,
            slope: atan(tangent.norm()),
            pad_friction: approach.friction,
            block_friction: approach.friction,
            static_friction_ratio: None,
            soil: Soil::Rock,
            ground: Ground::default(),
            gravity: None,
            thrust: Thrust::default(),
        })
    }

    /// Flies freely for `time` seconds. Returns the approach then, and the displacement of the CG, ft.
    fn fly(&self, time: f64) -> Result<(Approach, Vector3<f64>), Invalid> {
        let scene = self.scene(&self.approach, &Vector2::zeros())?;
        let settings = Settings::new(TOLERANCE, 1.0, CrushRule::default())?;
        let model = ForceModel::new(self.vehicle, &scene, &settings);
        let mut state = touchdown(self.vehicle, &scene, model.motion());
        let mut body = state.body();
        body.position = Vector3::new(0.0, 0.0, -HIGH_UP);
        state.set_body(&body);
        let mut evaluator = Evaluator {
            system: &model,
            memory: PerLeg::same(self.times.len(), contact::Sets::default()),
            evaluations: 0,
        };
        let mut stepper = RungeKutta {
            interval: FLIGHT_STEP,
        };
        let mut gone = 0.0;
        while time - gone > 0.0 {
            let slope = evaluator.slope(&state);
            let start = Start { state, slope };
            let taken = stepper.advance(&start, time - gone, &mut evaluator);
            state = taken.state;
            gone += taken.length;
        }
        let body = state.body();
        let q = body.quaternion;
        let approach = Approach {
            velocity: body.velocity,
            attitude: Attitude::from_quaternion([q.x, q.y, q.z, q.w]),
            angular_velocity: body.rate.into(),
            friction: self.approach.friction,
        };
        Ok((approach, body.position + Vector3::new(0.0, 0.0, HIGH_UP)))
    }

    /// The plane through the outboard sections of the first three pads at their impact times in free flight.
    fn plane_of_free_flight(&self) -> Result<Vector2<f64>, NoSurface> {
        let mut points = [Vector3::zeros(); 3];
        for (leg, point) in points.iter_mut().enumerate() {
            let (approach, way) = self.fly(self.times[leg])?;
            let design = &self.vehicle.hinged_legs()[leg];
            let extended = design.extended_angle();
            let [outboard, _] = pads::centroids(self.vehicle, leg, extended, extended);
            *point = way + approach.attitude.matrix() * outboard;
        }
        let [a, b] = [points[1] - points[0], points[2] - points[0]];
        let normal = a.cross(&b);
        if normal.norm() <= COLLINEAR * a.norm() * b.norm() {
            return Err(NoSurface::Collinear);
        }
        let tangent = Vector2::new(normal.x, normal.y) / normal.z;
        if tangent.norm().is_nan() || tangent.norm() > STEEPEST {
            return Err(NoSurface::Wall);
        }
        Ok(tangent)
    }

    /// Lands on the surface of a tangent.
    fn land(&mut self, tangent: &Vector2<f64>) -> Result<Trial, NoSurface> {
        let last = self.times.iter().fold(0.0f64, |last, time| last.max(*time));
        let span = last - self.times[self.first];
        let settings = Settings::new(TOLERANCE, 2.0 * span + AFTERWARDS, CrushRule::default())?;
        let (approach, _) = self.fly((self.times[self.first] - self.delay).max(0.0))?;
        let scene = self.scene(&approach, tangent)?;
        let landing = land_until_all_pads_touch(self.vehicle, &scene, &settings);
        self.landings += 1;
        let first = landing.pad_contact[self.first];
        let mut residuals = self.times;
        for (leg, residual) in residuals.iter_mut().enumerate() {
            let contact = landing.pad_contact[leg].zip(first);
            let (contact, first) = contact.ok_or_else(|| NoSurface::NeverTouches {
                leg,
                outcome: landing.outcome.clone(),
                time: landing.end_time,
            })?;
            *residual = (contact - first) - (self.times[leg] - self.times[self.first]);
        }
        Ok(Trial { residuals, landing })
    }

    /// Takes Gauss-Newton steps to the tangent that gives the times.
    fn refine(&mut self, mut tangent: Vector2<f64>) -> Result<Vector2<f64>, NoSurface> {
        let mut trial = self.land(&tangent)?;
        let mut is_at_least = false;
        while self.landings < MOST_LANDINGS {
            self.delay = trial.landing.pad_contact[self.first].unwrap_or(0.0);
            let mut columns = [self.times; 2];
            for (axis, column) in columns.iter_mut().enumerate() {
                let mut aside = tangent;
                aside[axis] += DIFFERENCE;
                let there = self.land(&aside)?;
                *column = PerLeg::from_fn(self.times.len(), |leg| {
                    (there.residuals[leg] - trial.residuals[leg]) / DIFFERENCE
                });
            }
            let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
            let [x, y] = &columns;
            let normal = Matrix2::new(dot(x, x), dot(x, y), dot(x, y), dot(y, y));
            let right = Vector2::new(dot(x, &trial.residuals), dot(y, &trial.residuals));
            let Some(inverse) = normal.try_inverse() else {
                break;
            };
            let mut step = inverse * -right;
            is_at_least = self.times.len() > DETERMINED && step.norm() < SETTLED;
            let mut halvings = 0;
            let better = loop {
                let there = tangent + step;
                let outcome = if there.norm() < STEEPEST {
                    self.land(&there)
                } else {
                    Err(NoSurface::Wall)
                };
                match outcome {
                    Ok(found) if found.squares() < trial.squares() || step.norm() < CLOSE => {
                        break Some((there, found));
                    }
                    _ if halvings == MOST_HALVINGS || self.landings >= MOST_LANDINGS => {
                        break None;
                    }
                    _ => {
                        halvings += 1;
                        step *= 0.5;
                    }
                }
            };
            let Some((there, found)) = better else {
                break;
            };
            tangent = there;
            trial = found;
            if step.norm() < CLOSE {
                break;
            }
        }
        if trial.worst() > TIMELY && !is_at_least {
            return Err(NoSurface::NotFound {
                residual: trial.worst(),
            });
        }
        Ok(tangent)
    }

    fn result(&mut self, tangent: Vector2<f64>) -> Result<ImpactSurface, NoSurface> {
        let trial = self.land(&tangent)?;
        let (approach, way) = self.fly((self.times[self.first] - self.delay).max(0.0))?;
        let scene = self.scene(&approach, &tangent)?;
        let conditions = scene.conditions();
        let back = about_z(rotation(&tangent));
        let mut impact_points = PerLeg::same(self.times.len(), Vector3::zeros());
        for (leg, point) in impact_points.iter_mut().enumerate() {
            let contact = trial.landing.pad_contact[leg].unwrap_or(0.0);
            let (start, there) = pads::at_contact(self.vehicle, &scene, leg, contact)?;
            *point = way + back * (there - start);
        }
        let is_level = tangent.norm() < LEVEL;
        let is_moving = conditions.horizontal_velocity > NO_MOTION;
        Ok(ImpactSurface {
            slope: conditions.slope,
            rotation: (!is_level).then(|| rotation(&tangent)),
            cross_slope: (!is_level && is_moving).then_some(conditions.cross_slope),
            attitude: conditions.attitude.euler(),
            vertical_velocity: conditions.vertical_velocity,
            horizontal_velocity: conditions.horizontal_velocity,
            impact_points,
            residual: trial.worst(),
            landings: self.landings,
        })
    }
}
