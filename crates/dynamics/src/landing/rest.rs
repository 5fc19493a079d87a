//! Rest: a vehicle is at rest once it has stood for a while on supports that hold it.
//!
//! Supports are feet and blocks, each with the fall left to its own ground. A set of them holds the vehicle if the CG
//! is over it and lifting the CG over any edge of it takes some times the energy that may move the vehicle: its kinetic
//! energy, and that of the fall until all of the set stand. Struts and pads that still push back add to that energy;
//! the wait gives them time to.

use arrayvec::ArrayVec;
use libm::sqrt;
use nalgebra::{Matrix3, Vector2, Vector3};

use super::hull::{Hull, MOST_SUPPORTS};
use super::trajectory::Trajectory;
use crate::energy::kinetic;
use crate::kinematics::BodyFrame;
use crate::motion::Signal;
use crate::outcome::Outcome;
use crate::scene::{Scene, Settings, Stop};
use crate::vehicle::{Legs, Vehicle};

/// Greatest share of the toppling energy that a vehicle held on hinged legs may have, where its verdict does not wait
/// ([`Stop::Rest`]).
const SHARE_ON_HINGED_LEGS: f64 = 0.5;
/// Greatest such share on legs of three struts, which may hardly damp: such a vehicle hops for long.
const SHARE_ON_THREE_STRUTS: f64 = 0.1;
/// Greatest such share where the verdict waits, and under an engine that stays on. A vehicle that is light on its feet
/// loses little energy at each hop, and a slope gives it back.
const SETTLED_SHARE: f64 = 0.02;
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
    /// Friction under supports that stick, as a multiple of that.
    static_ratio: f64,
    /// The vehicle stands.
    stands: Held,
    /// Hardly any motion is left; only where the verdict waits for that.
    settled: Option<Held>,
}

/// Since when the vehicle has had at most a share of the toppling energy.
#[derive(Debug, Clone)]
struct Held {
    /// Greatest share under the weight alone.
    share: f64,
    since: Option<f64>,
    /// True once it has had no more for long enough.
    is_long_enough: bool,
}

/// A foot or block that the vehicle stands on, or will after a small fall.
pub(super) struct Support {
    pub(super) leg: usize,
    pub(super) is_foot: bool,
    /// Position from the point taken as the CG, ft; z is along the pull taken as the weight.
    place: Vector3<f64>,
    /// Fall left to its ground, ft.
    pub(super) fall: f64,
    /// Gradient of its ground in plan; its length is the tangent of the ground's slope.
    gradient: Vector2<f64>,
}

impl Support {
    /// Returns whether it is on its ground.
    fn is_down(&self) -> bool {
        self.fall <= 0.0
    }
}

/// Supports of a vehicle.
pub(super) type Supports = ArrayVec<Support, MOST_SUPPORTS>;

/// Pull on the vehicle: its weight or, with an engine that stays on, weight and thrust together.
pub(super) struct Pull {
    /// Force, lb.
    force: f64,
    /// Turns ground axes into axes with z along the pull.
    axes: Matrix3<f64>,
    /// Offset of its line of action from the CG, ft.
    beside: Vector3<f64>,
    /// True if an engine that stays on is part of it.
    has_thrust: bool,
}

/// A landing as the judge of rest sees it.
pub(super) trait Standing {
    /// Time after first contact, s.
    fn time(&self) -> f64;
    /// Mass, slug.
    fn mass(&self) -> f64;
    /// Kinetic energy, ft·lb.
    fn kinetic_energy(&self) -> f64;
    /// Velocity of the CG in ground axes, ft/s.
    fn velocity(&self) -> Vector3<f64>;
    /// Distance of the farthest foot from the CG, ft.
    fn farthest_foot(&self) -> f64;
    /// Pull on a vehicle that comes to rest; `None` while the thrust still changes or lifts it.
    fn pull_at_rest(&self) -> Option<Pull>;
    /// All feet and blocks that can bear.
    fn supports(&self, pull: &Pull) -> Supports;
    /// Returns whether a support on its ground sticks to it.
    fn sticks(&self, support: &Support) -> bool;
    /// Returns whether a support holds under loads up to `load` (lb): no element crushes faster than `creep` (ft/s) under less
    /// than that, nor beyond its limit.
    fn bears(&self, support: &Support, load: f64, creep: f64) -> bool;
}

