//! The motion of a landing as plain numbers.

use nalgebra::{Vector3, Vector4};
use touchdown_dynamics::attitude::Attitude;
use touchdown_dynamics::state::{Body, LegState, State};

pub const LEGS: usize = 3;
const BODY: usize = 13;
const LEG: usize = 4;
/// Variables of a landing: body and legs, without the work integrals, on which nothing depends.
pub const COUNT: usize = BODY + LEGS * LEG;

/// The state that `COUNT` numbers say.
#[inline]
pub fn state(y: &[f64]) -> State<f64> {
    let body = Body {
        position: Vector3::new(y[0], y[1], y[2]),
        velocity: Vector3::new(y[3], y[4], y[5]),
        quaternion: Vector4::new(y[6], y[7], y[8], y[9]),
        rate: Vector3::new(y[10], y[11], y[12]),
    };
    let leg = |j: usize| {
        let l = &y[BODY + LEG * j..][..LEG];
        LegState {
            link_angle: l[0],
            link_rate: l[1],
            pad_turn: l[2],
            pad_rate: l[3],
            work: [0.0; 6],
        }
    };
    State::new(&body, &std::array::from_fn::<_, LEGS, _>(leg))
}

/// Writes a state, or its derivative, as `COUNT` numbers.
#[inline]
pub fn write(state: &State<f64>, y: &mut [f64]) {
    let body = state.body();
    y[0..3].copy_from_slice(body.position.as_slice());
    y[3..6].copy_from_slice(body.velocity.as_slice());
    y[6..10].copy_from_slice(body.quaternion.as_slice());
    y[10..13].copy_from_slice(body.rate.as_slice());
    for j in 0..LEGS {
        let leg = state.leg(j);
        y[BODY + LEG * j..][..LEG].copy_from_slice(&[
            leg.link_angle,
            leg.link_rate,
            leg.pad_turn,
            leg.pad_rate,
        ]);
    }
}

/// Position (ft) and pitch (deg).
pub fn position_and_pitch(state: &State<f64>) -> ([f64; 3], f64) {
    let body = state.body();
    let q = body.quaternion;
    let attitude = Attitude::from_quaternion([q.x, q.y, q.z, q.w]);
    (body.position.into(), attitude.euler().pitch.to_degrees())
}
