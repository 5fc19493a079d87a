//! The report of one landing, as text and as JSON.

use serde_json::{Map, Value, json};
use touchdown_dynamics::landing::{Landing, LegWork};
use touchdown_dynamics::methods::IntegrationSummary;
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::scene::Settings;
use touchdown_sweep::assignment::Assignment;
use touchdown_sweep::fingerprint::fingerprint;
use touchdown_sweep::landing_table;
use touchdown_sweep::method_input::{method_name, method_words};
use touchdown_sweep::parameter::Home;
use touchdown_sweep::results;
use touchdown_sweep::scene_input::NamedConditions;
use touchdown_sweep::settings_input::{crush_rule_name, friction_profile_name};
use touchdown_sweep::vehicle_file::VehicleFile;

use crate::integration_report;
use crate::summary::number;

/// An angle (rad) in degrees to so many decimals, without the sign of what is zero but for rounding.
pub fn degrees(angle: f64, decimals: u8) -> String {
    let unit = 10f64.powi(i32::from(decimals));
    let rounded = (unit * angle.to_degrees()).round() / unit + 0.0;
    format!("{rounded:.*}", usize::from(decimals))
}

/// The report as text.
pub fn text(
    vehicle: &VehicleFile,
    set: &[Assignment],
    conditions: &NamedConditions,
    settings: &Settings,
    landing: &Landing,
    integration: &IntegrationSummary,
) -> String {
    let given: Vec<String> = conditions
        .resolved()
        .into_iter()
        .map(|(name, value)| format!("{name} {value}"))
        .collect();
    let energies = &landing.energies;
    let work = |of: fn(&LegWork) -> f64| energies.legs.iter().map(of).sum::<f64>();
    let changes: String = (set.iter())
        .filter(|one| one.parameter().home() == Home::Vehicle)
        .map(|one| format!("with {} = {}\n", one.parameter().name(), one.text()))
        .collect();
    let name = &vehicle.name;
    let mut lines = Lines(format!("{name}\n{changes}{}\n\n", wrapped(&given)));
    lines.add(
        "outcome",
        format!("{} at {:.6} s", landing.outcome, verdict_time(landing)),
    );
    lines.add("why", why(&landing.outcome));
    if let Some(beyond) = &landing.beyond {
        let said = format!("to {:.6} s: {}", landing.end_time, beyond.end);
        lines.add("went on", said);
    }
    lines.add(
        "least stability angle",
        format!(
            "{} deg at {:.4} s",
            degrees(landing.min_stability_angle, 4),
            landing.min_stability_time
        ),
    );
    lines.add(
        "least ground clearance",
        format!("{:.5} ft", landing.min_clearance),
    );
    let legs = landing.leg_count();
    lines.legs("leg", (1..=legs).map(|leg| leg.to_string()));
    lines.legs(
        "footpad contact, s",
        landing.pad_contact.into_iter().map(time),
    );
    lines.legs(
        "block contact, s",
        landing.block_contact.into_iter().map(time),
    );
    lines.legs(
        "largest strut force, lb",
        landing
            .max_strut_force
            .into_iter()
            .map(|f| format!("{f:.1}")),
    );
    lines.energy("kinetic energy at contact", energies.initial_kinetic);
    lines.energy("+ potential energy released", energies.potential_change);
    if energies.thrust != 0.0 {
        lines.energy("+ work of the thrust", energies.thrust);
    }
    lines.energy("- struts", work(|leg| leg.strut));
    lines.energy("- footpads, crushing", work(|leg| leg.pad_crush));
    lines.energy("- footpads, sliding", work(|leg| leg.pad_friction));
    lines.energy("- blocks, crushing", work(|leg| leg.block_crush));
    lines.energy("- blocks, sliding", work(|leg| leg.block_friction));
    lines.energy("- stops", work(|leg| leg.stop));
    lines.energy("- kinetic energy at the end", energies.final_kinetic);
    lines.add("= closure", format!("{:>14.3e} ft lb", energies.closure()));
    lines.add(
        "computation",
        format!(
            "{}, {}, {}",
            number(landing.steps, "step"),
            number(landing.events, "event"),
            number(landing.evaluations, "derivative evaluation"),
        ),
    );
    lines.add(
        "",
        format!(
            "{}, crush rule {}",
            method_words(&settings.method(), settings.tolerance()),
            crush_rule_name(settings.crush_rule())
        ),
    );
    lines.0 + &integration_report::text(integration, legs)
}

/// When the verdict fell, s.
fn verdict_time(landing: &Landing) -> f64 {
    let beyond = landing.beyond.as_ref();
    beyond.map_or(landing.end_time, |beyond| beyond.verdict_time)
}

