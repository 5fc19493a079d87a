//! How landings are computed: the table `[solver]` of input files, and the words in it.

use touchdown_dynamics::method::Method;
use touchdown_dynamics::rules::{CrushRule, FrictionProfile, RestRule};
use touchdown_dynamics::scene::Settings;

use crate::choice::{choice, words};
use crate::input_error::InputError;
use crate::method_input;
use crate::section::{LocatedValue, Section};

/// Keys of `[solver]`.
pub const SOLVER: [&str; 6] = [
    "tolerance",
    "time_limit_s",
    "crush_rule",
    "rest_rule",
    "friction_profile",
    "stop",
];
/// When an element may crush further.
pub const CRUSH_RULES: [(&str, CrushRule); 2] = [
    ("pivot-rate", CrushRule::PivotRate),
    ("section", CrushRule::Section),
];
/// When motion counts as subsided.
pub const REST_RULES: [(&str, RestRule); 2] =
    [("limits", RestRule::Limits), ("energy", RestRule::Energy)];
/// How friction sets in near rest.
pub const FRICTION_PROFILES: [(&str, FrictionProfile); 3] = [
    ("A", FrictionProfile::A),
    ("B", FrictionProfile::B),
    ("C", FrictionProfile::C),
];
/// When a landing ends: at its verdict, or at the time limit.
pub const STOPS: [(&str, Stop); 2] = [("verdict", Stop::Verdict), ("time", Stop::Time)];

/// When a landing ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stop {
    /// At its verdict.
    #[default]
    Verdict,
    /// At the time limit, its verdict noted.
    Time,
}

/// Keys of `[solver]` whose values are words, and these.
pub(crate) fn word_keys() -> [(&'static str, Vec<&'static str>); 5] {
    [
        ("crush_rule", words(&CRUSH_RULES)),
        ("rest_rule", words(&REST_RULES)),
        ("friction_profile", words(&FRICTION_PROFILES)),
        ("stop", words(&STOPS)),
        ("method", method_input::METHODS.to_vec()),
    ]
}

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
    let Some(solver) = root.optional_section("solver", &known)? else {
        return (Settings::default().with_tolerance(default_tolerance))
            .map_err(|invalid| root.complain(&invalid));
    };
    let tolerance = solver.optional_number("tolerance")?;
    let method = method_input::read(&solver, tolerance)?;
    let tolerance = tolerance.unwrap_or(default_tolerance);
    let time_limit =
        (solver.optional_number("time_limit_s")?).unwrap_or(Settings::DEFAULT_TIME_LIMIT);
    let crush_rule = choice(&solver, "crush_rule", &CRUSH_RULES)?;
    let rest_rule = choice(&solver, "rest_rule", &REST_RULES)?;
    let friction_profile = choice(&solver, "friction_profile", &FRICTION_PROFILES)?;
    let settings = Settings::new(tolerance, time_limit, crush_rule)
        .map_err(|invalid| solver.complain(&invalid))?
        .with_method(method)
        .with_rest_rule(rest_rule)
        .with_friction_profile(friction_profile);
    let stop = choice(&solver, "stop", &STOPS)?;
    stopping(settings, stop).map_err(|why| match solver.optional("stop") {
        Some(found) => found.complain_that(why),
        None => InputError::other(why),
    })
}

/// The same settings for landings that end so.
///
/// # Errors
/// Says why the method of the settings cannot.
pub fn stopping(settings: Settings, stop: Stop) -> Result<Settings, &'static str> {
    match (stop, settings.method()) {
        (Stop::Verdict, _) => Ok(settings),
        (Stop::Time, Method::Located) => Ok(settings.beyond_verdict()),
        (Stop::Time, _) => Err("only the method \"located\" goes on beyond the verdict"),
    }
}
