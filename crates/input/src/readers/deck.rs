//! Card decks of the report (3.4.4.1, 3.4.4.2): tables in eight columns of ten, then input constants on 21 numbered
//! cards of five columns of twelve. A blank card ends the tables and each run. Runs stacked behind the first contain
//! only the cards that change.

mod card;
mod scene;
mod tables;
mod vehicle;

use crate::documents::input_error::{InputError, Place};

use card::constants;
use tables::{Tables, tables};

/// Number of cards of input constants, and fields on each.
const CARDS: usize = 21;
const FIELDS: usize = 5;
const LEGS: usize = 3;

/// A deck.
#[derive(Debug, Clone, PartialEq)]
pub struct Deck {
    tables: Tables,
    /// All runs, each complete.
    pub runs: Vec<Run>,
}

/// The constants of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    cards: [[f64; FIELDS]; CARDS],
}

/// Reads a deck.
///
/// # Errors
/// Names the faulty card by its line.
pub fn parse(place: &Place, text: &str) -> Result<Deck, InputError> {
    let mut cards = text
        .lines()
        .enumerate()
        .map(|(index, card)| (index + 1, card));
    let tables = tables(place, &mut cards)?;
    let mut runs: Vec<Run> = Vec::new();
    let mut present = [[None; FIELDS]; CARDS];
    let mut is_changed = false;
    let mut last = 1;
    for (line, card) in cards {
        last = line;
        if !card.trim().is_empty() {
            let (number, fields) = constants(&place.line(line), card)?;
            present[number - 1] = fields.map(Some);
            is_changed = true;
        } else if is_changed {
            runs.push(run(&place.line(line), &present)?);
            is_changed = false;
        }
    }
    if is_changed {
        runs.push(run(&place.line(last), &present)?);
    }
    if runs.is_empty() {
        let complaint = "has no cards of input constants after its tables and a blank card";
        return Err(InputError::other(complaint).at(place.clone()));
    }
    Ok(Deck { tables, runs })
}

fn run(place: &Place, present: &[[Option<f64>; FIELDS]; CARDS]) -> Result<Run, InputError> {
    let mut cards = [[0.0; FIELDS]; CARDS];
    for (index, (card, fields)) in cards.iter_mut().zip(present).enumerate() {
        for (value, field) in card.iter_mut().zip(fields) {
            let missing = || {
                let complaint = format!("card {} is missing before the first run", index + 1);
                InputError::other(complaint).at(place.clone())
            };
            *value = field.ok_or_else(missing)?;
        }
    }
    Ok(Run { cards })
}

impl Run {
    /// Field `field` of card `card`, both counted from 1 as in the report.
    fn at(&self, card: usize, field: usize) -> f64 {
        self.cards[card - 1][field - 1]
    }

    /// Serial number (card 11).
    pub fn serial_number(&self) -> f64 {
        self.at(11, 2)
    }
}

#[cfg(test)]
mod tests;
