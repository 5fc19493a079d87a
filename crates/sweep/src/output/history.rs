//! The history of a landing as a CSV table, written instant by instant.

use std::io::{self, Write};

use touchdown_dynamics::landing::Instant;
use touchdown_input::documents::history_columns::{names, values};
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

#[cfg(test)]
mod tests {
    use super::*;
    use touchdown_dynamics::attitude::{Attitude, Euler};
    use touchdown_dynamics::landing::{HingedPosture, LegInstant, LegPosture, LegWork};

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
