//! A run in the terms of this program: its vehicle as a file, its scene as named numbers.

use touchdown_dynamics::attitude::{Attitude, Euler};

use crate::documents::input_error::InputError;

use super::{Deck, LEGS, Run};

impl Deck {
    /// Writes the vehicle of a run as a vehicle file of this program.
    pub fn vehicle(&self, run: &Run, name: &str) -> String {
        let at = |card, field| run.at(card, field);
        let [pads, blocks, struts] = &self.tables;
        let mut text = format!(
            "# Converted from a card deck of the 1966 program.\nname = {name:?}\nrules = \"1966\"\n\
             mass_slug = {}\ngravity_fps2 = {}\ncenter_of_gravity_height_ft = {}\n\n\
             [inertia_slug_ft2]\nxx = {}\nyy = {}\nzz = {}\nxy = {}\nxz = {}\nyz = {}\n\n\
             [linkage]\nlower_hardpoint_radius_ft = {}\nlower_link_length_ft = {}\n\
             hardpoint_distance_ft = {}\nhardpoint_angle_deg = {}\ninertia_slug_ft2 = {}\n\n",
            at(1, 1),
            at(3, 4),
            at(2, 5),
            at(1, 2),
            at(1, 3),
            at(1, 4),
            at(1, 5),
            at(2, 1),
            at(2, 2),
            at(3, 1),
            at(3, 2),
            at(3, 3),
            at(4, 4),
            at(5, 3),
        );
        text += &format!(
            "[strut]\nextended_length_ft = {}\nminimum_length_ft = {}\n\
             structural_stiffness_lb_per_ft = {}\nfriction_fraction = {}\n\n\
             [footpad]\ndiameter_ft = {}\nheight_ft = {}\ninertia_slug_ft2 = {}\n\
             minimum_angle_deg = {}\nmaximum_angle_deg = {}\n\n\
             [block]\nradius_ft = {}\nheight_ft = {}\ndiameter_ft = {}\n",
            at(2, 4),
            at(7, 2),
            at(7, 3),
            at(7, 1),
            at(6, 1),
            at(5, 4),
            at(5, 2),
            at(3, 5),
            at(4, 1),
            at(4, 5),
            at(5, 1),
            at(5, 5),
        );
        // Data that the deck gives leg by leg.
        let per_leg = |cards: [(usize, usize); LEGS], leg: usize| at(cards[leg].0, cards[leg].1);
        for leg in 0..LEGS {
            let value = |cards| per_leg(cards, leg);
            text += &format!(
                "\n[[legs]]\nazimuth_deg = {}\n\n[legs.strut]\npreload_lb = {}\n\
                 spring_constant_lb_per_ft = {}\ncompression_damping = {}\nrebound_damping = {}\n\
                 rebound_growth_per_ft = {}\n",
                at(8, leg + 1),
                value([(18, 1), (18, 2), (18, 3)]),
                value([(17, 3), (17, 4), (17, 5)]),
                value([(16, 5), (17, 1), (17, 2)]),
                value([(18, 4), (18, 5), (19, 1)]),
                value([(19, 2), (19, 3), (19, 4)]),
            );
            if let Some(table) = &struts[leg] {
                for (profile, ordinates) in ["spring_profile", "damping_profile"]
                    .iter()
                    .zip(&table.ordinates)
                {
                    text += &format!(
                        "\n[legs.strut.{profile}]\nstroke_in = {:?}\nmultiplier = {ordinates:?}\n",
                        table.abscissas
                    );
                }
            }
            for (element, tables, cards) in [
                ("footpad", pads, [(20, 3), (20, 4), (20, 5)]),
                ("block", blocks, [(19, 5), (20, 1), (20, 2)]),
            ] {
                text += &format!(
                    "\n[legs.{element}]\ncrush_pressure_psf = {}\n",
                    value(cards)
                );
                if let Some(table) = &tables[leg] {
                    text += &format!(
                        "\n[legs.{element}.profile]\ninterference_in = {:?}\n\
                         relative_pressure = {:?}\n",
                        table.abscissas, table.ordinates[0]
                    );
                }
            }
        }
        text
    }
}

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
