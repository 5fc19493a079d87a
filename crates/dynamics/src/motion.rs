//! The equations of motion (55), (60), (68), (69) as straight-line arithmetic (model chapter 6).
//!
//! Which piece of each law is active arrives as coefficients, [`Pieces`]. There is no table search
//! here and no branch but one: what carries no pressure on any leg is passed over. Along with the
//! derivative come the signals whose ranges tell how long those coefficients hold. The legs are
//! computed abreast, four in a register where the processor has registers of that width.

mod footing;
mod free_flight;
mod glance;
mod landings;
mod leg;
mod leg_response;
mod pieces;
mod signal;
mod stops;

use nalgebra::{Matrix3, Vector3};
use pulp::NullaryFnOnce;

use crate::formation::{Formation, LegsAbreast};
use crate::kinematics::{BodyFrame, LegGeometry, Surface};
use crate::products::times;
use crate::quad::{GROUPS, LANES, Quad, groups_of, members};
use crate::registers::{Four, Registers};
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::{Body, State, quaternion_rate};
use crate::vehicle::Vehicle;
use crate::wide::{Abreast, abreast};

use leg::{LegAction, LegMotion};
use pieces::GroupPieces;

pub use footing::Footing;
pub use free_flight::FreeFlight;
pub use glance::Glance;
pub use landings::{GlancesAbreast, MotionsAbreast};
pub use pieces::{LegPieces, Pieces};
pub use signal::Signal;

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

abreast!(LegLoads {
    strut,
    pad_normal,
    pad_friction,
    block_normal,
    block_friction,
});

/// The equations of motion of one vehicle on one surface.
#[derive(Debug, Clone, Copy)]
pub struct Motion<const LEGS: usize = 3> {
    /// What registers the processor has.
    registers: Four,
    equations: Equations<LegsAbreast, LEGS>,
    legs: [LegMotion<f64>; LEGS],
}

/// Constants of the equations of motion.
#[derive(Debug, Clone, Copy)]
struct Equations<F: Formation<LEGS>, const LEGS: usize> {
    surface: Surface<F::Body>,
    gravity: F::Body,
    inverse_mass: F::Body,
    inertia: Matrix3<F::Body>,
    inverse_inertia: Matrix3<F::Body>,
    groups: F::Groups<LegMotion<F::Leg>>,
}

impl<F: Formation<LEGS>, const LEGS: usize> Equations<F, LEGS> {
    /// Lets the legs push the body.
    #[inline(always)]
    fn push(
        &self,
        state: &State<F::Body, LEGS>,
        derivative: &mut State<F::Body, LEGS>,
        mut legs: impl Legs<F, LEGS>,
    ) {
        let body = state.body();
        let frame = self.surface.frame(&body);
        let mut force: Vector3<F::Body> = none();
        let mut torque: Vector3<F::Body> = none();
        for group in 0..F::GROUPS {
            let [forces, torques] = legs.push(group, &frame, derivative);
            F::add(&mut force.data.0[0], &forces.data.0[0]);
            F::add(&mut torque.data.0[0], &torques.data.0[0]);
        }
        let mut acceleration = times(&frame.rotation, &force) * self.inverse_mass;
        acceleration.z += self.gravity;
        let momentum = times(&self.inertia, &body.rate);
        let twist = torque - body.rate.cross(&momentum);
        derivative.set_body(&Body {
            position: body.velocity,
            velocity: acceleration,
            quaternion: quaternion_rate(&body.quaternion, &body.rate),
            rate: times(&self.inverse_inertia, &twist),
        });
    }
}

/// What legs do. A trait, as closures are not always inlined where they have to be compiled for wide registers.
trait Legs<F: Formation<LEGS>, const LEGS: usize> {
    /// How a group of legs pushes the body over which the surface lies like this; writes their derivative.
    fn push(
        &mut self,
        group: usize,
        frame: &BodyFrame<F::Body>,
        derivative: &mut State<F::Body, LEGS>,
    ) -> Push<F::Leg>;
}

