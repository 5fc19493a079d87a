//! The report of one landing as text.

use touchdown_dynamics::landing::LegWork;
use touchdown_dynamics::methods::{IntegrationSummary, variable_names};
use touchdown_input::points::parameter::Home;
use touchdown_input::readers::method_input::method_words;
use touchdown_input::readers::settings_input::rules_in_words;
use touchdown_sweep::output::landing_report::{LandingReport, verdict_time};
use touchdown_sweep::output::landing_table::why;

use crate::summary::number;

/// An angle (rad) in degrees to so many decimals, without the sign of what is zero but for rounding.
pub fn degrees(angle: f64, decimals: u8) -> String {
    let unit = 10f64.powi(i32::from(decimals));
    let rounded = (unit * angle.to_degrees()).round() / unit + 0.0;
    format!("{rounded:.*}", usize::from(decimals))
}

/// The report as text.
pub fn text(report: &LandingReport) -> String {
    let (landing, units) = (report.landing, report.units);
    let given: Vec<String> = (report.scene())
        .map(|(name, value)| format!("{name} {value}"))
        .collect();
    let energies = &landing.energies;
    let work = |of: fn(&LegWork) -> f64| energies.legs.iter().map(of).sum::<f64>();
    let changes: String = (report.set.iter())
        .filter(|one| one.parameter().home() == Home::Vehicle)
        .map(|one| format!("with {} = {}\n", one.parameter().name(), one.text()))
        .collect();
    let name = &report.vehicle.name;
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
    let length = units.quantity("clearance_ft");
    lines.add(
        "least ground clearance",
        format!(
            "{:.5} {}",
            length.number(landing.min_clearance),
            length.unit()
        ),
    );
    lines.add(
        "tilt at the end",
        format!("{} deg", degrees(landing.tilt, 2)),
    );
    let legs = landing.leg_count();
    lines.legs("leg", (1..=legs).map(|leg| leg.to_string()));
    lines.legs(
        "footpad contact, s",
        landing.pad_contact.into_iter().map(time),
    );
    let hinged_legs = report.vehicle.vehicle.hinged_legs();
    if hinged_legs.iter().any(|leg| leg.design().block.is_some()) {
        lines.legs(
            "block contact, s",
            landing.block_contact.into_iter().map(time),
        );
    }
    let force = units.quantity("strut_force_lb");
    lines.legs(
        &format!("largest strut force, {}", force.unit()),
        (landing.max_strut_force.into_iter()).map(|f| format!("{:.1}", force.number(f))),
    );
    let stroke = units.quantity("stroke_ft");
    lines.legs(
        &format!("greatest stroke, {}", stroke.unit()),
        (landing.max_stroke.into_iter()).map(|length| format!("{:.4}", stroke.number(length))),
    );
    lines.legs(
        "- of the whole, %",
        (landing.max_stroke_share.into_iter()).map(|share| format!("{:.1}", 100.0 * share)),
    );
    let of_table = landing.max_stroke_table_share;
    if of_table.iter().any(|share| *share > 1.0) {
        lines.legs(
            "- of its crush table, %",
            (of_table.into_iter()).map(|share| format!("{:.1}", 100.0 * share)),
        );
    }
    if landing.max_sinkage.iter().any(|depth| *depth > 0.0) {
        lines.legs(
            &format!("greatest sinkage, {}", stroke.unit()),
            (landing.max_sinkage.into_iter()).map(|depth| format!("{:.4}", stroke.number(depth))),
        );
    }
    let energy = units.quantity("energy_ftlb");
    let closure = energy.number(energies.closure());
    let terms = [
        ("kinetic energy at contact", energies.initial_kinetic),
        ("+ potential energy released", energies.potential_change),
        ("+ work of the thrust", energies.thrust),
        ("- struts", work(|leg| leg.strut)),
        ("- footpads, crushing", work(|leg| leg.pad_crush)),
        ("- footpads, sliding", work(|leg| leg.pad_friction)),
        ("- blocks, crushing", work(|leg| leg.block_crush)),
        ("- blocks, sliding", work(|leg| leg.block_friction)),
        ("- stops", work(|leg| leg.stop)),
        ("- kinetic energy at the end", energies.final_kinetic),
    ];
    // What neither gave nor took any is left out.
    for (name, value) in terms.into_iter().filter(|(_, value)| *value != 0.0) {
        let (value, unit) = (energy.number(value), energy.unit());
        lines.add(name, format!("{value:>14.4} {unit}"));
    }
    lines.add("= closure", format!("{closure:>14.3e} {}", energy.unit()));
    lines.add(
        "computation",
        format!(
            "{}, {}, {}",
            number(landing.steps, "step"),
            number(landing.events, "event"),
            number(landing.evaluations, "derivative evaluation"),
        ),
    );
    let settings = report.settings;
    lines.add(
        "",
        format!(
            "{}, {}",
            method_words(&settings.method(), settings.tolerance()),
            rules_in_words(settings.rules(&report.vehicle.vehicle))
        ),
    );
    lines.0 + &account_of_integration(report.integration, legs)
}

/// The account of an integration, as the program of 1966 printed it at the end of a run (3.4.4.3); empty for a method that
/// keeps none.
fn account_of_integration(summary: &IntegrationSummary, legs: usize) -> String {
    if summary.critical.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\nintervals                    {}, {:.8} s on average, {} accepted although not good enough\n",
        summary.intervals,
        summary.mean_interval(),
        summary.bypassed
    );
    text += &counted("from 0.1, 0.01, 0.001 s ...", &summary.by_decade);
    text += &counted("after 0, 1, 2 cuts ...", &summary.by_cuts);
    text += "\nvariable                  critical     sum of errors   of absolute errors\n";
    let names = variable_names(legs);
    for (index, name) in names.iter().enumerate() {
        text += &format!(
            "{name:<24} {:>9} {:>17.7e} {:>20.7e}\n",
            summary.critical[index], summary.arithmetic[index], summary.absolute[index]
        );
    }
    text
}

fn counted(name: &str, counts: &[u64]) -> String {
    let cells: String = counts.iter().map(|count| format!("{count:>7}")).collect();
    format!("{name:<28}{cells}\n")
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
