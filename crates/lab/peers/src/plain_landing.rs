//! A landing as any integrator can take it: a right-hand side, and what to do after each step.
//!
//! Every evaluation chooses the active piece of each law from the state. What the crushable
//! elements keep changes only with accepted steps, after which the landing is also judged: nothing
//! is located between the ends of steps.

use std::cell::Cell;

use touchdown_dynamics::contact::Sets;
use touchdown_dynamics::methods::{ForceModel, System};
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::per_leg::PerLeg;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::stability::StabilityMonitor;
use touchdown_dynamics::state::State;
use touchdown_dynamics::touchdown::touchdown;
use touchdown_dynamics::vehicle::Vehicle;

use crate::variables::{self, COUNT, LEGS};

/// How far a landing is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Until {
    /// To its outcome, or to the time limit of the settings.
    Outcome,
    /// To a time (s), whatever happens before.
    Time(f64),
}

/// A landing under way.
pub struct PlainLanding {
    model: ForceModel,
    first: State<f64>,
    sets: PerLeg<Sets>,
    monitor: StabilityMonitor,
    least_angle: f64,
    until: Until,
    limit: f64,
    outcome: Option<Outcome>,
    evaluations: Cell<u64>,
}

impl PlainLanding {
    /// The landing at first contact.
    pub fn new(vehicle: &Vehicle, scene: &Scene, settings: &Settings, until: Until) -> Self {
        let model = ForceModel::new(vehicle, scene, settings);
        Self {
            first: touchdown(vehicle, scene, model.motion()),
            model,
            sets: PerLeg::same(LEGS, Sets::default()),
            monitor: StabilityMonitor::new(settings.rules(vehicle), vehicle, scene),
            least_angle: f64::INFINITY,
            until,
            limit: settings.time_limit(),
            outcome: None,
            evaluations: Cell::new(0),
        }
    }

    /// Variables at first contact.
    pub fn start(&self) -> [f64; COUNT] {
        let mut y = [0.0; COUNT];
        variables::write(&self.first, &mut y);
        y
    }

    /// Time to integrate to, s.
    pub fn last(&self) -> f64 {
        match self.until {
            Until::Outcome => self.limit,
            Until::Time(time) => time,
        }
    }

    /// The derivative at variables `y`.
    pub fn derivative(&self, y: &[f64], slope: &mut [f64]) {
        self.evaluations.set(self.evaluations.get() + 1);
        let mut trial = self.sets;
        let found = self.model.derivative(&variables::state(y), &mut trial);
        variables::write(&found, slope);
    }

    /// Takes note of an accepted step that ends at `y`; whether it ends the landing.
    pub fn accept(&mut self, y: &[f64]) -> bool {
        self.evaluations.set(self.evaluations.get() + 1);
        let state = variables::state(y);
        let look = self.model.look(&state, &mut self.sets);
        if matches!(self.until, Until::Time(_)) {
            return false;
        }
        self.outcome = match self.monitor.choose_plane(self.model.motion(), &state) {
            Ok(seen) => {
                self.least_angle = self.least_angle.min(seen.angle);
                let verdict = self.monitor.verdict(&seen, self.least_angle);
                verdict.map(Outcome::from).or_else(|| self.model.end(&look))
            }
            Err(verdict) => Some(verdict.into()),
        };
        self.outcome.is_some()
    }

    /// How the landing ended; a landing without an outcome is out of time.
    pub fn class(&self) -> Class {
        let outcome = self.outcome.clone().unwrap_or(Outcome::TimeExpired);
        outcome.class()
    }

    /// Evaluations of the right-hand side so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }
}
