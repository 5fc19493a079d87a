//! The history of a landing as a table: motion, loads and deformations, energies.

use std::io::{self, Write};

use touchdown_dynamics::landing::{Instant, LegInstant};
use touchdown_input::documents::column::Column;
use touchdown_input::documents::output_units::{OutputUnits, Quantity};

/// A history being written as CSV.
#[derive(Debug)]
pub struct History<W: Write> {
    writer: csv::Writer<W>,
    units: OutputUnits,
    /// Quantities of the columns, known from the first instant.
    quantities: Vec<Quantity>,
    written: Result<(), csv::Error>,
}

impl<W: Write> History<W> {
    /// An empty history.
    pub fn new(writer: W, units: OutputUnits) -> Self {
        Self {
            writer: csv::Writer::from_writer(writer),
            units,
            quantities: Vec::new(),
            written: Ok(()),
        }
    }

    /// Adds an instant.
    pub fn add(&mut self, instant: &Instant) {
        if self.written.is_ok() {
            self.written = self.write(instant);
        }
    }

    fn write(&mut self, instant: &Instant) -> Result<(), csv::Error> {
        if self.quantities.is_empty() {
            let names = names(instant);
            self.quantities = names.iter().map(|name| self.units.quantity(name)).collect();
            self.writer
                .write_record(self.quantities.iter().map(Quantity::name))?;
        }
        let values = self.quantities.iter().zip(values(instant));
        let values = values.map(|(quantity, value)| quantity.number(value).to_string());
        self.writer.write_record(values)
    }

    /// Ends the table; its writer.
    ///
    /// # Errors
    /// The first error of writing.
    pub fn end(self) -> io::Result<W> {
        self.written?;
        let ended = self.writer.into_inner();
        ended.map_err(csv::IntoInnerError::into_error)
    }
}

/// Columns of the body.
pub const OF_BODY: [Column<Instant>; 18] = [
    Column::number("t_s", |at| Some(at.time), "time after first contact"),
    Column::number(
        "x_ft",
        |at| Some(at.position.x),
        "CG, ground axis X (across the slope)",
    ),
    Column::number(
        "y_ft",
        |at| Some(at.position.y),
        "CG, ground axis Y (horizontal, into the slope: uphill)",
    ),
    Column::number(
        "z_ft",
        |at| Some(at.position.z),
        "CG, ground axis Z (down along gravity)",
    ),
    Column::number(
        "x_rate_fps",
        |at| Some(at.velocity.x),
        "velocity of the CG along X",
    ),
    Column::number(
        "y_rate_fps",
        |at| Some(at.velocity.y),
        "velocity of the CG along Y",
    ),
    Column::number(
        "z_rate_fps",
        |at| Some(at.velocity.z),
        "velocity of the CG along Z",
    ),
    Column::number(
        "pitch_deg",
        |at| Some(at.attitude.euler().pitch.to_degrees()),
        "pitch Ψ",
    ),
    Column::number(
        "yaw_deg",
        |at| Some(at.attitude.euler().yaw.to_degrees()),
        "yaw Φ",
    ),
    Column::number(
        "roll_deg",
        |at| Some(at.attitude.euler().roll.to_degrees()),
        "roll Ξ",
    ),
    Column::number(
        "angular_velocity_x_dps",
        |at| Some(at.angular_velocity.x.to_degrees()),
        "angular velocity about the vehicle's x axis",
    ),
    Column::number(
        "angular_velocity_y_dps",
        |at| Some(at.angular_velocity.y.to_degrees()),
        "angular velocity about the vehicle's y axis",
    ),
    Column::number(
        "angular_velocity_z_dps",
        |at| Some(at.angular_velocity.z.to_degrees()),
        "angular velocity about the vehicle's z axis (centreline)",
    ),
    Column::number(
        "sigma_deg",
        |at| Some(at.stability_angle.to_degrees()),
        "stability angle σ (79)",
    ),
    Column::number(
        "clearance_ft",
        |at| Some(at.clearance),
        "least height of the lower hardpoints over the surface",
    ),
    Column::number(
        "kinetic_energy_ftlb",
        |at| Some(at.kinetic_energy),
        "kinetic energy of body and lower links",
    ),
    Column::number(
        "potential_energy_change_ftlb",
        |at| Some(at.potential_change),
        "potential energy released since first contact",
    ),
    Column::number(
        "thrust_work_ftlb",
        |at| at.thrust_work,
        "work done by the thrust since first contact; only in scenes that have any",
    ),
];

