//! Touchdown conditions on the command line.

use clap::Args;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_sweep::assignment::{self, Assignment};
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::parameter::Parameter;
use touchdown_sweep::scene_input::{NamedConditions, SceneFault};

/// The conditions of a single touchdown.
#[derive(Debug, Args)]
#[command(next_help_heading = "Touchdown")]
pub struct TouchdownOptions {
    /// Downward velocity V_V of the CG
    #[arg(long, value_name = "FT/S", value_parser = finite, allow_hyphen_values = true)]
    vertical_velocity: Option<f64>,
    /// The same in m/s
    #[arg(long, value_name = "M/S", value_parser = finite, allow_hyphen_values = true,
          conflicts_with = "vertical_velocity")]
    vertical_velocity_mps: Option<f64>,
    /// Horizontal velocity V_H of the CG
    #[arg(long, value_name = "FT/S", value_parser = finite, allow_hyphen_values = true)]
    horizontal_velocity: Option<f64>,
    /// The same in m/s
    #[arg(long, value_name = "M/S", value_parser = finite, allow_hyphen_values = true,
          conflicts_with = "horizontal_velocity")]
    horizontal_velocity_mps: Option<f64>,
    /// Direction of the horizontal velocity across the slope: 180 is straight downhill, 0 uphill
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    cross_slope: Option<f64>,
    /// Slope of the surface, between -90 and 90
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    slope: Option<f64>,
    /// Friction coefficient between surface and footpads
    #[arg(long, value_name = "MU", value_parser = finite, allow_hyphen_values = true)]
    friction: Option<f64>,
    /// Friction coefficient between surface and body blocks [default: that of the footpads]
    #[arg(long, value_name = "MU", value_parser = finite, allow_hyphen_values = true)]
    block_friction: Option<f64>,
    /// Pitch angle, about the horizontal axis across the slope [default: 0]
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    pitch: Option<f64>,
    /// Yaw angle, about the vehicle's y axis after pitch [default: 0]
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    yaw: Option<f64>,
    /// Roll angle, about the vehicle's centreline [default: 0]
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    roll: Option<f64>,
    /// Angle between centreline and vertical; replaces --pitch, --yaw and --roll
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    tip: Option<f64>,
    /// Azimuth of the axis about which the vehicle is tipped, with --tip
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    tip_azimuth: Option<f64>,
    /// Roll about the centreline before tipping, with --tip [default: 0]
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    nominal_roll: Option<f64>,
    /// Angular velocity about the vehicle's axes x, y and z, deg/s [default: 0,0,0]
    #[arg(long, value_name = "X,Y,Z", value_parser = triple, allow_hyphen_values = true)]
    angular_velocity: Option<[f64; 3]>,
}

impl TouchdownOptions {
    /// The conditions by name.
    pub fn named(&self) -> NamedConditions {
        let [x, y, z] = match self.angular_velocity {
            Some(rates) => rates.map(Some),
            None => [None; 3],
        };
        let given = [
            ("vertical_velocity_fps", self.vertical_velocity),
            ("horizontal_velocity_fps", self.horizontal_velocity),
            ("cross_slope_deg", self.cross_slope),
            ("slope_deg", self.slope),
            ("friction", self.friction),
            ("block_friction", self.block_friction),
            ("pitch_deg", self.pitch),
            ("yaw_deg", self.yaw),
            ("roll_deg", self.roll),
            ("tip_deg", self.tip),
            ("tip_azimuth_deg", self.tip_azimuth),
            ("nominal_roll_deg", self.nominal_roll),
            ("angular_velocity_x_dps", x),
            ("angular_velocity_y_dps", y),
            ("angular_velocity_z_dps", z),
        ];
        let given = given.into_iter();
        let mut conditions =
            NamedConditions::of(given.filter_map(|(name, value)| Some((name, value?))));
        for (parameter, value) in self.in_si() {
            conditions.set(parameter.program_name(), parameter.to_program(value));
        }
        conditions
    }

