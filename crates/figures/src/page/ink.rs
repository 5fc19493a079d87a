//! Colours, type and marks common to all pictures; they keep their order in grey and for
//! colour-blind readers (after Okabe and Ito).

use plotters::prelude::*;

use crate::boundary_table::Kind;

/// Typefaces, in the order in which a viewer should look for them.
pub const TYPEFACE: &str = "Helvetica, Arial, DejaVu Sans, sans-serif";
/// Axes and their text.
pub const TEXT: RGBColor = RGBColor(38, 38, 38);
/// Second lines and remarks.
pub const PALE_TEXT: RGBColor = RGBColor(96, 96, 96);
/// What was said before.
pub const STATEMENT: RGBColor = RGBColor(120, 70, 20);
/// Grid lines.
pub const GRID: RGBColor = RGBColor(226, 226, 226);
/// The line that joins transitions.
pub const LINE: RGBColor = RGBColor(60, 60, 60);
/// Cells that the boundary jumps across, and the bars that say so.
pub const TORN: RGBColor = RGBColor(236, 226, 232);
/// Bars where the boundary jumps.
pub const JUMP: RGBColor = RGBColor(190, 30, 100);
/// Where the velocity bisects the leading feet.
pub const BISECTOR: RGBColor = RGBColor(0, 0, 0);
/// The lowest transition of each row of a map.
pub const VALLEY: RGBColor = RGBColor(230, 90, 0);
/// Marks of points without a transition.
pub const NONE: RGBColor = RGBColor(0, 130, 100);
/// Half the breadth of a mark, pixels.
pub const MARK: i32 = 5;
/// Half the breadth of marks that would touch each other, pixels.
pub const SMALL_MARK: i32 = 3;

/// Colour of the marks of a kind of transition.
pub fn mark(kind: Kind) -> RGBColor {
    match kind {
        Kind::Unstable => RGBColor(0, 90, 160),
        Kind::Bottomed => RGBColor(213, 94, 0),
        Kind::Failure => RGBColor(150, 40, 110),
        Kind::Undecided => RGBColor(105, 105, 105),
    }
}

/// Colour of the line of a landing among several.
pub fn series(index: usize) -> RGBColor {
    [
        RGBColor(0, 90, 160),
        RGBColor(213, 94, 0),
        RGBColor(0, 130, 100),
        RGBColor(150, 40, 110),
    ][index % 4]
}

/// Colour of the region above a kind of transition.
pub fn region(kind: Kind) -> RGBColor {
    match kind {
        Kind::Unstable => RGBColor(206, 223, 240),
        Kind::Bottomed => RGBColor(248, 214, 186),
        Kind::Failure => RGBColor(240, 224, 236),
        Kind::Undecided => RGBColor(226, 226, 218),
    }
}

/// What happens above a kind of transition, in a word for the region.
pub fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Unstable => "topples",
        Kind::Bottomed => "strut bottoms",
        Kind::Failure => "not computed",
        Kind::Undecided => "undecided",
    }
}

/// Text in the common typeface: size in pixels of the picture, and colour.
pub fn text(size: u32, colour: RGBColor) -> TextStyle<'static> {
    // The SVG backend divides sizes by 1.24.
    let size = f64::from(size) * 1.24;
    (TYPEFACE, size).into_font().color(&colour)
}