/// Columns of each leg.
pub const OF_LEG: [Column<LegInstant>; 28] = [
    Column::number(
        "gamma_#_deg",
        |leg| leg.hinged().map(|posture| posture.link_angle.to_degrees()),
        "lower-link angle γ; grows as the strut extends",
    ),
    Column::number(
        "gamma_rate_#_dps",
        |leg| leg.hinged().map(|posture| posture.link_rate.to_degrees()),
        "its rate γ̇",
    ),
    Column::number(
        "alpha_#_deg",
        |leg| leg.hinged().map(|posture| posture.pad_angle.to_degrees()),
        "footpad angle α",
    ),
    Column::number(
        "alpha_rate_#_dps",
        |leg| leg.hinged().map(|posture| posture.pad_rate.to_degrees()),
        "its rate state α̇, which goes on integrating while the pad presses on a stop",
    ),
    Column::number(
        "foot_x_#_ft",
        |leg| leg.three_strut().map(|posture| posture.foot.x),
        "foot from the CG, along x of vehicle axes; legs of three struts only, as the next six",
    ),
    Column::number(
        "foot_y_#_ft",
        |leg| leg.three_strut().map(|posture| posture.foot.y),
        "the same along y",
    ),
    Column::number(
        "foot_z_#_ft",
        |leg| leg.three_strut().map(|posture| posture.foot.z),
        "the same along z (down the centreline)",
    ),
    Column::number(
        "stroke_a_#_ft",
        |leg| {
            leg.three_strut()
                .map(|posture| posture.secondary_strokes[0])
        },
        "stroke of the secondary strut at the lesser azimuth; shorter is positive",
    ),
    Column::number(
        "stroke_b_#_ft",
        |leg| {
            leg.three_strut()
                .map(|posture| posture.secondary_strokes[1])
        },
        "stroke of the other secondary strut",
    ),
    Column::number(
        "strut_force_a_#_lb",
        |leg| leg.three_strut().map(|posture| posture.secondary_forces[0]),
        "load of the secondary strut at the lesser azimuth, compression positive",
    ),
    Column::number(
        "strut_force_b_#_lb",
        |leg| leg.three_strut().map(|posture| posture.secondary_forces[1]),
        "load of the other secondary strut",
    ),
    Column::number(
        "stroke_#_ft",
        |leg| Some(leg.stroke),
        "strut stroke δ; of the primary strut of three",
    ),
    Column::number(
        "strut_force_#_lb",
        |leg| Some(leg.strut_force),
        "strut force F, compression positive; 0 off the surface and on the extension stop",
    ),
    Column::number(
        "pad_normal_#_lb",
        |leg| Some(leg.pad_normal),
        "normal force of the surface on the footpad",
    ),
    Column::number(
        "pad_friction_#_lb",
        |leg| Some(leg.pad_friction),
        "friction force on the footpad",
    ),
    Column::number(
        "block_normal_#_lb",
        |leg| Some(leg.block_normal),
        "normal force of the surface on the body block",
    ),
    Column::number(
        "block_friction_#_lb",
        |leg| Some(leg.block_friction),
        "friction force on the body block",
    ),
    Column::number(
        "pad_set_#_outboard_ft",
        |leg| Some(leg.pad_sets[0]),
        "plastic set P of the outboard pad section",
    ),
    Column::number(
        "pad_set_#_inboard_ft",
        |leg| Some(leg.pad_sets[1]),
        "plastic set P of the inboard pad section",
    ),
    Column::number(
        "pad_sinkage_#_ft",
        |leg| leg.sinkages.map(|sunk| sunk.pad[0].max(sunk.pad[1])),
        "greatest sinkage of the footpad so far; only in scenes on soil",
    ),
    Column::number(
        "block_set_#_ft",
        |leg| Some(leg.block_set),
        "plastic set P of the block",
    ),
    Column::number(
        "block_sinkage_#_ft",
        |leg| leg.sinkages.map(|sunk| sunk.block),
        "greatest sinkage of the block so far; only in scenes on soil",
    ),
    Column::number(
        "strut_work_#_ftlb",
        |leg| Some(leg.work.strut),
        "work done on the strut since first contact, what it stores included",
    ),
    Column::number(
        "pad_crush_work_#_ftlb",
        |leg| Some(leg.work.pad_crush),
        "work done on the footpad normal to the surface, what it stores included",
    ),
    Column::number(
        "pad_friction_work_#_ftlb",
        |leg| Some(leg.work.pad_friction),
        "work of sliding of the footpad",
    ),
    Column::number(
        "block_crush_work_#_ftlb",
        |leg| Some(leg.work.block_crush),
        "work done on the block normal to the surface",
    ),
    Column::number(
        "block_friction_work_#_ftlb",
        |leg| Some(leg.work.block_friction),
        "work of sliding of the block",
    ),
    Column::number(
        "stop_work_#_ftlb",
        |leg| Some(leg.work.stop),
        "energy of link motion that the extension stop ended, or that was frozen off the surface",
    ),
];