/// Closures do where they dispatch what is wide themselves.
impl<F, A, const LEGS: usize> Legs<F, LEGS> for A
where
    F: Formation<LEGS>,
    A: FnMut(usize, &BodyFrame<F::Body>, &mut State<F::Body, LEGS>) -> Push<F::Leg>,
{
    #[inline(always)]
    fn push(
        &mut self,
        group: usize,
        frame: &BodyFrame<F::Body>,
        derivative: &mut State<F::Body, LEGS>,
    ) -> Push<F::Leg> {
        self(group, frame, derivative)
    }
}

/// No force.
#[inline(always)]
fn none<S: Real>() -> Vector3<S> {
    Vector3::from([S::zero(); 3])
}

impl<const LEGS: usize> Motion<LEGS> {
    /// The equations of motion of a vehicle in a scene.
    pub fn new(vehicle: &Vehicle<LEGS>, scene: &Scene) -> Self {
        let inertia = *vehicle.inertia();
        // A positive definite matrix has an inverse; the vehicle was checked.
        let inverse_inertia = inertia.try_inverse().unwrap_or_else(Matrix3::zeros);
        let depth = vehicle.center_of_gravity_height();
        let legs: [LegMotion<f64>; LEGS] =
            std::array::from_fn(|j| LegMotion::new(&vehicle.legs()[j], depth, scene));
        Self {
            registers: Four::new(),
            equations: Equations {
                surface: Surface::new(scene),
                gravity: vehicle.gravity(),
                inverse_mass: 1.0 / vehicle.mass(),
                inertia,
                inverse_inertia,
                groups: std::array::from_fn(|group| {
                    LegMotion::abreast(members::<_, LEGS>(group, |j| &legs[j]))
                }),
            },
            legs,
        }
    }

    /// The same equations for a processor that has no wide registers: the same numbers, slower.
    pub fn in_narrow_registers(self) -> Self {
        Self {
            registers: Four::InParts,
            ..self
        }
    }

    /// The registers there are.
    pub(crate) fn registers(&self) -> Four {
        self.registers
    }

    /// The surface.
    pub fn surface(&self) -> &Surface<f64> {
        &self.equations.surface
    }

    /// Geometry of leg `index`.
    pub fn geometry(&self, index: usize) -> &LegGeometry<f64> {
        &self.legs[index].geometry
    }

    /// Writes the time derivative of the state into `derivative`.
    #[inline(always)]
    pub fn derivative(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
        derivative: &mut State<f64, LEGS>,
    ) {
        let bent = self.bend(state, pieces);
        let bent = bent.as_ref().unwrap_or(state);
        let act = |group, frame: &BodyFrame<f64>, derivative: &mut _| {
            let group = self.group(group, frame, bent, pieces);
            self.registers.dispatch(Derivative(group, derivative))
        };
        self.equations.push(bent, derivative, act);
        self.turn(state, pieces, derivative);
    }

    /// Writes the time derivative of the state and the signals of all legs.
    #[inline(always)]
    pub fn evaluate(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
        derivative: &mut State<f64, LEGS>,
        signals: &mut Glance<LEGS>,
    ) {
        let bent = self.bend(state, pieces);
        let bent = bent.as_ref().unwrap_or(state);
        let act = |group, frame: &BodyFrame<f64>, derivative: &mut _| {
            let group = self.group(group, frame, bent, pieces);
            (self.registers).dispatch(DerivativeAndSignals(group, derivative, &mut *signals))
        };
        self.equations.push(bent, derivative, act);
        self.turn(state, pieces, derivative);
        self.tell_turns(state, pieces, signals);
    }

    /// Signals of all legs, the link torques only if asked for: no other signal is a force.
    #[inline(always)]
    pub fn signals(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
        with_torques: bool,
    ) -> Glance<LEGS> {
        let mut signals = Glance::blank();
        self.look(state, pieces, with_torques, &mut signals);
        signals
    }

