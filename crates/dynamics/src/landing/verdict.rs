//! Stability followed over each step: verdicts located, extremes noted.

use super::trajectory::Trajectory;
use crate::integrator::event::{Node, first_exit, is_plain};
use crate::integrator::parabola::Parabola;
use crate::motion::{Footing, Signals};
use crate::stability::{Observation, StabilityMonitor, Verdict};
use crate::state::Body;

/// Parabolas fitted to find a least σ between the nodes of a step.
const REFINEMENTS: usize = 4;

/// Stability as it has been followed so far.
pub(super) struct StabilityTrack {
    monitor: StabilityMonitor,
    /// The present observation.
    seen: Observation,
    /// The observation at the start of the previous step, and how long ago that was, s. It survives changes of laws: feet and
    /// velocities do not jump.
    before: Option<(Observation, f64)>,
}

impl StabilityTrack {
    /// A monitor and its observation at touchdown.
    pub(super) fn new(monitor: StabilityMonitor, seen: Observation) -> Self {
        Self {
            monitor,
            seen,
            before: None,
        }
    }

    /// Judges the touchdown.
    ///
    /// # Errors
    /// The verdict, if there already is one.
    pub(super) fn begin(&mut self, trajectory: &mut Trajectory<'_>) -> Result<(), Verdict> {
        let first_look = self
            .monitor
            .choose_plane(&trajectory.motion, &trajectory.start);
        self.seen = self.monitor.observe(&trajectory.motion, &trajectory.start);
        trajectory.note_observation(&self.seen, 0.0);
        if let Err(verdict) = first_look {
            // With all feet on one side no angle is defined: nothing is left of stability.
            trajectory.least_angle = (0.0, 0.0);
            return Err(verdict);
        }
        match self.monitor.verdict(&self.seen, trajectory.least_angle.0) {
            Some(verdict) => Err(verdict),
            None => Ok(()),
        }
    }

    /// Takes note that the thrust is on another line.
    pub(super) fn follow_thrust(&mut self, trajectory: &Trajectory<'_>) {
        self.monitor
            .set_calm_height(trajectory.calm_height_under_thrust());
    }

    /// Stability angle σ now, rad.
    pub(super) fn angle(&self) -> f64 {
        self.seen.angle
    }

    /// Whether within a step of `length` s that ends like this no verdict can fall.
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
    /// Follows stability over the step up to fraction `reach`: the verdict and where, if one falls. Of an `event` there
    /// one of the `buffers` has the signals.
    pub(super) fn judge_step(
        &mut self,
        stability: &mut StabilityTrack,
        reach: f64,
        event: Option<usize>,
    ) -> Option<(f64, Verdict)> {
        let resolution = self.event_resolution / self.step.length;
        let mut start = Node {
            theta: 0.0,
            signals: stability.seen,
        };
        while start.theta < reach {
            (stability.monitor).guard(&start.signals, self.least_angle.0);
            let monitor = &stability.monitor;
            let look = |theta: f64| {
                let told = |signals: &Signals<f64>, body: &Body<f64>| {
                    let depth = self.motion.surface().depth(&body.position);
                    monitor.observe_footing(&Footing::from_signals(signals, depth), body)
                };
                if theta == 1.0 {
                    told(self.signals.end(), &self.step.after.body())
                } else if let Some(buffer) = event
                    && theta == reach
                {
                    told(&self.buffers[buffer], &self.motion_at(theta).body())
                } else {
                    monitor.observe(&self.motion, &self.motion_at(theta))
                }
            };
            let node = |theta: f64| Node {
                theta,
                signals: look(theta),
            };
            let mut end = node(reach);
            let share = monitor.share_within_turn(&start.signals, &end.signals);
            if share < 1.0 {
                let part = (share * (reach - start.theta)).max(resolution);
                end = node(reach.min(start.theta + part));
            }
            let length = (end.theta - start.theta) * self.step.length;
            let is_plain = self.is_plain(stability, &end.signals, length);
            if is_plain && stability.keeps(&end.signals, length) {
                self.note_observation(&end.signals, self.time_at(end.theta));
                stability.finish_step(end.signals, length);
                start = end;
                continue;
            }
            let middle = node(0.5 * (start.theta + end.theta));
            let nodes = [&start, &middle, &end].map(Node::sample);
            let mut buffers = [end.signals; 3];
            let exit = first_exit(
                nodes,
                monitor.guards(),
                resolution,
                &mut buffers,
                |theta, signals| *signals = look(theta),
            );
            let exit = exit.map(|(theta, buffer)| Node {
                theta,
                signals: buffers[buffer],
            });
            let Some(exit) = exit else {
                if is_plain {
                    self.note_observation(&end.signals, self.time_at(end.theta));
                } else {
                    self.note_least(monitor, [&start, &middle, &end]);
                }
                stability.finish_step(end.signals, length);
                start = end;
                continue;
            };
            let middle = node(0.5 * (start.theta + exit.theta));
            self.note_least(monitor, [&start, &middle, &exit]);
            if let Some(verdict) = monitor.verdict(&exit.signals, self.least_angle.0) {
                return Some((exit.theta, verdict));
            }
            match (stability.monitor).choose_plane(&self.motion, &self.motion_at(exit.theta)) {
                Err(verdict) => return Some((exit.theta, verdict)),
                Ok(observation) => {
                    self.note_observation(&observation, self.time_at(exit.theta));
                    let verdict = stability.monitor.verdict(&observation, self.least_angle.0);
                    if let Some(verdict) = verdict {
                        return Some((exit.theta, verdict));
                    }
                    start = Node {
                        theta: exit.theta,
                        signals: observation,
                    };
                    stability.seen = observation;
                    stability.before = None;
                }
            }
        }
        None
    }

    /// Whether within a step of `length` s that ends like this no new least value can hide.
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

    /// Takes note of σ and clearance at one instant.
    pub(super) fn note_observation(&mut self, seen: &Observation, time: f64) {
        if seen.angle < self.least_angle.0 {
            self.least_angle = (seen.angle, time);
        }
        self.least_clearance = self.least_clearance.min(seen.clearance);
    }

    /// Takes note of the least σ and clearance over three nodes between which both are smooth.
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

    /// Closes in by parabolas on a least value of `number` that lies below the `least` so far.
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
            let seen = monitor.observe(&self.motion, &self.motion_at(theta));
            self.note_observation(&seen, self.time_at(theta));
            parabola = parabola.about((theta, number(&seen)));
        }
    }
}
