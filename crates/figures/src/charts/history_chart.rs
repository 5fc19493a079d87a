//! Histories of landings: one panel for each quantity, over the same time.

use plotters::prelude::*;

use crate::axis_title::axis_title;
use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::history_table::{History, HistoryTable};
use crate::ink;
use crate::mesh::{self, Along};
use crate::number::label;
use crate::sheet::{self, Sheet};

/// Width of the picture, and height of its head and foot and of each panel, pixels.
const WIDTH: u32 = 900;
const AROUND: u32 = 130;
const PANEL: u32 = 285;
/// Length of the sample of a line in the legend, pixels.
const SAMPLE: i32 = 34;

/// Draws histories as SVG. Lines are thick in free flight, printed values are circles.
///
/// # Errors
/// Only those of the drawing library.
pub fn draw(table: &HistoryTable, caption: &Caption) -> Result<String, FigureError> {
    let panels = table.quantities.len();
    let size = (WIDTH, AROUND + PANEL * panels as u32);
    let mut svg = String::new();
    let sheet = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    let (body, foot) = sheet::parts(&sheet, size, caption)?;
    for (quantity, panel) in body.split_evenly((panels, 1)).iter().enumerate() {
        draw_panel(panel, table, quantity)?;
    }
    draw_legend(&foot, table)?;
    sheet.present().map_err(drawing)?;
    drop((body, foot, sheet));
    Ok(sheet::with_subscripts(&svg))
}

fn draw_panel(panel: &Sheet, table: &HistoryTable, quantity: usize) -> Result<(), FigureError> {
    let [low, high] = table.range(quantity);
    let margin = 0.06 * (high - low).max(1e-9);
    let mut chart = ChartBuilder::on(panel)
        .margin_right(28)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(46)
        .y_label_area_size(62)
        .build_cartesian_2d(0.0..table.end(), low - margin..high + margin)
        .map_err(drawing)?;
    mesh::draw(
        &mut chart,
        ink::GRID,
        &Along {
            title: "Time after first contact, s",
            count: 13,
            label: &|x| label(*x),
        },
        &Along {
            title: &axis_title(&table.quantities[quantity]),
            count: 8,
            label: &|y| label(*y),
        },
    )?;
    for (index, landing) in table.landings.iter().enumerate() {
        for (points, is_free) in stretches(landing, quantity) {
            let stroke = ink::series(index).stroke_width(if is_free { 4 } else { 2 });
            match dashes(index) {
                None => chart.draw_series(LineSeries::new(points, stroke)),
                Some((dash, gap)) => {
                    chart.draw_series(DashedLineSeries::new(points, dash, gap, stroke))
                }
            }
            .map_err(drawing)?;
        }
        let printed = landing.instants.iter().filter_map(|instant| {
            let place = (instant.time, instant.printed[quantity]?);
            Some(Circle::new(
                place,
                ink::MARK - 1,
                ink::STATEMENT.stroke_width(2),
            ))
        });
        chart.draw_series(printed).map_err(drawing)?;
    }
    Ok(())
}

/// Stretches of contact and of free flight of a landing; each begins where the last one ended.
fn stretches(landing: &History, quantity: usize) -> Vec<(Vec<(f64, f64)>, bool)> {
    let mut stretches: Vec<(Vec<(f64, f64)>, bool)> = Vec::new();
    for run in landing.instants.chunk_by(|a, b| a.is_free == b.is_free) {
        let last = stretches.last().and_then(|(points, _)| points.last());
        let points = last.copied().into_iter().chain(
            run.iter()
                .map(|instant| (instant.time, instant.values[quantity])),
        );
        let points = points.collect();
        stretches.push((points, run[0].is_free));
    }
    stretches
}

/// Dashes and gaps of a line, which tell lines apart in grey.
fn dashes(index: usize) -> Option<(u32, u32)> {
    [None, Some((9, 4)), Some((3, 3)), Some((14, 5))][index % 4]
}

