//! `touchdown new`: commented files to start from.

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::output_units::OutputUnits;

use crate::failure::Failure;
use crate::print::print;
use crate::units::units;

const VEHICLE: &str = include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml");
const VEHICLE_SI: &str = include_str!("../../../sweeps/vehicles/surveyor-si.toml");
const SWEEP: &str = include_str!("new/sweep.toml");
const SWEEP_SI: &str = include_str!("new/sweep-si.toml");
const SCENE: &str = include_str!("new/scene.toml");
const SCENE_SI: &str = include_str!("new/scene-si.toml");
/// Rules of the Surveyor, and those of a lander of one's own.
const RULES: [&str; 2] = ["rules = \"1966\"    ", "rules = \"physical\""];
/// Placeholder of the templates for the path of the vehicle file.
const VEHICLE_PATH: &str = "VEHICLE";

const EXAMPLES: &str = "\
Examples:
  A vehicle of your own, and a sweep of it:
    touchdown new vehicle lander.toml
    touchdown new sweep trade.toml
    touchdown sweep trade.toml --out results

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
    /// A vehicle file: the Surveyor, with an explanation of each number
    Vehicle(NewFile),
    /// A sweep file: V_H over roll and cross-slope
    Sweep(NamesVehicle),
    /// A scene file: a touchdown and two cases that differ from it
    Scene(NamesVehicle),
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
    let (new, us, si, vehicle) = match &options.kind {
        Kind::Vehicle(new) => (new, VEHICLE, VEHICLE_SI, None),
        Kind::Sweep(named) => (&named.new, SWEEP, SWEEP_SI, Some(&named.vehicle)),
        Kind::Scene(named) => (&named.new, SCENE, SCENE_SI, Some(&named.vehicle)),
    };
    let template = match new.units {
        OutputUnits::Us => us,
        OutputUnits::Si => si,
    };
    match vehicle {
        Some(vehicle) => write(&new.file, &naming(template, vehicle)),
        None => write(&new.file, &template.replace(RULES[0], RULES[1])),
    }
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
