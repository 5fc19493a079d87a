//! `parameters`: every number of scene, attitude, vehicle and solver, with slider data.

mod groups;
mod ranges;
mod slider;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use touchdown_dynamics::attitude::Attitude;
use touchdown_dynamics::quantities::{BEARING_FACTOR, STATIC_FRICTION_RATIO};
use touchdown_dynamics::rules::FrictionProfile;
use touchdown_figures::axis_title::bare_title;
use touchdown_figures::unit::unit_of;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::assignment::{self, Assignment};
use touchdown_input::points::parameter::{self, Home, Parameter};
use touchdown_input::readers::choice::word;
use touchdown_input::readers::settings_input::{FRICTION_PROFILES, STOPS, rules_by_key};
use touchdown_input::readers::vehicle_file::{self, VehicleFile};

use super::complaint::Complaint;
use super::request::{Asked, read, written};
use super::touchdown::Touchdown;
use crate::named::Named;

use ranges::Allowed;
use slider::Slider;

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
#[derive(Default)]
struct Request {
    touchdown: Asked,
}

#[derive(Serialize)]
struct Told {
    name: String,
    title: String,
    /// Meaning, as `docs/reference.md` says it; empty for words.
    meaning: &'static str,
    unit: String,
    value: Value,
    /// True if the input gives it; false for a default.
    is_given: bool,
    slider: Option<Slider>,
    si: Option<InSi>,
    allowed: Allowed,
    group: &'static str,
    leg: Option<usize>,
    /// For a leg's number: true if the leg has its own.
    is_own: bool,
    words: Vec<&'static str>,
}

#[derive(Serialize)]
struct InSi {
    name: String,
    unit: String,
    value: f64,
    slider: Option<Slider>,
}

pub fn answer(named: &Named, request: &str) -> Result<String, Complaint> {
    let request: Request = read(request)?;
    let touchdown = Touchdown::of(named, &request.touchdown)?;
    let legs = touchdown.vehicle.vehicle.leg_count();
    let mut told: Vec<Told> = parameter::names(legs)
        .filter_map(|name| tell(&touchdown, Parameter::named(&name, legs)?))
        .collect();
    told.sort_by_key(|one| (one.leg.is_some(), groups::place(one.group)));
    written(&json!({ "parameters": told }))
}

fn tell(touchdown: &Touchdown, parameter: Parameter) -> Option<Told> {
    let name = parameter.program_name();
    let (value, is_given) = match parameter.home() {
        Home::Scene => of_scene(touchdown, &parameter)?,
        Home::Vehicle => (of_vehicle(touchdown, &parameter)?, true),
        Home::Sweep => return of_solver(touchdown, &parameter),
    };
    let quantity = parameter.quantity()?;
    let (group, leg) = groups::of(name, quantity);
    let allowed = Allowed::of(Some(quantity));
    let shown = ranges::shown(quantity, value);
    let in_si = OutputUnits::Si.quantity(name);
    Some(Told {
        title: bare_title(name),
        meaning: quantity.meaning,
        unit: unit_of(name),
        value: json!(value),
        is_given,
        slider: Some(Slider::over(shown, value, &allowed)),
        si: (in_si.name() != name).then(|| InSi {
            name: in_si.name().to_owned(),
            unit: unit_of(in_si.name()),
            value: in_si.number(value),
            slider: Some(Slider::over(
                shown.map(|end| in_si.number(end)),
                in_si.number(value),
                &allowed.in_unit(|end| in_si.number(end)),
            )),
        }),
        allowed,
        group,
        leg,
        is_own: leg.is_some() && is_own(touchdown, &parameter),
        words: Vec::new(),
        name: name.to_owned(),
    })
}