/// Draws what tells the landings apart, and what thick lines and circles mean, in one centred line.
fn draw_legend(foot: &Sheet, table: &HistoryTable) -> Result<(), FigureError> {
    const GAP: i32 = 26;
    const Y: i32 = 12;
    let conditions = table
        .landings
        .iter()
        .enumerate()
        .filter_map(|(index, landing)| {
            let title = axis_title(table.condition.as_deref()?);
            let (name, unit) = title.split_once(", ").unwrap_or((&title, ""));
            let symbol = name.rsplit(' ').next().unwrap_or(name);
            let text = format!("{symbol} = {} {unit}", label(landing.condition?));
            Some((Some(index), text.trim_end().to_owned()))
        });
    let mut entries: Vec<(Option<usize>, String)> = conditions.collect();
    let mut instants = table.landings.iter().flat_map(|landing| &landing.instants);
    if instants.clone().any(|instant| instant.is_free) {
        entries.push((None, "thick: free flight".to_owned()));
    }
    if instants.any(|instant| instant.printed.iter().any(Option::is_some)) {
        entries.push((None, "circles: printed in 1966".to_owned()));
    }
    let width = |(index, text): &(Option<usize>, String)| {
        let sample = if index.is_some() { SAMPLE + 8 } else { 0 };
        sample + (text.chars().count() as f64 * 6.6) as i32
    };
    let used: i32 = entries.iter().map(|entry| width(entry) + GAP).sum::<i32>() - GAP;
    let mut x = (foot.dim_in_pixel().0 as i32 - used) / 2;
    for entry in &entries {
        let mut start = x;
        if let Some(index) = entry.0 {
            let stroke = ink::series(index).stroke_width(2);
            let ends = [(x, Y), (x + SAMPLE, Y)];
            match dashes(index) {
                None => foot
                    .draw(&PathElement::new(ends, stroke))
                    .map_err(drawing)?,
                Some((dash, gap)) => {
                    let (dash, gap) = (dash as i32, gap as i32);
                    for from in (x..x + SAMPLE).step_by((dash + gap) as usize) {
                        let to = (from + dash).min(x + SAMPLE);
                        foot.draw(&PathElement::new([(from, Y), (to, Y)], stroke))
                            .map_err(drawing)?;
                    }
                }
            }
            start += SAMPLE + 8;
        }
        let text = Text::new(entry.1.clone(), (start, Y - 5), ink::text(12, ink::TEXT));
        foot.draw(&text).map_err(drawing)?;
        x += width(entry) + GAP;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_has_a_panel_and_free_flight_is_thick() {
        let text = "tip_azimuth_deg,t_s,psi_deg,omega_x_dps,touches\n\
                    90,0,1,-3,1\n90,0.5,2,-2,0\n90,1,2,-2,0\n-90,0,3,1,1\n-90,1,3,2,1\n";
        let svg = draw(&HistoryTable::parse(text).unwrap(), &Caption::default()).unwrap();
        assert!(svg.starts_with("<svg width=\"900\" height=\"700\""));
        assert!(svg.contains("Pitch angle") && svg.contains("Angular velocity about x"));
        assert!(svg.contains("Γ = 90 deg") && svg.contains("Γ = \u{2212}90 deg"));
        let thick = svg
            .lines()
            .filter(|line| line.contains("stroke-width=\"4\""));
        assert_eq!(thick.count(), 2);
    }

    #[test]
    fn printed_values_are_circles() {
        let text = "t_s,y_rate_fps,y_rate_1966_fps\n0,1,1.1\n0.5,2,\n1,3,3\n";
        let svg = draw(&HistoryTable::parse(text).unwrap(), &Caption::default()).unwrap();
        assert_eq!(svg.matches("<circle").count(), 2);
        assert!(svg.contains("printed in 1966"));
    }
}
