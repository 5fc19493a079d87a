//! How landings are computed: the table `[solver]` of a sweep file, and the crush rules by name.

use touchdown_dynamics::scene::{CrushRule, Settings};

use crate::input_error::InputError;
use crate::section::Section;

/// Keys of `[solver]`.
pub(crate) const SOLVER: [&str; 3] = ["tolerance", "time_limit_s", "crush_rule"];
/// Words of the crush rules.
pub(crate) const CRUSH_RULES: [&str; 2] = ["pivot-rate", "section"];

/// Reads `[solver]`; whatever it leaves out has the program's default.
pub(crate) fn settings(root: &Section) -> Result<Settings, InputError> {
    let solver = root.optional_section("solver", &SOLVER)?;
    let number = |key| match &solver {
        Some(solver) => solver.optional_number(key),
        None => Ok(None),
    };
    let tolerance = number("tolerance")?.unwrap_or(Settings::BOUNDARY_TOLERANCE);
    let time_limit = number("time_limit_s")?.unwrap_or(Settings::DEFAULT_TIME_LIMIT);
    let rule = match solver
        .as_ref()
        .and_then(|solver| solver.optional("crush_rule"))
    {
        Some(found) => crush_rule(found.text()?)
            .ok_or_else(|| found.complain("\"pivot-rate\" or \"section\""))?,
        None => CrushRule::default(),
    };
    Settings::new(tolerance, time_limit, rule)
        .map_err(|invalid| solver.as_ref().unwrap_or(root).complain(&invalid))
}

/// Word of a crush rule in input files.
pub fn crush_rule_name(rule: CrushRule) -> &'static str {
    match rule {
        CrushRule::PivotRate => CRUSH_RULES[0],
        CrushRule::Section => CRUSH_RULES[1],
    }
}

/// The crush rule that a word of an input file stands for.
pub fn crush_rule(name: &str) -> Option<CrushRule> {
    [CrushRule::PivotRate, CrushRule::Section]
        .into_iter()
        .find(|rule| crush_rule_name(*rule) == name)
}
