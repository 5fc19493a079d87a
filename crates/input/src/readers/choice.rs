//! Keys whose values are words, one for each choice.

use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};

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

/// Keys that only some kinds of a thing have: the word of each kind, and its own.
pub(crate) type KeysOfKinds<'k> = [(&'static str, &'k [&'static str])];

/// Refuses keys that only other kinds of the thing have.
pub(crate) fn refuse_keys_of_others(
    section: &Section,
    thing: &str,
    kinds: &KeysOfKinds,
    own: &str,
) -> Result<(), InputError> {
    let has =
        |kind: &str, key| (kinds.iter()).any(|(word, keys)| *word == kind && keys.contains(key));
    let all = kinds.iter().flat_map(|(_, keys)| keys.iter());
    let mut others = all.filter(|key| !has(own, key));
    let Some((key, found)) = others.find_map(|key| Some((key, section.optional(key)?))) else {
        return Ok(());
    };
    let words: Vec<String> = (kinds.iter())
        .filter(|(_, keys)| keys.contains(key))
        .map(|(word, _)| format!("\"{word}\""))
        .collect();
    Err(found.complain_that(&format!(
        "only {thing}s of kind {} have this, and this one is of kind \"{own}\"",
        words.join(" or ")
    )))
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
