//! Settings of landings: the table `[solver]` of input files and its words.

use std::path::Path;

use serde_json::{Map, json};
use touchdown_dynamics::method::Method;
use touchdown_dynamics::quantities::{TIME_LIMIT, TOLERANCE};
use touchdown_dynamics::quantity::Quantity;
use touchdown_dynamics::rules::{
    ContactRule, CrushRule, FrictionProfile, RestRule, RuleChoices, Rules, TopplingRule,
};
use touchdown_dynamics::scene::{Settings, Stop};
use touchdown_dynamics::vehicle::Vehicle;

use crate::documents::document::{Document, Value};
use crate::documents::input_error::InputError;
use crate::documents::key_path::KeyPath;
use crate::documents::section::{LocatedValue, Section};
use crate::readers::choice::{choice, chosen_by, word, words};
use crate::readers::method_input::{self, method_name};
use crate::readers::numbers::{joined, keys_of};

/// Keys of `[solver]` for landings by any method.
pub const SOLVER: [&str; 9] = joined(&[&keys_of::<2>(&NUMBERS), &WORDS]);
/// Numbers of `[solver]` for landings by any method.
const NUMBERS: [Quantity; 2] = [TOLERANCE, TIME_LIMIT];
/// Keys that take words.
const WORDS: [&str; 7] = [
    "rules",
    "crush_rule",
    "contact_rule",
    "rest_rule",
    "toppling_rule",
    "friction_profile",
    "stop",
];

/// Keys of `[solver]` that take numbers.
pub(crate) fn numbers() -> impl Iterator<Item = &'static Quantity> {
    const { &NUMBERS }
        .iter()
        .chain(const { &method_input::NUMBERS })
}

/// All keys of `[solver]`.
pub(crate) fn solver_keys() -> Vec<&'static str> {
    [&SOLVER[..], &method_input::KEYS].concat()
}

/// Rule sets for landings.
pub const RULES: [(&str, Rules); 2] = [("1966", Rules::REPORT), ("physical", Rules::PHYSICAL)];
/// Rules for when an element may crush further.
pub const CRUSH_RULES: [(&str, CrushRule); 2] = [
    ("pivot-rate", CrushRule::PivotRate),
    ("section", CrushRule::Section),
];
/// Rules for where the ground acts on footpads and blocks.
pub const CONTACT_RULES: [(&str, ContactRule); 2] =
    [("pivot", ContactRule::Pivot), ("face", ContactRule::Face)];
/// Rules for when a landing counts as stable.
pub const REST_RULES: [(&str, RestRule); 2] =
    [("limits", RestRule::Limits), ("energy", RestRule::Energy)];
/// Rules for when a vehicle counts as toppled.
pub const TOPPLING_RULES: [(&str, TopplingRule); 2] = [
    ("critical-feet", TopplingRule::CriticalFeet),
    ("hull", TopplingRule::Hull),
];
/// Profiles of friction near rest.
pub const FRICTION_PROFILES: [(&str, FrictionProfile); 3] = [
    ("A", FrictionProfile::A),
    ("B", FrictionProfile::B),
    ("C", FrictionProfile::C),
];
/// Ends of a landing.
pub const STOPS: [(&str, Stop); 3] = [
    ("verdict", Stop::Verdict),
    ("rest", Stop::Rest),
    ("time", Stop::Time),
];

/// Keys of `[solver]` whose values are words, with these words.
pub(crate) fn word_keys() -> [(&'static str, Vec<&'static str>); 8] {
    [
        ("rules", words(&RULES)),
        ("crush_rule", words(&CRUSH_RULES)),
        ("contact_rule", words(&CONTACT_RULES)),
        ("rest_rule", words(&REST_RULES)),
        ("toppling_rule", words(&TOPPLING_RULES)),
        ("friction_profile", words(&FRICTION_PROFILES)),
        ("stop", words(&STOPS)),
        ("method", method_input::METHODS.to_vec()),
    ]
}

/// The rules in force by key: the best-matching set, then each rule.
pub fn rules_by_key(rules: Rules) -> [(&'static str, &'static str); 5] {
    let single = |rules: Rules| {
        [
            ("crush_rule", word(&CRUSH_RULES, rules.crush)),
            ("contact_rule", word(&CONTACT_RULES, rules.contact)),
            ("rest_rule", word(&REST_RULES, rules.rest)),
            ("toppling_rule", word(&TOPPLING_RULES, rules.toppling)),
        ]
    };
    let own = single(rules);
    let alike = |(_, set): &&(&str, Rules)| {
        let pairs = own.iter().zip(single(*set));
        pairs.filter(|(one, other)| **one == *other).count()
    };
    let set = RULES.iter().max_by_key(alike).map_or("", |(word, _)| word);
    let [crush, contact, rest, toppling] = own;
    [("rules", set), crush, contact, rest, toppling]
}

