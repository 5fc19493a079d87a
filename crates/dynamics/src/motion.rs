//! The equations of motion (55), (60), (68), (69) as straight-line arithmetic (model chapter 6).
//!
//! Which piece of each law is active arrives as coefficients, [`LegPieces`]. There is no table
//! search here and no branch but one: what carries no pressure at all is passed over. Along with
//! the derivative come the signals whose ranges tell how long those coefficients hold.

mod leg_damping;
mod signal;

use nalgebra::{Matrix3, Vector3};

use crate::crush::PressureLine;
use crate::damping::Inertia;
use crate::friction::FrictionPiece;
use crate::hinge::HingePiece;
use crate::kinematics::{
    BodyFrame, LegFrame, LegGeometry, LegPose, PlanePoint, PointVelocity, Surface,
};
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::{Body, LegState, State, quaternion_rate};
use crate::strut::{LinkPiece, StrutPiece};
use crate::vehicle::{Leg, Vehicle};

pub use signal::Signal;

/// Coefficients of the active piece of every law of one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegPieces<S> {
    /// Pressure on the outboard and inboard pad sections.
    pub pad: [PressureLine<S>; 2],
    /// Pressure on the block.
    pub block: PressureLine<S>,
    /// Friction under the pad.
    pub pad_friction: FrictionPiece<S>,
    /// Friction under the block.
    pub block_friction: FrictionPiece<S>,
    /// Shock absorber.
    pub strut: StrutPiece<S>,
    /// Lower link.
    pub link: LinkPiece<S>,
    /// Footpad hinge.
    pub hinge: HingePiece<S>,
}

/// The signals of one leg, indexed by [`Signal`].
pub type LegSignals<S> = [S; Signal::COUNT];

/// Forces on one leg, lb.
#[derive(Debug, Clone, Copy)]
pub struct LegLoads<S> {
    /// Strut force F, compression positive.
    pub strut: S,
    /// Normal force N on the pad.
    pub pad_normal: S,
    /// Friction force on the pad.
    pub pad_friction: S,
    /// Normal force on the block.
    pub block_normal: S,
    /// Friction force on the block.
    pub block_friction: S,
}

/// Constants of the equations of motion of one vehicle on one surface.
#[derive(Debug, Clone, Copy)]
pub struct Motion<S, const LEGS: usize> {
    surface: Surface<S>,
    gravity: S,
    inverse_mass: S,
    inertia: Matrix3<S>,
    inverse_inertia: Matrix3<S>,
    legs: [LegMotion<S>; LEGS],
}

#[derive(Debug, Clone, Copy)]
struct LegMotion<S> {
    geometry: LegGeometry<S>,
    link_inertia: S,
    inverse_link_inertia: S,
    inverse_pad_inertia: S,
    /// Half of π d_f²/8 C_f: the attitude factor of (29) and (33) is then 1 + cos²ξ.
    pad_strength: S,
    /// Half of π d_B²/4 C_B.
    block_strength: S,
    pad_friction: S,
    block_friction: S,
}

impl<S: Real> LegMotion<S> {
    fn new(leg: &Leg, hardpoint_depth: f64, scene: &Scene) -> Self {
        let design = leg.design();
        let (pad, block) = (&design.footpad, &design.block);
        let quarter_circle = std::f64::consts::FRAC_PI_4;
        let constant = S::constant;
        Self {
            geometry: LegGeometry::new(leg, hardpoint_depth),
            link_inertia: constant(design.linkage.inertia),
            inverse_link_inertia: constant(1.0 / design.linkage.inertia),
            inverse_pad_inertia: constant(1.0 / pad.inertia),
            pad_strength: constant(
                0.25 * quarter_circle * pad.diameter * pad.diameter * pad.crush_pressure,
            ),
            block_strength: constant(
                0.5 * quarter_circle * block.diameter * block.diameter * block.crush_pressure,
            ),
            pad_friction: constant(scene.conditions().pad_friction),
            block_friction: constant(scene.conditions().block_friction),
        }
    }
}

