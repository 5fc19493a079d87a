//! Reads the table `[search]` of a sweep file.

use crate::boundary::{Extent, Search};
use crate::certainty::Doubt;
use crate::choice::{choice, words};
use crate::input_error::InputError;
use crate::refine::Refinement;
use crate::scan::Scan;
use crate::section::Section;

pub(crate) const SEARCH: [&str; 11] = [
    "from_fps",
    "to_fps",
    "scan_step_fps",
    "parts_below",
    "tolerance_fps",
    "bands",
    "scan",
    "scan_looseness",
    "refinement",
    "certainty",
    "keep_deg",
];
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
    [
        ("bands", words(&EXTENTS)),
        ("scan", words(&SCANS)),
        ("refinement", words(&REFINEMENTS)),
        ("certainty", words(&DOUBTS)),
    ]
}

/// Keys of `[search]` without default, and their meanings.
pub(crate) const REQUIRED: [(&str, &str); 4] = [
    ("from_fps", "the lowest horizontal velocity, ft/s"),
    ("to_fps", "the highest horizontal velocity, ft/s"),
    ("scan_step_fps", "the step of the scan, ft/s"),
    ("tolerance_fps", "the width of a bracket, ft/s"),
];
/// Most parts of a scan step below the first transition.
const MOST_PARTS_BELOW: u64 = 100;
/// Greatest stability angle that landings can be asked to keep, deg. It is less than that of landings between which scans
/// look no closer.
const GREATEST_KEPT: f64 = 30.0;
/// Finest bracket, ft/s: a tenth of the precision of landings at the least tolerance.
const LEAST_BRACKET: f64 = 1e-9;
/// Greatest factor on the solver's tolerance in a scan.
const LOOSEST_SCAN: f64 = 100.0;
/// Greatest horizontal velocity of a touchdown, ft/s.
const GREATEST_SPEED: f64 = 1e4;
/// Most landings in one scan.
const LONGEST_SCAN: f64 = 1e6;

/// Reads `[search]`.
pub(crate) fn search(root: &Section) -> Result<Search, InputError> {
    let section = &root.section("search", &SEARCH)?;
    let search = Search {
        from: section.number("from_fps")?,
        to: section.number("to_fps")?,
        scan_step: section.number("scan_step_fps")?,
        parts_below: section
            .optional_whole_number("parts_below", 1, MOST_PARTS_BELOW)?
            .map_or(Search::PARTS_BELOW, |parts| parts as u32),
        tolerance: section.number("tolerance_fps")?,
        extent: choice(section, "bands", &EXTENTS)?,
        scan: choice(section, "scan", &SCANS)?,
        scan_looseness: section.optional_number("scan_looseness")?.unwrap_or(1.0),
        refinement: choice(section, "refinement", &REFINEMENTS)?,
        doubt: choice(section, "certainty", &DOUBTS)?,
        kept: section
            .optional_number("keep_deg")?
            .unwrap_or(0.0)
            .to_radians(),
    };
    let width = search.to - search.from;
    let step = search.scan_step;
    let checks = [
        ("from_fps", search.from >= 0.0, "a number ≥ 0".to_owned()),
        (
            "to_fps",
            search.to <= GREATEST_SPEED,
            format!("a number ≤ {GREATEST_SPEED}"),
        ),
        (
            "from_fps",
            width > 0.0,
            format!("a number below to_fps = {}", search.to),
        ),
        ("scan_step_fps", step > 0.0, "a number > 0".to_owned()),
        (
            "scan_step_fps",
            step <= width,
            format!("at most to_fps - from_fps = {width}"),
        ),
        (
            "scan_step_fps",
            width / step <= LONGEST_SCAN,
            format!("at most {LONGEST_SCAN} steps"),
        ),
        (
            "scan_looseness",
            (1.0..=LOOSEST_SCAN).contains(&search.scan_looseness),
            format!("1 to {LOOSEST_SCAN}"),
        ),
        (
            "keep_deg",
            (0.0..=GREATEST_KEPT.to_radians()).contains(&search.kept),
            format!("0 to {GREATEST_KEPT}"),
        ),
        (
            "tolerance_fps",
            (LEAST_BRACKET..=step).contains(&search.tolerance),
            format!("{LEAST_BRACKET:e} ≤ value ≤ scan_step_fps = {step}"),
        ),
    ];
    for (key, holds, allowed) in checks {
        if !holds {
            return Err(section.value(key, &allowed)?.complain(&allowed));
        }
    }
    Ok(search)
}
