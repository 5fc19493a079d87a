//! JSON report of one landing.

use serde_json::{Map, Value, json};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::methods::{IntegrationSummary, variable_names};
use touchdown_dynamics::scene::Settings;
use touchdown_input::documents::fingerprint::fingerprint;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::assignment::Assignment;
use touchdown_input::readers::scene_input::NamedConditions;
use touchdown_input::readers::settings_input::solver_in_record;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_search::contact_warnings::ContactWarnings;

use crate::output::landing_table::{self, why};
use crate::output::results;

/// Content of the report of a landing.
#[derive(Debug, Clone, Copy)]
pub struct LandingReport<'r> {
    /// Version of the program.
    pub version: &'r str,
    /// The vehicle.
    pub vehicle: &'r VehicleFile,
    /// Assignments that replaced numbers of the input.
    pub set: &'r [Assignment],
    /// The touchdown conditions.
    pub conditions: &'r NamedConditions,
    /// Settings of the landing.
    pub settings: &'r Settings,
    /// The landing.
    pub landing: &'r Landing,
    /// Summary of the integration.
    pub integration: &'r IntegrationSummary,
    /// Units of the report.
    pub units: OutputUnits,
}

impl LandingReport<'_> {
    /// Touchdown conditions by name.
    pub fn scene(&self) -> impl Iterator<Item = (String, f64)> {
        let told = |(name, value): (&str, f64)| {
            let quantity = self.units.quantity(name);
            (quantity.name().to_owned(), quantity.number(value))
        };
        self.conditions.resolved().into_iter().map(told)
    }

    /// The report.
    pub fn json(&self) -> Value {
        let (vehicle, settings, landing) = (self.vehicle, self.settings, self.landing);
        let legs = landing.leg_count();
        let scene: Map<String, Value> = (self.scene())
            .map(|(name, value)| (name, json!(value)))
            .collect();
        let mut report = json!({
            "program": results::program(self.version),
            "commit": results::COMMIT,
            "vehicle": { "name": vehicle.name },
            "vehicle_file": vehicle.document.path().display().to_string(),
            "vehicle_fingerprint": fingerprint(&vehicle.document.source().text),
            "set": (self.set.iter())
                .map(|one| (one.parameter().name().to_owned(), json!(one.text())))
                .collect::<Map<String, Value>>(),
            "scene": scene,
            "solver": solver_in_record(settings, &vehicle.vehicle),
            "result": self.units.by_name(&landing_table::COLUMNS, landing, legs),
            "why": why(&landing.outcome),
            "integration": integration(self.integration, legs),
        });
        for (name, value) in self
            .units
            .by_name(&landing_table::OF_REPORTS, landing, legs)
        {
            report[name] = value;
        }
        if let Some(beyond) = &landing.beyond {
            report["verdict_time_s"] = json!(beyond.verdict_time);
            report["went_on_to"] = json!(beyond.end.to_string());
        }
        report
    }
}

/// Summary of an integration; null for a method without one.
fn integration(summary: &IntegrationSummary, legs: usize) -> Value {
    if summary.critical.is_empty() {
        return Value::Null;
    }
    let variables: Vec<Value> = variable_names(legs)
        .into_iter()
        .enumerate()
        .map(|(index, name)| {
            json!({
                "variable": name,
                "critical": summary.critical[index],
                "sum_of_errors": summary.arithmetic[index],
                "sum_of_absolute_errors": summary.absolute[index],
            })
        })
        .collect();
    json!({
        "intervals": summary.intervals,
        "mean_interval_s": summary.mean_interval(),
        "bypassed": summary.bypassed,
        "by_decade_from_0.1_s_down": summary.by_decade,
        "by_cuts": summary.by_cuts,
        "variables": variables,
    })
}

/// Time of the verdict, s.
pub fn verdict_time(landing: &Landing) -> f64 {
    let beyond = landing.beyond.as_ref();
    beyond.map_or(landing.end_time, |beyond| beyond.verdict_time)
}

/// Warnings of a landing whose energy balance closes: elements that gave back more energy than they took, footpads
/// crushed beyond their hinges, and cartridges beyond their crush tables.
pub fn warning(landing: &Landing, units: OutputUnits) -> Option<String> {
    let ContactWarnings {
        given,
        is_crushed_through,
        is_beyond_table,
    } = ContactWarnings::of(landing);
    let mut told = Vec::new();
    if given > 0.0 {
        told.push(given_by_contact(given, units));
    }
    if is_crushed_through {
        told.extend(crushed_through(landing, units));
    }
    if is_beyond_table {
        told.extend(beyond_table(landing, units));
    }
    (!told.is_empty()).then(|| told.join("; "))
}

/// Warning that footpads were crushed beyond their hinges.
pub const CRUSHED_THROUGH: &str = "footpads were crushed beyond their hinges: the contact rule \"face\" ends such \
     landings as bottomed";

/// Warning that a footpad was crushed beyond its hinge, as the contact rule of 1966 allows.
fn crushed_through(landing: &Landing, units: OutputUnits) -> Option<String> {
    let quantity = units.quantity("crush_ft");
    let shares = landing.max_pad_crush_share.iter();
    let (leg, share) = shares.enumerate().find(|(_, share)| **share > 1.0)?;
    let crush = landing.max_pad_crush[leg];
    let [crush, height] = [crush, crush / share].map(|length| quantity.number(length));
    let unit = quantity.unit();
    Some(format!(
        "footpad {} was crushed by {crush:.3} {unit}, which is more than the {height:.3} {unit} up to its hinge: the contact rule \
         \"face\" ends such a landing as bottomed",
        leg + 1
    ))
}

/// Warning that struts were crushed beyond their crush tables.
pub const BEYOND_TABLE: &str = "struts stroked beyond the end of their crush_load, where the load stays that of the last \
     knot: a knot at the full stroke says that this is meant";

/// Warning that a strut was crushed beyond its crush table.
fn beyond_table(landing: &Landing, units: OutputUnits) -> Option<String> {
    let quantity = units.quantity("stroke_ft");
    let shares = landing.max_stroke_table_share.iter();
    let (leg, share) = shares.enumerate().find(|(_, share)| **share > 1.0)?;
    let stroke = landing.max_stroke[leg];
    let [stroke, end, full] = [
        stroke,
        stroke / share,
        stroke / landing.max_stroke_share[leg],
    ]
    .map(|length| quantity.number(length));
    let unit = quantity.unit();
    Some(format!(
        "strut {} stroked {stroke:.4} {unit}, beyond the {end:.4} {unit} at which its crush_load ends: the load stays that of the \
         last knot; a knot at the full stroke, {full:.4} {unit}, says that this is meant",
        leg + 1
    ))
}

/// Warning that crushing elements gave this energy, ft·lb, stated in these units.
pub fn given_by_contact(energy: f64, units: OutputUnits) -> String {
    let quantity = units.quantity("energy_ftlb");
    let (energy, unit) = (quantity.number(energy), quantity.unit());
    format!(
        "crushing footpads or blocks added {energy:.1} {unit} to the motion, which no material does: they tip on the \
         ground, or are too stiff for the crush laws"
    )
}
