//! The mirror symmetry that the report assumed, with and without products of inertia.

use std::fmt::Write;

use touchdown_input::documents::input_error::InputError;

use super::answer::speed;
use super::results::{Results, Transitions};

/// Folder of the results without products of inertia.
pub const NO_PRODUCTS: &str = "no-products";

/// First transitions on both sides of the plane of symmetry.
///
/// # Errors
/// When a result is missing.
pub fn section(results: &Results) -> Result<String, InputError> {
    let mut text = "\
## Mirror symmetry and the products of inertia

The report (4.2.2) calls the products of inertia \"inconsequential compared with the moments of inertia,
however, so that the symmetries can be utilized\". The same landings with the products set to zero
(`sweeps/vehicles/surveyor-no-products.toml`) show what the products do.

"
    .to_owned();
    let level = [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0];
    text += &table(results, "figure-4-09", "roll", &level)?;
    let azimuths = [22.5, 45.0, 67.5, 90.0, 112.5, 135.0, 157.5];
    text += &table(results, "figure-4-23", "tip azimuth, tip 9 deg", &azimuths)?;
    text += &table(results, "figure-4-24", "tip azimuth, tip 5 deg", &azimuths)?;
    Ok(text)
}

fn table(results: &Results, stem: &str, axis: &str, values: &[f64]) -> Result<String, InputError> {
    let with = results.transitions(stem)?;
    let without = results.variant(NO_PRODUCTS).transitions(stem)?;
    let mut text = format!(
        "| {stem}: ± {axis} | + | − | difference | without products: + | − | difference |\n\
         |---:|---:|---:|---:|---:|---:|---:|\n"
    );
    for value in values {
        let row = [
            format!("{value}"),
            pair(&with, *value)?,
            pair(&without, *value)?,
        ];
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
    let greatest = [&with, &without].map(greatest_difference);
    let _ = writeln!(
        text,
        "\nGreatest difference over all pairs of the sweep: {:.3} ft/s with products, {:.3} without.\n",
        greatest[0], greatest[1]
    );
    Ok(text)
}

fn pair(transitions: &Transitions, value: f64) -> Result<String, InputError> {
    let [plus, minus] = [transitions.at(&[value])?, transitions.at(&[-value])?];
    let difference = match (plus, minus) {
        (Some(plus), Some(minus)) => format!("{:+.3}", plus.speed - minus.speed),
        _ => String::new(),
    };
    let difference = difference.replace('-', "\u{2212}");
    Ok(format!("{} | {} | {difference}", speed(plus), speed(minus)))
}

/// Greatest difference between a point and its mirror image, ft/s, where both have a transition.
fn greatest_difference(transitions: &Transitions) -> f64 {
    transitions
        .points()
        .filter_map(|(place, first)| {
            let mirrored = transitions.at(&[-place[0] + 0.0]).ok()??;
            Some((first?.speed - mirrored.speed).abs())
        })
        .fold(0.0, f64::max)
}
