//! One landing: integrate from first contact until an outcome, and report.

use nalgebra::{Vector3, Vector4};

use crate::attitude::Attitude;
use crate::contact::{LegLaws, LegMode};
use crate::integrator::dense::Interpolant;
use crate::integrator::dormand_prince;
use crate::integrator::event::{Bounds, Node, first_exit};
use crate::integrator::step_control::{SHORTEST, StepControl};
use crate::motion::{LegPieces, LegSignals, Motion, Signal};
use crate::outcome::{Failure, Outcome};
use crate::scene::{Scene, Settings};
use crate::stability::{Judge, Observation, Verdict};
use crate::state::{Body, LegState, State};
use crate::vehicle::Vehicle;

pub use crate::record::{Energies, Instant, Landing, LegInstant, LegWork};

/// First step after touchdown, s.
const FIRST_STEP: f64 = 1e-4;
/// Time within which an event is located, s.
const EVENT_RESOLUTION: f64 = 1e-12;
/// Changes of laws at one instant before they are called chattering.
const MOST_CHANGES: usize = 64;
/// Steps, rejected ones included, before a landing is given up.
const MOST_STEPS: u64 = 2_000_000;
/// Subsided motion stays within this height over the extended vehicle's own, ft.
const CALM_MARGIN: f64 = 0.5;

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
    let mut flight = Flight::new(vehicle, scene, settings, History::new(interval, observe));
    let outcome = flight.run();
    flight.conclude(outcome)
}

/// State at first contact: CG above the origin, the lowest pad section centroid on the surface.
fn touchdown<const LEGS: usize>(
    vehicle: &Vehicle<LEGS>,
    scene: &Scene,
    motion: &Motion<f64, LEGS>,
) -> State<f64, LEGS> {
    let conditions = scene.conditions();
    let [w, x, y, z] = conditions.attitude.quaternion();
    let (sin_cross, cos_cross) = conditions.cross_slope.sin_cos();
    let speed = conditions.horizontal_velocity;
    let legs: [LegState<f64>; LEGS] = std::array::from_fn(|j| {
        let angle = vehicle.legs()[j].extended_angle();
        LegState {
            link_angle: angle,
            link_rate: 0.0,
            pad_angle: angle,
            pad_rate: 0.0,
            work: [0.0; 6],
        }
    });
    let mut body = Body {
        position: Vector3::zeros(),
        velocity: Vector3::new(
            -speed * sin_cross,
            speed * cos_cross,
            conditions.vertical_velocity,
        ),
        quaternion: Vector4::new(w, x, y, z),
        rate: Vector3::from(conditions.angular_velocity),
    };
    let frame = motion.surface().frame(&body);
    let deepest = (0..LEGS)
        .flat_map(|j| {
            let pose = motion
                .geometry(j)
                .pose(&frame, legs[j].link_angle, legs[j].pad_angle);
            pose.pad_interference.map(|i| i * pose.pad_inclination)
        })
        .fold(f64::NEG_INFINITY, f64::max);
    // A rise of the CG by h along the vertical lifts every point off the surface by h cos θs.
    body.position.z = -deepest / conditions.slope.cos();
    State::new(&body, legs)
}

/// A landing under way.
struct Flight<'a, O, const LEGS: usize> {
    vehicle: &'a Vehicle<LEGS>,
    scene: &'a Scene,
    settings: &'a Settings,
    motion: Motion<f64, LEGS>,
    laws: [LegLaws; LEGS],
    modes: [LegMode; LEGS],
    pieces: [LegPieces<f64>; LEGS],
    bounds: [[Bounds; Signal::COUNT]; LEGS],
    time: f64,
    state: State<f64, LEGS>,
    slope: State<f64, LEGS>,
    signals: [LegSignals<f64>; LEGS],
    start: State<f64, LEGS>,
    least_angle: (f64, f64),
    least_clearance: f64,
    greatest_strut_force: [f64; LEGS],
    pad_contact: [Option<f64>; LEGS],
    block_contact: [Option<f64>; LEGS],
    steps: u64,
    evaluations: u64,
    events: u64,
    history: History<O>,
}