impl Pull {
    /// The weight (lb) of a vehicle without thrust.
    pub(super) fn of_weight(weight: f64) -> Self {
        Self {
            force: weight,
            axes: Matrix3::identity(),
            beside: Vector3::zeros(),
            has_thrust: false,
        }
    }

    /// Weight (lb), and the force of an engine that stays on (ground axes, lb) with its moment about the CG (ft·lb), unless
    /// they lift the vehicle.
    pub(super) fn of_weight_and_thrust(
        weight: f64,
        pushed: &Vector3<f64>,
        moment: &Vector3<f64>,
    ) -> Option<Self> {
        let pull: Vector3<f64> = Vector3::new(0.0, 0.0, weight) + pushed;
        let squared = pull.norm_squared();
        let down = pull / sqrt(squared);
        (down.z > 0.0).then(|| {
            let across = Vector3::y().cross(&down).normalize();
            let along = down.cross(&across);
            Self {
                force: sqrt(squared),
                axes: Matrix3::from_rows(&[
                    across.transpose(),
                    along.transpose(),
                    down.transpose(),
                ]),
                beside: pull.cross(moment) / squared,
                has_thrust: true,
            }
        })
    }

    /// The support of a leg at a place relative to the CG (ground axes, ft), with this `gap` (ft) to the ground of this inward
    /// `normal` (ground axes). Ground that overhangs supports nothing.
    pub(super) fn support(
        &self,
        leg: usize,
        is_foot: bool,
        place: &Vector3<f64>,
        normal: &Vector3<f64>,
        gap: f64,
    ) -> Option<Support> {
        let normal = self.axes * normal;
        let facing = normal.z;
        (facing > 0.0).then(|| Support {
            leg,
            is_foot,
            place: self.axes * (place - self.beside),
            fall: gap / facing,
            gradient: normal.xy() / facing,
        })
    }
}

impl Held {
    fn with(share: f64) -> Self {
        Self {
            share,
            since: None,
            is_long_enough: false,
        }
    }
}

impl Rest {
    /// For a landing of a vehicle in a scene.
    pub(super) fn new(vehicle: &Vehicle, scene: &Scene, settings: &Settings) -> Self {
        let (height, gravity) = (vehicle.standing_height(), scene.gravity(vehicle));
        let conditions = scene.conditions();
        Self {
            height,
            creep: CREEP * sqrt(2.0 * height * gravity),
            friction: [conditions.pad_friction, conditions.block_friction],
            static_ratio: conditions.static_friction_ratio.unwrap_or(1.0),
            stands: Held::with(match vehicle.legs() {
                Legs::Hinged(_) => SHARE_ON_HINGED_LEGS,
                Legs::ThreeStrut(_) => SHARE_ON_THREE_STRUTS,
            }),
            settled: (settings.stop() == Stop::Rest).then(|| Held::with(SETTLED_SHARE)),
        }
    }

    /// Notes the present state. Returns whether the vehicle is at rest.
    #[cold]
    #[inline(never)]
    pub(super) fn note(&mut self, landing: &impl Standing) -> bool {
        if !self.stands.is_long_enough {
            self.stands = self.noted(&self.stands, landing);
        }
        let Some(settled) = &self.settled else {
            return self.stands.is_long_enough;
        };
        let settled = match self.stands.since {
            Some(_) => self.noted(settled, landing),
            None => Held::with(SETTLED_SHARE),
        };
        self.settled.insert(settled).is_long_enough
    }

    /// Returns since when the vehicle has been held, if it is held now.
    fn noted(&self, held: &Held, landing: &impl Standing) -> Held {
        let pull = landing.pull_at_rest();
        let Some(pull) = pull.filter(|pull| self.holds(landing, pull, held.share)) else {
            return Held::with(held.share);
        };
        let since = held.since.unwrap_or(landing.time());
        let long = WHILE * free_fall(self.height, pull.force / landing.mass());
        Held {
            since: Some(since),
            is_long_enough: landing.time() - since >= long,
            ..*held
        }
    }

