//! The history of a landing as a table: motion, loads and deformations, energies.

use touchdown_dynamics::landing::{Instant, LegInstant};

use crate::output_units::{OutputUnits, Quantity};

/// A history being written.
#[derive(Debug)]
pub struct History {
    writer: csv::Writer<Vec<u8>>,
    units: OutputUnits,
    /// Quantities of the columns, known from the first instant.
    quantities: Vec<Quantity>,
    written: Result<(), csv::Error>,
}

impl History {
    /// An empty history.
    pub fn new(units: OutputUnits) -> Self {
        Self {
            writer: csv::Writer::from_writer(Vec::new()),
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
        let columns = columns(instant);
        if self.quantities.is_empty() {
            let names = columns.iter().map(|(name, _)| name);
            self.quantities = names.map(|name| self.units.quantity(name)).collect();
            self.writer
                .write_record(self.quantities.iter().map(Quantity::name))?;
        }
        let values = self.quantities.iter().zip(&columns);
        let values = values.map(|(quantity, (_, value))| quantity.number(*value).to_string());
        self.writer.write_record(values)
    }

    /// The table as CSV.
    ///
    /// # Errors
    /// Only out of memory.
    pub fn table(self) -> Result<Vec<u8>, csv::Error> {
        self.written?;
        self.writer
            .into_inner()
            .map_err(|error| error.into_error().into())
    }
}

/// Headings and values in program units.
pub fn columns(instant: &Instant) -> Vec<(String, f64)> {
    let euler = instant.attitude.euler();
    let [position, velocity, rate] = [
        &instant.position,
        &instant.velocity,
        &instant.angular_velocity,
    ];
    let body = [
        ("t_s", instant.time),
        ("x_ft", position.x),
        ("y_ft", position.y),
        ("z_ft", position.z),
        ("x_rate_fps", velocity.x),
        ("y_rate_fps", velocity.y),
        ("z_rate_fps", velocity.z),
        ("psi_deg", euler.pitch.to_degrees()),
        ("phi_deg", euler.yaw.to_degrees()),
        ("xi_deg", euler.roll.to_degrees()),
        ("omega_x_dps", rate.x.to_degrees()),
        ("omega_y_dps", rate.y.to_degrees()),
        ("omega_z_dps", rate.z.to_degrees()),
        ("sigma_deg", instant.stability_angle.to_degrees()),
        ("clearance_ft", instant.clearance),
        ("kinetic_energy_ftlb", instant.kinetic_energy),
        ("potential_energy_change_ftlb", instant.potential_change),
    ];
    let thrust = (instant.thrust_work).map(|work| ("thrust_work_ftlb", work));
    let mut columns: Vec<(String, f64)> = (body.into_iter().chain(thrust))
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    for (index, leg) in instant.legs.iter().enumerate() {
        columns.extend(leg_columns(index + 1, leg));
    }
    columns
}

fn leg_columns(number: usize, leg: &LegInstant) -> impl Iterator<Item = (String, f64)> {
    let work = &leg.work;
    [
        ("gamma_#_deg", leg.link_angle.to_degrees()),
        ("gamma_rate_#_dps", leg.link_rate.to_degrees()),
        ("alpha_#_deg", leg.pad_angle.to_degrees()),
        ("alpha_rate_#_dps", leg.pad_rate.to_degrees()),
        ("stroke_#_ft", leg.stroke),
        ("strut_force_#_lb", leg.strut_force),
        ("pad_normal_#_lb", leg.pad_normal),
        ("pad_friction_#_lb", leg.pad_friction),
        ("block_normal_#_lb", leg.block_normal),
        ("block_friction_#_lb", leg.block_friction),
        ("pad_set_#_outboard_ft", leg.pad_sets[0]),
        ("pad_set_#_inboard_ft", leg.pad_sets[1]),
        ("block_set_#_ft", leg.block_set),
        ("strut_work_#_ftlb", work.strut),
        ("pad_crush_work_#_ftlb", work.pad_crush),
        ("pad_friction_work_#_ftlb", work.pad_friction),
        ("block_crush_work_#_ftlb", work.block_crush),
        ("block_friction_work_#_ftlb", work.block_friction),
        ("stop_work_#_ftlb", work.stop),
    ]
    .into_iter()
    .map(move |(name, value)| (name.replace('#', &number.to_string()), value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use touchdown_dynamics::attitude::{Attitude, Euler};
    use touchdown_dynamics::landing::LegWork;

    #[test]
    fn headings_carry_units_and_leg_numbers() {
        let leg = LegInstant {
            link_angle: 0.0,
            link_rate: 0.0,
            pad_angle: 0.0,
            pad_rate: 0.0,
            stroke: 0.125,
            strut_force: 185.0,
            pad_normal: 0.0,
            pad_friction: 0.0,
            block_normal: 0.0,
            block_friction: 0.0,
            pad_sets: [0.0625, 0.0],
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
            let mut history = History::new(units);
            history.add(&instant);
            history.add(&instant);
            String::from_utf8(history.table().unwrap()).unwrap()
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
        let mut history = History::new(OutputUnits::Si);
        let thrust_work = Some(-2.0);
        let under_thrust = Instant {
            thrust_work,
            ..instant
        };
        history.add(&under_thrust);
        let text = String::from_utf8(history.table().unwrap()).unwrap();
        assert!(text.contains(",potential_energy_change_j,thrust_work_j,gamma_1_deg,"));
        assert!(text.contains(",-2.711635896"), "{text}");
    }
}
