//! One landing: integrate from first contact until an outcome, and report.

mod account;
mod advance;
mod foresight;
mod rates;
mod stiffness;
mod trail;
mod verdict;

use crate::contact::{LegLaws, LegMode};
use crate::energy::kinetic;
use crate::integrator::event::{Node, Watch, first_exit};
use crate::integrator::step::{EVALUATIONS, Step};
use crate::integrator::step_control::{SHORTEST, StepControl};
use crate::methods::{self, Method};
use crate::motion::{LegSignals, Motion, Pieces, Signal};
use crate::outcome::{Failure, Outcome};
use crate::scene::{Scene, Settings};
use crate::stability::{Judge, Observation, calm_height};
use crate::state::State;
use crate::strut::Kinks;
use crate::touchdown::touchdown;
use crate::vehicle::Vehicle;

use account::History;
use advance::{Advance, Look};
use stiffness::Stiffness;
use trail::Trail;

pub(crate) use rates::final_rates;

pub use crate::record::{Energies, FinalRates, Instant, Landing, LegInstant, LegWork};

/// First step after touchdown, s.
const FIRST_STEP: f64 = 1e-4;
/// Tolerances at which gentle kinks of the laws are foreseen: at tighter ones they are located, at looser
/// ones steps run over them.
const FORESEEN: [f64; 2] = [5e-7, 1e-6];
/// Error of work allowed to a step, in units of tolerance times energy: an account of thousands of
/// steps still closes to the tolerance.
const WORK_SHARE: f64 = 0.01;
/// Time within which an event is located, s: this times the tolerance, but within these limits.
const EVENT_RESOLUTION: f64 = 1e-3;
const EVENT_RESOLUTION_LIMITS: [f64; 2] = [1e-12, 1e-7];
/// Changes of laws at one instant before they are called chattering.
const MOST_CHANGES: usize = 64;
/// So many events within so short a time (s) are chattering too: the laws switch to and fro while
/// the time creeps.
const BURST: u64 = 4000;
const BURST_TIME: f64 = 1e-5;
/// Steps, rejected ones included, before a landing is given up.
const MOST_STEPS: u64 = 2_000_000;

/// Computes a landing.
pub fn land<const LEGS: usize>(
    vehicle: &Vehicle<LEGS>,
    scene: &Scene,
    settings: &Settings,
) -> Landing<LEGS> {
    land_observed(vehicle, scene, settings, f64::INFINITY, |_| {})
}

/// Computes a landing and reports its state every `interval` seconds from first contact on, and
/// at the end.
pub fn land_observed<const LEGS: usize>(
    vehicle: &Vehicle<LEGS>,
    scene: &Scene,
    settings: &Settings,
    interval: f64,
    observe: impl FnMut(&Instant<LEGS>),
) -> Landing<LEGS> {
    if settings.method() != Method::Located {
        return methods::land_observed(vehicle, scene, settings, interval, observe).0;
    }
    let mut flight = Flight::new(vehicle, scene, settings, History::new(interval, observe));
    let outcome = flight.run();
    flight.report_end();
    flight.conclude(outcome)
}

/// What was seen at the start of the step before.
struct Earlier<const LEGS: usize> {
    observation: Observation<LEGS>,
    link_accelerations: [f64; LEGS],
    length: f64,
}

