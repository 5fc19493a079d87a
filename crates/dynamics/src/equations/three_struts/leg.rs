//! One leg, or four side by side: its constants, and the forces on its foot.

use nalgebra::{Matrix3, Vector3};

use super::bearing::{BearingFriction, Bearings};
use super::state::FootState;
use super::struts::{Reach, Struts};
use crate::ground::Patch;
use crate::kinematics::LocalPlane;
use crate::lanes::per_lane;
use crate::laws::three_struts::{
    INTERFERENCE, INTERFERENCE_RATE, LOAD, LegPieces, LegSignals, SIGNALS, SLIDING, STROKE_RATES,
    STROKES, STRUTS,
};
use crate::products::transposed_times;
use crate::scalar::Real;
use crate::scene::Scene;
use crate::state::Body;
use crate::three_strut_leg::ThreeStrutLeg;
use crate::three_struts::LegStrut;

/// Constants of one leg, or of a group of them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg<S> {
    pub(super) struts: Struts<S>,
    /// Damping of each strut: lb·s/ft, and lb·s²/ft².
    damping: [[S; 2]; STRUTS],
    pub(super) bearings: Bearings<S>,
    pub(super) mass: S,
    pub(super) ground: LocalPlane<S>,
    pub(super) pad_height: S,
    /// π d_f²/4 C_f: the force on the footpad per relative pressure, lb.
    pub(super) pad_strength: S,
    pub(super) friction: S,
}

per_lane!(Leg {
    struts,
    damping,
    bearings,
    mass,
    ground,
    pad_height,
    pad_strength,
    friction,
});

/// One leg at one instant, or a group of them.
pub(super) struct LegAction<S> {
    /// Foot from the CG in vehicle axes, ft.
    pub(super) place: Vector3<S>,
    /// Its velocity in the body, ft/s.
    pub(super) velocity: Vector3<S>,
    pub(super) reaches: [Reach<S>; STRUTS],
    pub(super) rates: [S; STRUTS],
    pub(super) loads: [S; STRUTS],
    /// Friction of the primary strut's bearings, which is part of its load.
    pub(super) bearing: BearingFriction<S>,
    /// Force of the struts on the foot in vehicle axes, lb.
    pub(super) pull: Vector3<S>,
    pub(super) contact: Contact<S>,
    pub(super) interference: S,
}

/// Action of the ground on a foot.
pub(super) struct Contact<S> {
    /// Velocity into the ground, ft/s, and along it in ground axes.
    pub(super) inward: S,
    pub(super) sliding: Vector3<S>,
    pub(super) sliding_squared: S,
    /// Normal force, lb.
    pub(super) normal: S,
    /// μ/S, s/ft.
    pub(super) drag: S,
}

/// The body as the legs see it.
pub(super) struct SeenBody<S> {
    position: Vector3<S>,
    velocity: Vector3<S>,
    /// Turns vehicle axes into ground axes.
    pub(super) frame: Matrix3<S>,
    /// Angular velocity, vehicle axes, rad/s.
    pub(super) rate: Vector3<S>,
}

impl<S: Real> SeenBody<S> {
    #[inline(always)]
    pub(super) fn new(body: &Body<f64>, frame: &Matrix3<f64>) -> Self {
        Self {
            position: body.position.map(S::constant),
            velocity: body.velocity.map(S::constant),
            frame: frame.map(S::constant),
            rate: body.rate.map(S::constant),
        }
    }
}

impl Leg<f64> {
    /// Leg `index` of a vehicle in a scene, whose plane of the lower hardpoints lies `depth` (ft) below the CG, placed from the
    /// `center` of the centreline (x and y of vehicle axes relative to the CG, ft).
    pub(super) fn new(
        index: usize,
        leg: &ThreeStrutLeg,
        depth: f64,
        center: [f64; 2],
        scene: &Scene,
    ) -> Self {
        let design = leg.design();
        let conditions = scene.conditions();
        let struts = Struts::new(design, depth, center);
        let patch: &Patch = &conditions.ground.leg(index).pad;
        let place = conditions.attitude.matrix() * struts.foot;
        let pad = &design.footpad;
        Self {
            struts,
            damping: design
                .struts()
                .map(|strut: &LegStrut| [strut.damping, strut.square_damping]),
            bearings: Bearings::new(design),
            mass: design.foot.mass,
            ground: LocalPlane::new(patch, conditions.slope, place),
            pad_height: pad.height,
            pad_strength: std::f64::consts::FRAC_PI_4
                * pad.diameter
                * pad.diameter
                * pad.crush_pressure,
            friction: conditions.pad_friction,
        }
    }
}

