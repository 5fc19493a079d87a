//! Touchdown conditions on the command line.

use clap::builder::{PossibleValuesParser, ValueParser};
use clap::{Arg, ArgGroup, ArgMatches, Args, Command, FromArgMatches};
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantities::{
    ANGULAR_VELOCITY_X, ANGULAR_VELOCITY_Y, ANGULAR_VELOCITY_Z, CONDITIONS,
};
use touchdown_dynamics::quantity::{IfMissing, Quantity};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::documents::unit::{unit, without_program_unit};
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::points::parameter::Parameter;
use touchdown_input::readers::scene_input::{NamedConditions, SceneFault, soil_names};

/// The conditions of a single touchdown: an option for each in the catalogue, and one in SI where results in SI have
/// another unit.
#[derive(Debug)]
pub struct TouchdownOptions {
    /// What is given, in its unit.
    given: Vec<(Parameter, f64)>,
    /// Name of the soil.
    soil: Option<String>,
}

/// Angular velocities, which one option gives.
const RATES: [&Quantity; 3] = [
    &ANGULAR_VELOCITY_X,
    &ANGULAR_VELOCITY_Y,
    &ANGULAR_VELOCITY_Z,
];
const RATES_OPTION: &str = "angular-velocity";
const SOIL_OPTION: &str = "soil";

/// The conditions that have an option for themselves.
fn single() -> impl Iterator<Item = &'static Quantity> {
    let is_rate = |quantity: &&Quantity| RATES.iter().any(|rate| rate.key == quantity.key);
    CONDITIONS.iter().filter(move |quantity| !is_rate(quantity))
}

/// Names of a condition in the unit of the program and in SI, if that is another.
fn names(quantity: &Quantity) -> impl Iterator<Item = String> {
    let in_si = OutputUnits::Si.quantity(quantity.key).name().to_owned();
    let is_other = in_si != quantity.key;
    std::iter::once(quantity.key.to_owned()).chain(is_other.then_some(in_si))
}

/// The option of a condition, under a name in the unit of the program or in SI.
fn argument(quantity: &Quantity, name: String) -> Arg {
    let option = option_of(&name).trim_start_matches('-').to_owned();
    let value_name = match unit(&name) {
        "1" => "NUMBER".to_owned(),
        unit => unit.to_uppercase(),
    };
    let argument = Arg::new(name.clone())
        .long(option)
        .value_name(value_name)
        .value_parser(finite)
        .allow_hyphen_values(true);
    match name == quantity.key {
        true => argument.help(help(quantity)),
        false => argument
            .help(format!("The same in {}", unit(&name)))
            .conflicts_with(quantity.key),
    }
}

/// Meaning, range and default of a condition.
fn help(quantity: &Quantity) -> String {
    let mut letters = quantity.meaning.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let meaning: String = first.chain(letters).collect();
    // A range that nobody comes near says nothing here.
    const WIDE: f64 = 1e4;
    let range = (quantity.range.upper < WIDE).then(|| quantity.range.to_string());
    let default = match quantity.if_missing {
        IfMissing::Required => None,
        IfMissing::Number(number) => Some(format!("default: {number}")),
        IfMissing::Words(words) => Some(format!("default: {}", words.replace('`', ""))),
    };
    let notes: Vec<String> = range.into_iter().chain(default).collect();
    match notes.is_empty() {
        true => meaning,
        false => format!("{meaning} [{}]", notes.join("; ")),
    }
}

impl Args for TouchdownOptions {
    fn group_id() -> Option<clap::Id> {
        Some("TouchdownOptions".into())
    }

    fn augment_args(command: Command) -> Command {
        let single =
            single().flat_map(|quantity| names(quantity).map(move |name| argument(quantity, name)));
        let rates = Arg::new(RATES_OPTION)
            .long(RATES_OPTION)
            .value_name("X,Y,Z")
            .value_parser(ValueParser::from(triple))
            .allow_hyphen_values(true)
            .help("Angular velocity about the vehicle's axes x, y and z, deg/s [default: 0,0,0]");
        let soil = Arg::new(SOIL_OPTION)
            .long(SOIL_OPTION)
            .value_name("NAME")
            .value_parser(PossibleValuesParser::new(soil_names()))
            .help("Soil under footpads and blocks, of a landing site on the Moon [default: rock]");
        let arguments: Vec<Arg> = single.chain([rates, soil]).collect();
        let names: Vec<_> = arguments.iter().map(|one| one.get_id().clone()).collect();
        let group = ArgGroup::new("TouchdownOptions").multiple(true).args(names);
        command
            .next_help_heading("Touchdown")
            .args(arguments)
            .group(group)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for TouchdownOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let single = single().flat_map(names).filter_map(|name| {
            let value = *matches.get_one::<f64>(&name)?;
            Some((Parameter::named(&name, MOST_LEGS)?, value))
        });
        let rates = matches.get_one::<[f64; 3]>(RATES_OPTION).copied();
        let rates = RATES.iter().zip(rates.into_iter().flatten());
        let rates =
            rates.filter_map(|(rate, value)| Some((Parameter::named(rate.key, MOST_LEGS)?, value)));
        Ok(Self {
            given: single.chain(rates).collect(),
            soil: matches.get_one(SOIL_OPTION).cloned(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl TouchdownOptions {
    /// The conditions by name.
    pub fn named(&self) -> NamedConditions {
        let mut conditions = NamedConditions::default();
        if let Some(soil) = &self.soil {
            conditions.set_soil(soil);
        }
        for (parameter, value) in &self.given {
            conditions.set(parameter.program_name(), parameter.to_program(*value));
        }
        conditions
    }

    /// The conditions by name, with those that `--set` gives.
    pub fn with(&self, set: &[Assignment]) -> Result<NamedConditions, InputError> {
        let mut conditions = self.named();
        for one in set {
            let name = one.parameter().program_name();
            let mut given = self.given.iter();
            if given.any(|(parameter, _)| parameter.program_name() == name) {
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
                let allowed = in_options(&allowed);
                let mut given = self.given.iter();
                match given.find(|(parameter, _)| parameter.program_name() == name) {
                    Some((parameter, value)) => {
                        let allowed = parameter.explain(&allowed, *value);
                        InputError::value(&option_of(parameter.name()), value, &allowed)
                    }
                    None => match value {
                        Some(value) => InputError::value(&option_of(name), value, &allowed),
                        None => InputError::missing(&option_of(name), &allowed),
                    },
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
    if RATES.iter().any(|rate| rate.key == name) {
        return format!("--{RATES_OPTION}");
    }
    format!("--{}", without_program_unit(name).replace('_', "-"))
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
