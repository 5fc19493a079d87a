//! The trajectory of one landing: its state, the laws in force, and the extremes and contacts so far.

use arrayvec::ArrayVec;

use super::History;
use super::hidden_forces::HiddenForces;
use super::ranges::{Guards, SignalRanges};
use super::step_attempt::{Decay, Evaluate};
use super::stiffness::Stiffness;
use crate::contact::{LegLaws, LegMode};
use crate::energy::kinetic;
use crate::extremes::least;
use crate::integrator::step::Step;
use crate::motion::{FreeFlight, Motion, Pieces, Signal, SignalHistory, Signals};
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::registers::{Registers, Single};
use crate::scene::{Scene, Settings};
use crate::stability::StabilityMonitor;
use crate::state::State;
use crate::strut::GentleKinks;
use crate::touchdown::touchdown;
use crate::vehicle::Vehicle;

/// Tolerance up to which gentle kinks of the laws are located. At looser ones steps run over them.
const KINKS_LOCATED: f64 = 1e-6;
/// Work error allowed per step, in units of tolerance times energy. An account of thousands of steps still closes to
/// the tolerance.
const WORK_SHARE: f64 = 0.01;
/// Time resolution of events, s: this times the tolerance, within these limits.
const EVENT_RESOLUTION: f64 = 1e-3;
const EVENT_RESOLUTION_LIMITS: [f64; 2] = [1e-12, 1e-7];

/// Time resolution of events, s.
pub(super) fn event_resolution(settings: &Settings) -> f64 {
    let [finest, coarsest] = EVENT_RESOLUTION_LIMITS;
    (EVENT_RESOLUTION * settings.tolerance()).clamp(finest, coarsest)
}

/// Work error allowed per step of a landing with this energy, ft·lb.
pub(super) fn work_error(settings: &Settings, energy: f64) -> f64 {
    WORK_SHARE * settings.tolerance() * energy
}

/// The previous step.
pub(super) struct Earlier {
    /// Accelerations of the links at its start, rad/s².
    pub(super) link_accelerations: PerLeg<f64>,
    /// Its length, s.
    pub(super) length: f64,
}

/// The greatest force of each strut at the ends of steps so far, and its greatest stroke.
#[derive(Debug, Clone, Copy)]
pub(super) struct StrutPeaks {
    /// Magnitude of the force F, lb.
    pub(super) force: PerLeg<f64>,
    /// Stroke δ, ft.
    pub(super) stroke: PerLeg<f64>,
}

impl StrutPeaks {
    fn none(legs: usize) -> Self {
        Self {
            force: PerLeg::same(legs, 0.0),
            stroke: PerLeg::same(legs, 0.0),
        }
    }
}

/// A landing under way.
pub(crate) struct Trajectory<'o> {
    pub(super) registers: Single,
    pub(super) scene: Scene,
    pub(super) settings: Settings,
    pub(crate) motion: Motion<f64>,
    /// Stability monitor that has observed nothing yet.
    pub(super) monitor: StabilityMonitor,
    pub(super) stiffness: Stiffness,
    /// Time resolution of events, s.
    pub(super) event_resolution: f64,
    /// Kinetic energy at touchdown plus the work of raising the vehicle by the height of its CG, ft·lb. The energy
    /// account closes to this times the tolerance.
    energy: f64,
    /// True if steps end at gentle kinks.
    pub(super) locates_kinks: bool,
    pub(super) laws: ArrayVec<LegLaws, MOST_LEGS>,
    pub(super) modes: PerLeg<LegMode>,
    pub(crate) pieces: Pieces<f64>,
    /// Changes of each leg's pieces so far.
    pub(crate) changes: PerLeg<u64>,
    pub(super) ranges: SignalRanges,
    /// Signals that may have left their range within the last step.
    pub(super) suspects: Guards,
    /// Gentle kinks next to each working strut.
    pub(super) kinks: PerLeg<Option<GentleKinks>>,
    pub(super) time: f64,
    /// Time of the thrust's next change of line, s, and its work so far, ft·lb.
    pub(super) next_knot: f64,
    pub(super) thrust_work: f64,
    /// The start of this step is the present state and its derivative.
    pub(crate) step: Step<f64, State<f64>>,
    /// Motion at the last look between the ends of the step.
    pub(super) within: State<f64>,
    /// Closed form of the present step, if it is free flight.
    pub(super) free: Option<FreeFlight>,
    pub(crate) signals: SignalHistory,
    /// Signals in the middle of the step, if evaluated.
    pub(crate) middle: Signals<f64>,
    pub(super) is_middle_seen: bool,
    /// Signals at the points of the step between which an event was located.
    pub(super) buffers: [Signals<f64>; 3],
    /// The previous step, if no law has changed since.
    pub(super) earlier: Option<Earlier>,
    pub(super) start: State<f64>,
    pub(super) least_angle: (f64, f64),
    pub(super) least_clearance: f64,
    pub(super) peaks: StrutPeaks,
    /// Strut forces within steps that may exceed these peaks.
    pub(super) hidden_forces: HiddenForces,
    pub(super) pad_contact: PerLeg<Option<f64>>,
    pub(super) block_contact: PerLeg<Option<f64>>,
    pub(super) steps: u64,
    pub(super) evaluations: u64,
    pub(super) events: u64,
    pub(super) history: Option<History<'o>>,
}