/// When to report to whom.
struct History<O> {
    interval: f64,
    reported: u64,
    observe: O,
}

impl<O> History<O> {
    fn new(interval: f64, observe: O) -> Self {
        Self {
            interval,
            reported: 0,
            observe,
        }
    }

    /// Next time to report at, s.
    fn next(&self) -> f64 {
        if self.reported == 0 {
            0.0
        } else {
            self.interval * self.reported as f64
        }
    }
}

impl<'a, O: FnMut(&Instant<LEGS>), const LEGS: usize> Flight<'a, O, LEGS> {
    fn new(
        vehicle: &'a Vehicle<LEGS>,
        scene: &'a Scene,
        settings: &'a Settings,
        history: History<O>,
    ) -> Self {
        let motion = Motion::new(vehicle, scene);
        let laws = std::array::from_fn(|j| LegLaws::new(&vehicle.legs()[j], settings.crush_rule()));
        let modes: [LegMode; LEGS] = std::array::from_fn(|j| LegMode::untouched(&laws[j]));
        let pieces = std::array::from_fn(|j| modes[j].pieces(&laws[j]));
        let bounds = std::array::from_fn(|j| modes[j].bounds(&laws[j]));
        let state = touchdown(vehicle, scene, &motion);
        let (slope, signals) = motion.evaluate(&state, &pieces);
        Self {
            vehicle,
            scene,
            settings,
            motion,
            laws,
            modes,
            pieces,
            bounds,
            time: 0.0,
            state,
            slope,
            signals,
            start: state,
            least_angle: (f64::INFINITY, 0.0),
            least_clearance: f64::INFINITY,
            greatest_strut_force: [0.0; LEGS],
            pad_contact: [None; LEGS],
            block_contact: [None; LEGS],
            steps: 0,
            evaluations: 1,
            events: 0,
            history,
        }
    }

    fn run(&mut self) -> Outcome {
        let extended_height = self
            .vehicle
            .legs()
            .iter()
            .map(|leg| {
                let design = leg.design();
                design.linkage.lower_link_length * leg.extended_angle().sin()
                    + design.footpad.height
            })
            .fold(f64::NEG_INFINITY, f64::max);
        let calm_height = self.vehicle.center_of_gravity_height() + extended_height + CALM_MARGIN;
        let judged = Judge::new(self.scene, calm_height, &self.motion, &self.state);
        let (mut judge, mut seen) = match judged {
            Ok(judged) => judged,
            Err(verdict) => return outcome_of(verdict),
        };
        self.note_observation(&seen, 0.0);
        if let Some(verdict) = judge.verdict(&seen, self.least_angle.0) {
            return outcome_of(verdict);
        }
        if let Err(outcome) = self.settle() {
            return outcome;
        }
        let limit = self.settings.time_limit();
        let mut control = StepControl::new(FIRST_STEP);
        for _ in 0..MOST_STEPS {
            if self.time >= limit {
                return Outcome::TimeExpired;
            }
            let length = control.proposed().min(limit - self.time);
            if length < SHORTEST {
                return Outcome::Failure(Failure::StepCollapse);
            }
            let (step, end_signals) = self.try_step(length);
            let norm = step
                .error
                .error_norm(&step.before, &step.after, self.settings.tolerance());
            if !control.accept(length, norm) {
                continue;
            }
            if !step.after.is_finite() {
                return Outcome::Failure(Failure::NonFinite);
            }
            self.steps += 1;
            let curve = Interpolant::new(&step);
            let event = self.find_event(&curve, length, end_signals);
            let reach = event.as_ref().map_or(1.0, |node| node.theta);

            let judged = self.judge(&mut judge, &mut seen, &curve, reach, length);
            let reach = judged.map_or(reach, |(theta, _)| theta);
            self.report(&curve, &judge, length, reach);
            self.time = if reach == 1.0 {
                self.time + length
            } else {
                self.time + reach * length
            };
            if let Some((theta, verdict)) = judged {
                self.state = curve.at(theta);
                return outcome_of(verdict);
            }
            if event.is_some() {
                self.state = curve.at(reach);
                control.restart();
                if let Err(outcome) = self.settle() {
                    return outcome;
                }
            } else {
                self.state = step.after;
                self.slope = step.slopes[5];
                self.signals = end_signals;
            }
            self.note_strut_forces();
        }
        Outcome::Failure(Failure::StepLimit)
    }

