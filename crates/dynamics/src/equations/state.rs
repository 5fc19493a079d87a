//! The integrated state: rigid body, legs, and the work done on their elements.

mod numbers;

use libm::{atan2, hypot};
use nalgebra::{Matrix3, Vector3, Vector4};

use crate::integrator::step::StateVector;
use crate::per_leg::PerLeg;
use crate::scalar::Real;

/// State of a vehicle, or its time derivative.
///
/// Stored flat so that linear combinations run over plain arrays. The physics reads and writes it through the named
/// views [`Body`] and [`LegState`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct State<S> {
    /// Padded with zeros.
    body: [S; BODY],
    legs: PerLeg<[S; LEG]>,
}

/// Numbers of the body.
const BODY_NUMBERS: usize = 13;
/// Thirteen, and three to fill registers.
const BODY: usize = 16;
/// Numbers of a leg.
const LEG: usize = 10;
/// Indices of γ and γ̇ among the numbers of a leg.
const LINK_ANGLE: usize = 0;
const LINK_RATE: usize = 1;
/// Index of α̇.
const PAD_RATE: usize = 3;
/// Error of Simpson's rule as a share of its difference from the midpoint rule: h²f⁗/(120 f″), as much as where f
/// swings by 3.5 rad within the step.
const SIMPSON_SHARE: f64 = 0.1;
/// Leading numbers of a leg that move; the rest are work integrals.
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
    /// Footpad angle α, rad; for a pad that presses on a stop, the angle to which α̇ would have turned it without the
    /// stop (`hinge`).
    pub pad_turn: S,
    /// Its rate state α̇, rad/s.
    pub pad_rate: S,
    /// Work done on strut, pad (crush, friction), block (crush, friction) and stop, ft·lb.
    pub work: [S; LEG - LEG_MOTION],
}

impl<S: Real> LegState<S> {
    #[inline(always)]
    fn from_numbers(n: &[S; LEG]) -> Self {
        Self {
            link_angle: n[0],
            link_rate: n[1],
            pad_turn: n[2],
            pad_rate: n[3],
            work: [n[4], n[5], n[6], n[7], n[8], n[9]],
        }
    }
}

impl<S: Real> State<S> {
    /// Packs body and legs.
    ///
    /// # Panics
    /// Without a leg, or with more than a vehicle may have.
    pub fn new(body: &Body<S>, legs: &[LegState<S>]) -> Self {
        let mut state = Self::zero(legs.len());
        state.set_body(body);
        for (index, leg) in legs.iter().enumerate() {
            state.set_leg(index, leg);
        }
        state
    }

    /// A zero state with this many legs.
    #[inline(always)]
    pub fn zero(legs: usize) -> Self {
        Self {
            body: [S::zero(); BODY],
            legs: PerLeg::same(legs, [S::zero(); LEG]),
        }
    }

    /// Number of legs.
    #[inline(always)]
    pub fn leg_count(&self) -> usize {
        self.legs.len()
    }

    /// Takes over another state with as many legs.
    #[inline(always)]
    pub fn assign(&mut self, other: &Self) {
        self.body = other.body;
        self.legs.copy_from_slice(&other.legs);
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
        // One by one: an array would go through memory.
        let numbers = &mut self.legs[index];
        numbers[0] = leg.link_angle;
        numbers[1] = leg.link_rate;
        numbers[2] = leg.pad_turn;
        numbers[3] = leg.pad_rate;
        numbers[4] = leg.work[0];
        numbers[5] = leg.work[1];
        numbers[6] = leg.work[2];
        numbers[7] = leg.work[3];
        numbers[8] = leg.work[4];
        numbers[9] = leg.work[5];
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
        LegState::from_numbers(&self.legs[index])
    }

    /// Rate γ̇ of the link of leg `index`, rad/s.
    #[inline(always)]
    pub fn link_rate(&self, index: usize) -> S {
        self.legs[index][LINK_RATE]
    }

    /// Angles γ (rad) and rates γ̇ (rad/s) of the links in self + Σ weight · slope.
    #[inline(always)]
    pub fn links_advanced<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> [PerLeg<S>; 2] {
        [LINK_ANGLE, LINK_RATE].map(|number| self.number_advanced(number, weights, slopes))
    }

    /// Rates α̇ of the pads (rad/s) in self + Σ weight · slope.
    #[inline(always)]
    pub fn pad_rates_advanced<const TERMS: usize>(
        &self,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> PerLeg<S> {
        self.number_advanced(PAD_RATE, weights, slopes)
    }

    #[inline(always)]
    fn number_advanced<const TERMS: usize>(
        &self,
        number: usize,
        weights: [S; TERMS],
        slopes: [&Self; TERMS],
    ) -> PerLeg<S> {
        let mut numbers = PerLeg::same(self.legs.len(), S::zero());
        for (j, sum) in numbers.iter_mut().enumerate() {
            *sum = self.legs[j][number];
            for k in 0..TERMS {
                *sum += weights[k] * slopes[k].legs[j][number];
            }
        }
        numbers
    }

    /// self + Σ weight · slope, number by number.
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

    /// self + Σ weight · slope of the motion. The work integrals, on which nothing depends, stay.
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

    /// Sums the accumulating numbers of leg `leg` by Simpson's rule over a step of length `h`: its work integrals, and
    /// the rate of a pad at rest on a stop (`hinge_gain` 0). Elsewhere a share of the error of that rate counts. Also
    /// writes an estimate of the error of work, over h.
    #[inline(always)]
    pub fn accumulate(
        &mut self,
        leg: usize,
        before: &Self,
        h: S,
        slopes: [&Self; 3],
        [hinge_gain, pad_share]: [S; 2],
        error: &mut Self,
    ) {
        let [first, middle, last] = slopes.map(|slope| &slope.legs[leg]);
        let (own, before, error) = (&mut self.legs[leg], &before.legs[leg], &mut error.legs[leg]);
        let sixth = S::constant(1.0 / 6.0);
        for i in PAD_RATE..LEG {
            S::keep_rounds_apart();
            let ends = first[i] + last[i];
            let mean = (ends + S::constant(4.0) * middle[i]) * sixth;
            let past_midpoint = (ends - S::constant(2.0) * middle[i]) * sixth;
            let summed = before[i] + h * mean;
            if i < LEG_MOTION {
                own[i] = hinge_gain.where_zero(summed, own[i]);
                error[i] = hinge_gain.where_zero(S::zero(), error[i] * pad_share);
            } else {
                own[i] = summed;
                error[i] = S::constant(SIMPSON_SHARE) * past_midpoint;
            }
        }
    }
}

impl State<f64> {
    /// Returns whether every number is finite.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        let mut are_finite = true;
        for number in &self.body {
            are_finite &= number.is_finite();
        }
        for number in self.legs.as_flattened() {
            are_finite &= number.is_finite();
        }
        are_finite
    }
}

impl Body<f64> {
    /// Inclination of the centreline to the vertical, rad.
    pub fn tilt(&self) -> f64 {
        let down = rotation(&self.quaternion).column(2).into_owned();
        atan2(hypot(down.x, down.y), down.z)
    }

    /// Cosine of that inclination.
    pub fn tilt_cosine(&self) -> f64 {
        let q = &self.quaternion;
        let (kept, turned) = (q.x * q.x + q.w * q.w, q.y * q.y + q.z * q.z);
        (kept - turned) / (kept + turned)
    }
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
