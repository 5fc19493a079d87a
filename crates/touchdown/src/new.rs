//! `touchdown new`: commented files to start from.

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::builder::PossibleValue;
use clap::{Args, Subcommand, ValueEnum};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;

use crate::options::units;
use crate::terminal::{Failure, print};

const SURVEYOR: &str = include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml");
const SURVEYOR_SI: &str = include_str!("../../../sweeps/vehicles/surveyor-si.toml");
/// The lander on honeycomb struts, in SI.
const HONEYCOMB: &str = include_str!("../../../sweeps/vehicles/four-legs.toml");
/// The lander on legs of three struts that meet at the foot, in SI.
const TRIPOD: &str = include_str!("new/tripod.toml");
/// The lander on legs with a collar, in SI.
const CANTILEVER: &str = include_str!("../../../sweeps/vehicles/apollo-like.toml");
const SWEEP: &str = include_str!("new/sweep.toml");
const SWEEP_SI: &str = include_str!("new/sweep-si.toml");
const SCENE: &str = include_str!("new/scene.toml");
const SCENE_SI: &str = include_str!("new/scene-si.toml");
/// Rules of the Surveyor, and those of a lander of one's own.
const RULES: [&str; 2] = ["rules = \"1966\"    ", "rules = \"physical\""];
/// The first leg of the templates of vehicles, which end with their legs.
const FIRST_LEG: &str = "[[legs]]\n";
/// Placeholder of the templates for the path of the vehicle file.
const VEHICLE_PATH: &str = "VEHICLE";

const EXAMPLES: &str = "\
Examples:
  A vehicle of your own, and a sweep of it:
    touchdown new vehicle lander.toml
    touchdown new sweep trade.toml
    touchdown sweep trade.toml --out results

  A lander with six legs on honeycomb struts:
    touchdown new vehicle lander.toml --kind honeycomb --legs 6

  A lander with three legs of three struts:
    touchdown new vehicle lander.toml --kind tripod

  A sweep of an existing vehicle:
    touchdown new sweep trade.toml --vehicle sweeps/vehicles/surveyor-table-4-1.toml";

/// Options of `new`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    #[command(subcommand)]
    kind: Kind,
}

#[derive(Debug, Subcommand)]
enum Kind {
    /// A vehicle file: the Surveyor, or a lander on honeycomb struts or on legs of three struts, with an explanation of each number
    Vehicle(NewVehicle),
    /// A sweep file: V_H over roll and cross-slope
    Sweep(NamesVehicle),
    /// A scene file: a touchdown and two cases that differ from it
    Scene(NamesVehicle),
}

#[derive(Debug, Args)]
struct NewVehicle {
    /// File to write; an existing file is not replaced
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,
    /// Struts or legs
    #[arg(long, value_enum, default_value = "damper")]
    kind: VehicleKind,
    /// Number of legs, at even angles [default: 3 with damper and tripod, 4 with honeycomb and cantilever]
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u8).range(3..=8))]
    legs: Option<u8>,
    /// Units of the file; the keys of either may be mixed [default: US with damper, SI with all others]
    #[arg(long, value_parser = units(), ignore_case = true)]
    units: Option<OutputUnits>,
}

/// Kinds of a new vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum VehicleKind {
    /// Hinged legs with the Surveyor's shock absorbers: spring and damping
    Damper,
    /// Hinged legs with honeycomb that crushes, described in SI
    Honeycomb,
    /// Legs of three struts that meet at the foot, described in SI
    Tripod,
    /// Legs of three struts, two of which end at a collar of the third, described in SI
    Cantilever,
}

#[derive(Debug, Args)]
struct NewFile {
    /// File to write; an existing file is not replaced
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,
    /// Units of the file; the keys of either may be mixed
    #[arg(long, value_parser = units(), default_value = "US", ignore_case = true)]
    units: OutputUnits,
}

#[derive(Debug, Args)]
struct NamesVehicle {
    #[command(flatten)]
    new: NewFile,
    /// Path of the vehicle file, relative to the new file
    #[arg(long, value_name = "FILE", default_value = "lander.toml")]
    vehicle: String,
}

/// Runs `new`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let (named, us, si) = match &options.kind {
        Kind::Vehicle(new) => return write(&new.file, &vehicle(new)?),
        Kind::Sweep(named) => (named, SWEEP, SWEEP_SI),
        Kind::Scene(named) => (named, SCENE, SCENE_SI),
    };
    let template = match named.new.units {
        OutputUnits::Us => us,
        OutputUnits::Si => si,
    };
    write(&named.new.file, &naming(template, &named.vehicle))
}

/// The text of a new vehicle file.
fn vehicle(new: &NewVehicle) -> Result<String, InputError> {
    let template = match (new.kind, new.units) {
        (VehicleKind::Damper, None | Some(OutputUnits::Us)) => SURVEYOR,
        (VehicleKind::Damper, Some(OutputUnits::Si)) => SURVEYOR_SI,
        (kind, Some(OutputUnits::Us)) => {
            let kind = kind.to_possible_value();
            let allowed = format!(
                "SI with --kind {}; keys of either units may be mixed in the file",
                kind.as_ref().map_or("", PossibleValue::get_name)
            );
            return Err(InputError::value("--units", "US", &allowed));
        }
        (VehicleKind::Honeycomb, _) => HONEYCOMB,
        (VehicleKind::Tripod, _) => TRIPOD,
        (VehicleKind::Cantilever, _) => CANTILEVER,
    };
    let template = template.replace(RULES[0], RULES[1]);
    Ok(match new.legs {
        Some(legs) => with_legs(&template, legs),
        None => template,
    })
}

/// A vehicle with this number of legs, and a name that tells it instead of the template's.
fn with_legs(template: &str, legs: u8) -> String {
    let body = template.split(FIRST_LEG).next().unwrap_or_default();
    let lines = body.lines().skip_while(|line| line.starts_with('#'));
    let lines = lines.filter(|line| !line.starts_with("name = "));
    let body: Vec<&str> = lines.collect();
    let azimuths = (0..legs).map(|leg| 360.0 * f64::from(leg) / f64::from(legs));
    let azimuths: Vec<String> = azimuths
        .map(|azimuth| format!("{FIRST_LEG}azimuth_deg = {azimuth}\n"))
        .collect();
    format!(
        "name = \"Lander with {legs} legs\"\n{}\n\n{}",
        body.join("\n").trim_end(),
        azimuths.join("\n")
    )
}

/// A template that names this vehicle file.
fn naming(template: &str, vehicle: &str) -> String {
    let escaped = vehicle.replace('\\', "\\\\").replace('"', "\\\"");
    template.replace(VEHICLE_PATH, &escaped)
}

fn write(file: &Path, text: &str) -> Result<(), Failure> {
    let mut new = File::create_new(file).map_err(|error| {
        let complaint = match error.kind() {
            ErrorKind::AlreadyExists => "exists: expected the name of a new file".into(),
            _ => format!("cannot be written: {error}"),
        };
        InputError::in_file(file, complaint)
    })?;
    new.write_all(text.as_bytes()).map_err(Failure::running)?;
    print(&format!("written: {}\n", file.display()))
}
