//! Classes of outcomes, in the words and colours of the pictures.

use serde::Serialize;
use touchdown_dynamics::outcome::Class;
use touchdown_figures::boundary_table::Kind;
use touchdown_figures::palette;
use touchdown_figures::style::{Colour, WHITE};

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
