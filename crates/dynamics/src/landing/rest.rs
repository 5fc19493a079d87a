//! Rest: a vehicle is at rest once it has stood for a while on supports that hold it.
//!
//! Supports are feet and blocks, each with the fall left to its own ground. A set of them holds the vehicle if the CG
//! is over it and lifting the CG over any edge of it takes twice the energy that may move the vehicle: its kinetic
//! energy, and that of the fall until all of the set stand. Struts and pads that still push back add to that energy;
//! the wait gives them time to. Under an engine that stays on it has to take fifty times that energy.

use arrayvec::ArrayVec;
use libm::sqrt;
use nalgebra::{Matrix3, Vector2, Vector3};

use super::hull::{Hull, MOST_SUPPORTS};
use super::trajectory::Trajectory;
use crate::energy::kinetic;
use crate::kinematics::BodyFrame;
use crate::motion::{LegLoads, Signal};
use crate::scene::Scene;
use crate::vehicle::Vehicle;

/// Greatest share of the toppling energy that a held vehicle may have.
const SHARE: f64 = 0.5;
/// Greatest such share under an engine that stays on. A vehicle that is light on its feet loses little energy at each
/// hop, and a slope gives it back.
const SHARE_UNDER_THRUST: f64 = 0.02;
/// Time that the vehicle must stand to be at rest, or its CG be beyond its feet to have toppled, in free falls of the
/// CG from its height on extended legs.
pub(super) const WHILE: f64 = 0.4;
/// Speed of crushing above which an element gives way, as a share of the speed of that free fall.
const CREEP: f64 = 1e-3;

/// Time of a free fall from `height` (ft) at `acceleration` (ft/s²), s.
pub(super) fn free_fall(height: f64, acceleration: f64) -> f64 {
    sqrt(2.0 * height / acceleration)
}

/// Tracks since when a vehicle has stood on supports that hold it.
#[derive(Debug, Clone)]
pub(super) struct Rest {
    /// Height of the CG on extended legs, ft.
    height: f64,
    /// Speed above which an element that crushes gives way, ft/s.
    creep: f64,
    /// Nominal friction under footpads and under blocks.
    friction: [f64; 2],
    since: Option<f64>,
}

/// A foot or block that the vehicle stands on, or will after a small fall.
struct Support {
    leg: usize,
    is_foot: bool,
    /// Position from the point taken as the CG, ft; z is along the pull taken as the weight.
    place: Vector3<f64>,
    /// Fall left to its ground, ft.
    fall: f64,
    /// Gradient of its ground in plan; its length is the tangent of the ground's slope.
    gradient: Vector2<f64>,
}

/// Pull on the vehicle: its weight or, with an engine that stays on, weight and thrust together.
struct Pull {
    /// Force, lb.
    force: f64,
    /// Turns ground axes into axes with z along the pull.
    axes: Matrix3<f64>,
    /// Offset of its line of action from the CG, ft.
    beside: Vector3<f64>,
    /// Greatest share of the toppling energy that a vehicle held against it may have.
    share: f64,
}

impl Rest {
    /// For a vehicle in a scene.
    pub(super) fn new(vehicle: &Vehicle, scene: &Scene) -> Self {
        let (height, gravity) = (vehicle.standing_height(), scene.gravity(vehicle));
        let conditions = scene.conditions();
        Self {
            height,
            creep: CREEP * sqrt(2.0 * height * gravity),
            friction: [conditions.pad_friction, conditions.block_friction],
            since: None,
        }
    }

    /// Notes the present state. Returns whether the vehicle is at rest.
    #[cold]
    #[inline(never)]
    pub(super) fn note(&mut self, trajectory: &Trajectory<'_>) -> bool {
        let held = (trajectory.pull_at_rest()).filter(|pull| self.holds(trajectory, pull));
        let Some(pull) = held else {
            self.since = None;
            return false;
        };
        let since = *self.since.get_or_insert(trajectory.time);
        let acceleration = pull.force / trajectory.motion.mass();
        trajectory.time - since >= WHILE * free_fall(self.height, acceleration)
    }

    /// Returns whether supports hold the vehicle now.
    fn holds(&self, trajectory: &Trajectory<'_>, pull: &Pull) -> bool {
        let (motion, state) = (&trajectory.motion, &trajectory.step.before);
        // Height to which the energy of motion would lift the CG.
        let lift = kinetic(motion, state) / pull.force;
        let reach = |leg| foot(trajectory, leg).norm();
        let farthest = (0..motion.leg_count()).map(reach).fold(0.0, f64::max);
        if lift > pull.share * farthest {
            return false;
        }
        let frame = motion.frame(&state.body());
        let speed = (pull.axes * state.body().velocity).xy().norm();
        let mut supports = trajectory.supports(&frame, pull);
        supports.sort_by(|a, b| a.fall.total_cmp(&b.fall));
        let places: ArrayVec<Vector3<f64>, MOST_SUPPORTS> =
            supports.iter().map(|support| support.place).collect();
        (3..=supports.len()).any(|count| {
            let hull = Hull::of(&places[..count]);
            let fall = supports[count - 1].fall;
            hull.has_center()
                && pull.share * hull.least_rise() - fall >= lift
                && self.stops_by_friction(&supports[..count], speed, pull.force / motion.mass())
                && (supports[..count].iter().enumerate()).all(|(index, support)| {
                    let load = pull.force * hull.greatest_share(index);
                    self.bears(trajectory, support, load, &frame)
                })
        })
    }

