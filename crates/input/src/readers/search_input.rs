//! Reads the table `[search]` of a sweep file.

use touchdown_dynamics::quantities;
use touchdown_dynamics::quantity::{IfMissing, Quantity, Range};
use touchdown_search::boundary::{Extent, Search};
use touchdown_search::certainty::Doubt;
use touchdown_search::refine::Refinement;
use touchdown_search::scan::Scan;

use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::readers::choice::{choice, words};
use crate::readers::numbers::{definite, joined, keys_of};

/// Greatest horizontal velocity of a touchdown, ft/s.
const SPEEDS: Range = quantities::HORIZONTAL_VELOCITY.range;
/// Finest bracket, ft/s: a tenth of the precision of landings at the least tolerance.
const LEAST_BRACKET: f64 = 1e-9;
/// Most landings in one scan.
const LONGEST_SCAN: f64 = 1e6;

const FROM: Quantity =
    Quantity::new("from_fps", SPEEDS, "lowest horizontal velocity").also("below `to_fps`");
const TO: Quantity =
    Quantity::new("to_fps", SPEEDS, "highest horizontal velocity").also("above `from_fps`");
const SCAN_STEP: Quantity = Quantity::new(
    "scan_step_fps",
    SPEEDS.above_lower(),
    "step of the scan; bands that are narrower can be missed",
)
.also("at most `to_fps` − `from_fps`, at most 10^6 steps");
const PARTS_BELOW: Quantity = Quantity::new(
    "parts_below",
    Range::closed(1.0, 100.0),
    "below the first transition, landings that are not quiet are followed by others at so many parts of a scan step, where a \
     margin runs out before the next landing, at a speed drawn at random, and on either side of a transition at which margins \
     jump; 1 for none of these",
)
.also("a whole number")
.default(Search::PARTS_BELOW as f64);
const TOLERANCE: Quantity = Quantity::new(
    "tolerance_fps",
    Range::closed(LEAST_BRACKET, SPEEDS.upper),
    "width of the final bracket",
)
.also("at most `scan_step_fps`");
const SCAN_LOOSENESS: Quantity = Quantity::new(
    "scan_looseness",
    Range::closed(1.0, 100.0),
    "factor on the solver's tolerance during the scan; the ends of every bracket are landed at the tolerance itself",
)
.default(1.0);
/// The greatest is less than the stability angle of landings between which scans look no closer.
const KEEP: Quantity = Quantity::new(
    "keep_deg",
    Range::closed(0.0, 30.0),
    "least stability angle that a stable landing keeps: one that comes below it counts as unstable, so that V_H is the speed up \
     to which all landings keep that angle",
)
.default(0.0);
/// Numbers of `[search]`.
pub(crate) const NUMBERS: [Quantity; 7] = [
    FROM,
    TO,
    SCAN_STEP,
    PARTS_BELOW,
    TOLERANCE,
    SCAN_LOOSENESS,
    KEEP,
];
/// Keys of `[search]` that take words.
const WORDS: [&str; 4] = ["bands", "scan", "refinement", "certainty"];
pub(crate) const SEARCH: [&str; 11] = joined(&[&keys_of::<7>(&NUMBERS), &WORDS]);
/// Words of the choices, and their meaning.
pub(crate) const EXTENTS: [(&str, Extent); 2] = [("first", Extent::First), ("all", Extent::All)];
pub(crate) const SCANS: [(&str, Scan); 2] = [("full", Scan::Full), ("skipping", Scan::Skipping)];
pub(crate) const REFINEMENTS: [(&str, Refinement); 2] = [
    ("margin", Refinement::Margin),
    ("bisection", Refinement::Bisection),
];
pub(crate) const DOUBTS: [(&str, Doubt); 3] = [
    ("doubtful", Doubt::Doubtful),
    ("all", Doubt::All),
    ("none", Doubt::None),
];
/// Keys of `[search]` that take words, and their words.
pub(crate) fn word_keys() -> [(&'static str, Vec<&'static str>); 4] {
    let [bands, scan, refinement, certainty] = WORDS;
    [
        (bands, words(&EXTENTS)),
        (scan, words(&SCANS)),
        (refinement, words(&REFINEMENTS)),
        (certainty, words(&DOUBTS)),
    ]
}

/// Numbers of `[search]` without default.
pub(crate) fn required() -> impl Iterator<Item = &'static Quantity> {
    (const { &NUMBERS }.iter()).filter(|quantity| quantity.if_missing == IfMissing::Required)
}

/// Reads `[search]`.
pub(crate) fn search(root: &Section) -> Result<Search, InputError> {
    let section = &root.section("search", &SEARCH)?;
    let number = |quantity: &Quantity| -> Result<f64, InputError> {
        let value = definite(section, quantity)?;
        match (
            quantity.range.contains(value),
            section.optional(quantity.key),
        ) {
            (false, Some(found)) => Err(found.complain(&quantity.range.to_string())),
            _ => Ok(value),
        }
    };
    let parts_below = number(&PARTS_BELOW)?;
    let [bands, scan, refinement, certainty] = WORDS;
    let search = Search {
        from: number(&FROM)?,
        to: number(&TO)?,
        scan_step: number(&SCAN_STEP)?,
        parts_below: parts_below as u32,
        tolerance: section.number(TOLERANCE.key)?,
        extent: choice(section, bands, &EXTENTS)?,
        scan: choice(section, scan, &SCANS)?,
        scan_looseness: number(&SCAN_LOOSENESS)?,
        refinement: choice(section, refinement, &REFINEMENTS)?,
        doubt: choice(section, certainty, &DOUBTS)?,
        kept: number(&KEEP)?.to_radians(),
    };
    let width = search.to - search.from;
    let step = search.scan_step;
    let checks = [
        (
            PARTS_BELOW,
            parts_below.fract() == 0.0,
            "a whole number".to_owned(),
        ),
        (
            FROM,
            width > 0.0,
            format!("a number below to_fps = {}", search.to),
        ),
        (
            SCAN_STEP,
            step <= width,
            format!("at most to_fps - from_fps = {width}"),
        ),
        (
            SCAN_STEP,
            width / step <= LONGEST_SCAN,
            format!("at most {LONGEST_SCAN} steps"),
        ),
        (
            TOLERANCE,
            (LEAST_BRACKET..=step).contains(&search.tolerance),
            format!("{LEAST_BRACKET:e} ≤ value ≤ scan_step_fps = {step}"),
        ),
    ];
    for (quantity, holds, allowed) in checks {
        if !holds {
            return Err(section.value(quantity.key, &allowed)?.complain(&allowed));
        }
    }
    Ok(search)
}
