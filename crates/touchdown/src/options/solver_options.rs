//! How landings are computed, on the command line.

use clap::Args;
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::methods::Method;
use touchdown_dynamics::rules::{
    ContactRule, CrushRule, FrictionProfile, RestRule, RuleChoices, Rules, TopplingRule,
};
use touchdown_dynamics::scene::{Settings, Stop};
use touchdown_input::documents::document::Value;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::points::assignment::Assignment;
use touchdown_input::readers::choice::{chosen, words};
use touchdown_input::readers::method_input::{METHODS, MethodNumbers, method};
use touchdown_input::readers::settings_input::{
    CONTACT_RULES, CRUSH_RULES, FRICTION_PROFILES, REST_RULES, RULES, STOPS, TOPPLING_RULES,
    settings_with, stopping,
};

use crate::touchdown_options::finite;

/// Solver settings.
#[derive(Debug, Args)]
#[command(next_help_heading = "Solver")]
pub struct SolverOptions {
    /// Rules by which the vehicle lands, in place of those of its file: "1966", those of the report's program, or "physical",
    /// those for any lander on any ground. The next options replace one of them
    #[arg(long, value_name = "RULES", value_parser = choice(&RULES))]
    rules: Option<Rules>,
    /// When an element may crush further: "pivot-rate" (as in the program of 1966), only while its pivot
    /// moves into the ground; "section", whenever it goes deeper than before
    #[arg(long, value_name = "RULE", value_parser = choice(&CRUSH_RULES))]
    crush_rule: Option<CrushRule>,
    /// Where the ground acts on footpads and blocks: at the "pivot" of a pad, by whose velocity friction is judged (as in the
    /// program of 1966); "face", where it touches, by the velocity of that place
    #[arg(long, value_name = "RULE", value_parser = choice(&CONTACT_RULES))]
    contact_rule: Option<ContactRule>,
    /// When a landing counts as stable: within the "limits" of the program of 1966, made for the Surveyor; "energy", once it
    /// has stood for a while on supports over which its energy cannot tip it
    #[arg(long, value_name = "RULE", value_parser = choice(&REST_RULES))]
    rest_rule: Option<RestRule>,
    /// When the vehicle counts as toppled: once its CG has passed over the line through the "critical-feet", in the plane of
    /// its motion (as in the program of 1966), or has left the "hull" of all feet
    #[arg(long, value_name = "RULE", value_parser = choice(&TOPPLING_RULES))]
    toppling_rule: Option<TopplingRule>,
    /// How friction sets in near rest (4.1.5 of the report): A, B or C, as in the 1966 program
    #[arg(long, value_name = "PROFILE", default_value = "C", value_parser = choice(&FRICTION_PROFILES))]
    friction_profile: FrictionProfile,
    /// Integration method. "located" finds every change of a law in time; the others are those of 1966:
    /// "report" is the report's own step doubling, the rest are the methods it was compared with
    #[arg(long, value_name = "METHOD", default_value = "located", value_parser = METHODS)]
    method: String,
    /// Relative error tolerance per step of "located", from 1e-12 to 1e-2 [default: 1e-6]
    #[arg(long, value_name = "TOL", value_parser = finite, allow_hyphen_values = true)]
    tolerance: Option<f64>,
    /// Factor of all error limits of "report" and "milne" [default: 1]
    #[arg(long, value_name = "FACTOR", value_parser = finite, allow_hyphen_values = true)]
    error_scale: Option<f64>,
    /// First interval of "report" and "milne", s [default: 0.0005]
    #[arg(long, value_name = "S", value_parser = finite, allow_hyphen_values = true)]
    first_interval: Option<f64>,
    /// Shortest interval of "report" and "milne", s [default: 1e-6]
    #[arg(long, value_name = "S", value_parser = finite, allow_hyphen_values = true)]
    least_interval: Option<f64>,
    /// Interval of "rk4" and "trapezoidal", s [default: 0.002]
    #[arg(long, value_name = "S", value_parser = finite, allow_hyphen_values = true)]
    fixed_interval: Option<f64>,
    /// Time at which a landing without an outcome ends as time-expired, s [default: 40]
    #[arg(long, value_name = "S", value_parser = finite, allow_hyphen_values = true)]
    time_limit: Option<f64>,
    /// When a landing ends: as soon as its "verdict" is known, once it has come to "rest", or at the "time" limit, its first
    /// verdict noted, to see what comes after
    #[arg(long, value_name = "WHEN", default_value = "rest", value_parser = choice(&STOPS))]
    stop: Stop,
}

/// The choice that a word stands for.
pub fn choice<T: Copy + Send + Sync>(
    choices: &'static [(&'static str, T)],
) -> impl Fn(&str) -> Result<T, String> + Clone {
    let expected = || format!("expected {}", words(choices).join(" or "));
    move |word| chosen(choices, word).ok_or_else(expected)
}

impl SolverOptions {
    /// The settings, with those that are set by name in place of those of the options.
    pub fn settings_with(&self, set: &[Assignment]) -> Result<Settings, InputError> {
        let settings = self.settings()?;
        let of_solver = || set.iter().filter(|one| one.is_of_solver());
        let Some(first) = of_solver().next() else {
            return Ok(settings);
        };
        if settings.method() != Method::Located {
            return Err(first.refuse("not beside --method: set solver.method too"));
        }
        let values: Vec<Value> = of_solver().map(Assignment::value).collect();
        let values = of_solver().map(Assignment::path).zip(&values);
        settings_with(&settings, values)
            .map_err(|error| InputError::other(format!("--set {error}")))
    }

    /// The settings, with complaints in the words of the command line.
    pub fn settings(&self) -> Result<Settings, InputError> {
        let numbers = MethodNumbers {
            tolerance: self.tolerance,
            error_scale: self.error_scale,
            first_interval: self.first_interval,
            least_interval: self.least_interval,
            interval: self.fixed_interval,
            limits: None,
        };
        let method = method(&self.method, &numbers).map_err(in_options)?;
        let tolerance = self.tolerance.unwrap_or(Settings::DEFAULT_TOLERANCE);
        let time_limit = self.time_limit.unwrap_or(Settings::DEFAULT_TIME_LIMIT);
        let rules = RuleChoices {
            set: self.rules,
            crush: self.crush_rule,
            contact: self.contact_rule,
            rest: self.rest_rule,
            toppling: self.toppling_rule,
        };
        let settings = Settings::default()
            .with_time_limit(time_limit)
            .and_then(|settings| settings.with_tolerance(tolerance))
            .map(|settings| {
                settings
                    .with_method(method)
                    .with_rules(rules)
                    .with_friction_profile(self.friction_profile)
            })
            .map_err(in_options)?;
        stopping(settings, self.stop)
            .map_err(|why| InputError::other(format!("--stop time: {why}")))
    }
}

/// A complaint under the name of the option.
fn in_options(invalid: Invalid) -> InputError {
    let option = match invalid.quantity.as_str() {
        "time_limit_s" => "--time-limit",
        "error_scale" => "--error-scale",
        "first_interval_s" => "--first-interval",
        "least_interval_s" => "--least-interval",
        "interval_s" => "--fixed-interval",
        _ => "--tolerance",
    };
    InputError::value(option, invalid.value, &invalid.allowed)
}
