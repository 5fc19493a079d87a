//! The equations of motion (55), (60), (68), (69) as straight-line arithmetic (model chapter 6).
//!
//! The active piece of each law arrives as coefficients, [`Pieces`]. There is no table search here and only one branch:
//! elements without pressure are skipped. Along with the derivative come the signals whose ranges limit how long those
//! coefficients hold. Numbers are those of one landing (`f64`) or of several, one per lane ([`crate::lanes`]); the legs
//! are computed one after another.

mod contact_response;
mod decay;
mod face;
mod footing;
mod free_flight;
mod leg;
mod leg_response;
mod pad_pressure;
mod pieces;
mod signals;
mod stops;

use nalgebra::{Matrix3, Vector3};

use crate::kinematics::{BodyFrame, LegGeometry, SeenGround, Surface};
use crate::lanes::{Lanes, PerLane, per_lane};
use crate::per_leg::PerLeg;
use crate::products::times;
use crate::rules::ContactRule;
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::{Body, LegState, State, quaternion_rate};
use crate::vehicle::Vehicle;

use leg::{LegAction, LegMotion};

pub use crate::leg_pieces::LegPieces;
pub use crate::signal::{LegSignals, Signal};
pub use footing::Footing;
pub use free_flight::FreeFlight;
pub use pieces::Pieces;
pub(crate) use signals::SignalHistory;
pub use signals::Signals;

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

per_lane!(LegLoads {
    strut,
    pad_normal,
    pad_friction,
    block_normal,
    block_friction,
});

/// The equations of motion of a vehicle on a surface, or of several landings, one per lane.
#[derive(Debug, Clone, Copy)]
pub struct Motion<S> {
    surface: Surface<S>,
    /// Centre from which the legs are placed, relative to the CG: x and y of vehicle axes, ft ([`crate::kinematics`]).
    center: [S; 2],
    /// Offset of the thrust's line of action from the centreline: x and y of vehicle axes, ft.
    thrust_offset: [S; 2],
    gravity: S,
    mass: S,
    inverse_mass: S,
    inertia: Matrix3<S>,
    inverse_inertia: Matrix3<S>,
    legs: PerLeg<LegMotion<S>>,
    /// True if the ground acts where it is touched, in all lanes.
    acts_at_face: bool,
}

impl Motion<f64> {
    /// The equations of motion of a vehicle in a scene.
    pub fn new(vehicle: &Vehicle, scene: &Scene) -> Self {
        let inertia = *vehicle.inertia();
        // A positive definite matrix has an inverse; the vehicle was checked.
        let inverse_inertia = inertia.try_inverse().unwrap_or_else(Matrix3::zeros);
        let depth = vehicle.center_of_gravity_height();
        let legs = vehicle.hinged_legs();
        let center = vehicle.center_of_gravity_offset().map(|offset| -offset);
        Self {
            surface: Surface::new(scene),
            center,
            thrust_offset: scene.conditions().thrust.offset(),
            gravity: scene.gravity(vehicle),
            mass: vehicle.mass(),
            inverse_mass: 1.0 / vehicle.mass(),
            inertia,
            inverse_inertia,
            legs: PerLeg::from_fn(legs.len(), |j| {
                LegMotion::new(j, &legs[j], depth, center, scene)
            }),
            acts_at_face: false,
        }
    }

    /// Returns these equations under another contact rule.
    pub fn with_contact_rule(self, rule: ContactRule) -> Self {
        Self {
            acts_at_face: rule == ContactRule::Face,
            ..self
        }
    }

    /// The same landing in all lanes.
    pub fn in_all_lanes<const N: usize>(&self) -> Motion<Lanes<N>> {
        Motion {
            surface: self.surface.splat(),
            center: self.center.splat(),
            thrust_offset: self.thrust_offset.splat(),
            gravity: self.gravity.splat(),
            mass: self.mass.splat(),
            inverse_mass: self.inverse_mass.splat(),
            inertia: self.inertia.splat(),
            inverse_inertia: self.inverse_inertia.splat(),
            legs: self.legs.map(|leg| leg.splat()),
            acts_at_face: self.acts_at_face,
        }
    }

