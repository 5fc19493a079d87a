//! Card decks of the report (3.4.4.1, 3.4.4.2): tables in eight columns of ten, then input constants on 21 numbered
//! cards of five columns of twelve. A blank card ends the tables and each run. Runs stacked behind the first contain
//! only the cards that change.

mod run;
mod tables;

use crate::documents::input_error::{InputError, Place};

use tables::{Tables, tables};

/// Number of cards of input constants, and fields on each.
const CARDS: usize = 21;
const FIELDS: usize = 5;
const LEGS: usize = 3;
/// Columns of the card number, and of each field.
const NUMBER_COLUMNS: usize = 7;
const CONSTANT_COLUMNS: usize = 12;

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

/// Reads the number in some columns of a card. Blank is zero; an exponent may lack its letter, as in .14222+03.
fn number(place: &Place, card: &str, from: usize, columns: usize) -> Result<f64, InputError> {
    let text: String = card.chars().skip(from).take(columns).collect();
    let text = text.trim();
    if text.is_empty() {
        return Ok(0.0);
    }
    let upper = text.to_ascii_uppercase().replace('D', "E");
    let sign = upper
        .char_indices()
        .skip(1)
        .find(|(index, letter)| matches!(letter, '+' | '-') && upper.as_bytes()[index - 1] != b'E');
    let written = match sign {
        Some((index, _)) => format!("{}E{}", &upper[..index], &upper[index..]),
        None => upper,
    };
    let parsed = written
        .parse::<f64>()
        .ok()
        .filter(|value| value.is_finite());
    parsed.ok_or_else(|| {
        let columns = format!("columns {} to {}", from + 1, from + columns);
        InputError::value(&columns, text, "a number").at(place.clone())
    })
}

/// Reads number and fields of a card of constants.
fn constants(place: &Place, card: &str) -> Result<(usize, [f64; FIELDS]), InputError> {
    let index = number(place, card, 0, NUMBER_COLUMNS)?;
    if index.fract() != 0.0 || !(1.0..=CARDS as f64).contains(&index) {
        return Err(InputError::value("card number", index, "1 to 21").at(place.clone()));
    }
    let mut fields = [0.0; FIELDS];
    for (field, value) in fields.iter_mut().enumerate() {
        let from = CONSTANT_COLUMNS * (field + 1);
        *value = number(place, card, from, CONSTANT_COLUMNS)?;
    }
    Ok((index as usize, fields))
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
