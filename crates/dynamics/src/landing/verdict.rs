//! Stability followed over each step: verdicts located, extremes noted.

use super::trajectory::Trajectory;
use crate::integrator::event::{Node, first_exit, is_plain};
use crate::integrator::parabola::Parabola;
use crate::motion::{Footing, Glance};
use crate::stability::{Judge, Observation, Verdict};
use crate::state::Body;

/// Parabolas laid toward a least σ between the nodes of a step.
const REFINEMENTS: usize = 4;

/// Stability as it has been followed so far.
pub(super) struct Outlook {
    judge: Judge,
    /// What the judge sees now.
    seen: Observation,
    /// What he saw at the start of the step before, and how long ago that is, s. Laws that change leave it: feet
    /// and velocities go on without a jump.
    before: Option<(Observation, f64)>,
}

impl Outlook {
    /// A judge and what he sees at touchdown.
    pub(super) fn new(judge: Judge, seen: Observation) -> Self {
        Self {
            judge,
            seen,
            before: None,
        }
    }

    /// Looks round at touchdown.
    ///
    /// # Errors
    /// The verdict, if there already is one.
    pub(super) fn begin(&mut self, trajectory: &mut Trajectory<'_>) -> Result<(), Verdict> {
        let first_look = self.judge.look(&trajectory.motion, &trajectory.start);
        self.seen = self.judge.observe(&trajectory.motion, &trajectory.start);
        trajectory.note_observation(&self.seen, 0.0);
        if let Err(verdict) = first_look {
            // With all feet on one side no angle is defined: nothing is left of stability.
            trajectory.least_angle = (0.0, 0.0);
            return Err(verdict);
        }
        match self.judge.verdict(&self.seen, trajectory.least_angle.0) {
            Some(verdict) => Err(verdict),
            None => Ok(()),
        }
    }

    /// Whether within a step of `length` s that ends like this no verdict can fall.
    fn keeps(&self, end: &Observation, length: f64) -> bool {
        self.before
            .as_ref()
            .is_some_and(|(before, ago)| self.judge.keep([before, &self.seen, end], length / ago))
    }

    fn go_on(&mut self, seen: Observation, time: f64) {
        self.before = Some((self.seen, time));
        self.seen = seen;
    }
}

impl Trajectory<'_> {
    /// Follows stability over the step up to fraction `reach`: the verdict and where, if one falls. Of an `event` there
    /// one of the `places` has the signals.
    pub(super) fn judge(
        &mut self,
        outlook: &mut Outlook,
        reach: f64,
        event: Option<usize>,
    ) -> Option<(f64, Verdict)> {
        let resolution = self.event_resolution / self.step.length;
        let mut start = Node {
            theta: 0.0,
            signals: outlook.seen,
        };
        while start.theta < reach {
            (outlook.judge).watch(&start.signals, self.least_angle.0);
            let judge = &outlook.judge;
            let look = |theta: f64| {
                let told = |signals: &Glance<f64>, body: &Body<f64>| {
                    let depth = self.motion.surface().depth(&body.position);
                    judge.observe_footing(&Footing::told(signals, depth), body)
                };
                if theta == 1.0 {
                    told(self.signals.ahead(), &self.step.after.body())
                } else if let Some(place) = event
                    && theta == reach
                {
                    told(&self.places[place], &self.motion_at(theta).body())
                } else {
                    judge.observe(&self.motion, &self.motion_at(theta))
                }
            };
            let node = |theta: f64| Node {
                theta,
                signals: look(theta),
            };
            let mut end = node(reach);
            let share = judge.share_within_turn(&start.signals, &end.signals);
            if share < 1.0 {
                let part = (share * (reach - start.theta)).max(resolution);
                end = node(reach.min(start.theta + part));
            }
            let length = (end.theta - start.theta) * self.step.length;
            let is_plain = self.is_plain(outlook, &end.signals, length);
            if is_plain && outlook.keeps(&end.signals, length) {
                self.note_observation(&end.signals, self.time_at(end.theta));
                outlook.go_on(end.signals, length);
                start = end;
                continue;
            }
            let middle = node(0.5 * (start.theta + end.theta));
            let nodes = [&start, &middle, &end].map(Node::seen);
            let mut places = [end.signals; 3];
            let exit = first_exit(
                nodes,
                judge.watches(),
                resolution,
                &mut places,
                |theta, signals| *signals = look(theta),
            );
            let exit = exit.map(|(theta, place)| Node {
                theta,
                signals: places[place],
            });
            let Some(exit) = exit else {
                if is_plain {
                    self.note_observation(&end.signals, self.time_at(end.theta));
                } else {
                    self.note_least(judge, [&start, &middle, &end]);
                }
                outlook.go_on(end.signals, length);
                start = end;
                continue;
            };
            let middle = node(0.5 * (start.theta + exit.theta));
            self.note_least(judge, [&start, &middle, &exit]);
            if let Some(verdict) = judge.verdict(&exit.signals, self.least_angle.0) {
                return Some((exit.theta, verdict));
            }
            match (outlook.judge).look(&self.motion, &self.motion_at(exit.theta)) {
                Err(verdict) => return Some((exit.theta, verdict)),
                Ok(observation) => {
                    self.note_observation(&observation, self.time_at(exit.theta));
                    let verdict = outlook.judge.verdict(&observation, self.least_angle.0);
                    if let Some(verdict) = verdict {
                        return Some((exit.theta, verdict));
                    }
                    start = Node {
                        theta: exit.theta,
                        signals: observation,
                    };
                    outlook.seen = observation;
                    outlook.before = None;
                }
            }
        }
        None
    }

    /// Whether within a step of `length` s that ends like this no new least value can hide.
    fn is_plain(&self, outlook: &Outlook, end: &Observation, length: f64) -> bool {
        let (start, Some((before, ago))) = (&outlook.seen, &outlook.before) else {
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
    fn note_least(&mut self, judge: &Judge, nodes: [&Node<Observation>; 3]) {
        for node in nodes {
            self.note_observation(&node.signals, self.time_at(node.theta));
        }
        self.close_in(
            judge,
            nodes,
            |seen| seen.angle,
            |flight| flight.least_angle.0,
        );
        self.close_in(
            judge,
            nodes,
            |seen| seen.clearance,
            |flight| flight.least_clearance,
        );
    }

    /// Closes in by parabolas on a least value of `number` that lies below the `least` so far.
    fn close_in(
        &mut self,
        judge: &Judge,
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
            let seen = judge.observe(&self.motion, &self.motion_at(theta));
            self.note_observation(&seen, self.time_at(theta));
            parabola = parabola.about((theta, number(&seen)));
        }
    }
}
