//! Keys whose values are words, one for each choice.

use crate::input_error::InputError;
use crate::section::{LocatedValue, Section};

/// Reads the choice of a key; the default without the key.
pub(crate) fn choice<T: Copy + Default>(
    section: &Section,
    key: &str,
    choices: &[(&str, T)],
) -> Result<T, InputError> {
    (section.optional(key)).map_or(Ok(T::default()), |value| chosen_by(&value, choices))
}

/// Reads the choice of a value.
pub(crate) fn chosen_by<T: Copy>(
    value: &LocatedValue,
    choices: &[(&str, T)],
) -> Result<T, InputError> {
    chosen(choices, value.text()?).ok_or_else(|| {
        let quoted: Vec<String> = (choices.iter())
            .map(|(word, _)| format!("\"{word}\""))
            .collect();
        value.complain(&quoted.join(" or "))
    })
}

/// Finds the choice of a word.
pub fn chosen<T: Copy>(choices: &[(&str, T)], word: &str) -> Option<T> {
    let found = choices.iter().find(|(known, _)| *known == word);
    found.map(|(_, choice)| *choice)
}

/// Word of a choice.
pub fn word<T: Copy + PartialEq>(choices: &[(&'static str, T)], choice: T) -> &'static str {
    let found = choices.iter().find(|(_, known)| *known == choice);
    found.map_or("", |(word, _)| word)
}

/// Words of all choices.
pub fn words<T>(choices: &[(&'static str, T)]) -> Vec<&'static str> {
    choices.iter().map(|(word, _)| *word).collect()
}
