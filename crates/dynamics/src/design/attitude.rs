//! Attitude of the vehicle and its forms: quaternion inside, Euler angles and tip form outside.
//!
//! The rotation B takes vehicle axes to ground axes: B = Rx(pitch Ψ)·Ry(yaw Φ)·Rz(roll Ξ), the
//! report's matrix (1). Euler angles fail at cos Φ = 0; the quaternion does not.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use libm::{atan2, hypot, sincos};
use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};

/// Orientation of the vehicle: takes vehicle axes to ground axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attitude(UnitQuaternion<f64>);

/// Pitch Ψ, yaw Φ and roll Ξ of the report, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Euler {
    /// Ψ, about the ground X axis.
    pub pitch: f64,
    /// Φ, about the once turned y axis.
    pub yaw: f64,
    /// Ξ, about the vehicle's centreline.
    pub roll: f64,
}

/// A tipped vehicle (4.2.5): the centreline leans by ν in the direction Γ after a roll K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tip {
    /// ν: angle between centreline and vertical, rad, 0 to π.
    pub tip: f64,
    /// Γ: azimuth of the tip axis from ground X, rad; the top leans toward (−sin Γ, cos Γ).
    pub azimuth: f64,
    /// K: roll about the centreline, rad.
    pub nominal_roll: f64,
}

/// cos Φ below which pitch and roll turn about the same line: to rounding, yaw is a right angle.
const GIMBAL_LOCK: f64 = 1e-14;

impl Attitude {
    /// The attitude with the given Euler angles.
    pub fn from_euler(euler: Euler) -> Self {
        Self(
            turn(&Vector3::x_axis(), euler.pitch)
                * turn(&Vector3::y_axis(), euler.yaw)
                * turn(&Vector3::z_axis(), euler.roll),
        )
    }

    /// The attitude of a tipped vehicle: B = Rot((cos Γ, sin Γ, 0), ν)·Rz(K).
    pub fn from_tip(tip: Tip) -> Self {
        let (sine, cosine) = sincos(tip.azimuth);
        let axis = Unit::new_unchecked(Vector3::new(cosine, sine, 0.0));
        Self(turn(&axis, tip.tip) * turn(&Vector3::z_axis(), tip.nominal_roll))
    }

    /// The attitude with the given quaternion (w, x, y, z), of any length but zero.
    pub fn from_quaternion([w, x, y, z]: [f64; 4]) -> Self {
        Self(UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z)))
    }

    /// This rotation, in ground axes, after another.
    pub fn after(&self, first: &Self) -> Self {
        Self(self.0 * first.0)
    }

    /// The attitude with the given rotation matrix B, vehicle to ground.
    pub fn from_matrix(matrix: &Matrix3<f64>) -> Self {
        let rotation = Rotation3::from_matrix_unchecked(*matrix);
        Self(UnitQuaternion::from_rotation_matrix(&rotation))
    }

    /// Unit quaternion (w, x, y, z).
    pub fn quaternion(&self) -> [f64; 4] {
        [self.0.w, self.0.i, self.0.j, self.0.k]
    }

    /// The rotation matrix B, vehicle to ground.
    pub fn matrix(&self) -> Matrix3<f64> {
        *self.0.to_rotation_matrix().matrix()
    }

    /// Euler angles, pitch and roll in (−π, π], yaw in [−π/2, π/2]. Where cos Φ vanishes, only the sum or difference of
    /// pitch and roll is determined; roll is then given as zero.
    ///
    /// In terms of the quaternion, √2 sin(Φ/2 + π/4) multiplies sine and cosine of (Ψ + Ξ)/2, and √2 cos(Φ/2 + π/4)
    /// those of (Ψ − Ξ)/2. So the one of the two that remains determined at a right angle of yaw keeps all its digits
    /// there, unlike in the elements of the matrix.
    pub fn euler(&self) -> Euler {
        let [w, x, y, z] = self.quaternion();
        let (sum, difference) = (hypot(x + z, w + y), hypot(x - z, w - y));
        let yaw = 2.0 * atan2(sum, difference) - FRAC_PI_2;
        let half_sum = atan2(x + z, w + y);
        let half_difference = atan2(x - z, w - y);
        // Their product is cos Φ.
        if sum * difference < GIMBAL_LOCK {
            let determined = if sum > difference {
                half_sum
            } else {
                half_difference
            };
            return Euler {
                pitch: within_half_turn(2.0 * determined),
                yaw,
                roll: 0.0,
            };
        }
        Euler {
            pitch: within_half_turn(half_sum + half_difference),
            yaw,
            roll: within_half_turn(half_sum - half_difference),
        }
    }

    /// Tip form, ν in [0, π]. An upright vehicle has azimuth zero and all turn in K.
    pub fn tip(&self) -> Tip {
        let b = self.matrix();
        // The centreline in ground axes is (sin Γ sin ν, −cos Γ sin ν, cos ν).
        let (east, north) = (b[(0, 2)], -b[(1, 2)]);
        let sine = hypot(east, north);
        let tip = atan2(sine, b[(2, 2)]);
        let azimuth = if sine < GIMBAL_LOCK {
            0.0
        } else {
            atan2(east, north)
        };
        let upright = Self::from_tip(Tip {
            tip,
            azimuth,
            nominal_roll: 0.0,
        });
        let roll = (upright.0.inverse() * self.0).to_rotation_matrix();
        Tip {
            tip,
            azimuth,
            nominal_roll: atan2(roll[(1, 0)], roll[(0, 0)]),
        }
    }
}

/// An angle between −2π and 2π, rad, brought into (−π, π].
fn within_half_turn(angle: f64) -> f64 {
    if angle > PI {
        angle - TAU
    } else if angle <= -PI {
        angle + TAU
    } else {
        angle
    }
}

/// The rotation by an angle (rad) about an axis.
fn turn(axis: &Unit<Vector3<f64>>, angle: f64) -> UnitQuaternion<f64> {
    let (sine, cosine) = sincos(0.5 * angle);
    UnitQuaternion::new_unchecked(Quaternion::from_parts(cosine, axis.as_ref() * sine))
}

impl Euler {
    /// Rates (Ψ̇, Φ̇, Ξ̇) for an angular velocity ω in vehicle axes, rad/s, or `None` where cos Φ vanishes and no
    /// finite rates exist.
    pub fn rates(&self, omega: [f64; 3]) -> Option<[f64; 3]> {
        let (sin_yaw, cos_yaw) = sincos(self.yaw);
        if cos_yaw.abs() < GIMBAL_LOCK {
            return None;
        }
        let (sin_roll, cos_roll) = sincos(self.roll);
        let pitch = (omega[0] * cos_roll - omega[1] * sin_roll) / cos_yaw;
        let yaw = omega[0] * sin_roll + omega[1] * cos_roll;
        Some([pitch, yaw, omega[2] - pitch * sin_yaw])
    }

    /// Angular velocity in vehicle axes, rad/s, for the rates (Ψ̇, Φ̇, Ξ̇).
    pub fn angular_velocity(&self, [pitch, yaw, roll]: [f64; 3]) -> [f64; 3] {
        let (sin_yaw, cos_yaw) = sincos(self.yaw);
        let (sin_roll, cos_roll) = sincos(self.roll);
        [
            cos_yaw * cos_roll * pitch + sin_roll * yaw,
            -cos_yaw * sin_roll * pitch + cos_roll * yaw,
            sin_yaw * pitch + roll,
        ]
    }
}
