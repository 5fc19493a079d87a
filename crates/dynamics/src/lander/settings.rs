//! Settings of a computation of a landing.

use super::method::Method;
use super::vehicle::Vehicle;
use crate::invalid::Invalid;
use crate::quantities::{TIME_LIMIT, TOLERANCE};
use crate::rules::{ContactRule, CrushRule, FrictionProfile, RuleChoices, Rules};

/// When a landing ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Stop {
    /// At its verdict, as soon as that is known: for searches. Strokes and loads may still grow after it.
    Verdict,
    /// At its verdict, which waits, if it is that the vehicle stands, until hardly any motion is left: strokes, loads and
    /// clearances are those of the whole landing. The rules of 1966 wait for nothing.
    #[default]
    Rest,
    /// At the time limit, or where the model ends. The verdict is noted as soon as it is known.
    Time,
}

/// Settings of the computation of a landing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    tolerance: f64,
    time_limit: f64,
    rules: RuleChoices,
    method: Method,
    friction_profile: FrictionProfile,
    ends_early: bool,
    stop: Stop,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            tolerance: Self::DEFAULT_TOLERANCE,
            time_limit: Self::DEFAULT_TIME_LIMIT,
            rules: RuleChoices::default(),
            method: Method::default(),
            friction_profile: FrictionProfile::default(),
            ends_early: false,
            stop: Stop::default(),
        }
    }
}

impl Settings {
    /// Default tolerance of a single landing: trajectories to 1e-6 ft. At 3e-6 two of the 400 reference landings
    /// deviate more than allowed, one in a contact, one in its energy.
    pub const DEFAULT_TOLERANCE: f64 = 1e-6;
    /// Default tolerance of a boundary search: the loosest at which every transition of the level grid lies well within
    /// 5e-4 ft/s of the converged one (`results/work-precision.csv`).
    pub const BOUNDARY_TOLERANCE: f64 = 3e-5;
    /// Time limit t_f of the report's runs, s.
    pub const DEFAULT_TIME_LIMIT: f64 = TIME_LIMIT.default_number().unwrap();

    /// Checks solver settings: relative tolerance, time limit (s) and crush rule.
    ///
    /// # Errors
    /// The tolerance must lie in [1e-12, 1e-2], the time limit in (0, 10000] s.
    pub fn new(tolerance: f64, time_limit: f64, crush_rule: CrushRule) -> Result<Self, Invalid> {
        Self::default()
            .with_crush_rule(crush_rule)
            .with_time_limit(time_limit)?
            .with_tolerance(tolerance)
    }

    /// The same settings with another time limit, s.
    ///
    /// # Errors
    /// It must lie in (0, 10000] s.
    pub fn with_time_limit(self, time_limit: f64) -> Result<Self, Invalid> {
        TIME_LIMIT.check("", time_limit)?;
        Ok(Self { time_limit, ..self })
    }

    /// The same settings under another crush rule.
    pub fn with_crush_rule(self, rule: CrushRule) -> Self {
        self.with_rules(RuleChoices {
            crush: Some(rule),
            ..self.rules
        })
    }

    /// The same settings under another rule of contact.
    pub fn with_contact_rule(self, rule: ContactRule) -> Self {
        self.with_rules(RuleChoices {
            contact: Some(rule),
            ..self.rules
        })
    }

    /// The same settings with other choices of rules.
    pub fn with_rules(self, rules: RuleChoices) -> Self {
        Self { rules, ..self }
    }

    /// The same settings with another onset of friction.
    pub fn with_friction_profile(self, friction_profile: FrictionProfile) -> Self {
        Self {
            friction_profile,
            ..self
        }
    }

    /// The same settings at another tolerance.
    ///
    /// # Errors
    /// It must lie in [1e-12, 1e-2].
    pub fn with_tolerance(self, tolerance: f64) -> Result<Self, Invalid> {
        TOLERANCE.check("", tolerance)?;
        Ok(Self { tolerance, ..self })
    }

    /// Returns these settings with landings that end as [`crate::outcome::Outcome::StableSteady`] once they are steady: for
    /// scans, which ask only for the outcome.
    pub fn ending_early(self) -> Self {
        Self {
            ends_early: true,
            ..self
        }
    }

    /// Returns these settings with landings that end there.
    pub fn stopping_at(self, stop: Stop) -> Self {
        Self { stop, ..self }
    }

    /// When a landing ends.
    pub fn stop(&self) -> Stop {
        self.stop
    }

    /// Returns whether a landing goes on beyond its verdict.
    pub fn goes_on(&self) -> bool {
        self.stop == Stop::Time
    }

    /// Returns whether steady landings end early.
    pub fn ends_early(&self) -> bool {
        self.ends_early
    }

    /// Onset of friction near rest.
    pub fn friction_profile(&self) -> FrictionProfile {
        self.friction_profile
    }

    /// The same settings with another method.
    pub fn with_method(self, method: Method) -> Self {
        Self { method, ..self }
    }

    /// Method of integration.
    pub fn method(&self) -> Method {
        self.method
    }

    /// Relative error tolerance per step of the method that locates events.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Time at which a landing without an outcome is given up, s.
    pub fn time_limit(&self) -> f64 {
        self.time_limit
    }

    /// Choices of rules in the settings.
    pub fn rule_choices(&self) -> RuleChoices {
        self.rules
    }

    /// The rules in force for a vehicle. The methods of 1966 know only the rules of 1966, except for crushing.
    pub fn rules(&self, vehicle: &Vehicle) -> Rules {
        let rules = self.rules.over(vehicle.rules());
        match self.method {
            Method::Located => rules,
            _ => Rules {
                crush: rules.crush,
                ..Rules::REPORT
            },
        }
    }
}
