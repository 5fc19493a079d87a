//! `touchdown import-deck`: card decks of the 1966 program as vehicle files and tables of cases.

use std::path::PathBuf;

use clap::Args;
use touchdown_sweep::deck::{Deck, parse};
use touchdown_sweep::deposit::Folder;
use touchdown_sweep::input_error::{InputError, Place};

use crate::failure::Failure;
use crate::say::say;

const EXAMPLE: &str = "\
Writes, for each vehicle of the deck, STEM.toml and STEM-cases.csv (STEM-2.toml and so on for
further ones), to be landed with
    touchdown land --vehicle STEM.toml --cases STEM-cases.csv --out outcomes.csv";

/// Options of `import-deck`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Options {
    /// The cards, as a text file: tables of 8 columns of 10, a blank card, input constants with
    /// the card number in columns 1 to 7 and five fields of 12 from column 13, a blank card after
    /// each run
    cards: PathBuf,
    /// Folder to write to
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
}

/// Runs `import-deck`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let place = Place::file(&options.cards);
    let text = std::fs::read_to_string(&options.cards)
        .map_err(|error| InputError::other(format!("cannot be read: {error}")).at(place.clone()))?;
    let deck = parse(&place, &text)?;
    let stem = options.cards.file_stem().unwrap_or_default();
    let files = files(&deck, &stem.to_string_lossy(), &place)?;
    for file in Folder::open(&options.out)?.deposit(&files)? {
        say(&format!("{}\n", file.display()))?;
    }
    Ok(())
}

/// One vehicle with its cases after the other.
fn files(deck: &Deck, stem: &str, place: &Place) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let mut vehicles: Vec<(String, csv::Writer<Vec<u8>>)> = Vec::new();
    for run in &deck.runs {
        let vehicle = deck.vehicle(run, stem);
        let scene = run.scene().map_err(|error| error.at(place.clone()))?;
        let known = vehicles.iter().position(|(other, _)| *other == vehicle);
        let index = match known {
            Some(index) => index,
            None => {
                let mut table = csv::Writer::from_writer(Vec::new());
                let names = scene.iter().map(|(name, _)| *name);
                table
                    .write_record(std::iter::once("case").chain(names))
                    .map_err(Failure::running)?;
                vehicles.push((vehicle, table));
                vehicles.len() - 1
            }
        };
        let values = scene.iter().map(|(_, value)| value.to_string());
        vehicles[index]
            .1
            .write_record(std::iter::once(run.serial_number().to_string()).chain(values))
            .map_err(Failure::running)?;
    }
    let mut files = Vec::new();
    for (index, (vehicle, table)) in vehicles.into_iter().enumerate() {
        let stem = if index == 0 {
            stem.to_owned()
        } else {
            format!("{stem}-{}", index + 1)
        };
        let table = table.into_inner().map_err(Failure::running)?;
        files.push((format!("{stem}.toml"), vehicle.into_bytes()));
        files.push((format!("{stem}-cases.csv"), table));
    }
    Ok(files)
}
