//! One landing: integrate from first contact until an outcome, and report.

pub mod abreast;
mod account;
mod advance;
mod events;
mod fly;
mod kinks;
mod peaks;
mod ranges;
mod rates;
mod stiffness;
mod trail;
mod verdict;
mod within;

use std::convert::Infallible;
use std::ops::Deref;

use crate::contact::{LegLaws, LegMode};
use crate::energy::kinetic;
use crate::integrator::step::Step;
use crate::integrator::step_control::{SHORTEST, StepControl};
use crate::integrator::{dormand_prince, rosenbrock};
use crate::methods::{self, Method};
use crate::motion::{FreeFlight, Glance, Motion, Pieces, Signal};
use crate::outcome::{Failure, Outcome};
use crate::registers::Registers;
use crate::scene::{Scene, Settings};
use crate::stability::{Judge, calm_height};
use crate::state::State;
use crate::strut::GentleKinks;
use crate::touchdown::touchdown;
use crate::vehicle::Vehicle;

use account::History;
use advance::{Advance, Evaluate};
use peaks::StrutPeaks;
use ranges::{SignalRanges, Watches};
use stiffness::Stiffness;
use trail::Trail;
use verdict::Outlook;

pub(crate) use rates::final_rates;

pub use crate::record::{Energies, FinalRates, Instant, Landing, LegInstant, LegWork};

/// First step after touchdown, s.
const FIRST_STEP: f64 = 1e-4;
/// Tolerance up to which gentle kinks of the laws are located: at looser ones steps run over them.
const KINKS_LOCATED: f64 = 1e-6;
/// Error of work allowed to a step, in units of tolerance times energy: an account of thousands of
/// steps still closes to the tolerance.
const WORK_SHARE: f64 = 0.01;
/// Time within which an event is located, s: this times the tolerance, but within these limits.
const EVENT_RESOLUTION: f64 = 1e-3;
const EVENT_RESOLUTION_LIMITS: [f64; 2] = [1e-12, 1e-7];
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
    let mut flight = Flight::new(vehicle, *scene, *settings, History::new(interval, observe));
    let outcome = flight.run();
    flight.report_end();
    flight.conclude(outcome)
}

/// The step before.
struct Earlier<const LEGS: usize> {
    /// Accelerations of the links at its start, rad/s².
    link_accelerations: [f64; LEGS],
    /// Its length, s.
    length: f64,
}

/// How a landing is followed from step to step.
struct Course<const LEGS: usize> {
    outlook: Outlook<LEGS>,
    control: StepControl,
    /// Steps aimed at, rejected ones included.
    attempts: u64,
    /// Number of events and time (s) from which a burst is counted.
    burst: (u64, f64),
}

/// A step about to be tried.
#[derive(Clone, Copy)]
struct Attempt {
    /// Length that error control and the laws allow, s.
    whole: f64,
    /// Its length, s.
    length: f64,
}

/// Where a landing goes on from after a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    /// From the start of the step, which was not good enough.
    Back,
    /// From its end.
    On,
    /// From an event or kink within it.
    Elsewhere,
}

/// A landing under way.
struct Flight<V, O, const LEGS: usize> {
    vehicle: V,
    scene: Scene,
    settings: Settings,
    motion: Motion<LEGS>,
    stiffness: Stiffness<LEGS>,
    /// Time within which an event is located, s.
    event_resolution: f64,
    /// Kinetic energy at touchdown and the work of raising the vehicle by the height of its CG, ft·lb:
    /// what the account of energies closes to, times the tolerance.
    energy: f64,
    /// Whether steps end at gentle kinks.
    locates_kinks: bool,
    laws: [LegLaws; LEGS],
    modes: [LegMode; LEGS],
    pieces: Pieces<LEGS>,
    /// How often those of each leg have changed.
    changes: [u64; LEGS],
    ranges: SignalRanges<LEGS>,
    /// Signals that may have left their range within the last step.
    suspects: Watches,
    /// The gentle kinks next to each strut that works.
    kinks: [Option<GentleKinks>; LEGS],
    time: f64,
    /// The present state and its derivative are the start of the step.
    step: Step<f64, LEGS>,
    /// How the present step goes on if it is one of free flight.
    free: Option<FreeFlight<LEGS>>,
    signals: Trail<LEGS>,
    /// The signals in the middle of the step, if it is implicit or was looked into.
    middle: Glance<LEGS>,
    is_middle_seen: bool,
    /// The step before, if no law has changed since.
    earlier: Option<Earlier<LEGS>>,
    start: State<f64, LEGS>,
    least_angle: (f64, f64),
    least_clearance: f64,
    peaks: StrutPeaks<LEGS>,
    pad_contact: [Option<f64>; LEGS],
    block_contact: [Option<f64>; LEGS],
    steps: u64,
    evaluations: u64,
    events: u64,
    history: History<O>,
}

