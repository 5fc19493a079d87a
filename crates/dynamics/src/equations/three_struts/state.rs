//! The integrated state: rigid body, feet, and the work done on the elements of the legs.

use std::ops::Range;

use nalgebra::{Vector3, Vector4};

use crate::integrator::step::StateVector;
use crate::lanes::{Lanes, per_lane};
use crate::quads::{LANES, QUADS, Quad, leg_in, quads};
use crate::state::Body;

/// Room for the numbers of the body, of which there are 13.
const BODY: usize = 16;
/// Numbers of the motion of a group of feet.
const FEET: usize = 6 * LANES;
/// Works on a leg: struts, crush of the footpad, its friction.
pub const WORKS: usize = 3;
/// Weight of an error of a foot's velocity beside one of the body: feet are light, and struts make them follow the body.
const FOOT_RATE_SHARE: f64 = 0.05;
/// Error of Simpson's rule as a share of its difference from the midpoint rule ([`crate::state`]).
const SIMPSON_SHARE: f64 = 0.1;

/// State of a vehicle, or its time derivative. Feet and works are in groups of four, number by number.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub struct State {
    motion: [f64; BODY + FEET * QUADS],
    works: [f64; WORKS * LANES * QUADS],
    legs: usize,
}

/// One foot, or a group of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FootState<S> {
    /// Position in ground axes, ft.
    pub position: Vector3<S>,
    /// Velocity in ground axes, ft/s.
    pub velocity: Vector3<S>,
}

per_lane!(FootState { position, velocity });

impl State {
    /// A zero state with this many legs.
    pub fn zero(legs: usize) -> Self {
        Self {
            motion: [0.0; BODY + FEET * QUADS],
            works: [0.0; WORKS * LANES * QUADS],
            legs,
        }
    }

    /// The rigid body.
    #[inline(always)]
    pub fn body(&self) -> Body<f64> {
        let b = &self.motion;
        Body {
            position: Vector3::new(b[0], b[1], b[2]),
            velocity: Vector3::new(b[3], b[4], b[5]),
            quaternion: Vector4::new(b[6], b[7], b[8], b[9]),
            rate: Vector3::new(b[10], b[11], b[12]),
        }
    }

    /// Writes the rigid body.
    #[inline(always)]
    pub fn set_body(&mut self, body: &Body<f64>) {
        self.motion[0..3].copy_from_slice(body.position.as_slice());
        self.motion[3..6].copy_from_slice(body.velocity.as_slice());
        self.motion[6..10].copy_from_slice(body.quaternion.as_slice());
        self.motion[10..13].copy_from_slice(body.rate.as_slice());
    }

    /// The foot of leg `leg`.
    pub fn foot(&self, leg: usize) -> FootState<f64> {
        let (feet, lane) = (&self.motion[BODY + FEET * (leg / LANES)..], leg % LANES);
        let of = |k: usize| feet[LANES * k + lane];
        FootState {
            position: Vector3::new(of(0), of(1), of(2)),
            velocity: Vector3::new(of(3), of(4), of(5)),
        }
    }

    /// Writes the foot of leg `leg`.
    pub fn set_foot(&mut self, leg: usize, foot: &FootState<f64>) {
        for quad in 0..quads(self.legs) {
            for lane in 0..LANES {
                if leg_in(quad, lane, self.legs) == leg {
                    let feet = &mut self.motion[BODY + FEET * quad..];
                    let numbers = foot.position.iter().chain(&foot.velocity);
                    for (k, number) in numbers.enumerate() {
                        feet[LANES * k + lane] = *number;
                    }
                }
            }
        }
    }

    /// The feet of a group of legs.
    #[inline(always)]
    pub fn feet(&self, quad: usize) -> FootState<Quad> {
        let feet = self.motion[BODY + FEET * quad..][..FEET].as_chunks().0;
        let of = |k: usize| Lanes(feet[k]);
        FootState {
            position: Vector3::new(of(0), of(1), of(2)),
            velocity: Vector3::new(of(3), of(4), of(5)),
        }
    }

    /// Writes the feet of a group of legs.
    #[inline(always)]
    pub fn set_feet(&mut self, quad: usize, feet: &FootState<Quad>) {
        let room = self.motion[BODY + FEET * quad..][..FEET].as_chunks_mut().0;
        let (position, velocity) = (&feet.position, &feet.velocity);
        let numbers = [
            position.x, position.y, position.z, velocity.x, velocity.y, velocity.z,
        ];
        for (place, number) in room.iter_mut().zip(numbers) {
            *place = number.0;
        }
    }

    /// Work done on leg `leg` since first contact, ft·lb: on its struts, on its footpad by crushing and by sliding.
    pub fn works(&self, leg: usize) -> [f64; WORKS] {
        let works = &self.works[WORKS * LANES * (leg / LANES)..];
        std::array::from_fn(|k| works[LANES * k + leg % LANES])
    }

    /// Writes the work done on a group of legs, ft·lb, or its rate.
    #[inline(always)]
    pub fn set_works(&mut self, quad: usize, works: [Quad; WORKS]) {
        let room = self.works[WORKS * LANES * quad..][..WORKS * LANES]
            .as_chunks_mut()
            .0;
        for (place, work) in room.iter_mut().zip(works) {
            *place = work.0;
        }
    }

