//! Requests and answers as JSON, and what many of them have: a touchdown, numbers, units, the class of an outcome in the
//! words and colours of the pictures.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_figures::boundary_table::Kind;
use touchdown_figures::palette;
use touchdown_figures::style::{Colour, WHITE};
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::parameter::Parameter;

use super::complaint::Complaint;

/// A touchdown of a request.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Asked {
    /// Name of the source.
    pub source: Option<String>,
    /// Text of a vehicle file that replaces the source's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vehicle: Option<String>,
    /// Numbers and words by dotted names.
    pub values: Map<String, Value>,
}

impl Asked {
    /// The touchdown with other numbers, under whatever names it has them.
    #[must_use]
    pub fn with(&self, others: impl Iterator<Item = (String, Value)>) -> Self {
        let named = |name: &str| Parameter::named(name, MOST_LEGS);
        let mut asked = self.clone();
        for (name, value) in others {
            let other = named(&name);
            (asked.values)
                .retain(|known, _| known != &name && (other.is_none() || named(known) != other));
            asked.values.insert(name, value);
        }
        asked
    }
}

/// Parses a request.
///
/// # Errors
/// The deviation from the form of the request.
pub fn read<R: DeserializeOwned>(request: &str) -> Result<R, Complaint> {
    // Serde would also accept a list of the members.
    if !request.trim_start().starts_with('{') {
        return Err(Complaint::request("not a request: expected an object"));
    }
    serde_json::from_str(request)
        .map_err(|error| Complaint::request(format!("not a request: {error}")))
}

/// Serializes an answer.
///
/// # Errors
/// Only a fault of the program.
pub fn written(answer: &impl Serialize) -> Result<String, Complaint> {
    serde_json::to_string(answer).map_err(Complaint::engine)
}

/// Checks that a number of a request is in a range.
///
/// # Errors
/// If it is not.
pub fn within(key: &str, number: f64, [least, greatest]: [f64; 2]) -> Result<f64, Complaint> {
    match (least..=greatest).contains(&number) {
        true => Ok(number),
        false => {
            let allowed = format!("{least} ≤ value ≤ {greatest}");
            Err(Complaint::value(key, number, &allowed))
        }
    }
}

/// Units of an answer.
///
/// # Errors
/// If the word names no units.
pub fn units(word: Option<&str>, default: OutputUnits) -> Result<OutputUnits, Complaint> {
    Ok(asked_units(word)?.unwrap_or(default))
}

/// Units that a request asks for, if it does.
///
/// # Errors
/// If the word names no units.
pub fn asked_units(word: Option<&str>) -> Result<Option<OutputUnits>, Complaint> {
    let refuse = |word| Complaint::value("units", format!("{word:?}"), "\"US\" or \"SI\"");
    let named = |word| OutputUnits::named(word).ok_or_else(|| refuse(word));
    word.map(named).transpose()
}

/// Words and colours of a class.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ClassWords {
    /// Word in tables.
    pub class: String,
    /// Word in pictures.
    pub word: &'static str,
    /// Colour of its marks.
    pub mark: String,
    /// Colour of its region.
    pub region: String,
}

/// Words and colours of a class.
pub fn class_words(class: Class) -> ClassWords {
    let kind = Kind::from_name(&class.to_string());
    ClassWords {
        class: class.to_string(),
        word: kind.map_or("stable", palette::word),
        mark: hex(kind.map_or(palette::NONE, palette::mark)),
        region: hex(kind.map_or(WHITE, palette::region)),
    }
}

/// Finds a class by its word in tables.
pub fn class_named(word: &str) -> Option<Class> {
    Class::ALL
        .into_iter()
        .find(|class| class.to_string() == word)
}

/// A colour as written in pages.
pub fn hex(colour: Colour) -> String {
    colour.hex().to_lowercase()
}