    #[inline(always)]
    fn try_step(
        &mut self,
        length: f64,
    ) -> (dormand_prince::Step<f64, LEGS>, [LegSignals<f64>; LEGS]) {
        self.evaluations += dormand_prince::EVALUATIONS;
        dormand_prince::step(
            &self.state,
            &self.slope,
            length,
            |state| self.motion.derivative(state, &self.pieces),
            |state| self.motion.evaluate(state, &self.pieces),
        )
    }

    /// The first point of the step at which a law changes its active piece.
    fn find_event(
        &mut self,
        curve: &Interpolant<f64, LEGS>,
        length: f64,
        end_signals: [LegSignals<f64>; LEGS],
    ) -> Option<Node<[LegSignals<f64>; LEGS]>> {
        let mut looks = 0;
        let mut look = |theta: f64| {
            looks += 1;
            self.motion.signals(&curve.motion_at(theta), &self.pieces)
        };
        let start = Node {
            theta: 0.0,
            signals: self.signals,
        };
        let middle = Node {
            theta: 0.5,
            signals: look(0.5),
        };
        let end = Node {
            theta: 1.0,
            signals: end_signals,
        };
        let resolution = EVENT_RESOLUTION / length;
        let found = first_exit(
            &start,
            &middle,
            &end,
            self.bounds.as_flattened(),
            resolution,
            &mut look,
        );
        self.evaluations += looks;
        found
    }

    /// Follows stability over the step up to fraction `reach`: the verdict and where, if one falls.
    fn judge(
        &mut self,
        judge: &mut Judge<LEGS>,
        seen: &mut Observation<LEGS>,
        curve: &Interpolant<f64, LEGS>,
        reach: f64,
        length: f64,
    ) -> Option<(f64, Verdict)> {
        let resolution = EVENT_RESOLUTION / length;
        let mut start = Node {
            theta: 0.0,
            signals: *seen,
        };
        while start.theta < reach {
            let middle_theta = 0.5 * (start.theta + reach);
            let bounds = judge.bounds(&start.signals, self.least_angle.0).to_vec();
            let look = |theta: f64| judge.observe(&self.motion, &curve.motion_at(theta));
            let middle = Node {
                theta: middle_theta,
                signals: look(middle_theta),
            };
            let end = Node {
                theta: reach,
                signals: look(reach),
            };
            let exit = first_exit(&start, &middle, &end, &bounds, resolution, look);
            match &exit {
                None => self.note_least(judge, curve, [&start, &middle, &end], length),
                Some(exit) => {
                    let theta = 0.5 * (start.theta + exit.theta);
                    let middle = Node {
                        theta,
                        signals: look(theta),
                    };
                    self.note_least(judge, curve, [&start, &middle, exit], length);
                }
            }
            let Some(exit) = exit else {
                *seen = end.signals;
                return None;
            };
            if let Some(verdict) = judge.verdict(&exit.signals, self.least_angle.0) {
                return Some((exit.theta, verdict));
            }
            match judge.look(&self.motion, &curve.motion_at(exit.theta)) {
                Err(verdict) => return Some((exit.theta, verdict)),
                Ok(observation) => {
                    self.note_observation(&observation, self.time + exit.theta * length);
                    if let Some(verdict) = judge.verdict(&observation, self.least_angle.0) {
                        return Some((exit.theta, verdict));
                    }
                    start = Node {
                        theta: exit.theta,
                        signals: observation,
                    };
                }
            }
        }
        *seen = start.signals;
        None
    }

