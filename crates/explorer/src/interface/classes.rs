//! How landings end, in the words and colours of the pictures.

use serde::Serialize;
use touchdown_dynamics::outcome::Class;
use touchdown_figures::boundary_table::Kind;
use touchdown_figures::palette;
use touchdown_figures::style::{Colour, WHITE};

/// A class of outcomes as it is told and drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ClassWords {
    /// Its word in tables.
    pub class: String,
    /// Its word in pictures.
    pub word: &'static str,
    /// Colour of its marks.
    pub mark: String,
    /// Colour of the region in which landings end so.
    pub region: String,
}

/// A class in words and colours.
pub fn class_words(class: Class) -> ClassWords {
    let kind = Kind::from_name(&class.to_string());
    ClassWords {
        class: class.to_string(),
        word: kind.map_or("stable", palette::word),
        mark: hex(kind.map_or(palette::NONE, palette::mark)),
        region: hex(kind.map_or(WHITE, palette::region)),
    }
}

/// The class of a word of a table.
pub fn class_named(word: &str) -> Option<Class> {
    Class::ALL
        .into_iter()
        .find(|class| class.to_string() == word)
}

/// A colour as pages write it.
pub fn hex(colour: Colour) -> String {
    colour.hex().to_lowercase()
}
