//! Stability followed over each step: verdicts located, extremes noted.

use pulp::NullaryFnOnce;

use super::toppling::Toppling;
use super::trajectory::Trajectory;
use super::within::Between;
use crate::contact::LegMode;
use crate::integrator::event::{Node, first_exit, is_plain};
use crate::integrator::parabola::Parabola;
use crate::motion::Footing;
use crate::registers::Registers;
use crate::scene::Scene;
use crate::stability::{Observation, StabilityMonitor, Verdict};
use crate::vehicle::Vehicle;

/// Parabolas fitted to find a least σ between the nodes of a step.
const REFINEMENTS: usize = 4;

/// Stability followed so far.
pub(super) struct StabilityTrack {
    monitor: StabilityMonitor,
    /// The present observation.
    seen: Observation,
    /// Observation at the start of the previous step, and its age, s. It survives changes of laws, as feet and
    /// velocities do not jump.
    before: Option<(Observation, f64)>,
    toppling: Toppling,
}

impl StabilityTrack {
    /// A track before the touchdown of a vehicle in a scene.
    pub(super) fn new(monitor: StabilityMonitor, vehicle: &Vehicle, scene: &Scene) -> Self {
        Self {
            monitor,
            seen: Observation::none(vehicle.leg_count()),
            before: None,
            toppling: Toppling::new(vehicle, scene),
        }
    }

    /// Judges the touchdown.
    ///
    /// # Errors
    /// The verdict, if there already is one.
    pub(super) fn begin(&mut self, trajectory: &mut Trajectory<'_>) -> Result<(), Verdict> {
        self.monitor
            .set_thrust(trajectory.weight_at_rest().is_some());
        let first_look = self
            .monitor
            .choose_plane(&trajectory.motion, &trajectory.start);
        self.seen = self.monitor.observe(&trajectory.motion, &trajectory.start);
        trajectory.note_observation(&self.seen, 0.0);
        if let Err(verdict) = first_look {
            // With all feet on one side no angle is defined: no stability is left.
            trajectory.least_angle = (0.0, 0.0);
            return Err(verdict);
        }
        self.note_beyond(trajectory, 0.0);
        match self.monitor.verdict(&self.seen, trajectory.least_angle.0) {
            Some(verdict) => Err(verdict),
            None => Ok(()),
        }
    }

    /// Notes whether the CG is beyond the hull of the feet, a time (s) after that was last noted. Returns whether the vehicle has
    /// toppled.
    #[inline(always)]
    fn note_beyond(&mut self, trajectory: &Trajectory<'_>, passed: f64) -> bool {
        let is_beyond = self.monitor.is_beyond_hull(&self.seen);
        let body = || trajectory.step.after.body();
        (self.toppling).note(is_beyond, passed, self.seen.clearance, body, || {
            trajectory.modes.iter().any(LegMode::is_pressed)
        })
    }

    /// Returns whether the CG is beyond the hull of the feet.
    pub(super) fn is_beyond(&self) -> bool {
        self.toppling.is_beyond()
    }

    /// Takes over a new line of the thrust. Returns the verdict that was waiting for it.
    pub(super) fn follow_thrust(&mut self, trajectory: &Trajectory<'_>) -> Option<Verdict> {
        self.monitor
            .set_thrust(trajectory.weight_at_rest().is_some());
        self.monitor.verdict(&self.seen, trajectory.least_angle.0)
    }

    /// Stability angle σ now, rad.
    pub(super) fn angle(&self) -> f64 {
        self.seen.angle
    }

    /// Returns whether no verdict can fall within a step of `length` s with this end.
    #[inline(always)]
    fn keeps(&self, end: &Observation, length: f64) -> bool {
        self.before
            .as_ref()
            .is_some_and(|(before, ago)| self.monitor.keep([before, &self.seen, end], length / ago))
    }

    fn finish_step(&mut self, seen: Observation, time: f64) {
        self.before = Some((self.seen, time));
        self.seen = seen;
    }
}