    /// The outcome of a landing that ends with this one. It is stable if the computation ends while the vehicle stands and only
    /// its verdict waits.
    pub(super) fn ended(&self, outcome: Outcome, landing: &impl Standing) -> Outcome {
        let is_cut_short = matches!(outcome, Outcome::TimeExpired | Outcome::Failure(_));
        let stands = || {
            let pull = landing.pull_at_rest();
            pull.is_some_and(|pull| self.holds(landing, &pull, self.stands.share))
        };
        match self.settled.is_some() && self.stands.is_long_enough && is_cut_short && stands() {
            true => Outcome::StableSubsided,
            false => outcome,
        }
    }

    /// Returns whether supports hold the vehicle now, with at most this share of the toppling energy under the weight alone.
    fn holds(&self, landing: &impl Standing, pull: &Pull, share: f64) -> bool {
        let share = match pull.has_thrust {
            true => SETTLED_SHARE,
            false => share,
        };
        // Height to which the energy of motion would lift the CG.
        let lift = landing.kinetic_energy() / pull.force;
        if lift > share * landing.farthest_foot() {
            return false;
        }
        let speed = (pull.axes * landing.velocity()).xy().norm();
        let mut supports = landing.supports(pull);
        supports.sort_by(|a, b| a.fall.total_cmp(&b.fall));
        let places: ArrayVec<Vector3<f64>, MOST_SUPPORTS> =
            supports.iter().map(|support| support.place).collect();
        (3..=supports.len()).any(|count| {
            let hull = Hull::of(&places[..count]);
            let fall = supports[count - 1].fall;
            hull.has_center()
                && share * hull.least_rise() - fall >= lift
                && self.stops_by_friction(landing, &supports[..count], speed, pull.force)
                && (supports[..count].iter().enumerate()).all(|(index, support)| {
                    let load = pull.force * hull.greatest_share(index);
                    let may_slide = support.gradient.norm() > self.friction_under(support);
                    (!may_slide || !support.is_down() || landing.sticks(support))
                        && landing.bears(support, load, self.creep)
                })
        })
    }

    /// Returns whether friction stops a CG that moves in plan at `speed` (ft/s) within a free fall under a pull of this
    /// `force` (lb). The supports bear equal loads.
    fn stops_by_friction(
        &self,
        landing: &impl Standing,
        supports: &[Support],
        speed: f64,
        force: f64,
    ) -> bool {
        let acceleration = force / landing.mass();
        let downhill: Vector2<f64> = supports.iter().map(|support| support.gradient).sum();
        let friction = supports.iter().map(|support| {
            let counts = self.static_ratio > 1.0 && support.is_down();
            let sticks = counts && landing.sticks(support);
            let ratio = if sticks { self.static_ratio } else { 1.0 };
            self.friction_under(support) * ratio
        });
        let left = friction.sum::<f64>() - downhill.norm();
        speed * supports.len() as f64 <= left * acceleration * free_fall(self.height, acceleration)
    }

    fn friction_under(&self, support: &Support) -> f64 {
        self.friction[usize::from(!support.is_foot)]
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

impl Standing for Trajectory<'_> {
    fn time(&self) -> f64 {
        self.time
    }

    fn mass(&self) -> f64 {
        self.motion.mass()
    }

    fn kinetic_energy(&self) -> f64 {
        kinetic(&self.motion, &self.step.before)
    }

    fn velocity(&self) -> Vector3<f64> {
        self.step.before.body().velocity
    }

    fn farthest_foot(&self) -> f64 {
        let reach = |leg| foot(self, leg).norm();
        (0..self.leg_count()).map(reach).fold(0.0, f64::max)
    }

    fn pull_at_rest(&self) -> Option<Pull> {
        self.weight_at_rest()?;
        let weight = self.motion.mass() * self.motion.gravity();
        let thrust = self.pieces.thrust().at(self.time);
        if thrust == 0.0 {
            return Some(Pull::of_weight(weight));
        }
        let frame = self.motion.frame(&self.step.before.body());
        let pushed = frame.rotation.column(2) * -thrust;
        let moment = (self.motion.thrust_place(&frame)).cross(&pushed);
        Pull::of_weight_and_thrust(weight, &pushed, &moment)
    }

    fn supports(&self, pull: &Pull) -> Supports {
        let frame = self.motion.frame(&self.step.before.body());
        let mut supports = ArrayVec::new();
        for leg in 0..self.leg_count() {
            let (mode, laws) = (&self.modes[leg], &self.laws[leg]);
            let signals = self.signals.start().leg(leg);
            let grounds = self.motion.ground(leg, &frame);
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
                let normal = frame.rotation * ground.normal;
                let found = gap.and_then(|gap| pull.support(leg, is_foot, &place, &normal, gap));
                supports.extend(found);
            }
        }
        supports
    }