/// What one leg does to the body and itself.
struct LegAction<S> {
    force: Vector3<S>,
    torque: Vector3<S>,
    derivative: LegState<S>,
    signals: LegSignals<S>,
    loads: LegLoads<S>,
}

impl<S: Real, const LEGS: usize> Motion<S, LEGS> {
    /// The equations of motion of a vehicle in a scene.
    pub fn new(vehicle: &Vehicle<LEGS>, scene: &Scene) -> Self {
        let inertia = *vehicle.inertia();
        // A positive definite matrix has an inverse; the vehicle was checked.
        let inverse = inertia.try_inverse().unwrap_or_else(Matrix3::zeros);
        let depth = vehicle.center_of_gravity_height();
        Self {
            surface: Surface::new(scene),
            gravity: S::constant(vehicle.gravity()),
            inverse_mass: S::constant(1.0 / vehicle.mass()),
            inertia: inertia.map(S::constant),
            inverse_inertia: inverse.map(S::constant),
            legs: std::array::from_fn(|j| LegMotion::new(&vehicle.legs()[j], depth, scene)),
        }
    }

    /// The surface.
    pub fn surface(&self) -> &Surface<S> {
        &self.surface
    }

    /// Geometry of leg `index`.
    pub fn geometry(&self, index: usize) -> &LegGeometry<S> {
        &self.legs[index].geometry
    }

    /// Writes the time derivative of the state into `derivative`.
    // One copy of the code serves all stages of a step: inlined into each, it would not fit the
    // instruction cache.
    #[inline(never)]
    pub fn derivative(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
        derivative: &mut State<S, LEGS>,
    ) {
        self.evaluate_into::<false>(state, pieces, derivative, |_, _| {});
    }

    /// Signals of all legs, the link torques only if asked for: no other signal is a force.
    #[inline(always)]
    pub fn signals(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
        with_torques: bool,
    ) -> [LegSignals<S>; LEGS] {
        if with_torques {
            self.signals_of::<true>(state, pieces)
        } else {
            self.signals_of::<false>(state, pieces)
        }
    }

    #[inline(never)]
    fn signals_of<const FORCES: bool>(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
    ) -> [LegSignals<S>; LEGS] {
        let frame = self.surface.frame(&state.body());
        let mut signals = [[S::zero(); Signal::COUNT]; LEGS];
        for (j, (leg, pieces)) in self.legs.iter().zip(pieces).enumerate() {
            signals[j] = leg
                .action::<FORCES, true>(&frame, &state.leg(j), pieces)
                .signals;
        }
        signals
    }

    /// Writes the time derivative of the state and the signals of all legs.
    #[inline(never)]
    pub fn evaluate(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
        derivative: &mut State<S, LEGS>,
        signals: &mut [LegSignals<S>; LEGS],
    ) {
        self.evaluate_into::<true>(state, pieces, derivative, |j, leg| signals[j] = leg);
    }

    /// Loads of all legs.
    pub fn loads(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
    ) -> [LegLoads<S>; LEGS] {
        let frame = self.surface.frame(&state.body());
        std::array::from_fn(|j| {
            self.legs[j]
                .action::<true, true>(&frame, &state.leg(j), &pieces[j])
                .loads
        })
    }

    /// Inertia of the velocities.
    pub fn inertia(&self) -> Inertia<S, LEGS> {
        Inertia {
            mass: S::one() / self.inverse_mass,
            body: self.inertia,
            links: std::array::from_fn(|j| self.legs[j].link_inertia),
        }
    }

