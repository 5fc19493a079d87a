//! The integrators of 1966: the report's own (3.2, 3.3) and those it was compared with (4.1.2).
//!
//! They know of no events. Every evaluation chooses the active piece of each law from the state, and trial stages too
//! change the sets of crushed elements. Compared with the method that locates events, they show what the report's
//! published numbers owe to its integration.

mod bouncing_ball;
mod fixed_interval;
mod flight;
mod force_model;
mod integration_summary;
mod milne;
mod step_doubling;
mod variables;

pub use crate::method::{ErrorControl, ErrorLimits, FixedInterval, Intervals, Method};
pub use bouncing_ball::BouncingBall;
pub use fixed_interval::{RungeKutta, Trapezoidal};
pub use force_model::{ForceModel, Look};
pub use integration_summary::IntegrationSummary;
pub use milne::Milne;
pub use step_doubling::{ErrorCheck, StepDoubling, Worst};
pub use variables::names as variable_names;

use crate::record::{Instant, Landing};
use crate::scene::{Scene, Settings};
use crate::state::State;
use crate::vehicle::Vehicle;
use flight::Flight;

/// A point of a vector space.
pub trait Vector: Copy {
    /// self + Σ weight · slope.
    fn advanced<const TERMS: usize>(&self, weights: [f64; TERMS], slopes: [&Self; TERMS]) -> Self;
}

impl Vector for State<f64> {
    fn advanced<const TERMS: usize>(&self, weights: [f64; TERMS], slopes: [&Self; TERMS]) -> Self {
        State::advanced(self, weights, slopes)
    }
}

/// Differential equations whose laws have a memory.
pub trait System {
    /// The integrated state, or its derivative.
    type State: Vector;
    /// Memory of the laws. It changes with every evaluation, trial stages included.
    type Memory: Copy;

    /// The derivative at a state.
    fn derivative(&self, state: &Self::State, memory: &mut Self::Memory) -> Self::State;

    /// Puts the quantities that the program of 1966 held over an interval into a derivative, as they were at its start.
    fn hold(&self, start: &Self::State, derivative: &mut Self::State);

    /// Writes a − b, variable by variable, into `difference`.
    fn difference(&self, a: &Self::State, b: &Self::State, difference: &mut Vec<f64>);
}

/// A system under integration, with its memory and the count of its evaluations.
#[derive(Debug)]
pub struct Evaluator<'a, S: System> {
    /// The system.
    pub system: &'a S,
    /// Present memory of its laws.
    pub memory: S::Memory,
    /// Evaluations so far.
    pub evaluations: u64,
}

impl<S: System> Evaluator<'_, S> {
    /// The derivative at a state.
    pub fn slope(&mut self, state: &S::State) -> S::State {
        self.evaluations += 1;
        self.system.derivative(state, &mut self.memory)
    }
}

/// Start of an interval.
#[derive(Debug, Clone, Copy)]
pub struct Start<V> {
    /// The state there.
    pub state: V,
    /// Its derivative.
    pub slope: V,
}

/// A completed interval.
#[derive(Debug, Clone, Copy)]
pub struct Taken<V> {
    /// Its length, s.
    pub length: f64,
    /// The state at its end.
    pub state: V,
}

/// A method of integration.
pub trait Stepper<S: System> {
    /// Takes an interval no longer than `longest` seconds. The evaluator's memory is that of the start.
    fn advance(
        &mut self,
        start: &Start<S::State>,
        longest: f64,
        evaluator: &mut Evaluator<S>,
    ) -> Taken<S::State>;
}

/// Computes a landing with any of these methods, whatever method the settings name.
pub fn land_by(
    stepper: &mut impl Stepper<ForceModel>,
    (vehicle, scene): (&Vehicle, &Scene),
    settings: &Settings,
    interval: f64,
    observe: &mut dyn FnMut(&Instant),
) -> Landing {
    let model = ForceModel::new(vehicle, scene, settings);
    Flight::new(vehicle, scene, settings, &model, interval, observe).run(stepper)
}

/// The error check for a vehicle with this many legs.
pub fn check(control: &ErrorControl, legs: usize) -> ErrorCheck {
    ErrorCheck::new(variables::limits(&control.limits(), legs))
}
