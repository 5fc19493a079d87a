//! `touchdown new`: commented files to start from.

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};
use touchdown_sweep::input_error::{InputError, Place};

use crate::failure::Failure;
use crate::print::print;

const VEHICLE: &str = include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml");
const VEHICLE_SI: &str = include_str!("../../../sweeps/vehicles/surveyor-si.toml");
const SWEEP: &str = include_str!("new/sweep.toml");
const SCENE: &str = include_str!("new/scene.toml");
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
    Vehicle(NewVehicle),
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
}

#[derive(Debug, Args)]
struct NewVehicle {
    #[command(flatten)]
    new: NewFile,
    /// Units of the file; the keys of either may be mixed
    #[arg(long, value_enum, default_value = "US", ignore_case = true)]
    units: Units,
}

/// Units of a new file.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Units {
    /// Foot, slug, pound and degree
    #[value(name = "US")]
    Us,
    /// Metre, kilogram, newton and radian
    #[value(name = "SI")]
    Si,
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
    match &options.kind {
        Kind::Vehicle(vehicle) => {
            let text = match vehicle.units {
                Units::Us => VEHICLE,
                Units::Si => VEHICLE_SI,
            };
            write(&vehicle.new.file, text)
        }
        Kind::Sweep(named) => write(&named.new.file, &naming(SWEEP, &named.vehicle)),
        Kind::Scene(named) => write(&named.new.file, &naming(SCENE, &named.vehicle)),
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
        InputError::other(complaint).at(Place::file(file))
    })?;
    new.write_all(text.as_bytes()).map_err(Failure::running)?;
    print(&format!("written: {}\n", file.display()))
}