impl Trajectory<'_> {
    /// Follows stability over the step up to fraction `reach`. Returns the verdict and its fraction, if one falls.
    /// `event` is the one of the `buffers` with the signals of an event there.
    #[inline(always)]
    pub(super) fn judge_step(
        &mut self,
        stability: &mut StabilityTrack,
        reach: f64,
        event: Option<usize>,
    ) -> Option<(f64, Verdict)> {
        let mut theta = 0.0;
        while theta < reach {
            let before = theta;
            (stability.monitor).guard(&stability.seen, self.least_angle.0);
            let mut end = self.observe(&stability.monitor, reach, event);
            let mut end_theta = reach;
            let share = (stability.monitor).share_within_turn(&stability.seen, &end);
            if share < 1.0 {
                let part = (share * (reach - theta)).max(self.event_resolution / self.step.length);
                end_theta = reach.min(theta + part);
                end = self.observe(&stability.monitor, end_theta, None);
            }
            let length = (end_theta - theta) * self.step.length;
            let is_plain = self.is_plain(stability, &end, length);
            if is_plain && stability.keeps(&end, length) {
                self.note_observation(&end, self.time_at(end_theta));
                stability.finish_step(end, length);
                theta = end_theta;
            } else {
                let end = Node {
                    theta: end_theta,
                    signals: end,
                };
                match self.judge_closely(stability, theta, end, is_plain) {
                    Ok(reached) => theta = reached,
                    Err(found) => return Some(found),
                }
            }
            if stability.note_beyond(self, (theta - before) * self.step.length) {
                return Some((theta, Verdict::Toppled));
            }
        }
        None
    }

    /// Follows the clearance over the step up to fraction `reach`, after the verdict.
    #[cold]
    #[inline(never)]
    pub(super) fn follow_clearance(&mut self, stability: &StabilityTrack, reach: f64) {
        let monitor = &stability.monitor;
        let [start, middle, end] = [0.0, 0.5 * reach, reach].map(|theta| Node {
            theta,
            signals: self.observe(monitor, theta, None),
        });
        // The least σ is that up to the verdict.
        let least_angle = self.least_angle;
        self.note_least(monitor, [&start, &middle, &end]);
        self.least_angle = least_angle;
    }

    /// Follows stability from fraction `start` of the step to `end`, or up to where plane and feet are chosen anew. In
    /// between a verdict may fall or, unless it `is_plain`, a least value hide.
    ///
    /// # Errors
    /// The verdict and its fraction, if one falls.
    #[inline(never)]
    fn judge_closely(
        &mut self,
        stability: &mut StabilityTrack,
        start: f64,
        end: Node<Observation>,
        is_plain: bool,
    ) -> Result<f64, (f64, Verdict)> {
        let monitor = &stability.monitor;
        let start = Node {
            theta: start,
            signals: stability.seen,
        };
        let resolution = self.event_resolution / self.step.length;
        let mut node = |theta: f64| Node {
            theta,
            signals: self.observe(monitor, theta, None),
        };
        let middle = node(0.5 * (start.theta + end.theta));
        let mut buffers = [end.signals; 3];
        let exit = first_exit(
            [start.sample(), middle.sample(), end.sample()],
            monitor.guards(),
            resolution,
            &mut buffers,
            |theta, signals| *signals = self.observe(monitor, theta, None),
        );
        let Some((theta, buffer)) = exit else {
            if is_plain {
                self.note_observation(&end.signals, self.time_at(end.theta));
            } else {
                self.note_least(monitor, [&start, &middle, &end]);
            }
            stability.finish_step(end.signals, (end.theta - start.theta) * self.step.length);
            return Ok(end.theta);
        };
        let exit = Node {
            theta,
            signals: buffers[buffer],
        };
        let middle = Node {
            theta: 0.5 * (start.theta + theta),
            signals: self.observe(monitor, 0.5 * (start.theta + theta), None),
        };
        self.note_least(monitor, [&start, &middle, &exit]);
        if let Some(verdict) = monitor.verdict(&exit.signals, self.least_angle.0) {
            return Err((theta, verdict));
        }
        let state = self.motion_at(theta);
        let seen = (stability.monitor.choose_plane(&self.motion, &state))
            .map_err(|verdict| (theta, verdict))?;
        self.note_observation(&seen, self.time_at(theta));
        stability.seen = seen;
        stability.before = None;
        match stability.monitor.verdict(&seen, self.least_angle.0) {
            Some(verdict) => Err((theta, verdict)),
            None => Ok(theta),
        }
    }

    /// Observation at fraction θ of the step. At an event one of the buffers has the signals.
    #[inline(never)]
    fn observe(
        &mut self,
        monitor: &StabilityMonitor,
        theta: f64,
        event: Option<usize>,
    ) -> Observation {
        (self.registers).dispatch(Observe(self, monitor, theta, event))
    }

    /// Returns whether no new least value can hide within a step of `length` s with this end.
    fn is_plain(&self, stability: &StabilityTrack, end: &Observation, length: f64) -> bool {
        let (start, Some((before, ago))) = (&stability.seen, &stability.before) else {
            return false;
        };
        let ratio = length / ago;
        let plain = |number: fn(&Observation) -> f64, least| {
            is_plain(number(before), number(start), number(end), ratio, least)
        };
        plain(|seen| seen.angle, self.least_angle.0)
            && plain(|seen| seen.clearance, self.least_clearance)
    }

    /// Notes σ and clearance at one instant.
    pub(super) fn note_observation(&mut self, seen: &Observation, time: f64) {
        if seen.angle < self.least_angle.0 {
            self.least_angle = (seen.angle, time);
        }
        self.least_clearance = self.least_clearance.min(seen.clearance);
    }

    /// Notes the least σ and clearance over three nodes between which both are smooth.
    fn note_least(&mut self, monitor: &StabilityMonitor, nodes: [&Node<Observation>; 3]) {
        for node in nodes {
            self.note_observation(&node.signals, self.time_at(node.theta));
        }
        self.close_in(
            monitor,
            nodes,
            |seen| seen.angle,
            |flight| flight.least_angle.0,
        );
        self.close_in(
            monitor,
            nodes,
            |seen| seen.clearance,
            |flight| flight.least_clearance,
        );
    }

    /// Closes in by parabolas on a least value of `number` below the `least` so far.
    fn close_in(
        &mut self,
        monitor: &StabilityMonitor,
        nodes: [&Node<Observation>; 3],
        number: fn(&Observation) -> f64,
        least: fn(&Self) -> f64,
    ) {
        let points = nodes.map(|node| (node.theta, number(&node.signals)));
        let mut parabola = Parabola::through(points);
        for _ in 0..REFINEMENTS {
            let Some(theta) = parabola.lowest(least(self)) else {
                return;
            };
            let seen = self.observe(monitor, theta, None);
            self.note_observation(&seen, self.time_at(theta));
            parabola = parabola.about((theta, number(&seen)));
        }
    }
}

/// Observation by a monitor at fraction θ of a step. At an event one of the buffers has the signals.
struct Observe<'a, 'o>(
    &'a mut Trajectory<'o>,
    &'a StabilityMonitor,
    f64,
    Option<usize>,
);

impl NullaryFnOnce for Observe<'_, '_> {
    type Output = Observation;

    #[inline(always)]
    fn call(self) -> Observation {
        let Self(trajectory, monitor, theta, event) = self;
        let state = if theta == 1.0 {
            &trajectory.step.after
        } else {
            let between = Between {
                step: &trajectory.step,
                free: trajectory.free.as_ref(),
            };
            between.motion_at(theta, &mut trajectory.within);
            &trajectory.within
        };
        let known = match theta == 1.0 {
            true => Some(trajectory.signals.end()),
            false => event.map(|buffer| &trajectory.buffers[buffer]),
        };
        let motion = &trajectory.motion;
        let body = state.body();
        let footing = match known {
            Some(signals) => Footing::from_signals(signals, motion.surface().depth(&body.position)),
            None => motion.footing(state),
        };
        monitor.observe_footing(&footing, &body)
    }
}
