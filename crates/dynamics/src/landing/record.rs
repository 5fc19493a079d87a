//! Reports of a landing: its result, its energy account, its history.

use nalgebra::Vector3;

use crate::attitude::Attitude;
use crate::contact::{LegLaws, Sets, Sinkages};
use crate::motion::{LegLoads, Signal, Signals};
use crate::outcome::Outcome;
use crate::per_leg::PerLeg;
use crate::stability::Observation;
use crate::state::State;

/// Work done on one leg's elements since touchdown, ft·lb. Strut and crush work include energy still stored
/// elastically.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LegWork {
    /// Shock absorber.
    pub strut: f64,
    /// Footpad, normal to the surface (crushing); under [`crate::rules::ContactRule::Face`] at its face, leaning
    /// included.
    pub pad_crush: f64,
    /// Footpad, sliding.
    pub pad_friction: f64,
    /// Body block, normal to the surface (crushing).
    pub block_crush: f64,
    /// Body block, sliding.
    pub block_friction: f64,
    /// Link motion ended by the extension stop or frozen off the surface. Under [`crate::rules::ContactRule::Face`]
    /// also the pad's own kinetic energy of turning, motion ended by the stops of its hinge, and damping of its hinge.
    pub stop: f64,
}

impl LegWork {
    /// Takes the work in the order of the state.
    pub(crate) fn from_state(work: [f64; 6]) -> Self {
        let [
            strut,
            pad_crush,
            pad_friction,
            block_crush,
            block_friction,
            stop,
        ] = work;
        Self {
            strut,
            pad_crush,
            pad_friction,
            block_crush,
            block_friction,
            stop,
        }
    }

    /// Sum over the elements, ft·lb.
    pub fn total(&self) -> f64 {
        self.strut
            + self.pad_crush
            + self.pad_friction
            + self.block_crush
            + self.block_friction
            + self.stop
    }
}

/// Energy account of a landing, ft·lb.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Energies {
    /// Kinetic energy at first contact: body and lower links.
    pub initial_kinetic: f64,
    /// Potential energy released since: M g times the descent of the CG.
    pub potential_change: f64,
    /// Work done by the thrust.
    pub thrust: f64,
    /// Work done on the elements.
    pub legs: PerLeg<LegWork>,
    /// Kinetic energy at the end: body and lower links.
    pub final_kinetic: f64,
}

impl Energies {
    /// Energy taken up by all elements, ft·lb.
    pub fn dissipated(&self) -> f64 {
        self.legs.iter().map(LegWork::total).sum()
    }

    /// Energy that footpads and blocks gave to the motion where they gave more than they took, ft·lb; zero where it is
    /// rounding.
    ///
    /// Under [`crate::rules::ContactRule::Face`] it is zero. At the pivot, crush and friction of a footpad count
    /// together: friction at its face tips the pad about its hinge, and the pad lifts the vehicle by what friction took
    /// from it.
    pub fn given_by_contact(&self) -> f64 {
        const LEAST_SHARE: f64 = 1e-9;
        let works =
            (self.legs.iter()).flat_map(|leg| [leg.pad_crush + leg.pad_friction, leg.block_crush]);
        let given: f64 = works.map(|work| (-work).max(0.0)).sum();
        if given > LEAST_SHARE * self.initial_kinetic.max(1.0) {
            given
        } else {
            0.0
        }
    }

    /// Remainder that the account does not explain, ft·lb; zero but for integration error.
    pub fn closure(&self) -> f64 {
        self.initial_kinetic + self.potential_change + self.thrust
            - self.dissipated()
            - self.final_kinetic
    }
}

/// Rates at the end of a landing.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FinalRates {
    /// Rate of the stability angle σ, rad/s; `None` where all feet stand on one side.
    pub stability_angle: Option<f64>,
    /// Rates of the strokes of the struts, ft/s.
    pub strokes: PerLeg<f64>,
    /// Their accelerations with the body at rest, ft/s².
    pub stroke_accelerations: PerLeg<f64>,
}

/// Continuation of a landing beyond its verdict.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Beyond {
    /// Time of the verdict, s after first contact.
    pub verdict_time: f64,
    /// Its end: the time limit, or a state for which the model has no law.
    pub end: Outcome,
}

