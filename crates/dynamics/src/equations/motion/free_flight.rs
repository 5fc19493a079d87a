//! Free flight in closed form. No leg is on the surface, so the body falls (55) and turns free of torque (60). Hanging
//! legs keep their links still while their rates run down (model chapter 5), and those of their pads with them (69).
//!
//! The CG follows its parabola, rates of links an exponential, turns of pads its integral. The rotation of a body with
//! three different moments of inertia takes elliptic functions; here it is the power series of (60) and of the
//! quaternion, summed to the last bit within [`FreeFlight::reach`].

use libm::expm1;
use nalgebra::{Matrix3, Vector3, Vector4};

use super::{Motion, Pieces};
use crate::per_leg::PerLeg;
use crate::state::{Body, State, quaternion_rate};

/// Terms of the series, without that of order zero.
const ORDER: usize = 10;
/// Last term over the first below which a series counts as summed.
const ROUNDING: f64 = 1e-17;

/// A flight from one state on.
#[derive(Debug, Clone, Copy)]
pub struct FreeFlight {
    start: State<f64>,
    /// Gravity, ft/s², along z of the ground axes.
    gravity: f64,
    /// Derivatives of angular velocity (rad/s, body axes) and quaternion, order by order in s, over factorials.
    rates: [Vector3<f64>; ORDER + 1],
    quaternions: [Vector4<f64>; ORDER + 1],
    legs: PerLeg<HangingLeg>,
}

/// Motion of a hanging leg.
#[derive(Debug, Clone, Copy)]
struct HangingLeg {
    /// Rate at which the link's rate runs down, 1/s, and link rate above the residual rate, rad/s.
    run_down: f64,
    surplus: f64,
    /// Moment of inertia of the link, slug·ft².
    inertia: f64,
    /// The pad turns at follows·α̇ + steady, rad/s.
    follows: f64,
    steady: f64,
    /// Share of the link's loss of rate that the pad loses too; zero if they are one.
    shared: f64,
}

impl Motion<f64> {
    /// The flight from a state at which all legs hang.
    pub fn free_flight(&self, state: &State<f64>, pieces: &Pieces<f64>) -> FreeFlight {
        let Body {
            quaternion, rate, ..
        } = state.body();
        let (rates, quaternions) =
            rotation([&self.inertia, &self.inverse_inertia], rate, quaternion);
        FreeFlight {
            start: *state,
            gravity: self.gravity,
            rates,
            quaternions,
            legs: PerLeg::from_fn(self.leg_count(), |j| {
                let leg = &pieces.leg(j).leg;
                let [follows, steady] = leg.hinge.turning_by_rate();
                HangingLeg {
                    run_down: leg.link.run_down(),
                    surplus: leg.link.surplus(state.leg(j).link_rate),
                    inertia: self.legs[j].link_inertia,
                    follows,
                    steady,
                    shared: if self.acts_at_face { follows } else { 1.0 },
                }
            }),
        }
    }
}

/// The series of angular velocity and quaternion, from J ω̇ = Jω × ω (60).
fn rotation(
    [inertia, inverse]: [&Matrix3<f64>; 2],
    rate: Vector3<f64>,
    quaternion: Vector4<f64>,
) -> ([Vector3<f64>; ORDER + 1], [Vector4<f64>; ORDER + 1]) {
    let mut rates = [rate; ORDER + 1];
    let mut momenta = [inertia * rate; ORDER + 1];
    let mut quaternions = [quaternion; ORDER + 1];
    for order in 0..ORDER {
        let mut twist = Vector3::zeros();
        let mut turning = Vector4::zeros();
        for k in 0..=order {
            twist += momenta[k].cross(&rates[order - k]);
            turning += quaternion_rate(&quaternions[k], &rates[order - k]);
        }
        let share = 1.0 / (order + 1) as f64;
        rates[order + 1] = inverse * twist * share;
        momenta[order + 1] = inertia * rates[order + 1];
        quaternions[order + 1] = turning * share;
    }
    (rates, quaternions)
}

/// Sum of a series at a time.
fn sum<V>(terms: &[V; ORDER + 1], time: f64) -> V
where
    V: Copy + std::ops::Add<Output = V> + std::ops::Mul<f64, Output = V>,
{
    let [lower @ .., last] = terms;
    (lower.iter().rev()).fold(*last, |sum, &term| sum * time + term)
}

impl FreeFlight {
    /// Time up to `longest` (s) within which the series are summed to the last bit.
    pub fn reach(&self, longest: f64) -> f64 {
        let [rate, quaternion] = [self.rates[0].norm(), self.quaternions[0].norm()];
        let (last_rate, last_quaternion) =
            (self.rates[ORDER].norm(), self.quaternions[ORDER].norm());
        let mut reach = longest;
        // One of several hundred halvings is enough for any finite numbers.
        loop {
            let squared = reach * reach;
            let fourth = squared * squared;
            let power = fourth * fourth * squared;
            let is_summed = last_rate * power <= ROUNDING * rate
                && last_quaternion * power <= ROUNDING * quaternion;
            if is_summed || power == 0.0 {
                return reach;
            }
            reach *= 0.5;
        }
    }

    /// State after `time` (s), work integrals included.
    #[cold]
    #[inline(never)]
    pub fn at(&self, time: f64) -> State<f64> {
        let mut state = self.start;
        let start = self.start.body();
        let fall = Vector3::new(0.0, 0.0, self.gravity * time);
        state.set_body(&Body {
            position: start.position + (start.velocity + fall * 0.5) * time,
            velocity: start.velocity + fall,
            quaternion: sum(&self.quaternions, time),
            rate: sum(&self.rates, time),
        });
        for (j, hanging) in self.legs.iter().enumerate() {
            let mut leg = self.start.leg(j);
            let (lost, lost_turn) = hanging.lost(time);
            leg.pad_turn +=
                hanging.follows * (leg.pad_rate * time - lost_turn) + hanging.steady * time;
            let rate = leg.link_rate;
            leg.link_rate -= lost;
            leg.pad_rate -= hanging.shared * lost;
            // The energy that the link loses goes to its stop.
            let [.., stop] = &mut leg.work;
            *stop += 0.5 * hanging.inertia * (rate * rate - leg.link_rate * leg.link_rate);
            state.set_leg(j, &leg);
        }
        state
    }
}

impl HangingLeg {
    /// Rate that link and pad lose in `time` (s), rad/s, and its integral, rad.
    fn lost(&self, time: f64) -> (f64, f64) {
        if self.run_down == 0.0 {
            return (0.0, 0.0);
        }
        let lost = -expm1(-self.run_down * time);
        (
            self.surplus * lost,
            self.surplus * (time - lost / self.run_down),
        )
    }
}
