//! The scene of a run.

use touchdown_dynamics::attitude::{Attitude, Euler};

use crate::documents::input_error::InputError;

use super::Run;

impl Run {
    /// The scene as named numbers. Velocities come from the one of the report's three ways that the run selects.
    ///
    /// # Errors
    /// If the phase number is not 1, 2 or 3.
    pub fn scene(&self) -> Result<Vec<(&'static str, f64)>, InputError> {
        let [pitch, yaw, roll] = [2, 3, 4].map(|field| self.at(9, field));
        let phase = self.at(11, 3);
        let [mut x, mut y, mut z] = [2, 3, 4].map(|field| self.at(6, field));
        let (vertical, horizontal, cross_slope) = if phase == 2.0 {
            (self.at(11, 5), self.at(11, 4), self.at(9, 5))
        } else if phase == 1.0 || phase == 3.0 {
            if phase == 3.0 {
                let [pitch, yaw, roll] = [pitch, yaw, roll].map(f64::to_radians);
                let attitude = Attitude::from_euler(Euler { pitch, yaw, roll });
                let b = attitude.matrix();
                let turned = |row: usize| b[(row, 0)] * x + b[(row, 1)] * y + b[(row, 2)] * z;
                [x, y, z] = [turned(0), turned(1), turned(2)];
            }
            (z, libm::hypot(x, y), libm::atan2(-x, y).to_degrees())
        } else {
            return Err(InputError::value(
                "phase number (card 11)",
                phase,
                "1, 2 or 3",
            ));
        };
        Ok(vec![
            ("vertical_velocity_fps", vertical),
            ("horizontal_velocity_fps", horizontal),
            ("cross_slope_deg", cross_slope),
            ("slope_deg", self.at(9, 1)),
            ("friction", self.at(21, 1)),
            ("block_friction", self.at(21, 2)),
            ("pitch_deg", pitch),
            ("yaw_deg", yaw),
            ("roll_deg", roll),
            ("angular_velocity_x_dps", self.at(10, 1)),
            ("angular_velocity_y_dps", self.at(10, 2)),
            ("angular_velocity_z_dps", self.at(10, 3)),
        ])
    }
}