    #[inline(always)]
    fn evaluate_into<const SIGNALS: bool>(
        &self,
        state: &State<S, LEGS>,
        pieces: &[LegPieces<S>; LEGS],
        derivative: &mut State<S, LEGS>,
        mut tell: impl FnMut(usize, LegSignals<S>),
    ) {
        let body = state.body();
        let frame = self.surface.frame(&body);
        let mut force = Vector3::zeros();
        let mut torque = Vector3::zeros();
        for (j, (leg, pieces)) in self.legs.iter().zip(pieces).enumerate() {
            let action = leg.action::<true, SIGNALS>(&frame, &state.leg(j), pieces);
            force += action.force;
            torque += action.torque;
            derivative.set_leg(j, &action.derivative);
            tell(j, action.signals);
        }
        let mut acceleration = frame.rotation * force * self.inverse_mass;
        acceleration.z += self.gravity;
        let momentum = self.inertia * body.rate;
        derivative.set_body(&Body {
            position: body.velocity,
            velocity: acceleration,
            quaternion: quaternion_rate(&body.quaternion, &body.rate),
            rate: self.inverse_inertia * (torque - body.rate.cross(&momentum)),
        });
    }
}

/// What the surface does to a footpad or block, in leg axes.
struct Touch<S> {
    velocity: PointVelocity<S>,
    /// Normal force N, lb.
    normal: S,
    /// μ/S, s/ft.
    drag: S,
    /// n + μ t̂: against it the surface pushes with N.
    line: Vector3<S>,
    force: Vector3<S>,
    moment: Vector3<S>,
}

impl<S: Real> Touch<S> {
    fn none() -> Self {
        let zero = S::zero();
        Self {
            velocity: PointVelocity {
                inward: zero,
                sliding: Vector3::zeros(),
                sliding_squared: zero,
            },
            normal: zero,
            drag: zero,
            line: Vector3::zeros(),
            force: Vector3::zeros(),
            moment: Vector3::zeros(),
        }
    }

    /// Normal force N and friction along the sliding velocity of `point` (39).
    #[inline(always)]
    fn new(
        frame: &LegFrame<S>,
        point: &PlanePoint<S>,
        velocity: PointVelocity<S>,
        normal: S,
        drag: S,
    ) -> Self {
        let line = frame.normal + velocity.sliding * drag;
        let force = line * -normal;
        Self {
            moment: point.moment(&force),
            velocity,
            normal,
            drag,
            line,
            force,
        }
    }

    /// Friction force, lb.
    fn friction(&self) -> S {
        self.normal * self.drag * self.velocity.sliding_squared.sqrt()
    }
}

impl<S: Real> LegMotion<S> {
    /// Normal force (29) on the footpad per unit of relative pressure in both sections, lb.
    #[inline(always)]
    fn pad_force_per_pressure(&self, pose: &LegPose<S>) -> S {
        self.pad_strength * (pose.pad_upright + pose.pad_inclination)
    }

    /// Normal force (33) on the block, lb.
    #[inline(always)]
    fn block_normal(&self, frame: &LegFrame<S>, pose: &LegPose<S>, pieces: &LegPieces<S>) -> S {
        let cos_block = frame.normal.z;
        self.block_strength
            * (S::one() + cos_block * cos_block)
            * pieces.block.at(pose.block_interference)
    }

