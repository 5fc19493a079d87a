//! Colours, type and marks common to all pictures; they keep their order in grey and for
//! colour-blind readers (after Okabe and Ito).

use crate::boundary_table::Kind;
use crate::style::Colour;

/// Axes and their text.
pub const TEXT: Colour = Colour(38, 38, 38);
/// Second lines and remarks.
pub const PALE_TEXT: Colour = Colour(96, 96, 96);
/// Statements and printed values of the report of 1966.
pub const STATEMENT: Colour = Colour(120, 70, 20);
/// Grid lines.
pub const GRID: Colour = Colour(226, 226, 226);
/// The line that joins transitions.
pub const LINE: Colour = Colour(60, 60, 60);
/// Outlines of the cells of a surface in perspective.
pub const SURFACE: Colour = Colour(70, 70, 70);
/// Cells of a map across which the boundary jumps.
pub const JUMP_CELL: Colour = Colour(236, 226, 232);
/// Bars where the boundary jumps.
pub const JUMP: Colour = Colour(190, 30, 100);
/// The line on which the velocity bisects the leading feet.
pub const BISECTOR: Colour = Colour(0, 0, 0);
/// The lowest transition of each row of a map.
pub const LOWEST: Colour = Colour(230, 90, 0);
/// Stripes, and rings of points, where stable landings and others alternate above the transition.
pub const PATCHY: Colour = Colour(0, 130, 100);
/// Marks of points without a transition.
pub const NONE: Colour = Colour(0, 130, 100);
/// Width of the bars where the boundary jumps, pixels.
pub const JUMP_WIDTH: f64 = 3.0;
/// Words for them.
pub const PATCHY_WORDS: &str = "patchy: stable landings among others";
/// Hatching of areas of a map whose estimated error is larger than asked; it differs from all colours of levels.
pub const HATCH: Colour = Colour(240, 125, 150);
/// Width of its lines, pixels.
pub const HATCH_WIDTH: f64 = 0.8;
/// Their distance, pixels.
pub const HATCH_APART: f64 = 9.0;
/// Width of stripes, pixels.
pub const STRIPE: f64 = 1.5;
/// Their distance, pixels.
pub const STRIPES_APART: f64 = 5.0;
/// Half the breadth of a mark, pixels.
pub const MARK: f64 = 5.0;
/// Half the breadth of marks that would otherwise touch, pixels.
pub const SMALL_MARK: f64 = 3.0;

/// Colour of the marks of a kind of transition.
pub fn mark(kind: Kind) -> Colour {
    match kind {
        Kind::Unstable => Colour(0, 90, 160),
        Kind::Bottomed => Colour(213, 94, 0),
        Kind::Failure => Colour(150, 40, 110),
        Kind::Undecided => Colour(105, 105, 105),
    }
}

/// Colours of curves, in order of appearance.
const CURVES: [Colour; 8] = [
    Colour(0, 90, 160),
    Colour(213, 94, 0),
    Colour(0, 130, 100),
    Colour(180, 80, 140),
    Colour(120, 90, 20),
    Colour(60, 60, 60),
    Colour(80, 170, 220),
    Colour(230, 160, 0),
];

/// Colour of a curve among several, by its index.
pub fn curve(index: usize) -> Colour {
    CURVES[index % CURVES.len()]
}

/// Dashes and gaps of a curve among several of one colour, pixels; the first is solid.
pub fn dashes(index: usize) -> Option<(f64, f64)> {
    [None, Some((9.0, 4.0)), Some((3.0, 3.0)), Some((14.0, 5.0))][index % 4]
}

/// Colour of the region above a kind of transition.
pub fn region(kind: Kind) -> Colour {
    match kind {
        Kind::Unstable => Colour(206, 223, 240),
        Kind::Bottomed => Colour(248, 214, 186),
        Kind::Failure => Colour(240, 224, 236),
        Kind::Undecided => Colour(226, 226, 218),
    }
}

/// Words for a transition of a kind that lies at or below the lowest speed searched.
pub fn word_at_or_below(kind: Kind) -> String {
    format!("{}, at or below the lowest speed searched", word(kind))
}

/// Word for the region above a kind of transition.
pub fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Unstable => "topples",
        Kind::Bottomed => "strut bottoms",
        Kind::Failure => "not computed",
        Kind::Undecided => "undecided",
    }
}