impl<S: Real> Leg<S> {
    /// Damping of strut `k` at a rate of its stroke (ft/s): force per speed, and its derivative, lb·s/ft.
    #[inline(always)]
    pub(super) fn damping(&self, k: usize, rate: S) -> [S; 2] {
        let [linear, square] = self.damping[k];
        let grown = square * rate.abs();
        [linear + grown, linear + grown + grown]
    }

    /// Load of strut `k` at a stroke (ft) and its rate (ft/s), without friction of bearings, lb.
    #[inline(always)]
    pub(super) fn load(&self, k: usize, pieces: &LegPieces<S>, stroke: S, rate: S) -> S {
        pieces.struts[k].at(stroke) + self.damping(k, rate)[0] * rate
    }

    /// Normal force of the ground on the footpad at an interference (ft) and its rate (ft/s), lb.
    #[inline(always)]
    pub(super) fn normal(&self, pieces: &LegPieces<S>, interference: S, rate: S) -> S {
        self.pad_strength * (pieces.pad.at(interference) + pieces.pad.drag_at(rate))
    }

    /// The leg with its foot in a state.
    #[inline(always)]
    pub(super) fn act(
        &self,
        body: &SeenBody<S>,
        foot: &FootState<S>,
        pieces: &LegPieces<S>,
    ) -> LegAction<S> {
        let place = transposed_times(&body.frame, &(foot.position - body.position));
        let velocity = transposed_times(&body.frame, &(foot.velocity - body.velocity))
            - body.rate.cross(&place);
        let reaches = self.struts.at(&place);
        let (mut rates, mut loads) = ([S::zero(); STRUTS], [S::zero(); STRUTS]);
        for k in 0..STRUTS {
            let Reach { stroke, push } = &reaches[k];
            rates[k] = -push.dot(&velocity);
            loads[k] = self.load(k, pieces, *stroke, rates[k]);
        }
        let bearing = (self.bearings).friction(
            reaches[0].stroke,
            rates[0],
            &secondary_push(&reaches, &loads),
        );
        loads[0] += bearing.load;
        let pull = push(&reaches, &loads);
        let normal = self.ground.normal();
        let interference = self.ground.depth_of(&foot.position) + self.pad_height;
        let inward = normal.dot(&foot.velocity);
        let sliding = foot.velocity - normal * inward;
        let sliding_squared = sliding.dot(&sliding);
        LegAction {
            place,
            velocity,
            reaches,
            rates,
            loads,
            bearing,
            pull,
            contact: Contact {
                inward,
                sliding,
                sliding_squared,
                normal: self.normal(pieces, interference, inward),
                drag: self.friction * pieces.friction.per_speed(sliding_squared),
            },
            interference,
        }
    }
}

/// Force of the struts on the foot under these loads (lb), vehicle axes, lb.
#[inline(always)]
pub(super) fn push<S: Real>(reaches: &[Reach<S>; STRUTS], loads: &[S; STRUTS]) -> Vector3<S> {
    let mut push = Vector3::zeros();
    for k in 0..STRUTS {
        push += reaches[k].push * loads[k];
    }
    push
}

/// Force of the secondary struts alone on the foot.
#[inline(always)]
pub(super) fn secondary_push<S: Real>(
    reaches: &[Reach<S>; STRUTS],
    loads: &[S; STRUTS],
) -> Vector3<S> {
    reaches[1].push * loads[1] + reaches[2].push * loads[2]
}

impl<S: Real> LegAction<S> {
    /// Signals of the leg.
    #[inline(always)]
    pub(super) fn signals(&self) -> LegSignals<S> {
        let mut signals = [S::zero(); SIGNALS];
        signals[INTERFERENCE] = self.interference;
        signals[INTERFERENCE_RATE] = self.contact.inward;
        signals[SLIDING] = self.contact.sliding_squared;
        for k in 0..STRUTS {
            signals[STROKES.start + k] = self.reaches[k].stroke;
            signals[STROKE_RATES.start + k] = self.rates[k];
        }
        signals[LOAD] = self.loads[0];
        signals
    }
}