    /// Returns whether every number is finite.
    pub fn is_finite(&self) -> bool {
        (self.motion.iter().chain(&self.works)).all(|number| number.is_finite())
    }

    /// Sums the works by Simpson's rule over a step of length `h` from `before`, from their rates at its start, middle
    /// and end. Writes an estimate of their error, over h.
    #[inline(always)]
    pub(super) fn accumulate(
        &mut self,
        before: &Self,
        h: f64,
        slopes: [&Self; 3],
        error: &mut Self,
    ) {
        let [first, middle, last] = slopes.map(|slope| &slope.works);
        for i in 0..self.work_numbers() {
            let ends = first[i] + last[i];
            self.works[i] = before.works[i] + h * (ends + 4.0 * middle[i]) / 6.0;
            error.works[i] = SIMPSON_SHARE * (ends - 2.0 * middle[i]) / 6.0;
        }
    }

    #[inline(always)]
    fn motion_numbers(&self) -> usize {
        BODY + FEET * quads(self.legs)
    }

    #[inline(always)]
    fn work_numbers(&self) -> usize {
        WORKS * LANES * quads(self.legs)
    }
}

impl StateVector<f64> for State {
    #[inline(always)]
    fn advance<const TERMS: usize>(
        &self,
        weights: [f64; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        self.advance_motion(weights, slopes, result);
        for i in 0..self.work_numbers() {
            let change = (0..TERMS).map(|k| weights[k] * slopes[k].works[i]);
            result.works[i] = self.works[i] + change.sum::<f64>();
        }
    }

    #[inline(always)]
    fn advance_motion<const TERMS: usize>(
        &self,
        weights: [f64; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        for i in 0..self.motion_numbers() {
            let change = (0..TERMS).map(|k| weights[k] * slopes[k].motion[i]);
            result.motion[i] = self.motion[i] + change.sum::<f64>();
        }
    }

    #[inline(always)]
    fn midway(&self, end: &Self, eighth: f64, [first, last]: [&Self; 2], middle: &mut Self) {
        for i in 0..self.motion_numbers() {
            middle.motion[i] = 0.5 * (self.motion[i] + end.motion[i])
                + eighth * (first.motion[i] - last.motion[i]);
        }
    }

    #[inline(always)]
    fn set_mean_rate(&mut self, start: &Self, end: &Self, length: f64) {
        for i in 0..self.motion_numbers() {
            self.motion[i] = (end.motion[i] - start.motion[i]) / length;
        }
        for i in 0..self.work_numbers() {
            self.works[i] = (end.works[i] - start.works[i]) / length;
        }
    }

    #[inline(always)]
    fn set_motion_over(&mut self, change: &Self, length: f64) {
        for i in 0..self.motion_numbers() {
            self.motion[i] = change.motion[i] / length;
        }
    }

    /// The motion is weighed by its own magnitude or one, whichever is greater, as that of a vehicle on hinged legs. Velocities
    /// of feet count [`FOOT_RATE_SHARE`].
    #[inline(always)]
    fn greatest_error<const TERMS: usize>(
        weights: [f64; TERMS],
        slopes: [&Self; TERMS],
        before: &Self,
        after: &Self,
    ) -> [f64; 2] {
        // A maximum drops NaN, a sum keeps it.
        let mut all = 0.0;
        let mut greatest_of = |numbers: Range<usize>| {
            let mut greatest: f64 = 0.0;
            for i in numbers {
                let error: f64 = (0..TERMS).map(|k| weights[k] * slopes[k].motion[i]).sum();
                let weight = before.motion[i].abs().max(after.motion[i].abs()).max(1.0);
                greatest = greatest.max(error.abs() / weight);
                all += error;
            }
            greatest
        };
        let mut greatest = greatest_of(0..BODY);
        for quad in 0..quads(before.legs) {
            let feet = BODY + FEET * quad;
            let (positions, end) = (feet + FEET / 2, feet + FEET);
            greatest = greatest.max(greatest_of(feet..positions));
            greatest = greatest.max(FOOT_RATE_SHARE * greatest_of(positions..end));
        }
        let mut work: f64 = 0.0;
        for i in 0..before.work_numbers() {
            let error: f64 = (0..TERMS).map(|k| weights[k] * slopes[k].works[i]).sum();
            work = work.max(error.abs());
        }
        [greatest + 0.0 * all, work]
    }
}

#[cfg(test)]
impl State {
    /// The state that is one in a number of its motion and zero elsewhere.
    pub(super) fn unit(legs: usize, number: usize) -> Self {
        let mut state = Self::zero(legs);
        match number.checked_sub(13) {
            None => state.motion[number] = 1.0,
            Some(number) => {
                let (leg, number) = (number / 6, number % 6);
                let of = |first: usize| Vector3::from_fn(|k, _| f64::from(first + k == number));
                let foot = FootState {
                    position: of(0),
                    velocity: of(3),
                };
                state.set_foot(leg, &foot);
            }
        }
        state
    }

    /// Greatest magnitude of a number of its motion.
    pub(super) fn greatest(&self) -> f64 {
        self.motion
            .iter()
            .fold(0.0, |greatest: f64, number| greatest.max(number.abs()))
    }
}