    /// Returns whether damping of any hinge acts. Pads that swing in the air then have no closed form.
    #[inline(always)]
    pub fn damps_hinges(&self) -> bool {
        self.acts_at_face && !self.legs.iter().all(|leg| leg.hinge_damping == 0.0)
    }

    /// Acceleration of gravity, ft/s².
    pub fn gravity(&self) -> f64 {
        self.gravity
    }

    /// Mass, slug.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Inertia matrix J (59), slug·ft².
    pub fn inertia(&self) -> &Matrix3<f64> {
        &self.inertia
    }

    /// The ground under footpad and block of leg `index`, seen from a body.
    pub fn ground(&self, index: usize, body: &BodyFrame<f64>) -> [SeenGround<f64>; 2] {
        self.legs[index].seen_ground(body)
    }

    /// Vertical rise of a point to leave the ground of the footpad of leg `index`, ft, from its depth (ft) below that
    /// ground.
    pub fn rise(&self, index: usize, depth: f64) -> f64 {
        self.legs[index].ground.rise(depth)
    }

    /// A point of the line of action of the thrust relative to the CG, ground axes, ft.
    pub fn thrust_place(&self, body: &BodyFrame<f64>) -> Vector3<f64> {
        let [x, y] = self.thrust_offset;
        body.seen_from_center_of_gravity(&Vector3::new(x, y, 0.0))
    }

    /// Moment of inertia of the lower link of leg `index` about its hardpoint, slug·ft².
    pub fn link_inertia(&self, index: usize) -> f64 {
        self.legs[index].link_inertia
    }

    /// Signals of all legs, with link torques only if asked for; no other signal is a force.
    pub fn signals(
        &self,
        state: &State<f64>,
        pieces: &Pieces<f64>,
        with_torques: bool,
    ) -> Signals<f64> {
        let mut signals = Signals::blank(self.leg_count());
        self.look(state, pieces, with_torques, &mut signals);
        signals
    }

    /// Writes the signals of all legs into `signals`, with link torques only if asked for.
    #[inline(always)]
    pub fn look(
        &self,
        state: &State<f64>,
        pieces: &Pieces<f64>,
        with_torques: bool,
        signals: &mut Signals<f64>,
    ) {
        let frame = self.frame(&state.body());
        for leg in 0..self.leg_count() {
            let action = match (with_torques, self.acts_at_face) {
                (true, false) => self.action::<true, true, true, false>(leg, &frame, state, pieces),
                (true, true) => self.action::<true, true, true, true>(leg, &frame, state, pieces),
                (false, false) => {
                    self.action::<false, true, true, false>(leg, &frame, state, pieces)
                }
                (false, true) => self.action::<false, true, true, true>(leg, &frame, state, pieces),
            };
            signals.set_leg(leg, &action.signals);
        }
    }

    /// Loads of all legs.
    pub fn loads(&self, state: &State<f64>, pieces: &Pieces<f64>) -> PerLeg<LegLoads<f64>> {
        let frame = self.frame(&state.body());
        PerLeg::from_fn(self.leg_count(), |leg| {
            self.leg_loads(leg, &frame, state, pieces)
        })
    }

    /// Loads of a leg, given the frame of the body at that state.
    pub fn leg_loads(
        &self,
        leg: usize,
        frame: &BodyFrame<f64>,
        state: &State<f64>,
        pieces: &Pieces<f64>,
    ) -> LegLoads<f64> {
        if self.acts_at_face {
            (self.action::<true, true, true, true>(leg, frame, state, pieces)).loads
        } else {
            (self.action::<true, true, true, false>(leg, frame, state, pieces)).loads
        }
    }
}

impl<const N: usize> Motion<Lanes<N>> {
    /// Puts a landing into a lane.
    pub fn set_lane(&mut self, lane: usize, one: &Motion<f64>) {
        one.surface.set_lane(&mut self.surface, lane);
        one.center.set_lane(&mut self.center, lane);
        one.thrust_offset.set_lane(&mut self.thrust_offset, lane);
        one.gravity.set_lane(&mut self.gravity, lane);
        one.mass.set_lane(&mut self.mass, lane);
        one.inverse_mass.set_lane(&mut self.inverse_mass, lane);
        one.inertia.set_lane(&mut self.inertia, lane);
        one.inverse_inertia
            .set_lane(&mut self.inverse_inertia, lane);
        for (leg, legs) in one.legs.iter().zip(self.legs.iter_mut()) {
            leg.set_lane(legs, lane);
        }
    }
}

