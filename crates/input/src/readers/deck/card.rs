//! A card: numbers in columns.

use crate::documents::input_error::{InputError, Place};

use super::{CARDS, FIELDS};

/// Columns of the card number, and of each field.
const NUMBER_COLUMNS: usize = 7;
const CONSTANT_COLUMNS: usize = 12;

/// Reads the number in some columns of a card. Blank is zero; an exponent may lack its letter, as in .14222+03.
pub(super) fn number(
    place: &Place,
    card: &str,
    from: usize,
    columns: usize,
) -> Result<f64, InputError> {
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
pub(super) fn constants(place: &Place, card: &str) -> Result<(usize, [f64; FIELDS]), InputError> {
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