    /// Takes note of σ and clearance at one instant.
    fn note_observation(&mut self, seen: &Observation<LEGS>, time: f64) {
        if seen.angle < self.least_angle.0 {
            self.least_angle = (seen.angle, time);
        }
        self.least_clearance = self.least_clearance.min(seen.clearance);
    }

    /// Takes note of the least σ and clearance over three nodes between which both are smooth.
    fn note_least(
        &mut self,
        judge: &Judge<LEGS>,
        curve: &Interpolant<f64, LEGS>,
        nodes: [&Node<Observation<LEGS>>; 3],
        length: f64,
    ) {
        let mut nodes = nodes.map(|node| (node.theta, node.signals));
        for (theta, seen) in nodes {
            self.note_observation(&seen, self.time + theta * length);
        }
        // Successive parabolas toward a least σ that may lie between the nodes.
        for _ in 0..4 {
            let [(t0, a), (t1, b), (t2, c)] = nodes;
            if b.angle >= a.angle.min(c.angle) && (a.angle - c.angle).abs() > 1e-3 {
                return;
            }
            let (first, second) = (
                (b.angle - a.angle) / (t1 - t0),
                (c.angle - b.angle) / (t2 - t1),
            );
            let bend = (second - first) / (t2 - t0);
            let slope = first - bend * (t1 - t0);
            let theta = t0 - slope / (2.0 * bend);
            if !(bend > 0.0 && theta > t0 && theta < t2 && theta != t1) {
                return;
            }
            let seen = judge.observe(&self.motion, &curve.motion_at(theta));
            self.note_observation(&seen, self.time + theta * length);
            nodes = if theta < t1 {
                [(t0, a), (theta, seen), (t1, b)]
            } else {
                [(t1, b), (theta, seen), (t2, c)]
            };
        }
    }

    fn note_strut_forces(&mut self) {
        for (greatest, signals) in self.greatest_strut_force.iter_mut().zip(&self.signals) {
            *greatest = greatest.max(signals[Signal::StrutForce as usize].abs());
        }
    }