/// A landing under way.
struct Flight<'a, O, const LEGS: usize> {
    vehicle: &'a Vehicle<LEGS>,
    scene: &'a Scene,
    settings: &'a Settings,
    motion: Motion<LEGS>,
    stiffness: Stiffness<LEGS>,
    /// Time within which an event is located, s.
    event_resolution: f64,
    /// Kinetic energy at touchdown and the work of raising the vehicle by the height of its CG, ft·lb:
    /// what the account of energies closes to, times the tolerance.
    energy: f64,
    /// What becomes of gentle kinks.
    kinks: Kinks,
    laws: [LegLaws; LEGS],
    modes: [LegMode; LEGS],
    pieces: Pieces<LEGS>,
    watches: Vec<Watch>,
    /// Those of them that may have left their range within the last step.
    suspects: Vec<Watch>,
    time: f64,
    /// The present state and its derivative are the start of the step.
    step: Step<f64, LEGS>,
    signals: Trail<LEGS>,
    /// The step before, if no law has changed since.
    earlier: Option<Earlier<LEGS>>,
    start: State<f64, LEGS>,
    least_angle: (f64, f64),
    least_clearance: f64,
    greatest_strut_force: [f64; LEGS],
    greatest_stroke: [f64; LEGS],
    pad_contact: [Option<f64>; LEGS],
    block_contact: [Option<f64>; LEGS],
    steps: u64,
    evaluations: u64,
    events: u64,
    history: History<O>,
}

impl<'a, O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'a, O, LEGS> {
    fn new(
        vehicle: &'a Vehicle<LEGS>,
        scene: &'a Scene,
        settings: &'a Settings,
        history: History<O>,
    ) -> Self {
        let motion = Motion::new(vehicle, scene);
        let [finest, coarsest] = EVENT_RESOLUTION_LIMITS;
        let resolution = (EVENT_RESOLUTION * settings.tolerance()).clamp(finest, coarsest);
        let kinks = match settings.tolerance() {
            tolerance if tolerance < FORESEEN[0] => Kinks::Located,
            tolerance if tolerance <= FORESEEN[1] => Kinks::Foreseen,
            _ => Kinks::SteppedOver,
        };
        let laws = std::array::from_fn(|j| {
            LegLaws::new(&vehicle.legs()[j], settings.crush_rule(), kinks)
                .with_friction(settings.friction_profile())
                .within(settings.tolerance())
        });
        let modes: [LegMode; LEGS] = std::array::from_fn(|j| LegMode::untouched(&laws[j]));
        let pieces = Pieces::new(&std::array::from_fn(|j| modes[j].pieces(&laws[j])));
        let state = touchdown(vehicle, scene, &motion);
        Self {
            vehicle,
            scene,
            settings,
            stiffness: Stiffness::new(&motion, settings.tolerance()),
            event_resolution: resolution,
            energy: kinetic(vehicle, &state)
                + vehicle.mass() * vehicle.gravity() * vehicle.center_of_gravity_height(),
            motion,
            kinks,
            laws,
            modes,
            pieces,
            watches: Vec::with_capacity(LEGS * Signal::COUNT),
            suspects: Vec::with_capacity(LEGS * Signal::COUNT),
            time: 0.0,
            step: Step::from(state, State::zero()),
            signals: Trail::new(),
            earlier: None,
            start: state,
            least_angle: (f64::INFINITY, 0.0),
            least_clearance: f64::INFINITY,
            greatest_strut_force: [0.0; LEGS],
            greatest_stroke: [0.0; LEGS],
            pad_contact: [None; LEGS],
            block_contact: [None; LEGS],
            steps: 0,
            evaluations: 0,
            events: 0,
            history,
        }
    }

