//! Thrust along a landing: its lines, knot by knot, and its work.

use super::trajectory::Trajectory;
use crate::integrator::step_control::SHORTEST;

/// Nodes (fractions of half a step from its middle) and weights of Gauss' rule of four points.
const GAUSS: [[f64; 2]; 4] = [
    [-0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
    [-0.339_981_043_584_856_3, 0.652_145_154_862_546_1],
    [0.339_981_043_584_856_3, 0.652_145_154_862_546_1],
    [0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
];

impl Trajectory<'_> {
    /// Time until the thrust changes its line, s.
    pub(super) fn time_to_knot(&self) -> f64 {
        self.next_knot - self.time
    }

    /// Sets the line of the thrust from now on. Returns whether it is a new one.
    pub(super) fn follow_thrust(&mut self) -> bool {
        if self.time_to_knot() > SHORTEST {
            return false;
        }
        let knot = self.next_knot;
        let (line, next_knot) = self.scene.conditions().thrust.line_from(knot);
        self.pieces.set_thrust(line);
        self.next_knot = next_knot;
        // Lanes see a new line by the changes of their legs.
        for changes in self.changes.iter_mut() {
            *changes += 1;
        }
        self.stiffness.forget();
        self.earlier = None;
        self.evaluate();
        true
    }

    /// Weight that the thrust leaves to a vehicle that comes to rest, lb; `None` while the thrust still changes or
    /// lifts it.
    pub(super) fn weight_at_rest(&self) -> Option<f64> {
        let weight = self.motion.mass() * self.motion.gravity();
        let left = weight - self.pieces.thrust().at(self.time);
        (self.next_knot == f64::INFINITY && left > 0.0).then_some(left)
    }

    /// Work of the thrust from first contact to fraction `reach` of the step, ft·lb.
    pub(super) fn thrust_work_at(&self, reach: f64) -> f64 {
        if self.pieces.thrust().is_none() {
            return self.thrust_work;
        }
        let power = summed(reach, |theta| {
            let state = self.motion_at(theta);
            let thrust = self.pieces.thrust().at(self.time_at(theta));
            [thrust, self.motion.speed_along_thrust(&state)]
        });
        self.thrust_work + 0.5 * reach * self.step.length * power
    }
}

/// Twice the mean, from fraction 0 to `reach` of a step, of the product of two quantities.
pub(super) fn summed(reach: f64, quantities: impl Fn(f64) -> [f64; 2]) -> f64 {
    let products = GAUSS.map(|[node, weight]| {
        let [thrust, speed] = quantities(0.5 * reach * (1.0 + node));
        weight * thrust * speed
    });
    products.iter().sum::<f64>()
}
