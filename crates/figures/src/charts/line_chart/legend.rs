//! The names of the curves, and their colours.

use plotters::prelude::*;

use super::{Curve, LineChart, Stroke};
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::sheet::Sheet;

/// Colours of curves, in order of appearance (Okabe and Ito).
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 90, 160),
    RGBColor(213, 94, 0),
    RGBColor(0, 130, 100),
    RGBColor(180, 80, 140),
    RGBColor(120, 90, 20),
    RGBColor(60, 60, 60),
    RGBColor(80, 170, 220),
    RGBColor(230, 160, 0),
];

/// Names of the curves, each once.
pub(super) fn names(chart: &LineChart) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for curve in chart.panels.iter().flat_map(|panel| &panel.curves) {
        if !names.contains(&curve.name.as_str()) {
            names.push(&curve.name);
        }
    }
    names
}

/// Colour of the curves of a name.
pub(super) fn colour(names: &[&str], name: &str) -> RGBColor {
    let index = names.iter().position(|other| *other == name).unwrap_or(0);
    COLOURS[index % COLOURS.len()]
}

/// Writes the names of the curves in one centred line, each after a piece of its curve.
pub(super) fn draw(foot: &Sheet, chart: &LineChart, names: &[&str]) -> Result<(), FigureError> {
    const GAP: i32 = 24;
    const SWATCH: i32 = 22;
    // There is no font to measure texts with.
    let width = |text: &str| (text.chars().count() as f64 * 6.6) as i32;
    let used: i32 = names
        .iter()
        .map(|name| SWATCH + 6 + width(name))
        .sum::<i32>()
        + GAP * (names.len() as i32 - 1);
    let mut x = (foot.dim_in_pixel().0 as i32 - used) / 2;
    let curves: Vec<&Curve> = chart.panels.iter().flat_map(|p| &p.curves).collect();
    for name in names {
        let style = colour(names, name).stroke_width(2);
        let is_broken = curves
            .iter()
            .any(|curve| curve.name == *name && curve.stroke == Stroke::Dashes);
        let pieces: &[(i32, i32)] = if is_broken {
            &[(0, 8), (13, 21)]
        } else {
            &[(0, SWATCH)]
        };
        for (from, to) in pieces {
            let piece = PathElement::new(vec![(x + from, 12), (x + to, 12)], style);
            foot.draw(&piece).map_err(drawing)?;
        }
        let place = (x + SWATCH + 6, 7);
        foot.draw(&Text::new(
            (*name).to_owned(),
            place,
            ink::text(12, ink::TEXT),
        ))
        .map_err(drawing)?;
        x += SWATCH + 6 + width(name) + GAP;
    }
    Ok(())
}