    fn sticks(&self, support: &Support) -> bool {
        let sliding = if support.is_foot {
            Signal::PadSliding
        } else {
            Signal::BlockSliding
        };
        let speed_squared = self.signals.start().of(support.leg, sliding);
        self.laws[support.leg].friction().is_viscous(speed_squared)
    }

    /// An element that crushes under more than its share of the weight comes to rest by that.
    fn bears(&self, support: &Support, load: f64, creep: f64) -> bool {
        let leg = support.leg;
        let (mode, laws) = (&self.modes[leg], &self.laws[leg]);
        let signals = self.signals.start().leg(leg);
        let frame = self.motion.frame(&self.step.before.body());
        let loads = || (self.motion).leg_loads(leg, &frame, &self.step.before, &self.pieces);
        if !support.is_foot {
            return !mode.block_crushes(creep, signals) || loads().block_normal >= load;
        }
        if mode.pad_crushes(creep, signals) && loads().pad_normal < load {
            return false;
        }
        // The strut force that bears the load on the link (68), by virtual work.
        let force = load * foot_descent(self, leg, &frame) / signals[Signal::StrutLever as usize];
        let gives_way =
            mode.strut_crushes(creep, signals) && signals[Signal::StrutForce as usize] < force;
        !gives_way && mode.strut_bears(laws, force)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A vehicle of 10 slug on four feet, 5 ft apart from the CG each way and 4 ft below it, that moves down a slope at 1 ft/s.
    struct OnASlope {
        gradient: f64,
        fall: f64,
        sticks: bool,
    }

    impl Standing for OnASlope {
        fn time(&self) -> f64 {
            0.0
        }

        fn mass(&self) -> f64 {
            10.0
        }

        fn kinetic_energy(&self) -> f64 {
            5.0
        }

        fn velocity(&self) -> Vector3<f64> {
            Vector3::x()
        }

        fn farthest_foot(&self) -> f64 {
            8.0
        }

        fn pull_at_rest(&self) -> Option<Pull> {
            Some(Pull::of_weight(100.0))
        }

        fn supports(&self, _: &Pull) -> Supports {
            let places = [[5.0, 5.0], [-5.0, 5.0], [-5.0, -5.0], [5.0, -5.0]];
            let support = |(leg, [x, y]): (usize, [f64; 2])| Support {
                leg,
                is_foot: true,
                place: Vector3::new(x, y, 4.0),
                fall: self.fall,
                gradient: Vector2::new(self.gradient, 0.0),
            };
            places.into_iter().enumerate().map(support).collect()
        }

        fn sticks(&self, _: &Support) -> bool {
            self.sticks
        }

        fn bears(&self, _: &Support, _: f64, _: f64) -> bool {
            true
        }
    }

    fn holds(landing: &OnASlope, static_ratio: f64) -> bool {
        let rest = Rest {
            height: 4.0,
            creep: 0.0,
            friction: [0.3; 2],
            static_ratio,
            stands: Held::with(SHARE_ON_HINGED_LEGS),
            settled: None,
        };
        rest.holds(landing, &Pull::of_weight(100.0), SHARE_ON_HINGED_LEGS)
    }

    #[test]
    fn static_friction_counts_for_feet_that_stick_to_the_ground() {
        let on = |gradient, fall, sticks| OnASlope {
            gradient,
            fall,
            sticks,
        };
        // Sliding friction stops it on ground that is flat enough, whatever its feet do.
        assert!(holds(&on(0.1, 0.0, false), 1.0) && holds(&on(0.1, 0.01, false), 3.0));
        // On steep ground only what sticks is held, up to its static friction.
        assert!(holds(&on(0.5, 0.0, true), 3.0));
        assert!(!holds(&on(0.5, 0.0, true), 1.5));
        assert!(!holds(&on(0.5, 0.0, false), 3.0));
        assert!(!holds(&on(0.5, 0.0, true), 1.0));
        // A foot above its ground does not stick yet.
        assert!(!holds(&on(0.5, 0.01, true), 3.0));
    }
}