impl<'o> Trajectory<'o> {
    pub(super) fn new(
        vehicle: &Vehicle,
        scene: &Scene,
        settings: &Settings,
        history: Option<History<'o>>,
    ) -> Self {
        let rules = settings.rules(vehicle);
        let motion = Motion::new(vehicle, scene).with_contact_rule(rules.contact);
        let legs = motion.leg_count();
        let friction = scene.friction_law(settings);
        let laws: ArrayVec<LegLaws, MOST_LEGS> = (vehicle.hinged_legs().iter())
            .enumerate()
            .map(|(index, leg)| {
                leg.laws()
                    .clone()
                    .on_soil(&scene.conditions().soil_under(index), leg.design())
                    .with_crush_rule(rules.crush)
                    .with_contact_rule(rules.contact)
                    .with_friction(friction)
                    .within(settings.tolerance())
            })
            .collect();
        let modes = PerLeg::from_fn(legs, |j| LegMode::untouched(&laws[j]));
        let pieces = Pieces::new(&PerLeg::from_fn(legs, |j| modes[j].pieces(&laws[j])));
        let state = touchdown(vehicle, scene, &motion);
        let energy = kinetic(&motion, &state)
            + motion.mass() * motion.gravity() * vehicle.center_of_gravity_height();
        Self {
            registers: Single::fastest(),
            scene: *scene,
            settings: *settings,
            monitor: StabilityMonitor::new(rules, vehicle, scene),
            stiffness: Stiffness::new(settings, rules.contact, &friction),
            event_resolution: event_resolution(settings),
            energy,
            motion,
            locates_kinks: settings.tolerance() <= KINKS_LOCATED,
            ranges: SignalRanges::new(&PerLeg::from_fn(legs, |j| modes[j].ranges(&laws[j]))),
            laws,
            modes,
            pieces,
            changes: PerLeg::same(legs, 1),
            suspects: Guards::new(),
            kinks: PerLeg::same(legs, None),
            time: 0.0,
            next_knot: if scene.conditions().thrust.is_none() {
                f64::INFINITY
            } else {
                0.0
            },
            thrust_work: 0.0,
            step: Step::from(state, State::zero(legs)),
            within: State::zero(legs),
            free: None,
            signals: SignalHistory::new(legs),
            middle: Signals::blank(legs),
            is_middle_seen: false,
            buffers: [Signals::blank(legs); 3],
            earlier: None,
            start: state,
            least_angle: (f64::INFINITY, 0.0),
            least_clearance: f64::INFINITY,
            peaks: StrutPeaks::none(legs),
            hidden_forces: HiddenForces::none(legs),
            pad_contact: PerLeg::same(legs, None),
            block_contact: PerLeg::same(legs, None),
            steps: 0,
            evaluations: 0,
            events: 0,
            history,
        }
    }

