//! Where to search: the table `[search]` of a sweep file.

use crate::boundary::{Extent, Search};
use crate::input_error::InputError;
use crate::section::Section;

const SEARCH: [&str; 5] = [
    "from_fps",
    "to_fps",
    "scan_step_fps",
    "tolerance_fps",
    "bands",
];
/// Keys of `[search]` that are numbers.
pub(crate) const NUMBERS: [&str; 4] = ["from_fps", "to_fps", "scan_step_fps", "tolerance_fps"];
/// Finest bracket, ft/s: ten times finer than landings are determined at the least tolerance.
const LEAST_BRACKET: f64 = 1e-9;
/// Most landings in one scan.
const LONGEST_SCAN: f64 = 1e6;

/// Reads `[search]`.
pub(crate) fn search(root: &Section) -> Result<Search, InputError> {
    let section = &root.section("search", &SEARCH)?;
    let search = Search {
        from: section.number("from_fps")?,
        to: section.number("to_fps")?,
        scan_step: section.number("scan_step_fps")?,
        tolerance: section.number("tolerance_fps")?,
        extent: extent(section)?,
    };
    let width = search.to - search.from;
    let step = search.scan_step;
    let checks = [
        ("from_fps", search.from >= 0.0, "a number ≥ 0".to_owned()),
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

fn extent(section: &Section) -> Result<Extent, InputError> {
    let Some(found) = section.optional("bands") else {
        return Ok(Extent::default());
    };
    extent_named(found.text()?).ok_or_else(|| found.complain("\"first\" or \"all\""))
}

/// Word of an extent in sweep files.
pub(crate) fn extent_name(extent: Extent) -> &'static str {
    match extent {
        Extent::First => "first",
        Extent::All => "all",
    }
}

/// The extent that a word of an input file stands for.
pub(crate) fn extent_named(name: &str) -> Option<Extent> {
    [Extent::First, Extent::All]
        .into_iter()
        .find(|extent| extent_name(*extent) == name)
}