/// Value of a condition, and whether it is given; `None` if it does not apply to this touchdown.
fn of_scene(touchdown: &Touchdown, parameter: &Parameter) -> Option<(f64, bool)> {
    let (name, quantity) = (parameter.program_name(), parameter.quantity()?);
    let conditions = &touchdown.conditions;
    if let Some(value) = conditions.get(name) {
        return Some((value, true));
    }
    let resolved = conditions.resolved();
    if let Some((_, value)) = resolved.iter().find(|(known, _)| *known == name) {
        return Some((*value, false));
    }
    if name.starts_with("thrust.") {
        let has_thrust = !conditions.thrust_knots().is_empty();
        return quantity
            .default_number()
            .filter(|_| has_thrust)
            .map(|value| (value, false));
    }
    if name.starts_with("soil.") || quantity.key == BEARING_FACTOR.key {
        let has_soil = resolved.iter().any(|(known, _)| known.starts_with("soil."));
        let default = quantity.default_number().filter(|_| has_soil);
        return default.map(|value| (value, false));
    }
    if let Some(of_pad) = name
        .split_once("].block_")
        .map(|(leg, key)| format!("{leg}].{key}"))
    {
        let of_pad = Parameter::named(&of_pad, touchdown.vehicle.vehicle.leg_count())?;
        return of_scene(touchdown, &of_pad).map(|(value, _)| (value, false));
    }
    if name.starts_with("footing[") {
        return quantity.default_number().map(|value| (value, false));
    }
    if name == STATIC_FRICTION_RATIO.key {
        return Some((FrictionProfile::STATIC_RATIO, false));
    }
    if name == "gravity_fps2" {
        return Some((touchdown.vehicle.vehicle.gravity(), false));
    }
    let attitude = touchdown.scene().ok()?.conditions().attitude;
    Some((in_other_form(&attitude, name)?, false))
}

/// An angle of the attitude in the form not given, deg.
fn in_other_form(attitude: &Attitude, name: &str) -> Option<f64> {
    let (euler, tip) = (attitude.euler(), attitude.tip());
    let angle = match name {
        "pitch_deg" => euler.pitch,
        "yaw_deg" => euler.yaw,
        "roll_deg" => euler.roll,
        "tip_deg" => tip.tip,
        "tip_azimuth_deg" => tip.azimuth,
        "nominal_roll_deg" => tip.nominal_roll,
        _ => return None,
    };
    // Removes rounding errors of the conversion to radians and back.
    const STEPS: f64 = 1e9;
    Some((angle.to_degrees() * STEPS).round() / STEPS + 0.0)
}

/// Value of a number of the vehicle; `None` if it has no such part.
fn of_vehicle(touchdown: &Touchdown, parameter: &Parameter) -> Option<f64> {
    let file = &touchdown.vehicle;
    let value = vehicle_file::number(&file.document, parameter.path())?;
    // A scale defaults to 1 even for a table that this vehicle lacks, but cannot be set there.
    if parameter.program_name().ends_with(".scale") {
        let same = Assignment::new(parameter.program_name(), &value.to_string()).ok()?;
        let document = assignment::vehicle_document(file.document.clone(), &[same]).ok()?;
        VehicleFile::from_document(document).ok()?;
    }
    Some(value)
}

fn is_own(touchdown: &Touchdown, parameter: &Parameter) -> bool {
    let document = &touchdown.vehicle.document;
    parameter.home() == Home::Scene && touchdown.conditions.get(parameter.program_name()).is_some()
        || document.number(parameter.path()).is_some()
}

fn of_solver(touchdown: &Touchdown, parameter: &Parameter) -> Option<Told> {
    let name = parameter.program_name();
    let settings = &touchdown.settings;
    let key = name.strip_prefix("solver.")?;
    let (value, slider) = match key {
        "tolerance" => (json!(settings.tolerance()), None),
        "time_limit_s" => {
            let limit = settings.time_limit();
            let shown = ranges::shown(parameter.quantity()?, limit);
            let slider = Slider::over(shown, limit, &Allowed::of(parameter.quantity()));
            (json!(limit), Some(slider))
        }
        "friction_profile" => (
            json!(word(&FRICTION_PROFILES, settings.friction_profile())),
            None,
        ),
        "stop" => (json!(word(&STOPS, settings.stop())), None),
        _ => {
            let rules = rules_by_key(settings.rules(&touchdown.vehicle.vehicle));
            let (_, word) = rules.into_iter().find(|(rule, _)| *rule == key)?;
            (json!(word), None)
        }
    };
    Some(Told {
        name: name.to_owned(),
        title: bare_title(name),
        meaning: parameter.quantity().map_or("", |quantity| quantity.meaning),
        unit: unit_of(name),
        value,
        is_given: touchdown.gives_solver(key),
        slider,
        si: None,
        allowed: Allowed::of(parameter.quantity()),
        group: "solver",
        leg: None,
        is_own: false,
        words: parameter.words().to_vec(),
    })
}
