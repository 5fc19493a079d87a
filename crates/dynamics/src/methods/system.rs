//! Systems to integrate, and their derivatives as methods ask for them.

use crate::state::State;

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