    fn run(&mut self) -> Outcome {
        let mut judge = Judge::new(self.scene, calm_height(self.vehicle));
        let first_look = judge.look(&self.motion, &self.start);
        let mut seen = judge.observe(&self.motion, &self.start);
        if let Err(verdict) = first_look {
            // With all feet on one side no angle is defined: nothing is left of stability.
            self.note_observation(&Observation { angle: 0.0, ..seen }, 0.0);
            return verdict.into();
        }
        self.note_observation(&seen, 0.0);
        if let Some(verdict) = judge.verdict(&seen, self.least_angle.0) {
            return verdict.into();
        }
        if let Err(outcome) = self.settle() {
            return outcome;
        }
        let limit = self.settings.time_limit();
        let mut control = StepControl::new(FIRST_STEP);
        let mut burst = (self.events, self.time);
        for _ in 0..MOST_STEPS {
            if self.time > limit - SHORTEST {
                return Outcome::TimeExpired;
            }
            let whole = control
                .proposed()
                .min(self.longest_step())
                .min(limit - self.time);
            let length = match self.kinks {
                Kinks::Foreseen => self.up_to_kink(whole),
                Kinks::Located | Kinks::SteppedOver => whole,
            };
            if length < SHORTEST {
                return Outcome::Failure(Failure::StepCollapse);
            }
            let error = self.try_step(length);
            if !control.accept(length, error) {
                continue;
            }
            if length < whole {
                control.keep(whole);
            }
            if !self.step.after.is_finite() {
                return Outcome::Failure(Failure::NonFinite);
            }
            self.steps += 1;
            let event = self.find_event();
            let reach = event.as_ref().map_or(1.0, |node| node.theta);
            let seen_before = seen;
            let judged = self.judge(&mut judge, &mut seen, reach);
            let reach = judged.map_or(reach, |(theta, _)| theta);
            self.report(reach);
            self.time += reach * length;
            if let Some((_, verdict)) = judged {
                self.step.before = self.step.at(reach);
                return verdict.into();
            }
            if let Some(event) = event {
                self.step.before = self.step.at(reach);
                *self.signals.now_mut() = event.signals;
                self.earlier = None;
                control.restart();
                if let Err(outcome) = self.cross().and_then(|_| self.settle()) {
                    return outcome;
                }
                if self.events - burst.0 > BURST {
                    if self.time - burst.1 < BURST_TIME {
                        return Outcome::Failure(Failure::Chattering);
                    }
                    burst = (self.events, self.time);
                }
            } else {
                let link_accelerations = self.step.slopes[0].link_rates();
                self.step.before = self.step.after;
                self.step.slopes[0] = self.step.slopes[5];
                self.earlier = Some(Earlier {
                    observation: seen_before,
                    link_accelerations,
                    length,
                });
                self.signals.go_on();
            }
            self.follow();
            self.note_struts();
        }
        Outcome::Failure(Failure::StepLimit)
    }

    /// The longest step that the laws allow whatever the error, s.
    fn longest_step(&self) -> f64 {
        let legs = self.modes.iter().zip(self.signals.now());
        legs.map(|(mode, signals)| mode.longest_step(signals))
            .fold(f64::INFINITY, f64::min)
    }

    /// Takes a step: its error in units of the tolerance.
    fn try_step(&mut self, length: f64) -> f64 {
        self.evaluations += EVALUATIONS;
        let damped = (self.stiffness).over(length, &self.motion, &self.step.before, &self.pieces);
        let advance = Advance {
            motion: &self.motion,
            pieces: &self.pieces,
            damped: damped.as_ref(),
            length,
            tolerance: self.settings.tolerance(),
            greatest_work_error: WORK_SHARE * self.settings.tolerance() * self.energy,
            step: &mut self.step,
            signals: self.signals.ahead_mut(),
        };
        self.motion.arch().dispatch(advance)
    }

    /// The first point of the step at which a law changes its active piece.
    fn find_event(&mut self) -> Option<Node<[LegSignals<f64>; LEGS]>> {
        let (before, start, end) = (
            self.signals.before(),
            self.signals.now(),
            self.signals.ahead(),
        );
        let watches = if let Some(earlier) = &self.earlier {
            let ratio = self.step.length / earlier.length;
            let suspect = |watch: &&Watch| !watch.is_quiet(before, start, end, ratio);
            self.suspects.clear();
            self.suspects.extend(self.watches.iter().filter(suspect));
            if self.suspects.is_empty() {
                return None;
            }
            &self.suspects
        } else {
            &self.watches
        };
        let torque = Signal::LinkTorque as usize;
        let with_torques = self
            .watches
            .iter()
            .any(|w| w.signal % Signal::COUNT == torque);
        let mut looks = 0;
        let mut look = |theta: f64| {
            looks += 1;
            self.motion.arch().dispatch(Look {
                motion: &self.motion,
                pieces: &self.pieces,
                step: &self.step,
                theta,
                with_torques,
            })
        };
        let start = Node {
            theta: 0.0,
            signals: *start,
        };
        let middle = Node {
            theta: 0.5,
            signals: look(0.5),
        };
        let resolution = self.event_resolution / self.step.length;
        let end = Node {
            theta: 1.0,
            signals: *end,
        };
        let found = first_exit(&start, &middle, &end, watches, resolution, &mut look);
        self.evaluations += looks;
        found
    }