    /// What is given in SI units.
    fn in_si(&self) -> impl Iterator<Item = (Parameter, f64)> {
        let given = [
            ("vertical_velocity_mps", self.vertical_velocity_mps),
            ("horizontal_velocity_mps", self.horizontal_velocity_mps),
        ];
        let parameter = |name| Parameter::named(name, MOST_LEGS);
        (given.into_iter()).filter_map(move |(name, value)| Some((parameter(name)?, value?)))
    }

    /// The conditions by name, with those that `--set` gives.
    pub fn with(&self, set: &[Assignment]) -> Result<NamedConditions, InputError> {
        let mut conditions = self.named();
        for one in set {
            let name = one.parameter().program_name();
            if conditions.get(name).is_some() {
                return Err(one.refuse(&format!(
                    "{} is given too: expected one of them",
                    option_of(name)
                )));
            }
        }
        assignment::set_conditions(&mut conditions, set);
        Ok(conditions)
    }

    /// The scene of the conditions for a vehicle and settings, with complaints in the words of the command line.
    pub fn scene(
        &self,
        conditions: &NamedConditions,
        set: &[Assignment],
        vehicle: &Vehicle,
        settings: &Settings,
    ) -> Result<Scene, InputError> {
        conditions.scene_for(vehicle, settings).map_err(
            |SceneFault {
                 name,
                 value,
                 allowed,
             }| {
                if let Some(one) = set
                    .iter()
                    .find(|one| one.parameter().program_name() == name)
                {
                    return one.refuse_value(&allowed);
                }
                let mut in_si = self.in_si();
                if let Some((parameter, value)) =
                    in_si.find(|(parameter, _)| parameter.program_name() == name)
                {
                    let option = option_of(parameter.name());
                    return InputError::value(&option, value, &parameter.explain(&allowed, value));
                }
                let option = option_of(name);
                match value {
                    Some(value) => InputError::value(&option, value, &in_options(&allowed)),
                    None => InputError::missing(&option, &allowed),
                }
            },
        )
    }
}

/// The option that gives a condition: its name without the unit of the program. Dotted names are of the vehicle, and no options.
fn option_of(name: &str) -> String {
    if name.contains('.') {
        return name.to_owned();
    }
    let bare = ["_fps", "_deg", "_x_dps", "_y_dps", "_z_dps"]
        .into_iter()
        .find_map(|unit| name.strip_suffix(unit))
        .unwrap_or(name);
    format!("--{}", bare.replace('_', "-"))
}

/// A complaint with the names of angles turned into options.
fn in_options(allowed: &str) -> String {
    allowed
        .split(' ')
        .map(|word| match word.trim_end_matches(',') {
            name if name.ends_with("_deg") => word.replace(name, &option_of(name)),
            _ => word.to_owned(),
        })
        .collect::<Vec<_>>()
        .join(" ")
}

/// A number that is neither infinite nor undefined.
pub fn finite(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err("expected a finite number".to_owned()),
    }
}

/// Three numbers separated by commas.
pub fn triple(text: &str) -> Result<[f64; 3], String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map(|part| finite(part.trim()))
        .collect::<Result<_, _>>()
        .map_err(|_| "expected three finite numbers x,y,z".to_owned())?;
    numbers
        .try_into()
        .map_err(|_| "expected three finite numbers x,y,z".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conditions_are_named_as_their_options() {
        assert_eq!(option_of("tip_azimuth_deg"), "--tip-azimuth");
        assert_eq!(option_of("friction"), "--friction");
        let edge = "vehicle.footpad.edge_load_lb";
        assert_eq!(option_of(edge), edge);
        assert_eq!(option_of("angular_velocity_y_dps"), "--angular-velocity");
        let allowed = in_options("either pitch_deg, yaw_deg or tip_deg, not both");
        assert_eq!(allowed, "either --pitch, --yaw or --tip, not both");
    }

    #[test]
    fn triples_are_three_finite_numbers() {
        assert_eq!(triple("-1,2.5, 3"), Ok([-1.0, 2.5, 3.0]));
        assert!(triple("1,2").is_err());
        assert!(triple("1,2,nan").is_err());
    }
}
