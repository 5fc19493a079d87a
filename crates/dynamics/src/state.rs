//! The integrated state: rigid body, legs, and the work done on their elements.

mod abreast;

use nalgebra::{Matrix3, Vector3, Vector4};
use num_traits::Zero;

use crate::quad::{LANES, MOST_LEGS, Quad, groups_of};
use crate::scalar::Real;
use crate::wide::Wide;

/// State of a vehicle with `LEGS` legs, or its time derivative.
///
/// Stored flat so that linear combinations run over plain arrays; the named views [`Body`] and
/// [`LegState`] are how the physics reads and writes it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct State<S, const LEGS: usize = 3> {
    /// Component by component, so that the legs' numbers of one kind lie side by side. What is
    /// beyond the last leg stays zero.
    legs: [[S; MOST_LEGS]; LEG],
    /// Filled up with zeros.
    body: [S; BODY],
}

/// Numbers of the body.
const BODY_NUMBERS: usize = 13;
/// Thirteen, and three to fill registers.
const BODY: usize = 16;
const LEG: usize = 10;
/// Where γ and γ̇ are among the components of a leg.
const LINK_ANGLE: usize = 0;
const LINK_RATE: usize = 1;
/// Where the pad's turn and α̇ are.
const PAD_TURN: usize = 2;
const PAD_RATE: usize = 3;
/// Error of Simpson's rule as a share of its difference from the midpoint rule: h²f⁗/(120 f″), as much as where f
/// swings by 3.5 rad within the step.
const SIMPSON_SHARE: f64 = 0.1;
/// Leading components of a leg that move; the rest are work integrals.
const LEG_MOTION: usize = 4;

/// The rigid body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body<S> {
    /// CG in ground axes, ft.
    pub position: Vector3<S>,
    /// CG velocity in ground axes, ft/s.
    pub velocity: Vector3<S>,
    /// Quaternion (w, x, y, z) of the attitude, vehicle to ground; its length does not matter.
    pub quaternion: Vector4<S>,
    /// Angular velocity ω in vehicle axes, rad/s.
    pub rate: Vector3<S>,
}

/// One leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegState<S> {
    /// Lower-link angle γ, rad.
    pub link_angle: S,
    /// Its rate γ̇, rad/s.
    pub link_rate: S,
    /// Footpad angle α, rad; of a pad that presses on a stop the angle to which α̇ would have turned it
    /// without one (`hinge`).
    pub pad_turn: S,
    /// Its rate state α̇, rad/s.
    pub pad_rate: S,
    /// Work done on strut, pad (crush, friction), block (crush, friction) and stop, ft·lb.
    pub work: [S; LEG - LEG_MOTION],
}

impl<S: Real> LegState<S> {
    #[inline(always)]
    fn components(&self) -> [S; LEG] {
        let w = self.work;
        [
            self.link_angle,
            self.link_rate,
            self.pad_turn,
            self.pad_rate,
            w[0],
            w[1],
            w[2],
            w[3],
            w[4],
            w[5],
        ]
    }

    #[inline(always)]
    fn from_components(c: [S; LEG]) -> Self {
        Self {
            link_angle: c[0],
            link_rate: c[1],
            pad_turn: c[2],
            pad_rate: c[3],
            work: [c[4], c[5], c[6], c[7], c[8], c[9]],
        }
    }
}

impl<S: Real, const LEGS: usize> State<S, LEGS> {
    /// Packs body and legs.
    pub fn new(body: &Body<S>, legs: [LegState<S>; LEGS]) -> Self {
        let mut state = Self::zero();
        state.set_body(body);
        for (index, leg) in legs.iter().enumerate() {
            state.set_leg(index, leg);
        }
        state
    }

    /// Writes the rigid body.
    #[inline(always)]
    pub fn set_body(&mut self, body: &Body<S>) {
        let Body {
            position: p,
            velocity: v,
            quaternion: q,
            rate: w,
        } = body;
        let zero = S::zero();
        self.body = [
            p.x, p.y, p.z, v.x, v.y, v.z, q.x, q.y, q.z, q.w, w.x, w.y, w.z, zero, zero, zero,
        ];
    }