    /// Time at fraction θ of the step, s.
    fn time_at(&self, theta: f64) -> f64 {
        self.time + theta * self.step.length
    }

    fn note_struts(&mut self) {
        for (j, signals) in self.signals.now().iter().enumerate() {
            let force = &mut self.greatest_strut_force[j];
            *force = force.max(signals[Signal::StrutForce as usize].abs());
            // A stroke is greatest where the link turns: there a step ends, or nearly there at tolerances
            // at which steps run over kinks.
            let stroke = &mut self.greatest_stroke[j];
            *stroke = stroke.max(signals[Signal::Stroke as usize]);
        }
    }

    /// Puts the laws in place that hold from the present state on. One change can bring another
    /// with it, so this goes on until every signal lies in its range.
    fn settle(&mut self) -> Result<(), Outcome> {
        for _ in 0..MOST_CHANGES {
            self.choose_pieces();
            let Step { before, slopes, .. } = &mut self.step;
            let signals = self.signals.now_mut();
            self.motion
                .evaluate(before, &self.pieces, &mut slopes[0], signals);
            self.evaluations += 1;
            self.note_contacts();
            if !self.cross()? {
                return Ok(());
            }
        }
        Err(Outcome::Failure(Failure::Chattering))
    }

    /// Centres the coefficients of laws that bend gently; the laws themselves stay.
    fn follow(&mut self) {
        let mut changed = false;
        for j in 0..LEGS {
            changed |= self.modes[j].follow(&self.laws[j], &self.signals.now()[j]);
        }
        if changed {
            self.choose_pieces();
        }
    }

    /// The pieces and ranges of the present modes.
    fn choose_pieces(&mut self) {
        let pieces = std::array::from_fn(|j| self.modes[j].pieces(&self.laws[j]));
        self.pieces = Pieces::new(&pieces);
        self.stiffness.forget();
        self.watches.clear();
        for j in 0..LEGS {
            self.modes[j].watch(&self.laws[j], j, &mut self.watches);
        }
    }

    /// Lets each leg follow the first of its signals that is out of its range; whether any was.
    /// Only the first, because the ranges of the others may change with it.
    fn cross(&mut self) -> Result<bool, Outcome> {
        let mut crossed = [false; LEGS];
        for &Watch { signal, range } in &self.watches {
            let (leg, index) = (signal / Signal::COUNT, signal % Signal::COUNT);
            let Some(exit) = range.exit(self.signals.now()[leg][index]) else {
                continue;
            };
            if !crossed[leg] {
                crossed[leg] = true;
                self.events += 1;
                let signal = Signal::ALL[index];
                self.modes[leg].cross(
                    &self.laws[leg],
                    leg,
                    signal,
                    exit,
                    &self.signals.now()[leg],
                )?;
            }
        }
        Ok(crossed.contains(&true))
    }

    fn note_contacts(&mut self) {
        for j in 0..LEGS {
            if self.modes[j].pad_in_contact() {
                self.pad_contact[j].get_or_insert(self.time);
            }
            if self.modes[j].block_in_contact() {
                self.block_contact[j].get_or_insert(self.time);
            }
        }
    }
}