    /// Makes the step up to fraction `reach` the previous one.
    #[inline(always)]
    pub(super) fn remember_step(&mut self, reach: f64) {
        let start = &self.step.slopes[0];
        self.earlier = Some(Earlier {
            link_accelerations: PerLeg::from_fn(start.leg_count(), |j| start.link_rate(j)),
            length: reach * self.step.length,
        });
        self.signals.advance();
    }

    /// Number of legs.
    pub(super) fn leg_count(&self) -> usize {
        self.motion.leg_count()
    }

    /// Work error allowed per step, ft·lb.
    pub(crate) fn greatest_work_error(&self) -> f64 {
        work_error(&self.settings, self.energy)
    }

    /// Returns whether a step of this length (s) is stiff.
    pub(super) fn is_stiff(&mut self, length: f64) -> bool {
        if self.stiffness.is_known_mild() {
            return false;
        }
        let (motion, state, pieces) = (&self.motion, &self.step.before, &self.pieces);
        let rate = if motion.acts_at_face() {
            (self.registers).dispatch(Decay::<true, f64>(motion, state, pieces))
        } else {
            (self.registers).dispatch(Decay::<false, f64>(motion, state, pieces))
        };
        self.stiffness.exceeds_at(rate, length)
    }

    /// Longest step that the laws allow, whatever its error, s.
    pub(super) fn longest_step(&self) -> f64 {
        let pad_rate = |j| self.signals.start().of(j, Signal::PadRate);
        let legs = self.modes.iter().enumerate();
        least(legs.map(|(j, mode)| mode.longest_step(pad_rate(j))))
    }

    /// Time at fraction θ of the step, s.
    pub(super) fn time_at(&self, theta: f64) -> f64 {
        self.time + theta * self.step.length
    }

    /// Evaluates derivative and signals at the end of the step.
    pub(super) fn evaluate_end(&mut self) {
        let [.., last] = &mut self.step.slopes;
        evaluate(
            self.registers,
            &self.motion,
            self.time + self.step.length,
            &self.step.after,
            &self.pieces,
            last,
            self.signals.end_mut(),
        );
        self.evaluations += 1;
    }

    /// Evaluates derivative and signals at the present state.
    pub(super) fn evaluate(&mut self) {
        let [first, ..] = &mut self.step.slopes;
        evaluate(
            self.registers,
            &self.motion,
            self.time,
            &self.step.before,
            &self.pieces,
            first,
            self.signals.start_mut(),
        );
        self.evaluations += 1;
    }

    /// Returns whether all legs hang in the air, without thrust or hinge damping.
    #[inline(always)]
    pub(super) fn flies_freely(&self) -> bool {
        self.modes.iter().all(LegMode::is_hanging)
            && self.pieces.thrust().is_none()
            && !self.motion.damps_hinges()
    }

    /// Starts a step of free flight of this length (s); its end is known.
    pub(super) fn begin_flight(&mut self, flight: FreeFlight, length: f64) {
        self.step.length = length;
        self.step.after = flight.at(length);
        self.free = Some(flight);
        self.kinks.fill(None);
        self.is_middle_seen = false;
        self.evaluate_end();
    }

    /// Writes the pad rates at the middle and end of an implicit step: those of pads at rest are known only after it.
    #[inline(always)]
    pub(super) fn tell_pad_rates(&mut self) {
        let (weights, slopes) = self.step.change(0.5);
        let rates = self.step.before.pad_rates_advanced(weights, slopes);
        for (j, &rate) in rates.iter().enumerate() {
            self.middle.set(j, Signal::PadRate, rate);
            let end = self.step.after.leg(j).pad_rate;
            self.signals.end_mut().set(j, Signal::PadRate, end);
        }
    }
}

/// Writes derivative and signals at a time and a state.
fn evaluate(
    registers: Single,
    motion: &Motion<f64>,
    time: f64,
    state: &State<f64>,
    pieces: &Pieces<f64>,
    slope: &mut State<f64>,
    signals: &mut Signals<f64>,
) {
    if motion.acts_at_face() {
        registers.dispatch(Evaluate::<true, true, f64>(
            motion, time, state, pieces, slope, signals,
        ));
    } else {
        registers.dispatch(Evaluate::<true, false, f64>(
            motion, time, state, pieces, slope, signals,
        ));
    }
}