    /// Writes leg `index`.
    #[inline(always)]
    pub fn set_leg(&mut self, index: usize, leg: &LegState<S>) {
        // Component by component: an array of them would go through memory.
        self.legs[0][index] = leg.link_angle;
        self.legs[1][index] = leg.link_rate;
        self.legs[2][index] = leg.pad_turn;
        self.legs[3][index] = leg.pad_rate;
        self.legs[4][index] = leg.work[0];
        self.legs[5][index] = leg.work[1];
        self.legs[6][index] = leg.work[2];
        self.legs[7][index] = leg.work[3];
        self.legs[8][index] = leg.work[4];
        self.legs[9][index] = leg.work[5];
    }

    /// All components zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            body: [S::zero(); BODY],
            legs: [[S::zero(); MOST_LEGS]; LEG],
        }
    }

    /// The rigid body.
    #[inline(always)]
    pub fn body(&self) -> Body<S> {
        let b = &self.body;
        Body {
            position: Vector3::new(b[0], b[1], b[2]),
            velocity: Vector3::new(b[3], b[4], b[5]),
            quaternion: Vector4::new(b[6], b[7], b[8], b[9]),
            rate: Vector3::new(b[10], b[11], b[12]),
        }
    }

    /// Leg `index`.
    #[inline(always)]
    pub fn leg(&self, index: usize) -> LegState<S> {
        LegState::from_components(self.legs.each_ref().map(|row| row[index]))
    }

    /// What the pad of a leg has turned by, rad.
    #[inline(always)]
    pub fn pad_turn(&self, leg: usize) -> S {
        self.legs[PAD_TURN][leg]
    }

    /// Writes what the pad of a leg has turned by, rad.
    #[inline(always)]
    pub fn set_pad_turn(&mut self, leg: usize, turn: S) {
        self.legs[PAD_TURN][leg] = turn;
    }

    /// Rate α̇ of the pad of a leg, rad/s.
    #[inline(always)]
    pub fn pad_rate(&self, leg: usize) -> S {
        self.legs[PAD_RATE][leg]
    }

    /// Rates γ̇ of the links, rad/s.
    #[inline(always)]
    pub fn link_rates(&self) -> [S; LEGS] {
        std::array::from_fn(|j| self.legs[LINK_RATE][j])
    }

    /// Angles γ (rad) and rates γ̇ (rad/s) of the links in self + Σ weight · slope.
    #[inline(always)]
    pub fn links_advanced<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> [[S; LEGS]; 2] {
        [LINK_ANGLE, LINK_RATE].map(|row| self.row_advanced(row, weights, slopes))
    }

    /// Rates α̇ of the pads (rad/s) in self + Σ weight · slope.
    #[inline(always)]
    pub fn pad_rates_advanced<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> [S; LEGS] {
        self.row_advanced(PAD_RATE, weights, slopes)
    }

    #[inline(always)]
    fn row_advanced<const TERMS: usize>(
        &self,
        row: usize,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> [S; LEGS] {
        std::array::from_fn(|j| {
            let terms = weights.iter().zip(slopes);
            terms.fold(self.legs[row][j], |sum, (&weight, slope)| {
                sum + weight * slope.legs[row][j]
            })
        })
    }

    /// self + Σ weight · slope, component by component.
    #[inline(always)]
    pub fn advanced<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> Self {
        let mut result = *self;
        self.advance(weights, slopes, &mut result);
        result
    }

    /// self + Σ weight · slope of what moves; the work integrals, on which nothing depends, stay.
    #[inline(always)]
    pub fn advanced_motion<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> Self {
        let mut result = *self;
        self.advance_motion(weights, slopes, &mut result);
        result
    }

    /// Writes self + Σ weights·slopes into `result`, but for the work integrals.
    #[inline(always)]
    pub fn advance_motion<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        self.advance_through::<LEG_MOTION, TERMS>(weights, slopes, result);
    }

    /// Writes self + Σ weights·slopes into `result`.
    #[inline(always)]
    pub fn advance<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        self.advance_through::<LEG, TERMS>(weights, slopes, result);
    }

    #[inline(always)]
    fn advance_through<const LAST: usize, const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
        result: &mut Self,
    ) {
        let (body, legs) = const { (body_numbers::<S>(), columns::<S>(LEGS)) };
        for i in 0..body {
            S::one_round();
            let mut sum = self.body[i];
            for k in 0..TERMS {
                sum += weights[k] * slopes[k].body[i];
            }
            result.body[i] = sum;
        }
        for i in 0..LAST {
            for leg in 0..legs {
                S::one_round();
                let mut sum = self.legs[i][leg];
                for k in 0..TERMS {
                    sum += weights[k] * slopes[k].legs[i][leg];
                }
                result.legs[i][leg] = sum;
            }
        }
    }
}