    /// Puts the laws in place that hold from the present state on. One change can bring another
    /// with it, so this goes on until every signal lies in its range.
    fn settle(&mut self) -> Result<(), Outcome> {
        for _ in 0..MOST_CHANGES {
            for j in 0..LEGS {
                self.pieces[j] = self.modes[j].pieces(&self.laws[j]);
                self.bounds[j] = self.modes[j].bounds(&self.laws[j]);
            }
            (self.slope, self.signals) = self.motion.evaluate(&self.state, &self.pieces);
            self.evaluations += 1;
            self.note_contacts();
            let mut settled = true;
            for j in 0..LEGS {
                let left = Signal::ALL.into_iter().find_map(|signal| {
                    let index = signal as usize;
                    self.bounds[j][index]
                        .exit(self.signals[j][index])
                        .map(|exit| (signal, exit))
                });
                if let Some((signal, exit)) = left {
                    self.modes[j].cross(&self.laws[j], j, signal, exit, &self.signals[j])?;
                    self.events += 1;
                    settled = false;
                }
            }
            if settled {
                return Ok(());
            }
        }
        Err(Outcome::Failure(Failure::Chattering))
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

    /// Kinetic energy of body and lower links, ft·lb.
    fn kinetic_energy(&self, state: &State<f64, LEGS>) -> f64 {
        let body = state.body();
        let translation = self.vehicle.mass() * body.velocity.norm_squared();
        let rotation = body.rate.dot(&(self.vehicle.inertia() * body.rate));
        let links: f64 = (0..LEGS)
            .map(|j| {
                let rate = state.leg(j).link_rate;
                self.vehicle.legs()[j].design().linkage.inertia * rate * rate
            })
            .sum();
        0.5 * (translation + rotation + links)
    }

    /// Potential energy released since first contact, ft·lb.
    fn potential_change(&self, state: &State<f64, LEGS>) -> f64 {
        let descent = state.body().position.z - self.start.body().position.z;
        self.vehicle.mass() * self.vehicle.gravity() * descent
    }

    /// Reports the instants that are due up to fraction `reach` of the step.
    fn report(
        &mut self,
        curve: &Interpolant<f64, LEGS>,
        judge: &Judge<LEGS>,
        length: f64,
        reach: f64,
    ) {
        while self.history.interval.is_finite() && self.history.next() <= self.time + reach * length
        {
            let time = self.history.next();
            let theta = ((time - self.time) / length).clamp(0.0, 1.0);
            let instant = self.instant(&curve.at(theta), judge, time);
            (self.history.observe)(&instant);
            self.history.reported += 1;
        }
    }

    fn instant(&self, state: &State<f64, LEGS>, judge: &Judge<LEGS>, time: f64) -> Instant<LEGS> {
        let body = state.body();
        let mut judge = judge.clone();
        let seen = judge
            .look(&self.motion, state)
            .unwrap_or_else(|_| judge.observe(&self.motion, state));
        let signals = self.motion.signals(state, &self.pieces);
        let loads = self.motion.loads(state, &self.pieces);
        let q = body.quaternion;
        Instant {
            time,
            position: body.position,
            velocity: body.velocity,
            attitude: Attitude::from_quaternion([q.x, q.y, q.z, q.w]),
            angular_velocity: body.rate,
            stability_angle: seen.angle,
            clearance: seen.clearance,
            kinetic_energy: self.kinetic_energy(state),
            potential_change: self.potential_change(state),
            legs: std::array::from_fn(|j| {
                let leg = state.leg(j);
                let [outer, inner, block] = self.modes[j].sets(&self.laws[j], &signals[j]);
                LegInstant {
                    link_angle: leg.link_angle,
                    link_rate: leg.link_rate,
                    pad_angle: leg.pad_angle,
                    pad_rate: leg.pad_rate,
                    stroke: signals[j][Signal::Stroke as usize],
                    strut_force: loads[j].strut,
                    pad_normal: loads[j].pad_normal,
                    pad_friction: loads[j].pad_friction,
                    block_normal: loads[j].block_normal,
                    block_friction: loads[j].block_friction,
                    pad_sets: [outer, inner],
                    block_set: block,
                    work: LegWork::from_state(leg.work),
                }
            }),
        }
    }

    fn conclude(self, outcome: Outcome) -> Landing<LEGS> {
        Landing {
            outcome,
            end_time: self.time,
            min_stability_angle: self.least_angle.0,
            min_stability_time: self.least_angle.1,
            min_clearance: self.least_clearance,
            energies: Energies {
                initial_kinetic: self.kinetic_energy(&self.start),
                potential_change: self.potential_change(&self.state),
                legs: std::array::from_fn(|j| LegWork::from_state(self.state.leg(j).work)),
                final_kinetic: self.kinetic_energy(&self.state),
            },
            max_strut_force: self.greatest_strut_force,
            pad_contact: self.pad_contact,
            block_contact: self.block_contact,
            steps: self.steps,
            evaluations: self.evaluations,
            events: self.events,
        }
    }
}

fn outcome_of(verdict: Verdict) -> Outcome {
    match verdict {
        Verdict::Yaw => Outcome::UnstableYaw,
        Verdict::Pitch => Outcome::UnstablePitch,
        Verdict::Rockback => Outcome::StableRockback,
        Verdict::Subsided => Outcome::StableSubsided,
    }
}
