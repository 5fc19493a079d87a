//! `touchdown import-deck`: card decks of the 1966 program as vehicle files, scene files and tables of
//! cases.

use std::path::PathBuf;

use clap::Args;
use touchdown_input::documents::input_error::Place;
use touchdown_input::documents::library::Library;
use touchdown_input::readers::deck::{Deck, Run, parse};
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::output_guard::OutputGuard;

use crate::terminal::{Failure, print_paths};

const EXAMPLE: &str = "\
Writes, for each vehicle of the deck, STEM.toml and STEM-cases.csv (STEM-2.toml and so on for
further ones), and the runs as they are stacked as STEM-scene.toml, to be landed with
    touchdown land STEM-scene.toml --out landings
or, without histories and on all cores, with
    touchdown land --vehicle STEM.toml --cases STEM-cases.csv --out outcomes.csv";

/// Options of `import-deck`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// The cards, as a text file: tables of 8 columns of 10, a blank card, input constants with
    /// the card number in columns 1 to 7 and five fields of 12 from column 13, a blank card after
    /// each run
    cards: PathBuf,
    /// Folder for the files
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Replace existing files
    #[arg(long)]
    overwrite: bool,
}

/// Runs `import-deck`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let place = Place::file(&options.cards);
    let deck = parse(&place, &Library::Disk.text(&options.cards)?)?;
    let stem = options.cards.file_stem().unwrap_or_default();
    let files = files(&deck, &stem.to_string_lossy(), &place)?;
    let folder = Folder::open(&options.out)?;
    let guard = OutputGuard {
        inputs: &[&options.cards],
        overwrite: options.overwrite,
    };
    for (name, bytes) in &files {
        guard.check_same(&folder.path(name), bytes)?;
    }
    print_paths(&folder.write_files(&files)?)
}

/// Name of the file of a vehicle of the deck, from 0, without its ending.
fn name_of(stem: &str, vehicle: usize) -> String {
    match vehicle {
        0 => stem.to_owned(),
        further => format!("{stem}-{}", further + 1),
    }
}

/// A run: its vehicle among those of the deck, and its scene.
struct Landing<'d> {
    run: &'d Run,
    vehicle: usize,
    scene: Vec<(&'static str, f64)>,
}

fn files(deck: &Deck, stem: &str, place: &Place) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let mut vehicles: Vec<String> = Vec::new();
    let mut landings: Vec<Landing> = Vec::new();
    for run in &deck.runs {
        let text = deck.vehicle(run, stem);
        let known = vehicles.iter().position(|other| *other == text);
        let vehicle = known.unwrap_or_else(|| {
            vehicles.push(text);
            vehicles.len() - 1
        });
        let scene = run.scene().map_err(|error| error.at(place.clone()))?;
        landings.push(Landing {
            run,
            vehicle,
            scene,
        });
    }
    let mut files = Vec::new();
    for (index, vehicle) in vehicles.into_iter().enumerate() {
        let name = name_of(stem, index);
        let cases = cases(landings.iter().filter(|landing| landing.vehicle == index))?;
        files.push((format!("{name}.toml"), vehicle.into_bytes()));
        files.push((format!("{name}-cases.csv"), cases));
    }
    let scene = scene_file(stem, &landings).into_bytes();
    files.push((format!("{stem}-scene.toml"), scene));
    Ok(files)
}

/// Runs as a table of cases.
fn cases<'l>(landings: impl Iterator<Item = &'l Landing<'l>>) -> Result<Vec<u8>, Failure> {
    let mut table = csv::Writer::from_writer(Vec::new());
    for (index, landing) in landings.enumerate() {
        if index == 0 {
            let names = landing.scene.iter().map(|(name, _)| *name);
            let heading = std::iter::once("case").chain(names);
            table.write_record(heading).map_err(Failure::running)?;
        }
        let values = landing.scene.iter().map(|(_, value)| value.to_string());
        let serial = landing.run.serial_number().to_string();
        let row = std::iter::once(serial).chain(values);
        table.write_record(row).map_err(Failure::running)?;
    }
    table.into_inner().map_err(Failure::running)
}

/// Runs as a scene file: the first in full, of the others what changes.
fn scene_file(stem: &str, landings: &[Landing]) -> String {
    let mut text = "# Converted from a card deck of the 1966 program.\n".to_owned();
    let serials: Vec<String> = landings
        .iter()
        .map(|landing| landing.run.serial_number().to_string())
        .collect();
    // Serial numbers name the cases where they differ.
    let is_name = |(index, serial): (usize, &String)| {
        let is_plain = serial.chars().all(|c| c.is_ascii_digit());
        is_plain && !serials[..index].contains(serial)
    };
    let are_names = serials.iter().enumerate().all(is_name);
    let mut before: Option<&Landing> = None;
    for (landing, serial) in landings.iter().zip(&serials) {
        let name = if are_names {
            format!("name = \"{serial}\"\n")
        } else {
            String::new()
        };
        let vehicle = format!("vehicle = {:?}\n", name_of(stem, landing.vehicle) + ".toml");
        let values = |of: &[(&str, f64)]| -> String {
            of.iter()
                .map(|(name, value)| format!("{name} = {value}\n"))
                .collect()
        };
        match before {
            None => {
                text += &format!(
                    "{vehicle}\n[scene]\n{}\n[[case]]\n{name}",
                    values(&landing.scene)
                );
            }
            Some(before) => {
                let changed: Vec<(&str, f64)> = landing
                    .scene
                    .iter()
                    .zip(&before.scene)
                    .filter(|(now, then)| now != then)
                    .map(|(now, _)| *now)
                    .collect();
                text += &format!("\n[[case]]\n{name}");
                if landing.vehicle != before.vehicle {
                    text += &vehicle;
                }
                text += &values(&changed);
            }
        }
        before = Some(landing);
    }
    text
}
