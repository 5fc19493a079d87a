//! The ball of 4.1.2: undamped, of one degree of freedom, in and out of contact with a springy surface. Its motion is
//! known in closed form and its energy never changes.

use std::f64::consts::PI;

use libm::atan;

use super::{System, Vector};

/// A ball over a surface that pushes back in proportion to its penetration.
#[derive(Debug, Clone, Copy)]
pub struct BouncingBall {
    /// Gravity, ft/s².
    pub gravity: f64,
    /// Stiffness of the surface over the ball's mass, 1/s².
    pub stiffness: f64,
}

/// Height over the untouched surface, ft, and upward velocity, ft/s.
pub type BallState = [f64; 2];

impl BouncingBall {
    /// Energy over the ball's mass, ft²/s².
    pub fn energy(&self, &[height, velocity]: &BallState) -> f64 {
        let penetration = (-height).max(0.0);
        self.gravity * height
            + 0.5 * (velocity * velocity + self.stiffness * penetration * penetration)
    }

    /// Time from one apex at `height` (ft) to the next, s.
    pub fn period(&self, height: f64) -> f64 {
        let impact = (2.0 * self.gravity * height).sqrt();
        let frequency = self.stiffness.sqrt();
        // In contact the ball swings about the penetration under its own weight.
        let beyond_half = atan(self.gravity / (frequency * impact));
        2.0 * impact / self.gravity + (PI + 2.0 * beyond_half) / frequency
    }
}

impl Vector for BallState {
    fn advanced<const TERMS: usize>(&self, weights: [f64; TERMS], slopes: [&Self; TERMS]) -> Self {
        std::array::from_fn(|i| {
            let terms = weights.iter().zip(slopes).map(|(w, slope)| w * slope[i]);
            self[i] + terms.sum::<f64>()
        })
    }
}

impl System for BouncingBall {
    type State = BallState;
    type Memory = ();

    fn derivative(&self, &[height, velocity]: &BallState, (): &mut ()) -> BallState {
        let push = self.stiffness * (-height).max(0.0);
        [velocity, push - self.gravity]
    }

    fn hold(&self, _: &BallState, _: &mut BallState) {}

    fn difference(&self, a: &BallState, b: &BallState, difference: &mut Vec<f64>) {
        difference.clear();
        difference.extend((0..2).map(|i| a[i] - b[i]));
    }
}
