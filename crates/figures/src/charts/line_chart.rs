//! Curves over a common abscissa, in panels one above the other: histories of a landing, errors
//! against cost.

mod axis;
mod legend;

use plotters::prelude::*;

use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::mesh::{self, Along};
use crate::sheet::{self, Sheet};

pub use axis::Axis;

/// Width of the picture and height of its head, foot and panels, pixels.
const WIDTH: u32 = 900;
const FRAME: u32 = 130;
const PANEL: u32 = 330;

/// Curves over a common abscissa.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// What stands above.
    pub caption: Caption,
    /// The abscissa of all panels.
    pub abscissa: Axis,
    /// The panels, from above.
    pub panels: Vec<Panel>,
}

/// One panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Its ordinate.
    pub ordinate: Axis,
    /// Its curves.
    pub curves: Vec<Curve>,
}

/// A curve. Curves of one name have one colour and one entry in the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// What it shows.
    pub name: String,
    /// How it is drawn.
    pub stroke: Stroke,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// What is written beside each point, if anything.
    pub remarks: Vec<String>,
}

/// How a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// A line.
    Line,
    /// A broken line, on top of others.
    Dashes,
    /// A line with its points marked.
    Marks,
}

/// Draws a chart as SVG.
///
/// # Errors
/// When it has no panel, or drawing fails.
pub fn draw(chart: &LineChart) -> Result<String, FigureError> {
    if chart.panels.is_empty() {
        return Err(FigureError::Table("a chart has at least one panel".into()));
    }
    let size = (WIDTH, FRAME + PANEL * chart.panels.len() as u32);
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    draw_sheet(area, size, chart)?;
    Ok(sheet::with_subscripts(&svg))
}

fn draw_sheet(area: Sheet, size: (u32, u32), chart: &LineChart) -> Result<(), FigureError> {
    let (body, foot) = sheet::parts(&area, size, &chart.caption)?;
    let names = legend::names(chart);
    let points = |chart: &LineChart| -> Vec<(f64, f64)> {
        let curves = chart.panels.iter().flat_map(|panel| &panel.curves);
        curves.flat_map(|curve| curve.points.clone()).collect()
    };
    let across = chart.abscissa.extent(points(chart).iter().map(|p| p.0));
    let parts = body.split_evenly((chart.panels.len(), 1));
    for (index, (part, panel)) in parts.iter().zip(&chart.panels).enumerate() {
        let is_last = index + 1 == chart.panels.len();
        draw_panel(part, &chart.abscissa, across, panel, &names, is_last)?;
    }
    legend::draw(&foot, chart, &names)?;
    area.present().map_err(drawing)
}

fn draw_panel(
    part: &Sheet,
    abscissa: &Axis,
    (left, right): (f64, f64),
    panel: &Panel,
    names: &[&str],
    is_last: bool,
) -> Result<(), FigureError> {
    let ordinate = &panel.ordinate;
    let values = panel.curves.iter().flat_map(|curve| &curve.points);
    let (low, high) = ordinate.extent(values.map(|point| point.1));
    let mut chart = ChartBuilder::on(part)
        .margin_right(28)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(if is_last { 52 } else { 26 })
        .y_label_area_size(72)
        .build_cartesian_2d(left..right, low..high)
        .map_err(drawing)?;
    mesh::draw(
        &mut chart,
        ink::GRID,
        &Along {
            title: if is_last { &abscissa.title } else { "" },
            count: abscissa.divisions(left, right),
            label: &|x| abscissa.label(*x),
        },
        &Along {
            title: &ordinate.title,
            count: ordinate.divisions(low, high),
            label: &|y| ordinate.label(*y),
        },
    )?;
    for curve in &panel.curves {
        let colour = legend::colour(names, &curve.name);
        let points: Vec<(f64, f64)> = curve
            .points
            .iter()
            .map(|(x, y)| (abscissa.place(*x), ordinate.place(*y)))
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .collect();
        match curve.stroke {
            Stroke::Line | Stroke::Marks => {
                let line = PathElement::new(points.clone(), colour.stroke_width(2));
                chart.draw_series([line]).map_err(drawing)?;
            }
            Stroke::Dashes => {
                let dashes = DashedLineSeries::new(points.clone(), 8, 5, colour.stroke_width(2));
                chart.draw_series(dashes).map_err(drawing)?;
            }
        }
        if curve.stroke == Stroke::Marks {
            let marks = points
                .iter()
                .map(|point| Circle::new(*point, ink::SMALL_MARK, colour.filled()));
            chart.draw_series(marks).map_err(drawing)?;
        }
        let remarks = points.iter().zip(&curve.remarks).map(|(point, remark)| {
            EmptyElement::at(*point)
                + Text::new(remark.clone(), (7, -14), ink::text(11, ink::PALE_TEXT))
        });
        chart.draw_series(remarks).map_err(drawing)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> LineChart {
        let curve = |name: &str, stroke, points: &[(f64, f64)]| Curve {
            name: name.to_owned(),
            stroke,
            points: points.to_vec(),
            remarks: Vec::new(),
        };
        LineChart {
            caption: Caption {
                title: "Pitch".to_owned(),
                ..Caption::default()
            },
            abscissa: Axis::linear("time, s"),
            panels: vec![
                Panel {
                    ordinate: Axis::linear("pitch, deg"),
                    curves: vec![
                        curve("one", Stroke::Line, &[(0.0, 5.0), (1.0, -30.0)]),
                        curve("other", Stroke::Dashes, &[(0.0, 5.0), (1.0, -20.0)]),
                    ],
                },
                Panel {
                    ordinate: Axis::logarithmic("error, ft"),
                    curves: vec![curve("one", Stroke::Marks, &[(0.0, 1e-7), (1.0, 2e-3)])],
                },
            ],
        }
    }

    #[test]
    fn a_chart_names_its_axes_and_each_curve_once() {
        let svg = draw(&chart()).unwrap();
        for text in ["time, s", "pitch, deg", "error, ft", "Pitch", "other"] {
            assert!(svg.contains(text), "{text}");
        }
        assert_eq!(svg.matches("\none\n").count(), 1, "{svg}");
        // Decades of the lower panel.
        for decade in ["1e\u{2212}7", "1e\u{2212}5", "0.01"] {
            assert!(svg.contains(&format!("\n{decade}\n")), "{decade}: {svg}");
        }
    }

    #[test]
    fn a_chart_has_a_panel() {
        let panels = Vec::new();
        assert!(draw(&LineChart { panels, ..chart() }).is_err());
    }

    #[test]
    fn remarks_stand_beside_their_points() {
        let mut chart = chart();
        chart.panels[1].curves[0].remarks = vec!["first".to_owned(), "second".to_owned()];
        let svg = draw(&chart).unwrap();
        assert!(svg.contains("\nfirst\n") && svg.contains("\nsecond\n"));
    }
}