/// Names of the columns in program units: those of the body, then those of each leg.
pub fn names(instant: &Instant) -> Vec<String> {
    let of_body = OF_BODY
        .iter()
        .filter(|column| column.number_of(instant).is_some());
    let of_body = of_body.map(|column| column.name().to_owned());
    let legs = 1..=instant.legs.len();
    let of_legs = instant.legs.iter().zip(legs).flat_map(|(leg, number)| {
        let of_leg = OF_LEG.iter();
        let of_leg = of_leg.filter(|column| column.number_of(leg).is_some());
        of_leg.map(move |column| column.name_of_leg(number))
    });
    of_body.chain(of_legs).collect()
}

/// Their values in program units.
pub fn values(instant: &Instant) -> Vec<f64> {
    let of_body = OF_BODY
        .iter()
        .filter_map(|column| column.number_of(instant));
    let of_leg = |leg| {
        OF_LEG
            .iter()
            .filter_map(move |column| column.number_of(leg))
    };
    let of_legs = instant.legs.iter().flat_map(of_leg);
    of_body.chain(of_legs).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use touchdown_dynamics::attitude::{Attitude, Euler};
    use touchdown_dynamics::landing::{HingedPosture, LegPosture, LegWork};

    #[test]
    fn headings_carry_units_and_leg_numbers() {
        let leg = LegInstant {
            posture: LegPosture::Hinged(HingedPosture {
                link_angle: 0.0,
                link_rate: 0.0,
                pad_angle: 0.0,
                pad_rate: 0.0,
            }),
            stroke: 0.125,
            strut_force: 185.0,
            pad_normal: 0.0,
            pad_friction: 0.0,
            block_normal: 0.0,
            block_friction: 0.0,
            pad_sets: [0.0625, 0.0],
            sinkages: None,
            block_set: 0.0,
            work: LegWork::default(),
        };
        let attitude = Attitude::from_euler(Euler {
            pitch: 0.0,
            yaw: 0.0,
            roll: 0.0,
        });
        let instant = Instant {
            time: 0.5,
            position: Default::default(),
            velocity: Default::default(),
            attitude,
            angular_velocity: Default::default(),
            stability_angle: 0.0,
            clearance: 1.0,
            kinetic_energy: 2.0,
            potential_change: 3.0,
            thrust_work: None,
            legs: [leg; 3].into(),
        };
        let written = |units| {
            let mut history = History::new(Vec::new(), units);
            history.add(&instant);
            history.add(&instant);
            String::from_utf8(history.end().unwrap()).unwrap()
        };
        let si = written(OutputUnits::Si);
        assert!(si.starts_with("t_s,x_m,y_m,z_m,x_rate_mps"), "{si}");
        assert!(si.contains(",stroke_1_m,strut_force_1_n,") && si.contains(",stop_work_3_j\n"));
        assert!(si.contains(",0.0381,822.9209988231925,"), "{si}");
        let text = written(OutputUnits::Us);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 3);
        assert!(lines[0].starts_with("t_s,x_ft,y_ft,z_ft,x_rate_fps"));
        assert!(lines[0].contains("pad_set_2_outboard_ft"));
        assert_eq!(lines[0].split(',').count(), 17 + 3 * 19);
        assert_eq!(lines[1].split(',').count(), 17 + 3 * 19);
        assert!(lines[1].starts_with("0.5,0,0,0"));
        let mut history = History::new(Vec::new(), OutputUnits::Si);
        let thrust_work = Some(-2.0);
        let under_thrust = Instant {
            thrust_work,
            ..instant
        };
        history.add(&under_thrust);
        let text = String::from_utf8(history.end().unwrap()).unwrap();
        assert!(text.contains(",potential_energy_change_j,thrust_work_j,gamma_1_deg,"));
        assert!(text.contains(",-2.711635896"), "{text}");
    }
}