impl<V, O, const LEGS: usize> Flight<V, O, LEGS>
where
    V: Deref<Target = Vehicle<LEGS>>,
    O: FnMut(&Instant<LEGS>),
{
    fn new(vehicle: V, scene: Scene, settings: Settings, history: History<O>) -> Self {
        let motion = Motion::new(&vehicle, &scene);
        let [finest, coarsest] = EVENT_RESOLUTION_LIMITS;
        let resolution = (EVENT_RESOLUTION * settings.tolerance()).clamp(finest, coarsest);
        let laws = std::array::from_fn(|j| {
            LegLaws::new(&vehicle.legs()[j], settings.crush_rule())
                .with_friction(settings.friction_profile())
                .within(settings.tolerance())
        });
        let modes: [LegMode; LEGS] = std::array::from_fn(|j| LegMode::untouched(&laws[j]));
        let pieces = Pieces::new(&std::array::from_fn(|j| modes[j].pieces(&laws[j])));
        let state = touchdown(&vehicle, &scene, &motion);
        let energy = kinetic(&vehicle, &state)
            + vehicle.mass() * vehicle.gravity() * vehicle.center_of_gravity_height();
        Self {
            vehicle,
            scene,
            settings,
            stiffness: Stiffness::new(&motion, settings.tolerance()),
            event_resolution: resolution,
            energy,
            motion,
            locates_kinks: settings.tolerance() <= KINKS_LOCATED,
            ranges: SignalRanges::new(&std::array::from_fn(|j| modes[j].ranges(&laws[j]))),
            laws,
            modes,
            pieces,
            changes: [1; LEGS],
            suspects: Watches::new(),
            kinks: [None; LEGS],
            time: 0.0,
            step: Step::from(state, State::zero()),
            free: None,
            signals: Trail::new(),
            middle: Glance::blank(),
            is_middle_seen: false,
            earlier: None,
            start: state,
            least_angle: (f64::INFINITY, 0.0),
            least_clearance: f64::INFINITY,
            peaks: StrutPeaks::none(),
            pad_contact: [None; LEGS],
            block_contact: [None; LEGS],
            steps: 0,
            evaluations: 0,
            events: 0,
            history,
        }
    }

    fn run(&mut self) -> Outcome {
        let mut landing = || {
            let mut course = self.begin()?;
            loop {
                self.fly(&mut course)?;
                let attempt = self.aim(&mut course)?;
                let is_stiff = self.is_stiff(attempt.length);
                let error = self.take(attempt.length, is_stiff);
                if self.accept(&mut course, attempt, error) {
                    self.go_on(&mut course)?;
                }
            }
        };
        let Err(outcome): Result<Infallible, _> = landing();
        outcome
    }

    /// Looks round at touchdown.
    ///
    /// # Errors
    /// The outcome, if there already is one.
    fn begin(&mut self) -> Result<Course<LEGS>, Outcome> {
        let mut judge = Judge::new(&self.scene, calm_height(&self.vehicle));
        let first_look = judge.look(&self.motion, &self.start);
        let seen = judge.observe(&self.motion, &self.start);
        if let Err(verdict) = first_look {
            // With all feet on one side no angle is defined: nothing is left of stability.
            self.note_observation(&seen, 0.0);
            self.least_angle = (0.0, 0.0);
            return Err(verdict.into());
        }
        self.note_observation(&seen, 0.0);
        if let Some(verdict) = judge.verdict(&seen, self.least_angle.0) {
            return Err(verdict.into());
        }
        self.settle()?;
        Ok(Course {
            outlook: Outlook::new(judge, seen),
            control: StepControl::new(FIRST_STEP),
            attempts: 0,
            burst: (self.events, self.time),
        })
    }

    /// How far to step.
    ///
    /// # Errors
    /// The outcome, if no further step is to be taken.
    #[inline(always)]
    fn aim(&mut self, course: &mut Course<LEGS>) -> Result<Attempt, Outcome> {
        let left = self.time_left(course)?;
        let whole = (course.control.proposed())
            .min(self.longest_step())
            .min(left);
        let length = if self.locates_kinks {
            self.past_kink(whole)
        } else {
            whole
        };
        if length < SHORTEST {
            return Err(Outcome::Failure(Failure::StepCollapse));
        }
        Ok(Attempt { whole, length })
    }

    /// Time left for another step, s.
    ///
    /// # Errors
    /// The outcome, if no further step is to be taken.
    #[inline(always)]
    fn time_left(&self, course: &mut Course<LEGS>) -> Result<f64, Outcome> {
        let limit = self.settings.time_limit();
        if course.attempts == MOST_STEPS {
            return Err(Outcome::Failure(Failure::StepLimit));
        }
        course.attempts += 1;
        if self.time > limit - SHORTEST {
            return Err(Outcome::TimeExpired);
        }
        Ok(limit - self.time)
    }

    /// Whether a step of this length (s) is stiff.
    fn is_stiff(&mut self, length: f64) -> bool {
        (self.stiffness).exceeds(length, &self.motion, &self.step.before, &self.pieces)
    }

    /// Takes a step, an implicit one if it is stiff: its error in units of the tolerance.
    #[inline(always)]
    fn take(&mut self, length: f64, is_stiff: bool) -> f64 {
        self.evaluations += if is_stiff {
            rosenbrock::EVALUATIONS
        } else {
            dormand_prince::EVALUATIONS
        };
        self.is_middle_seen = is_stiff;
        let advance = Advance {
            motion: &self.motion,
            pieces: &self.pieces,
            response: is_stiff.then(|| self.stiffness.response()),
            length,
            tolerance: self.settings.tolerance(),
            greatest_work_error: self.greatest_work_error(),
            step: &mut self.step,
            middle: &mut self.middle,
            signals: self.signals.ahead_mut(),
        };
        self.motion.registers().dispatch(advance)
    }

    /// Error of work allowed to a step, ft·lb.
    fn greatest_work_error(&self) -> f64 {
        WORK_SHARE * self.settings.tolerance() * self.energy
    }

    /// Whether a step was good enough.
    #[inline(always)]
    fn accept(&self, course: &mut Course<LEGS>, attempt: Attempt, error: f64) -> bool {
        let Attempt { whole, length } = attempt;
        let control = &mut course.control;
        let is_good = control.accept(length, error, self.step.weights.error_order);
        if is_good && length < whole {
            control.keep(whole);
        }
        is_good
    }

    /// Goes on to the end of a step, or to the first event or verdict within it.
    ///
    /// # Errors
    /// The outcome, when the landing has ended.
    #[inline(always)]
    fn go_on(&mut self, course: &mut Course<LEGS>) -> Result<Way, Outcome> {
        let Course {
            outlook,
            control,
            burst,
            ..
        } = course;
        let length = self.step.length;
        if !self.step.after.is_finite() {
            return Err(Outcome::Failure(Failure::NonFinite));
        }
        self.steps += 1;
        let event = self.find_event();
        let reach = event.as_ref().map_or(1.0, |node| node.theta);
        let kink = if self.locates_kinks {
            self.kink_before(reach)
        } else {
            None
        };
        let event = event.filter(|_| kink.is_none());
        let reach = kink.unwrap_or(reach);
        let judged = self.judge(outlook, reach);
        let reach = judged.map_or(reach, |(theta, _)| theta);
        self.report(reach);
        if judged.is_some() || kink.is_some() {
            let end = self.look_at(reach);
            self.note_struts(Some(&end), reach);
        } else {
            self.note_struts(event.as_ref().map(|node| &node.signals), reach);
        }
        self.time += reach * length;
        let goes_to_end = event.is_none() && kink.is_none();
        if let Some((_, verdict)) = judged {
            self.go_to(reach);
            return Err(verdict.into());
        }
        if let Some(event) = event {
            self.go_to(reach);
            *self.signals.now_mut() = event.signals;
            self.earlier = None;
            control.restart();
            self.cross()?;
            self.settle()?;
            if self.events - burst.0 > BURST {
                if self.time - burst.1 < BURST_TIME {
                    return Err(Outcome::Failure(Failure::Chattering));
                }
                *burst = (self.events, self.time);
            }
        } else {
            let link_accelerations = self.step.slopes[0].link_rates();
            self.signals.go_on();
            if kink.is_some() {
                self.go_to(reach);
                self.events += 1;
                self.evaluate();
            } else {
                self.step.before = self.step.after;
                self.step.slopes[0] = self.step.slopes[5];
            }
            self.earlier = Some(Earlier {
                link_accelerations,
                length: reach * length,
            });
        }
        self.follow();
        Ok(if goes_to_end { Way::On } else { Way::Elsewhere })
    }

    /// The longest step that the laws allow whatever the error, s.
    fn longest_step(&self) -> f64 {
        let pad_rate = |j| self.signals.now().of(j, Signal::PadRate);
        let legs = self.modes.iter().enumerate();
        legs.map(|(j, mode)| mode.longest_step(pad_rate(j)))
            .fold(f64::INFINITY, f64::min)
    }

    /// Time at fraction θ of the step, s.
    fn time_at(&self, theta: f64) -> f64 {
        self.time + theta * self.step.length
    }

    /// Derivative and signals at the end of the step.
    fn evaluate_end(&mut self) {
        let [.., last] = &mut self.step.slopes;
        self.motion.registers().dispatch(Evaluate {
            motion: &self.motion,
            pieces: &self.pieces,
            state: &self.step.after,
            slope: last,
            signals: self.signals.ahead_mut(),
        });
        self.evaluations += 1;
    }

    /// Derivative and signals of the present state.
    fn evaluate(&mut self) {
        let [first, ..] = &mut self.step.slopes;
        self.motion.registers().dispatch(Evaluate {
            motion: &self.motion,
            pieces: &self.pieces,
            state: &self.step.before,
            slope: first,
            signals: self.signals.now_mut(),
        });
        self.evaluations += 1;
    }
}
