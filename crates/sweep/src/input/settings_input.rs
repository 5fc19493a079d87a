//! How landings are computed: the table `[solver]` of a sweep file, and the crush rules by name.

use touchdown_dynamics::friction::FrictionProfile;
use touchdown_dynamics::scene::{CrushRule, Settings};

use crate::input_error::InputError;
use crate::method_input;
use crate::section::{LocatedValue, Section};
use touchdown_dynamics::method::Method;

/// Keys of `[solver]`.
pub(crate) const SOLVER: [&str; 5] = [
    "tolerance",
    "time_limit_s",
    "crush_rule",
    "friction_profile",
    "stop",
];
/// Words of when a landing ends: at its verdict, or at the time limit.
pub const STOPS: [&str; 2] = ["verdict", "time"];
/// Words of the crush rules.
pub(crate) const CRUSH_RULES: [&str; 2] = ["pivot-rate", "section"];
/// Letters of the friction profiles.
pub(crate) const FRICTION_PROFILES: [&str; 3] = ["A", "B", "C"];

/// Reads `[solver]` of a sweep; whatever it leaves out has the program's default.
pub(crate) fn settings(root: &Section) -> Result<Settings, InputError> {
    settings_from(root, Settings::BOUNDARY_TOLERANCE)
}

/// Reads `[solver]` of single landings.
pub(crate) fn settings_of_landing(root: &Section) -> Result<Settings, InputError> {
    settings_from(root, Settings::DEFAULT_TOLERANCE)
}

/// Where `[solver]` says when landings end.
pub(crate) fn stop<'d>(root: &Section<'d>) -> Result<Option<LocatedValue<'d>>, InputError> {
    let known = [&SOLVER[..], &method_input::KEYS].concat();
    let solver = root.optional_section("solver", &known)?;
    Ok(solver.and_then(|solver| solver.optional("stop")))
}

fn settings_from(root: &Section, default_tolerance: f64) -> Result<Settings, InputError> {
    let known = [&SOLVER[..], &method_input::KEYS].concat();
    let solver = root.optional_section("solver", &known)?;
    let number = |key| match &solver {
        Some(solver) => solver.optional_number(key),
        None => Ok(None),
    };
    let tolerance = number("tolerance")?;
    let method = method_input::read(solver.as_ref(), tolerance)?;
    let tolerance = tolerance.unwrap_or(default_tolerance);
    let time_limit = number("time_limit_s")?.unwrap_or(Settings::DEFAULT_TIME_LIMIT);
    let rule = match solver
        .as_ref()
        .and_then(|solver| solver.optional("crush_rule"))
    {
        Some(word) => crush_rule(word.text()?)
            .ok_or_else(|| word.complain("\"pivot-rate\" or \"section\""))?,
        None => CrushRule::default(),
    };
    let profile = match solver
        .as_ref()
        .and_then(|solver| solver.optional("friction_profile"))
    {
        Some(word) => {
            friction_profile(word.text()?).ok_or_else(|| word.complain("\"A\", \"B\" or \"C\""))?
        }
        None => FrictionProfile::default(),
    };
    let settings = Settings::new(tolerance, time_limit, rule)
        .map(|settings| settings.with_method(method).with_friction_profile(profile))
        .map_err(|invalid| solver.as_ref().unwrap_or(root).complain(&invalid))?;
    match solver.as_ref().and_then(|solver| solver.optional("stop")) {
        None => Ok(settings),
        Some(found) => match found.text() {
            Ok(word) if STOPS.contains(&word) => {
                stopping(settings, word).map_err(|why| found.complain_that(why))
            }
            _ => Err(found.complain("\"verdict\" or \"time\"")),
        },
    }
}

/// The same settings for landings that end as a word of [`STOPS`] says.
///
/// # Errors
/// Says why the method of the settings cannot.
pub fn stopping(settings: Settings, word: &str) -> Result<Settings, &'static str> {
    match (word == STOPS[1], settings.method()) {
        (false, _) => Ok(settings),
        (true, Method::Located) => Ok(settings.beyond_verdict()),
        (true, _) => Err("only the method \"located\" goes on beyond the verdict"),
    }
}

/// Letter of a friction profile in input files.
pub fn friction_profile_name(profile: FrictionProfile) -> &'static str {
    match profile {
        FrictionProfile::A => FRICTION_PROFILES[0],
        FrictionProfile::B => FRICTION_PROFILES[1],
        FrictionProfile::C => FRICTION_PROFILES[2],
    }
}

/// The friction profile of a letter in input files.
pub fn friction_profile(name: &str) -> Option<FrictionProfile> {
    [FrictionProfile::A, FrictionProfile::B, FrictionProfile::C]
        .into_iter()
        .find(|profile| friction_profile_name(*profile) == name)
}

/// Word of a crush rule in input files.
pub fn crush_rule_name(rule: CrushRule) -> &'static str {
    match rule {
        CrushRule::PivotRate => CRUSH_RULES[0],
        CrushRule::Section => CRUSH_RULES[1],
    }
}

/// The crush rule of a word in input files.
pub fn crush_rule(name: &str) -> Option<CrushRule> {
    [CrushRule::PivotRate, CrushRule::Section]
        .into_iter()
        .find(|rule| crush_rule_name(*rule) == name)
}