/// Settings of a vehicle's landings, as written to a report or record.
pub fn solver_in_record(settings: &Settings, vehicle: &Vehicle) -> serde_json::Value {
    let mut solver = json!({
        "tolerance": settings.tolerance(),
        "time_limit_s": settings.time_limit(),
        "friction_profile": word(&FRICTION_PROFILES, settings.friction_profile()),
        "method": method_name(&settings.method()),
        // All numbers of the method, to the last digit.
        "method_in_full": format!("{:?}", settings.method()),
    });
    for (key, word) in rules_in_record(settings.rules(vehicle)) {
        solver[key] = word;
    }
    if settings.stop() != Stop::Verdict {
        solver["stop"] = json!(word(&STOPS, settings.stop()));
    }
    solver
}

/// The rules in force, by key and in words.
fn rules_in_record(rules: Rules) -> Map<String, serde_json::Value> {
    let keys = rules_by_key(rules).into_iter();
    keys.map(|(key, word)| (key.to_owned(), json!(word)))
        .chain([("rules_in_full".to_owned(), json!(rules_in_words(rules)))])
        .collect()
}

/// The rules in force in words: the set, and deviations from it.
pub fn rules_in_words(rules: Rules) -> String {
    let [(_, set), single @ ..] = rules_by_key(rules);
    let whole = RULES.iter().find(|(word, _)| *word == set);
    let [_, regular @ ..] = rules_by_key(whole.map_or(rules, |(_, whole)| *whole));
    let others = single.iter().zip(regular);
    let others = others.filter(|(one, regular)| **one != *regular);
    let others = others.map(|((key, word), _)| format!(", {} {word}", key.replace('_', " ")));
    format!("{set} rules{}", others.collect::<String>())
}

/// Keys and words of `[solver]` for these choices of rules.
pub(crate) fn chosen_rules(choices: RuleChoices) -> Vec<(&'static str, &'static str)> {
    let RuleChoices {
        set,
        crush,
        contact,
        rest,
        toppling,
    } = choices;
    let keys = [
        ("rules", set.map(|set| word(&RULES, set))),
        ("crush_rule", crush.map(|rule| word(&CRUSH_RULES, rule))),
        (
            "contact_rule",
            contact.map(|rule| word(&CONTACT_RULES, rule)),
        ),
        ("rest_rule", rest.map(|rule| word(&REST_RULES, rule))),
        (
            "toppling_rule",
            toppling.map(|rule| word(&TOPPLING_RULES, rule)),
        ),
    ];
    (keys.into_iter())
        .filter_map(|(key, word)| Some((key, word?)))
        .collect()
}

/// Names of the choices of `[solver]` that legs of three struts leave no other than one.
const BOUND_BY_THREE_STRUTS: [&str; 6] = [
    "solver.method",
    "solver.rules",
    "solver.crush_rule",
    "solver.contact_rule",
    "solver.rest_rule",
    "solver.toppling_rule",
];

/// The first choice that does not go with legs of three struts: its name, its word, and the word that does.
pub(crate) fn choice_beside_three_struts(
    settings: &Settings,
) -> Option<(&'static str, &'static str, &'static str)> {
    let method = |method| ("method", method_name(&method));
    let mut given = chosen_rules(settings.rule_choices());
    given.push(method(settings.method()));
    let mut needed = rules_by_key(Rules::PHYSICAL).to_vec();
    needed.push(method(Method::Located));
    BOUND_BY_THREE_STRUTS.into_iter().find_map(|name| {
        let is_of = |(key, _): &&(&str, &str)| name.strip_prefix("solver.") == Some(key);
        let (_, word) = given.iter().find(is_of)?;
        let (_, allowed) = needed.iter().find(is_of)?;
        (word != allowed).then_some((name, *word, *allowed))
    })
}

/// Reads a choice of `[solver]`, if it is made.
fn chosen<T: Copy>(
    solver: &Section,
    key: &str,
    choices: &[(&str, T)],
) -> Result<Option<T>, InputError> {
    let given = solver.optional(key);
    given.map(|value| chosen_by(&value, choices)).transpose()
}