/// Numbers of a body to be summed: what fills registers, or what there is if each is a register of its own.
const fn body_numbers<S: Real>() -> usize {
    if S::LANES == 1 { BODY } else { BODY_NUMBERS }
}

/// Columns of legs to be summed, likewise.
const fn columns<S: Real>(legs: usize) -> usize {
    if S::LANES == 1 {
        groups_of(legs) * LANES
    } else {
        legs
    }
}

impl<S: Real, const LEGS: usize> State<S, LEGS> {
    /// self − other.
    #[inline(always)]
    pub fn minus(&self, other: &Self) -> Self {
        self.advanced([-S::one()], [other])
    }

    /// self/length.
    #[inline(always)]
    pub fn over(&self, length: S) -> Self {
        Self::zero().advanced([S::one() / length], [self])
    }

    /// Writes what moves midway between self and `end` on the cubic between them, from the slopes at both and an
    /// eighth of the time between.
    #[inline(always)]
    pub fn midway(&self, end: &Self, eighth: S, [first, last]: [&Self; 2], middle: &mut Self) {
        let half = S::constant(0.5);
        Self::zero().advance_motion(
            [half, half, eighth, -eighth],
            [self, end, first, last],
            middle,
        );
    }

    /// Sums by Simpson's rule what only accumulates over a step of length `h`: the work integrals, and the
    /// rates of pads at rest, whose `hinge_gains` are 0. Of the error of work, over h, it writes a guess.
    #[inline(always)]
    pub fn accumulate(
        &mut self,
        before: &Self,
        h: S,
        [first, middle, last]: [&Self; 3],
        hinge_gains: [S; LEGS],
        error: &mut Self,
    ) {
        let sixth = S::constant(1.0 / 6.0);
        let sum = |i: usize, j: usize| {
            let ends = first.legs[i][j] + last.legs[i][j];
            let middle = middle.legs[i][j];
            (
                (ends + S::constant(4.0) * middle) * sixth,
                (ends - S::constant(2.0) * middle) * sixth,
            )
        };
        for (j, gain) in hinge_gains.into_iter().enumerate() {
            let summed = before.legs[PAD_RATE][j] + h * sum(PAD_RATE, j).0;
            self.legs[PAD_RATE][j] = gain.where_zero(summed, self.legs[PAD_RATE][j]);
            error.legs[PAD_RATE][j] = gain.where_zero(S::zero(), error.legs[PAD_RATE][j]);
        }
        for i in LEG_MOTION..LEG {
            for j in 0..LEGS {
                S::one_round();
                let (mean, past_midpoint) = sum(i, j);
                self.legs[i][j] = before.legs[i][j] + h * mean;
                error.legs[i][j] = S::constant(SIMPSON_SHARE) * past_midpoint;
            }
        }
    }
}

impl<const LEGS: usize> State<f64, LEGS> {
    /// The legs of a group of four, side by side.
    #[inline(always)]
    pub fn legs_abreast(&self, group: usize) -> LegState<Quad> {
        let quad = |row: &[f64; MOST_LEGS]| Wide(std::array::from_fn(|i| row[group * LANES + i]));
        LegState::from_components(self.legs.each_ref().map(quad))
    }