/// Result of one landing.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Landing {
    /// Its outcome.
    pub outcome: Outcome,
    /// End time, s after first contact; beyond the verdict, if it went on.
    pub end_time: f64,
    /// Continuation beyond the verdict that is its outcome.
    pub beyond: Option<Beyond>,
    /// Least stability angle σ up to the verdict, or to rest under [`Stop::Rest`](crate::scene::Stop::Rest), rad. Zero for
    /// a pitch topple, and where all feet stand on one side of the plane of motion from the first instant, so that none is
    /// defined.
    pub min_stability_angle: f64,
    /// Time of the least stability angle, s.
    pub min_stability_time: f64,
    /// Least ground clearance of the lower hardpoints, ft (71), also after the verdict.
    pub min_clearance: f64,
    /// Inclination of the centreline to the vertical at the end, rad.
    pub tilt: f64,
    /// Largest strut force magnitudes, lb.
    pub max_strut_force: PerLeg<f64>,
    /// Greatest stroke of each strut, ft.
    pub max_stroke: PerLeg<f64>,
    /// That stroke as a share of the stroke at which the strut bottoms.
    pub max_stroke_share: PerLeg<f64>,
    /// That stroke as a share of the one at which the crush table of a cartridge ends: more than 1 means beyond it. Zero
    /// for other struts, and where the table reaches the stroke at which the strut bottoms.
    pub max_stroke_table_share: PerLeg<f64>,
    /// Greatest crush of either section of each footpad, ft; for a pad on its edge that of the edge, if its share is
    /// greater.
    pub max_pad_crush: PerLeg<f64>,
    /// That crush as a share of the height up to the hinge: more than 1 means beyond it.
    pub max_pad_crush_share: PerLeg<f64>,
    /// Greatest sinkage of either section of each footpad into soil, ft: 0 on rock.
    pub max_sinkage: PerLeg<f64>,
    /// Rates at the end.
    pub final_rates: FinalRates,
    /// First contact of each footpad, s.
    pub pad_contact: PerLeg<Option<f64>>,
    /// First contact of each body block, s.
    pub block_contact: PerLeg<Option<f64>>,
    /// Energy account.
    pub energies: Energies,
    /// Accepted integration steps.
    pub steps: u64,
    /// Evaluations of the equations of motion, event location included.
    pub evaluations: u64,
    /// Events located: changes of a law's active piece.
    pub events: u64,
}

impl Landing {
    /// Number of legs.
    pub fn leg_count(&self) -> usize {
        self.pad_contact.len()
    }
}

/// State and loads at one instant of a landing, for histories. Foot, pound, second, radian.
#[derive(Debug, Clone, PartialEq)]
pub struct Instant {
    /// Time after first contact, s.
    pub time: f64,
    /// CG in ground axes, ft.
    pub position: Vector3<f64>,
    /// CG velocity in ground axes, ft/s.
    pub velocity: Vector3<f64>,
    /// Attitude, vehicle to ground.
    pub attitude: Attitude,
    /// Body angular velocity, vehicle axes, rad/s.
    pub angular_velocity: Vector3<f64>,
    /// Stability angle σ, rad.
    pub stability_angle: f64,
    /// Least height of the lower hardpoints above the surface, ft.
    pub clearance: f64,
    /// Kinetic energy of body and lower links, ft·lb.
    pub kinetic_energy: f64,
    /// Potential energy released since first contact, ft·lb.
    pub potential_change: f64,
    /// Work done by the thrust since first contact, ft·lb, in scenes that have any.
    pub thrust_work: Option<f64>,
    /// The legs.
    pub legs: PerLeg<LegInstant>,
}

/// Energies of the whole lander at one instant, ft·lb.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EnergiesAt {
    pub(crate) kinetic: f64,
    /// Released since first contact.
    pub(crate) potential_change: f64,
    pub(crate) thrust_work: Option<f64>,
}