    /// What one leg does to the body and itself, and its signals. Without `SIGNALS` nothing is
    /// computed of elements that carry no pressure, and their signals mean nothing; without
    /// `FORCES` nothing but the signals means anything, and of those not the link torque.
    #[inline(always)]
    fn action<const FORCES: bool, const SIGNALS: bool>(
        &self,
        body: &BodyFrame<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
    ) -> LegAction<S> {
        let frame = self.geometry.frame(body);
        let pose = self.geometry.pose(&frame, leg.link_angle, leg.pad_angle);
        let link_length = self.geometry.link_length();

        // Footpad: normal force (29), torque about its hinge (52).
        let cos_pad = pose.pad_inclination;
        let [outer, inner] = pose.pad_interference;
        let (pad, pad_torque) = if !SIGNALS && pieces.pad[0].is_slack() && pieces.pad[1].is_slack()
        {
            (Touch::none(), S::zero())
        } else {
            let velocity = frame.pivot_velocity(&pose, link_length * leg.link_rate);
            let per_pressure = self.pad_force_per_pressure(&pose);
            let pressure = [pieces.pad[0].at(outer), pieces.pad[1].at(inner)];
            let normal = per_pressure * (pressure[0] + pressure[1]);
            let drag = self.pad_friction * pieces.pad_friction.per_speed(velocity.sliding_squared);
            let pad = Touch::new(&frame, &pose.pivot, velocity, normal, drag);
            let along_z = pose.pad_z.dot(&pad.line);
            let along_y = pose.pad_y.dot(&pad.line);
            let centroids = self.geometry.centroids();
            let height = self.geometry.pad_height();
            let lever =
                |k: usize| (height - pose.pad_interference[k]) * along_y - centroids[k] * along_z;
            let torque = -per_pressure * (pressure[0] * lever(0) + pressure[1] * lever(1));
            (pad, torque)
        };

        // Block: normal force (33).
        let block = if !SIGNALS && pieces.block.is_slack() {
            Touch::none()
        } else {
            let velocity = frame.velocity_at(&pose.block_center);
            let normal = self.block_normal(&frame, &pose, pieces);
            let drag =
                self.block_friction * pieces.block_friction.per_speed(velocity.sliding_squared);
            Touch::new(&frame, &pose.block_center, velocity, normal, drag)
        };

        // Lower link (49), (68).
        let strut_rate = pose.strut_lever * leg.link_rate;
        let strut = pieces
            .strut
            .force(pose.stroke, leg.link_rate, pose.strut_lever);
        let surface_torque = link_length * pose.link_normal.dot(&pad.force);
        let link_torque = surface_torque + strut * pose.strut_lever;
        let link_acceleration = pieces
            .link
            .acceleration(link_torque * self.inverse_link_inertia, leg.link_rate);

        // Footpad hinge (69).
        let unclipped = pieces.hinge.unclipped_speed(leg.pad_angle, leg.pad_rate);
        let pad_speed = pieces.hinge.speed(unclipped);

        let derivative = LegState {
            link_angle: pieces.link.moving * leg.link_rate,
            link_rate: link_acceleration,
            pad_angle: pad_speed,
            pad_rate: pad_torque * self.inverse_pad_inertia + link_acceleration,
            work: [
                -strut * strut_rate,
                pad.normal * pad.velocity.inward,
                pad.normal * pad.drag * pad.velocity.sliding_squared,
                block.normal * block.velocity.inward,
                block.normal * block.drag * block.velocity.sliding_squared,
                (link_torque - self.link_inertia * link_acceleration) * leg.link_rate,
            ],
        };
        let rates = frame.pad_interference_rates(
            &pose,
            &self.geometry,
            pad.velocity.inward,
            leg.link_rate,
            pad_speed,
        );
        let signals = [
            outer,
            inner,
            pose.block_interference,
            rates[0],
            rates[1],
            frame.block_interference_rate(block.velocity.inward),
            pad.velocity.inward,
            block.velocity.inward,
            pad.velocity.sliding_squared,
            block.velocity.sliding_squared,
            pose.stroke,
            leg.link_rate,
            if FORCES { surface_torque } else { S::zero() },
            leg.pad_angle,
            leg.pad_rate,
            unclipped,
            cos_pad,
            strut,
        ];
        LegAction {
            force: self.geometry.in_vehicle_axes(&(pad.force + block.force)),
            torque: self.geometry.in_vehicle_axes(&(pad.moment + block.moment)),
            derivative,
            signals,
            loads: LegLoads {
                strut,
                pad_normal: pad.normal,
                pad_friction: pad.friction(),
                block_normal: block.normal,
                block_friction: block.friction(),
            },
        }
    }
}