impl<S: Real> Motion<S> {
    /// Number of legs.
    #[inline(always)]
    pub fn leg_count(&self) -> usize {
        self.legs.len()
    }

    /// The surface.
    pub fn surface(&self) -> &Surface<S> {
        &self.surface
    }

    /// The frame of a body over the surface.
    #[inline(always)]
    pub fn frame(&self, body: &Body<S>) -> BodyFrame<S> {
        self.surface.frame(body, &self.center)
    }

    /// Geometry of leg `index`.
    pub fn geometry(&self, index: usize) -> &LegGeometry<S> {
        &self.legs[index].geometry
    }

    /// Returns whether the ground under a leg is not the surface.
    pub fn has_ground_of_its_own(&self, leg: usize) -> bool {
        !self.legs[leg].ground.is_even()
    }

    /// Returns whether any of the rare actions is present: a pad that presses on a stop or is on its edge, ground of
    /// its own under a leg, soil with inertial drag, thrust.
    #[inline(always)]
    pub fn is_full(&self, pieces: &Pieces<S>) -> bool {
        pieces.press_stops()
            || !self.legs.iter().all(|leg| leg.ground.is_even())
            || !pieces.thrust().is_none()
            || pieces.has_edges()
            || pieces.have_drag()
    }

    /// Returns whether the ground acts where it is touched ([`ContactRule::Face`]).
    #[inline(always)]
    pub fn acts_at_face(&self) -> bool {
        self.acts_at_face
    }

    /// Writes the time derivative of the state, `time` s after first contact. Without `FULL` the rare actions
    /// ([`Self::is_full`]) are left out: known beforehand, they take no branch among the equations, which would cost
    /// more than they do. `FACE` goes with [`Self::acts_at_face`] and needs `FULL`.
    #[inline(always)]
    pub fn derivative<const FULL: bool, const FACE: bool>(
        &self,
        time: S,
        state: &State<S>,
        pieces: &Pieces<S>,
        derivative: &mut State<S>,
    ) {
        let body = state.body();
        let frame = self.frame(&body);
        let mut push = Push::none();
        for leg in 0..self.legs.len() {
            let action = self.action::<true, false, FULL, FACE>(leg, &frame, state, pieces);
            derivative.set_leg(leg, &action.derivative);
            push.add(&action);
        }
        if FULL {
            push.add_thrust(pieces.thrust().at(time), &self.thrust_offset);
        }
        self.move_body(&body, &frame, &push, derivative);
    }

    /// Writes the time derivative of the state and the signals of all legs. `FULL` and `FACE` are as in
    /// [`Self::derivative`].
    #[inline(always)]
    pub fn evaluate<const FULL: bool, const FACE: bool>(
        &self,
        time: S,
        state: &State<S>,
        pieces: &Pieces<S>,
        derivative: &mut State<S>,
        signals: &mut Signals<S>,
    ) {
        let body = state.body();
        let frame = self.frame(&body);
        let mut push = Push::none();
        for leg in 0..self.legs.len() {
            let action = self.action::<true, true, FULL, FACE>(leg, &frame, state, pieces);
            derivative.set_leg(leg, &action.derivative);
            signals.set_leg(leg, &action.signals);
            push.add(&action);
        }
        if FULL {
            push.add_thrust(pieces.thrust().at(time), &self.thrust_offset);
        }
        self.move_body(&body, &frame, &push, derivative);
    }

    /// Writes the motion of the body as the legs push it (55), (60).
    #[inline(always)]
    fn move_body(
        &self,
        body: &Body<S>,
        frame: &BodyFrame<S>,
        push: &Push<S>,
        derivative: &mut State<S>,
    ) {
        let mut acceleration = times(&frame.rotation, &push.force) * self.inverse_mass;
        acceleration.z += self.gravity;
        let momentum = times(&self.inertia, &body.rate);
        let torque = push.torque + frame.moment_of_center(&push.force);
        let twist = torque - body.rate.cross(&momentum);
        derivative.set_body(&Body {
            position: body.velocity,
            velocity: acceleration,
            quaternion: quaternion_rate(&body.quaternion, &body.rate),
            rate: times(&self.inverse_inertia, &twist),
        });
    }