impl Instant {
    /// The instant at `time`, with its energies, and the feet's state that only the laws know.
    pub(crate) fn new(
        time: f64,
        state: &State<f64>,
        seen: &Observation,
        energies: EnergiesAt,
        signals: &Signals<f64>,
        loads: &PerLeg<LegLoads<f64>>,
        feet: PerLeg<Foot>,
    ) -> Self {
        let body = state.body();
        let q = body.quaternion;
        Self {
            time,
            position: body.position,
            velocity: body.velocity,
            attitude: Attitude::from_quaternion([q.x, q.y, q.z, q.w]),
            angular_velocity: body.rate,
            stability_angle: seen.angle,
            clearance: seen.clearance,
            kinetic_energy: energies.kinetic,
            potential_change: energies.potential_change,
            thrust_work: energies.thrust_work,
            legs: PerLeg::from_fn(feet.len(), |j| {
                let leg = state.leg(j);
                let sets = feet[j].sets;
                LegInstant {
                    posture: LegPosture::Hinged(HingedPosture {
                        link_angle: leg.link_angle,
                        link_rate: leg.link_rate,
                        pad_angle: feet[j].pad_angle,
                        pad_rate: leg.pad_rate,
                    }),
                    stroke: signals.of(j, Signal::Stroke),
                    strut_force: loads[j].strut,
                    pad_normal: loads[j].pad_normal,
                    pad_friction: loads[j].pad_friction,
                    block_normal: loads[j].block_normal,
                    block_friction: loads[j].block_friction,
                    pad_sets: sets.pad,
                    block_set: sets.block,
                    sinkages: feet[j].sinkages,
                    work: LegWork::from_state(leg.work),
                }
            }),
        }
    }
}

/// State of a foot that only the laws of its leg know.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Foot {
    /// Footpad angle α, rad.
    pub(crate) pad_angle: f64,
    /// Plastic sets of its elements, without those of the soil.
    pub(crate) sets: Sets,
    /// Greatest sinkages of its elements so far, on soil.
    pub(crate) sinkages: Option<Sinkages>,
}

impl Foot {
    /// The foot of a leg with these laws, its pad at this angle (rad), with these sets of elements and soil together.
    pub(crate) fn new(laws: &LegLaws, pad_angle: f64, sets: &Sets) -> Self {
        let (sets, sinkages) = laws.without_soil(sets);
        Self {
            pad_angle,
            sets,
            sinkages,
        }
    }
}

/// Posture of a leg at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LegPosture {
    /// Of a leg that turns about one hinge.
    Hinged(HingedPosture),
    /// Of a leg of three struts.
    ThreeStrut(ThreeStrutPosture),
}

/// Posture of a leg that turns about one hinge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HingedPosture {
    /// Lower-link angle γ, rad.
    pub link_angle: f64,
    /// Its rate γ̇, rad/s.
    pub link_rate: f64,
    /// Footpad angle α, rad.
    pub pad_angle: f64,
    /// Its rate state α̇, rad/s (winds up while the pad presses on a stop).
    pub pad_rate: f64,
}

/// Posture of a leg of three struts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThreeStrutPosture {
    /// Foot from the CG in vehicle axes, ft.
    pub foot: Vector3<f64>,
    /// Its velocity in ground axes, ft/s.
    pub velocity: Vector3<f64>,
    /// Strokes of the secondary struts, ft, shorter is positive: first the one at the lesser azimuth.
    pub secondary_strokes: [f64; 2],
    /// Their loads, lb, compression positive.
    pub secondary_forces: [f64; 2],
}

/// One leg at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegInstant {
    /// Its posture.
    pub posture: LegPosture,
    /// Stroke δ of the strut, or of the primary strut, ft.
    pub stroke: f64,
    /// Strut force, lb, compression positive; zero off the surface and on the extension stop.
    pub strut_force: f64,
    /// Normal force of the surface on the footpad, lb.
    pub pad_normal: f64,
    /// Friction force on the footpad, lb.
    pub pad_friction: f64,
    /// Normal force of the surface on the block, lb.
    pub block_normal: f64,
    /// Friction force on the block, lb.
    pub block_friction: f64,
    /// Plastic sets of the outboard and inboard pad sections, ft.
    pub pad_sets: [f64; 2],
    /// Plastic set of the block, ft.
    pub block_set: f64,
    /// Greatest sinkages of its elements so far, in scenes on soil.
    pub sinkages: Option<Sinkages>,
    /// Work done on this leg's elements since first contact.
    pub work: LegWork,
}

impl LegInstant {
    /// Its posture, if it turns about one hinge.
    pub fn hinged(&self) -> Option<&HingedPosture> {
        match &self.posture {
            LegPosture::Hinged(posture) => Some(posture),
            LegPosture::ThreeStrut(_) => None,
        }
    }

    /// Its posture, if it has three struts.
    pub fn three_strut(&self) -> Option<&ThreeStrutPosture> {
        match &self.posture {
            LegPosture::Hinged(_) => None,
            LegPosture::ThreeStrut(posture) => Some(posture),
        }
    }
}
