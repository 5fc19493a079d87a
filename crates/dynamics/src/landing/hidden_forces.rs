//! Stretches in which the force on a strut may have been greater than at their ends. They are kept until the greatest
//! force is known to exceed any in them, and are searched if that never happens.

use arrayvec::ArrayVec;

use crate::integrator::parabola::Parabola;
use crate::integrator::step::Step;
use crate::kinematics::LegGeometry;
use crate::motion::Motion;
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::state::State;
use crate::strut::StrutPiece;

/// Stretches kept at a time: for each leg, while its force rises, those of the last two or three steps.
const MOST: usize = 4 * MOST_LEGS;
/// Parts in which a stretch is sampled, and parabolas then fitted to find its greatest force.
const PARTS: u32 = 8;
const REFINEMENTS: usize = 12;
/// Relative excess that makes a force worth seeking.
const NOTABLE: f64 = 1e-11;

/// Strut forces between the ends of steps.
#[derive(Debug, Clone)]
pub(super) struct HiddenForces {
    stretches: ArrayVec<Stretch, MOST>,
    /// Greatest forces of stretches searched before the end, lb.
    found: PerLeg<f64>,
}

impl HiddenForces {
    pub(super) fn none(legs: usize) -> Self {
        Self {
            stretches: ArrayVec::new(),
            found: PerLeg::same(legs, 0.0),
        }
    }

    /// Keeps a stretch. `forces` are the greatest on the legs so far, lb.
    #[inline(always)]
    pub(super) fn keep(&mut self, stretch: Stretch, motion: &Motion<f64>, forces: &PerLeg<f64>) {
        if self.stretches.is_full() {
            self.make_room(motion, forces);
        }
        self.stretches.push(stretch);
    }

    /// Drops stretches that hide no force greater than `forces` (lb), or searches all if it can drop none.
    #[cold]
    #[inline(never)]
    fn make_room(&mut self, motion: &Motion<f64>, forces: &PerLeg<f64>) {
        (self.stretches).retain(|stretch| stretch.may_exceed(forces));
        if self.stretches.is_full() {
            self.found = self.greatest(motion, forces);
            self.stretches.clear();
        }
    }

    /// Greatest force on each strut, lb, given the greatest at the ends of steps.
    #[cold]
    #[inline(never)]
    pub(super) fn greatest(&self, motion: &Motion<f64>, forces: &PerLeg<f64>) -> PerLeg<f64> {
        let mut forces = PerLeg::from_fn(forces.len(), |j| forces[j].max(self.found[j]));
        for stretch in &self.stretches {
            if stretch.may_exceed(&forces) {
                let force = &mut forces[stretch.leg];
                *force = stretch.greatest(motion.geometry(stretch.leg), *force);
            }
        }
        forces
    }
}

/// A stretch from the start of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    leg: usize,
    /// Angle (rad) and rate (rad/s) of the link over the step.
    link: [Quartic; 2],
    strut: StrutPiece<f64>,
    /// Fraction of the step at which it ends.
    reach: f64,
    /// Upper bound of the force in it, lb.
    most: f64,
}

/// A number over a step: Hermite's cubic, and the fourth-degree term of the method's continuous output.
#[derive(Debug, Clone, Copy)]
struct Quartic {
    start: f64,
    change: f64,
    bump: f64,
    /// Rates of change at both ends, times the length of the step.
    slopes: [f64; 2],
}

impl Quartic {
    fn at(&self, theta: f64) -> f64 {
        let (rest, squared) = (1.0 - theta, theta * theta);
        let [first, last] = self.slopes;
        self.start
            + self.change * squared * (3.0 - theta - theta)
            + self.bump * squared * rest * rest
            + first * theta * rest * rest
            - last * squared * rest
    }
}

impl Stretch {
    /// The step up to fraction `reach`, in which the force on a strut may have reached `most` (lb).
    pub(super) fn of(
        step: &Step<f64, State<f64>>,
        leg: usize,
        strut: &StrutPiece<f64>,
        reach: f64,
        most: f64,
    ) -> Self {
        let before = step.before.leg(leg);
        let slopes = (step.slopes.each_ref()).map(|slope| {
            let slope = slope.leg(leg);
            [slope.link_angle, slope.link_rate].map(|number| step.length * number)
        });
        let number = |index: usize, start: f64| {
            let sum = |weights: &[f64]| -> f64 {
                let terms = weights.iter().zip(&slopes);
                terms.map(|(weight, slope)| weight * slope[index]).sum()
            };
            Quartic {
                start,
                change: sum(&step.weights.result),
                bump: sum(&step.weights.bump),
                slopes: [slopes[0][index], slopes[5][index]],
            }
        };
        Self {
            leg,
            link: [number(0, before.link_angle), number(1, before.link_rate)],
            strut: *strut,
            reach,
            most,
        }
    }

    /// Returns whether it may hide a force greater than `forces` (lb).
    #[inline(always)]
    fn may_exceed(&self, forces: &PerLeg<f64>) -> bool {
        self.most > forces[self.leg]
    }

    /// Magnitude of the force at a fraction of the step, lb.
    fn force(&self, geometry: &LegGeometry<f64>, theta: f64) -> f64 {
        let [angle, rate] = self.link.map(|number| number.at(theta));
        let [stroke, lever] = geometry.strut(angle);
        self.strut.force(stroke, rate, lever).abs()
    }

    /// Greatest force in it, but not less than `least`; lb.
    fn greatest(&self, geometry: &LegGeometry<f64>, least: f64) -> f64 {
        let point = |part: u32| {
            let theta = self.reach * f64::from(part) / f64::from(PARTS);
            (theta, -self.force(geometry, theta))
        };
        let points: [(f64, f64); PARTS as usize + 1] = std::array::from_fn(|k| point(k as u32));
        let mut greatest = least;
        for middle in 1..points.len() - 1 {
            let [a, b, c] = [middle - 1, middle, middle + 1].map(|k| points[k]);
            greatest = greatest.max(-b.1);
            let mut parabola = Parabola::through([a, b, c]);
            for _ in 0..REFINEMENTS {
                let Some(theta) = parabola.lowest(-(1.0 + NOTABLE) * greatest) else {
                    break;
                };
                let force = self.force(geometry, theta);
                greatest = greatest.max(force);
                parabola = parabola.about((theta, -force));
            }
        }
        greatest
    }
}