    /// Returns whether friction stops a CG that moves in plan at `speed` (ft/s) within a free fall. The supports bear
    /// equal loads; `acceleration` (ft/s²) is the pull over the mass.
    fn stops_by_friction(&self, supports: &[Support], speed: f64, acceleration: f64) -> bool {
        let downhill: Vector2<f64> = supports.iter().map(|support| support.gradient).sum();
        let friction = supports.iter().map(|support| self.friction_under(support));
        let left = friction.sum::<f64>() - downhill.norm();
        speed * supports.len() as f64 <= left * acceleration * free_fall(self.height, acceleration)
    }

    fn friction_under(&self, support: &Support) -> f64 {
        self.friction[usize::from(!support.is_foot)]
    }

    /// Returns whether a support neither gives way under loads up to `load` (lb) nor slides off its ground.
    fn bears(
        &self,
        trajectory: &Trajectory<'_>,
        support: &Support,
        load: f64,
        frame: &BodyFrame<f64>,
    ) -> bool {
        let leg = support.leg;
        let (mode, laws) = (&trajectory.modes[leg], &trajectory.laws[leg]);
        let signals = trajectory.signals.start().leg(leg);
        let sliding = if support.is_foot {
            Signal::PadSliding
        } else {
            Signal::BlockSliding
        };
        let sticks = support.fall > 0.0 || laws.is_viscous(signals[sliding as usize]);
        if support.gradient.norm() > self.friction_under(support) && !sticks {
            return false;
        }
        // An element that crushes under more than its share of the weight comes to rest by that.
        if !support.is_foot {
            return !mode.block_crushes(self.creep, signals)
                || trajectory.loads(leg, frame).block_normal >= load;
        }
        if mode.pad_crushes(self.creep, signals) && trajectory.loads(leg, frame).pad_normal < load {
            return false;
        }
        // The strut force that bears the load on the link (68), by virtual work.
        let descent = foot_descent(trajectory, leg, frame);
        let force = load * descent / signals[Signal::StrutLever as usize];
        let gives_way =
            mode.strut_crushes(self.creep, signals) && signals[Signal::StrutForce as usize] < force;
        !gives_way && mode.strut_bears(laws, force)
    }
}

/// Position of a footpad's pivot from the CG, ground axes, ft.
fn foot(trajectory: &Trajectory<'_>, leg: usize) -> Vector3<f64> {
    let signals = trajectory.signals.start();
    let [x, y, z] = [Signal::FootX, Signal::FootY, Signal::FootZ];
    Vector3::new(signals.of(leg, x), signals.of(leg, y), signals.of(leg, z))
}

/// Descent of a footpad's pivot per radian of link angle, ft.
fn foot_descent(trajectory: &Trajectory<'_>, leg: usize, frame: &BodyFrame<f64>) -> f64 {
    let swing = (trajectory.motion.geometry(leg)).swing(trajectory.step.before.leg(leg).link_angle);
    let down = frame.rotation.row(2);
    down[0] * swing.x + down[1] * swing.y + down[2] * swing.z
}

impl Trajectory<'_> {
    /// Forces on a leg now.
    fn loads(&self, leg: usize, frame: &BodyFrame<f64>) -> LegLoads<f64> {
        (self.motion).leg_loads(leg, frame, &self.step.before, &self.pieces)
    }

    /// Pull on a vehicle that comes to rest; `None` while the thrust still changes or lifts it.
    fn pull_at_rest(&self) -> Option<Pull> {
        self.weight_at_rest()?;
        let weight = Vector3::new(0.0, 0.0, self.motion.mass() * self.motion.gravity());
        let thrust = self.pieces.thrust().at(self.time);
        if thrust == 0.0 {
            return Some(Pull {
                force: weight.z,
                axes: Matrix3::identity(),
                beside: Vector3::zeros(),
                share: SHARE,
            });
        }
        let frame = self.motion.frame(&self.step.before.body());
        let pushed = frame.rotation.column(2) * -thrust;
        let moment = (self.motion.thrust_place(&frame)).cross(&pushed);
        let pull: Vector3<f64> = weight + pushed;
        let squared = pull.norm_squared();
        let down = pull / sqrt(squared);
        (down.z > 0.0).then(|| {
            let across = Vector3::y().cross(&down).normalize();
            let along = down.cross(&across);
            Pull {
                force: sqrt(squared),
                axes: Matrix3::from_rows(&[
                    across.transpose(),
                    along.transpose(),
                    down.transpose(),
                ]),
                beside: pull.cross(&moment) / squared,
                share: SHARE_UNDER_THRUST,
            }
        })
    }

    /// All feet and blocks that can bear.
    fn supports(&self, frame: &BodyFrame<f64>, pull: &Pull) -> ArrayVec<Support, MOST_SUPPORTS> {
        let mut supports = ArrayVec::new();
        for leg in 0..self.leg_count() {
            let (mode, laws) = (&self.modes[leg], &self.laws[leg]);
            let signals = self.signals.start().leg(leg);
            let grounds = self.motion.ground(leg, frame);
            let places = [
                foot(self, leg),
                frame.seen_from_center_of_gravity(&self.motion.geometry(leg).block_face()),
            ];
            let gaps = [
                Some(mode.pad_gap(laws, signals)),
                mode.block_gap(laws, signals, 1.0 / grounds[1].upright),
            ];
            for (is_foot, ((ground, place), gap)) in [true, false]
                .into_iter()
                .zip(grounds.iter().zip(places).zip(gaps))
            {
                let normal = pull.axes * (frame.rotation * ground.normal);
                let facing = normal.z;
                let Some(gap) = gap.filter(|_| facing > 0.0) else {
                    continue;
                };
                supports.push(Support {
                    leg,
                    is_foot,
                    place: pull.axes * (place - pull.beside),
                    fall: gap / facing,
                    gradient: normal.xy() / facing,
                });
            }
        }
        supports
    }
}