    /// Writes the signals of all legs into `signals`, the link torques only if asked for.
    #[inline(always)]
    pub(crate) fn look(
        &self,
        state: &State<f64, LEGS>,
        pieces: &Pieces<LEGS>,
        with_torques: bool,
        signals: &mut Glance<LEGS>,
    ) {
        let bent = self.bend(state, pieces);
        let bent = bent.as_ref().unwrap_or(state);
        let frame = self.surface().frame(&bent.body());
        for index in 0..const { groups_of(LEGS) } {
            let group = self.group(index, &frame, bent, pieces);
            let signals = &mut *signals;
            if with_torques {
                self.registers
                    .dispatch(Signals::<true, LEGS>(group, signals));
            } else {
                self.registers
                    .dispatch(Signals::<false, LEGS>(group, signals));
            }
        }
        self.tell_turns(state, pieces, signals);
    }

    #[inline(always)]
    fn group<'a>(
        &'a self,
        index: usize,
        frame: &'a BodyFrame<f64>,
        state: &'a State<f64, LEGS>,
        pieces: &'a Pieces<LEGS>,
    ) -> Group<'a, LEGS> {
        Group {
            index,
            state,
            frame,
            motion: &self.equations.groups[index],
            pieces: &pieces.groups[index],
        }
    }

    /// Loads of all legs.
    pub fn loads(&self, state: &State<f64, LEGS>, pieces: &Pieces<LEGS>) -> [LegLoads<f64>; LEGS] {
        let bent = self.bend(state, pieces);
        let state = bent.as_ref().unwrap_or(state);
        let frame = self.surface().frame(&state.body());
        let groups: [_; GROUPS] = std::array::from_fn(|index| {
            let group = self.group(index, &frame, state, pieces);
            group.action::<true, true>().loads
        });
        std::array::from_fn(|j| LegLoads::lane(&groups[j / LANES], j % LANES))
    }
}

/// Four legs at one instant.
struct Group<'a, const LEGS: usize> {
    index: usize,
    state: &'a State<f64, LEGS>,
    frame: &'a BodyFrame<f64>,
    motion: &'a LegMotion<Quad>,
    pieces: &'a GroupPieces<Quad>,
}

impl<const LEGS: usize> Group<'_, LEGS> {
    #[inline(always)]
    fn action<const FORCES: bool, const SIGNALS: bool>(&self) -> LegAction<Quad> {
        let legs = self.state.legs_abreast(self.index);
        let GroupPieces {
            legs: pieces,
            pressed,
        } = self.pieces;
        self.motion
            .action::<FORCES, SIGNALS>(&self.frame.shared(), &legs, pieces, *pressed)
    }
}

// What is asked of a group is compiled once for each kind of register. Results go through memory,
// whole quads of them, which is what makes the compiler see the lanes.

/// Force on the body and torque about its CG, in vehicle axes.
type Push<S> = [Vector3<S>; 2];

/// Writes the derivative of the legs and returns how they push the body.
struct Derivative<'a, const LEGS: usize>(Group<'a, LEGS>, &'a mut State<f64, LEGS>);
/// The same with the signals.
struct DerivativeAndSignals<'a, const LEGS: usize>(
    Group<'a, LEGS>,
    &'a mut State<f64, LEGS>,
    &'a mut Glance<LEGS>,
);
/// Signals alone, with or without those that are forces.
struct Signals<'a, const FORCES: bool, const LEGS: usize>(Group<'a, LEGS>, &'a mut Glance<LEGS>);

impl<const LEGS: usize> NullaryFnOnce for Derivative<'_, LEGS> {
    type Output = Push<Quad>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Self(group, derivative) = self;
        let push = group.action::<true, false>().push;
        derivative.set_legs_abreast(group.index, &push.derivative);
        [push.force, push.torque]
    }
}

impl<const LEGS: usize> NullaryFnOnce for DerivativeAndSignals<'_, LEGS> {
    type Output = Push<Quad>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Self(group, derivative, told) = self;
        let LegAction { push, signals, .. } = group.action::<true, true>();
        derivative.set_legs_abreast(group.index, &push.derivative);
        told.set_abreast(group.index, &signals);
        [push.force, push.torque]
    }
}

impl<const FORCES: bool, const LEGS: usize> NullaryFnOnce for Signals<'_, FORCES, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self(group, told) = self;
        told.set_abreast(group.index, &group.action::<FORCES, true>().signals);
    }
}
