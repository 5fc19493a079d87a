//! Thrust after first contact: the table [scene.thrust], and axes such as `thrust.scale`.

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::quantities::{self, CONDITIONS};
use touchdown_dynamics::thrust::Thrust;

use super::{NamedConditions, SceneFault, conditions};
use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};
use crate::readers::numbers::{joined, keys_of};

/// The table of thrust, and its keys.
pub(crate) const THRUST: &str = "thrust";
pub(crate) const THRUST_KEYS: [&str; 5] = joined(&[&KNOTS, &NUMBER_KEYS]);
const KNOTS: [&str; 2] = ["time_s", "force_lb"];
const NUMBER_KEYS: [&str; 3] = keys_of(quantities::THRUST);
/// Defaults of the numbers, in their order.
const DEFAULTS: [f64; 3] = [
    quantities::THRUST_SCALE.default_number().unwrap(),
    quantities::THRUST_OFFSET_X.default_number().unwrap(),
    quantities::THRUST_OFFSET_Y.default_number().unwrap(),
];
/// Name of the condition that scales the forces.
pub(super) const SCALE: &str = "thrust.scale";
const NUMBERS: &str = "a list of numbers";

/// Names of the conditions of thrust, in the order of [`NUMBER_KEYS`].
fn names() -> [&'static str; NUMBER_KEYS.len()] {
    std::array::from_fn(|index| conditions(0)[CONDITIONS.len() + index].name.as_str())
}

/// Finds one of these numbers in a table [scene].
pub(super) fn find<'d>(scene: &Section<'d>, name: &str) -> Option<LocatedValue<'d>> {
    let key = name.strip_prefix("thrust.")?;
    let thrust = scene.optional_section(THRUST, &THRUST_KEYS).ok()??;
    thrust.optional(key)
}

impl NamedConditions {
    pub(super) fn read_thrust(&mut self, scene: &Section) -> Result<(), InputError> {
        let Some(thrust) = scene.optional_section(THRUST, &THRUST_KEYS)? else {
            return Ok(());
        };
        let column = |key: &str| -> Result<Vec<f64>, InputError> {
            let items = thrust.value(key, NUMBERS)?.items(NUMBERS)?;
            items.iter().map(LocatedValue::number).collect()
        };
        let (times, forces) = (column("time_s")?, column("force_lb")?);
        let list = thrust.value("force_lb", NUMBERS)?;
        if times.len() != forces.len() {
            let (forces, times) = (forces.len(), times.len());
            return Err(list.complain_that(&format!(
                "{forces} numbers: expected as many as in time_s, {times}"
            )));
        }
        let knots: Vec<[f64; 2]> = times.iter().zip(forces).map(|(t, f)| [*t, f]).collect();
        Thrust::new(&knots, [0.0; 2]).map_err(|invalid| {
            let key = invalid.quantity.strip_prefix("thrust.").unwrap_or("time_s");
            thrust.complain(&Invalid::new(key, invalid.value, invalid.allowed))
        })?;
        self.thrust.0[..knots.len()].copy_from_slice(&knots);
        self.thrust.1 = knots.len();
        for (key, name) in NUMBER_KEYS.iter().zip(names()) {
            if let Some(value) = thrust.optional_number(key)? {
                self.set(name, value);
            }
        }
        Ok(())
    }

    /// Knots of the thrust: time, s, and force, lb.
    pub fn thrust_knots(&self) -> &[[f64; 2]] {
        &self.thrust.0[..self.thrust.1]
    }

    /// Thrust with scale and offset applied.
    pub(super) fn thrust(&self) -> Result<Thrust, SceneFault> {
        let number = |name: &'static str, default: f64| match self.get(name) {
            Some(value) if self.thrust.1 == 0 => Err(SceneFault {
                name,
                value: Some(value.into()),
                allowed: "a table [scene.thrust] with time_s and force_lb".to_owned(),
            }),
            Some(_) => self.need(name),
            None => Ok(default),
        };
        let [scale, x, y] = names();
        let [by_default, x_by_default, y_by_default] = DEFAULTS;
        let factor = number(scale, by_default)?;
        let offset = [number(x, x_by_default)?, number(y, y_by_default)?];
        if self.thrust.1 == 0 {
            return Ok(Thrust::default());
        }
        let scaled = self.thrust_knots().iter().map(|[t, f]| [*t, factor * f]);
        let knots: Vec<[f64; 2]> = scaled.collect();
        Thrust::new(&knots, offset).map_err(|invalid| {
            let offset = [x, y].into_iter().find(|name| *name == invalid.quantity);
            match offset {
                Some(name) => SceneFault {
                    name,
                    value: Some(invalid.value.into()),
                    allowed: invalid.allowed,
                },
                None => SceneFault {
                    name: scale,
                    value: Some(self.get(scale).unwrap_or(invalid.value).into()),
                    allowed: format!("{} (the forces times the scale)", invalid.allowed),
                },
            }
        })
    }
}