    /// Writes the legs of a group of four.
    #[inline(always)]
    pub fn set_legs_abreast(&mut self, group: usize, legs: &LegState<Quad>) {
        for (row, component) in self.legs.iter_mut().zip(legs.components()) {
            row[group * LANES..][..LANES].copy_from_slice(&component.0);
        }
    }

    /// Greatest error of a moving component in units of its tolerance, which is relative above
    /// 1 ft, ft/s, rad or rad/s and absolute below. The work integrals follow from the motion and
    /// have no say here.
    #[inline(always)]
    pub fn error_norm(&self, before: &Self, after: &Self, tolerance: f64) -> f64 {
        let mut worst = Quad::zero();
        // A maximum drops what is not a number, a sum keeps it.
        let mut sum = Quad::zero();
        let mut weigh = |error: &[f64], a: &[f64], b: &[f64]| {
            for ((error, a), b) in quads(error).zip(quads(a)).zip(quads(b)) {
                let scaled = scaled(error, a, b);
                worst = worst.max(scaled);
                sum += scaled;
            }
        };
        weigh(&self.body, &before.body, &after.body);
        for i in 0..LEG_MOTION {
            weigh(&self.legs[i], &before.legs[i], &after.legs[i]);
        }
        let all_numbers = sum.0.iter().all(|sum| !sum.is_nan());
        let worst = if all_numbers {
            worst.0.into_iter().fold(0.0, f64::max)
        } else {
            f64::INFINITY
        };
        worst / tolerance
    }

    /// Greatest work among the work integrals whatever its sign, ft·lb.
    #[inline(always)]
    pub fn greatest_work(&self) -> f64 {
        let mut greatest = Quad::zero();
        for row in &self.legs[LEG_MOTION..] {
            for work in quads(row) {
                greatest = greatest.max(work.abs());
            }
        }
        greatest.0.into_iter().fold(0.0, f64::max)
    }

    /// Whether every component is a finite number.
    pub fn is_finite(&self) -> bool {
        // Nothing times what is not finite is not a number.
        let all = quads(&self.body).chain(quads(self.legs.as_flattened()));
        let sum = all.fold(Quad::zero(), |sum, four| sum + four * Quad::zero());
        sum.is_zero()
    }
}

/// An error over what it is weighed by: the component before or after, or one.
#[inline(always)]
fn scaled<S: Real>(error: S, before: S, after: S) -> S {
    error.abs() / before.abs().max(after.abs()).max(S::one())
}

#[inline(always)]
fn quads(values: &[f64]) -> impl Iterator<Item = Quad> {
    values.as_chunks().0.iter().map(|&four| Wide(four))
}

/// The rotation matrix B, vehicle to ground (1), of a quaternion of any length but zero.
#[inline(always)]
pub fn rotation<S: Real>(q: &Vector4<S>) -> Matrix3<S> {
    let (w, x, y, z) = (q.x, q.y, q.z, q.w);
    let two = S::constant(2.0) / (w * w + x * x + y * y + z * z);
    let one = S::one();
    Matrix3::new(
        one - two * (y * y + z * z),
        two * (x * y - w * z),
        two * (x * z + w * y),
        two * (x * y + w * z),
        one - two * (x * x + z * z),
        two * (y * z - w * x),
        two * (x * z - w * y),
        two * (y * z + w * x),
        one - two * (x * x + y * y),
    )
}

/// Rate of the quaternion at angular velocity ω in vehicle axes: q̇ = ½ q ∘ (0, ω).
#[inline(always)]
pub fn quaternion_rate<S: Real>(q: &Vector4<S>, rate: &Vector3<S>) -> Vector4<S> {
    let half = S::constant(0.5);
    let (w, x, y, z) = (q.x * half, q.y * half, q.z * half, q.w * half);
    Vector4::new(
        -x * rate.x - y * rate.y - z * rate.z,
        w * rate.x + y * rate.z - z * rate.y,
        w * rate.y + z * rate.x - x * rate.z,
        w * rate.z + x * rate.y - y * rate.x,
    )
}