/// What is to be told of a landing although its account closes: elements that gave back more than they took.
pub fn warning(landing: &Landing) -> Option<String> {
    let given = landing.energies.given_by_crushing();
    (given > 0.0).then(|| given_by_crushing(given))
}

/// The warning that crushing elements gave so much energy, ft·lb.
pub fn given_by_crushing(energy: f64) -> String {
    format!(
        "crushing footpads or blocks added {energy:.4} ft lb to the motion, which no material does: \
         they are too stiff for the crush laws"
    )
}

/// Lines of a name and what belongs to it.
struct Lines(String);

impl Lines {
    fn add(&mut self, name: &str, value: impl std::fmt::Display) {
        self.0 += &format!("{name:<28} {value}\n");
    }

    fn legs(&mut self, name: &str, values: impl Iterator<Item = String>) {
        let cells: String = values.map(|value| format!("{value:>12}")).collect();
        self.add(name, cells);
    }

    fn energy(&mut self, name: &str, value: f64) {
        self.add(name, format!("{value:>14.4} ft lb"));
    }
}

fn time(contact: Option<f64>) -> String {
    contact.map_or("never".to_owned(), |time| format!("{time:.6}"))
}

fn wrapped(parts: &[String]) -> String {
    parts
        .chunks(4)
        .map(|line| line.join(", "))
        .collect::<Vec<_>>()
        .join(",\n")
}

fn why(outcome: &Outcome) -> String {
    match outcome {
        Outcome::StableRockback => "it tipped up, stopped and fell back".to_owned(),
        Outcome::StableSubsided => "its motion died out near the ground".to_owned(),
        Outcome::UnstablePitch => {
            "its CG passed over the line through the critical feet".to_owned()
        }
        Outcome::UnstableYaw => "all feet are on one side of the plane of motion".to_owned(),
        Outcome::Bottomed { leg } => format!("strut {} used up its stroke", leg + 1),
        Outcome::TimeExpired => "it was still moving at the time limit".to_owned(),
        Outcome::Failure(reason) => reason.to_string(),
        Outcome::Sliding => {
            "it slides steadily down a slope on which friction cannot stop it".to_owned()
        }
        Outcome::StableSteady => "it was steady and far from toppling".to_owned(),
    }
}

/// The report as JSON.
pub fn json(
    vehicle: &VehicleFile,
    set: &[Assignment],
    conditions: &NamedConditions,
    settings: &Settings,
    landing: &Landing,
    integration: &IntegrationSummary,
) -> Value {
    let scene: Map<String, Value> = conditions
        .resolved()
        .into_iter()
        .map(|(name, value)| (name.to_owned(), json!(value)))
        .collect();
    let result: Map<String, Value> = landing_table::columns(landing)
        .into_iter()
        .map(|(name, cell)| (name, cell.into()))
        .collect();
    let work = landing.energies.legs.iter().map(|leg| {
        json!({
            "strut_ftlb": leg.strut,
            "pad_crush_ftlb": leg.pad_crush,
            "pad_friction_ftlb": leg.pad_friction,
            "block_crush_ftlb": leg.block_crush,
            "block_friction_ftlb": leg.block_friction,
            "stop_ftlb": leg.stop,
        })
    });
    json!({
        "program": results::program(env!("CARGO_PKG_VERSION")),
        "commit": results::COMMIT,
        "vehicle_file": vehicle.document.path().display().to_string(),
        "vehicle_fingerprint": fingerprint(&vehicle.document.source().text),
        "set": (set.iter())
            .map(|one| (one.parameter().name().to_owned(), json!(one.text())))
            .collect::<Map<String, Value>>(),
        "scene": scene,
        "solver": {
            "tolerance": settings.tolerance(),
            "time_limit_s": settings.time_limit(),
            "crush_rule": crush_rule_name(settings.crush_rule()),
            "friction_profile": friction_profile_name(settings.friction_profile()),
            "method": method_name(&settings.method()),
        },
        "result": result,
        "why": why(&landing.outcome),
        "min_stability_time_s": landing.min_stability_time,
        "events": landing.events,
        "work_by_leg": work.collect::<Vec<_>>(),
        "final_kinetic_energy_ftlb": landing.energies.final_kinetic,
        "integration": integration_report::json(integration, landing.leg_count()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_zero_but_for_rounding_has_no_sign() {
        assert_eq!(degrees(-1e-9, 3), "0.000");
        assert_eq!(degrees(-0.5f64.to_radians(), 3), "-0.500");
        assert_eq!(degrees(std::f64::consts::PI / 3.0, 4), "60.0000");
    }
}
