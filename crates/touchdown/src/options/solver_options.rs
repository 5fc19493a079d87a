//! How landings are computed, on the command line.

use clap::Args;
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::rules::{CrushRule, FrictionProfile, RestRule};
use touchdown_dynamics::scene::Settings;
use touchdown_sweep::choice::{chosen, words};
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::method_input::{METHODS, MethodNumbers, method};
use touchdown_sweep::settings_input::{
    CRUSH_RULES, FRICTION_PROFILES, REST_RULES, STOPS, Stop, stopping,
};

use crate::touchdown_options::finite;

/// Solver settings.
#[derive(Debug, Args)]
#[command(next_help_heading = "Solver")]
pub struct SolverOptions {
    /// When an element may crush further: "pivot-rate" (as in the program of 1966), only while its pivot
    /// moves into the ground; "section", whenever it goes deeper than before
    #[arg(long, value_name = "RULE", default_value = "pivot-rate", value_parser = choice(&CRUSH_RULES))]
    crush_rule: CrushRule,
    /// When motion counts as subsided: within the "limits" of the program of 1966, made for the Surveyor; "energy", once the
    /// vehicle has had less than half of the energy that toppling takes for a while
    #[arg(long, value_name = "RULE", default_value = "limits", value_parser = choice(&REST_RULES))]
    rest_rule: RestRule,
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
    /// When a landing ends: at its "verdict", or at the "time" limit, its first verdict noted, to see what comes after
    #[arg(long, value_name = "WHEN", default_value = "verdict", value_parser = choice(&STOPS))]
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
        let settings = Settings::new(tolerance, time_limit, self.crush_rule)
            .map(|settings| {
                settings
                    .with_method(method)
                    .with_rest_rule(self.rest_rule)
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