    /// Speed of the body along the line of action of the thrust, ft/s.
    pub fn speed_along_thrust(&self, state: &State<S>) -> S {
        let frame = self.frame(&state.body());
        let [x, y] = self.thrust_offset;
        let (v, w) = (&frame.velocity, &frame.rate);
        -(v.z + (w.x * y - w.y * x))
    }

    /// Adds the effect of `more` thrust (lb) to the derivative at a state.
    #[inline(always)]
    pub fn add_thrust(&self, more: S, state: &State<S>, derivative: &mut State<S>) {
        let frame = self.frame(&state.body());
        let mut push = Push::none();
        push.add_thrust(more, &self.thrust_offset);
        let acceleration = times(&frame.rotation, &push.force) * self.inverse_mass;
        let torque = push.torque + frame.moment_of_center(&push.force);
        let turning = times(&self.inverse_inertia, &torque);
        let mut body = derivative.body();
        for i in 0..3 {
            let (v, w) = (body.velocity[i], body.rate[i]);
            body.velocity[i] = more.where_zero(v, v + acceleration[i]);
            body.rate[i] = more.where_zero(w, w + turning[i]);
        }
        derivative.set_body(&body);
    }

    /// Action of a leg ([`LegMotion::action`]), pads that press on a stop included.
    #[inline(always)]
    fn action<const FORCES: bool, const SIGNALS: bool, const FULL: bool, const FACE: bool>(
        &self,
        leg: usize,
        frame: &BodyFrame<S>,
        state: &State<S>,
        pieces: &Pieces<S>,
    ) -> LegAction<S> {
        let (motion, pieces) = (&self.legs[leg], pieces.leg(leg));
        let leg = state.leg(leg);
        let posed = if FULL { at_angle(pieces, leg) } else { leg };
        let mut action = motion.action::<FORCES, SIGNALS, FULL, FACE>(
            frame,
            &posed,
            &pieces.leg,
            pieces.pressed,
        );
        if FULL && pieces.pressed.stops {
            let turning = &mut action.derivative.pad_turn;
            *turning = pieces.leg.hinge.turning(*turning, leg.pad_rate);
            action.signals[Signal::PadTurn as usize] = leg.pad_turn;
        }
        action
    }
}

/// A leg with the angle α of its pad in place of the pad's turn, as the equations of a leg take it. Where a pad presses
/// on a stop of its hinge, α falls behind the turn (`hinge`; model chapter 6).
#[inline(always)]
fn at_angle<S: Real>(pieces: &pieces::ActivePieces<S>, leg: LegState<S>) -> LegState<S> {
    if pieces.pressed.stops {
        LegState {
            pad_turn: pad_angle(&pieces.leg, leg.pad_turn),
            ..leg
        }
    } else {
        leg
    }
}

/// Angle α of a pad with this turn, rad.
#[cold]
#[inline(never)]
fn pad_angle<S: Real>(pieces: &LegPieces<S>, turn: S) -> S {
    pieces.hinge.angle(turn)
}

/// Push on the body, in vehicle axes.
struct Push<S> {
    /// Force, lb.
    force: Vector3<S>,
    /// Torque about the centre, ft·lb.
    torque: Vector3<S>,
}

impl<S: Real> Push<S> {
    #[inline(always)]
    fn none() -> Self {
        Self {
            force: Vector3::from([S::zero(); 3]),
            torque: Vector3::from([S::zero(); 3]),
        }
    }

    #[inline(always)]
    fn add(&mut self, leg: &LegAction<S>) {
        for i in 0..3 {
            self.force[i] += leg.force[i];
            self.torque[i] += leg.torque[i];
        }
    }

    /// Adds thrust (lb) upward along the centreline, or at an offset (ft) beside it. Without thrust every bit stays.
    #[inline(always)]
    fn add_thrust(&mut self, thrust: S, [x, y]: &[S; 2]) {
        let pushed = |own: S, more: S| thrust.where_zero(own, own + more);
        self.force.z = pushed(self.force.z, -thrust);
        self.torque.x = pushed(self.torque.x, -(*y * thrust));
        self.torque.y = pushed(self.torque.y, *x * thrust);
    }
}