/// Reads the choices of rules from `[solver]`.
fn rule_choices(solver: &Section) -> Result<RuleChoices, InputError> {
    Ok(RuleChoices {
        set: chosen(solver, "rules", &RULES)?,
        crush: chosen(solver, "crush_rule", &CRUSH_RULES)?,
        contact: chosen(solver, "contact_rule", &CONTACT_RULES)?,
        rest: chosen(solver, "rest_rule", &REST_RULES)?,
        toppling: chosen(solver, "toppling_rule", &TOPPLING_RULES)?,
    })
}

/// Reads `[solver]` of a sweep whose landings end at `stop` where it does not say; other missing keys have the program's
/// defaults.
pub(crate) fn settings(root: &Section, stop: Stop) -> Result<Settings, InputError> {
    settings_from(root, Settings::BOUNDARY_TOLERANCE, stop)
}

/// Reads `[solver]` of single landings.
pub(crate) fn settings_of_landing(root: &Section) -> Result<Settings, InputError> {
    settings_from(root, Settings::DEFAULT_TOLERANCE, Stop::default())
}

/// Settings of single landings by the method "located", with these values of `[solver]` replaced. The tolerance stays
/// only where the method does.
///
/// # Errors
/// If a value is not allowed. The error has no place.
pub fn settings_with<'v>(
    given: &Settings,
    values: impl Iterator<Item = (&'v KeyPath, &'v Value)> + Clone,
) -> Result<Settings, InputError> {
    let method = KeyPath::parse("solver.method");
    let is_located = |(path, value): (&KeyPath, &Value)| {
        Some(path) != method.as_ref()
            || matches!(value, Value::Text(word) if word == method_name(&Method::Located))
    };
    let mut text = format!(
        "[solver]\ntime_limit_s = {}\nfriction_profile = \"{}\"\nstop = \"{}\"\n",
        given.time_limit(),
        word(&FRICTION_PROFILES, given.friction_profile()),
        word(&STOPS, given.stop())
    );
    for (key, word) in chosen_rules(given.rule_choices()) {
        text += &format!("{key} = \"{word}\"\n");
    }
    if values.clone().all(is_located) {
        text += &format!("tolerance = {}\n", given.tolerance());
    }
    let mut document = Document::parse(Path::new("solver"), &text)?;
    for (path, value) in values {
        document.write(path, value.clone());
    }
    Section::root(&document, &["solver"])
        .and_then(|root| settings_of_landing(&root))
        .map_err(InputError::nowhere)
}

/// Location of the `stop` key in `[solver]`.
pub(crate) fn stop<'d>(root: &Section<'d>) -> Result<Option<LocatedValue<'d>>, InputError> {
    let solver = root.optional_section("solver", &solver_keys())?;
    Ok(solver.and_then(|solver| solver.optional("stop")))
}

fn settings_from(
    root: &Section,
    default_tolerance: f64,
    default_stop: Stop,
) -> Result<Settings, InputError> {
    let Some(solver) = root.optional_section("solver", &solver_keys())? else {
        return (Settings::default().stopping_at(default_stop))
            .with_tolerance(default_tolerance)
            .map_err(|invalid| root.complain(&invalid));
    };
    let tolerance = solver.optional_number(TOLERANCE.key)?;
    let method = method_input::read(&solver, tolerance)?;
    let tolerance = tolerance.unwrap_or(default_tolerance);
    let time_limit =
        (solver.optional_number(TIME_LIMIT.key)?).unwrap_or(Settings::DEFAULT_TIME_LIMIT);
    let rules = rule_choices(&solver)?;
    let friction_profile = choice(&solver, "friction_profile", &FRICTION_PROFILES)?;
    let settings = Settings::default()
        .with_time_limit(time_limit)
        .and_then(|settings| settings.with_tolerance(tolerance))
        .map_err(|invalid| solver.complain(&invalid))?
        .with_method(method)
        .with_rules(rules)
        .with_friction_profile(friction_profile);
    let stop = chosen(&solver, "stop", &STOPS)?.unwrap_or(default_stop);
    stopping(settings, stop).map_err(|why| match solver.optional("stop") {
        Some(found) => found.complain_that(why),
        None => InputError::other(why),
    })
}

/// Changes settings so that landings end at `stop`.
///
/// # Errors
/// The reason why the method of the settings does not allow it.
pub fn stopping(settings: Settings, stop: Stop) -> Result<Settings, &'static str> {
    match (stop, settings.method()) {
        (Stop::Verdict | Stop::Rest, _) | (_, Method::Located) => Ok(settings.stopping_at(stop)),
        (Stop::Time, _) => Err("only the method \"located\" goes on beyond the verdict"),
    }
}
