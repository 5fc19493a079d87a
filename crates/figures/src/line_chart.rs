//! Curves over a common abscissa, in panels one above the other: histories of a landing, errors
//! against cost.

use plotters::prelude::*;

use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::number::label;
use crate::sheet::{self, Sheet, round_values};

/// Width of the picture and height of its head, foot and panels, pixels.
const WIDTH: u32 = 900;
const FRAME: u32 = 130;
const PANEL: u32 = 330;
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
/// What a curve of two equal values is spread to.
const LEAST_EXTENT: f64 = 1e-9;

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

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity and unit.
    pub title: String,
    /// Whether it is divided by powers of ten; values then are greater than zero.
    pub is_logarithmic: bool,
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

impl Axis {
    /// An evenly divided axis.
    pub fn linear(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            is_logarithmic: false,
        }
    }

    /// An axis divided by powers of ten.
    pub fn logarithmic(title: &str) -> Self {
        Self {
            title: title.to_owned(),
            is_logarithmic: true,
        }
    }

    /// Where a value lies along the axis.
    fn place(&self, value: f64) -> f64 {
        if self.is_logarithmic {
            value.log10()
        } else {
            value
        }
    }

    fn label(&self, place: f64) -> String {
        if !self.is_logarithmic {
            return label(place);
        }
        let power = place.round();
        if (place - power).abs() > 1e-6 {
            return String::new();
        }
        if (-4.0..6.0).contains(&power) {
            label(10f64.powf(power))
        } else {
            format!("1e{}", label(power))
        }
    }

    /// Ends of the axis around its values.
    fn extent(&self, values: impl Iterator<Item = f64>) -> (f64, f64) {
        let (low, high) = values
            .map(|value| self.place(value))
            .filter(|place| place.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
                (low.min(place), high.max(place))
            });
        if low > high {
            return (0.0, 1.0);
        }
        if self.is_logarithmic {
            return (low.floor(), high.ceil().max(low.floor() + 1.0));
        }
        let margin = 0.03 * (high - low).max(LEAST_EXTENT);
        (low - margin, high + margin)
    }
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
    let names = names(chart);
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
    draw_legend(&foot, chart, &names)?;
    area.present().map_err(drawing)
}

/// Names of the curves, each once.
fn names(chart: &LineChart) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for curve in chart.panels.iter().flat_map(|panel| &panel.curves) {
        if !names.contains(&curve.name.as_str()) {
            names.push(&curve.name);
        }
    }
    names
}

fn colour(names: &[&str], name: &str) -> RGBColor {
    let index = names.iter().position(|other| *other == name).unwrap_or(0);
    COLOURS[index % COLOURS.len()]
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
    let divisions = |axis: &Axis, from: f64, to: f64| {
        if axis.is_logarithmic {
            (to - from).round() as usize + 1
        } else {
            round_values(from, to).len() + 1
        }
    };
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(ink::GRID)
        .axis_style(ink::TEXT)
        .x_labels(divisions(abscissa, left, right))
        .y_labels(divisions(ordinate, low, high))
        .x_label_formatter(&|x| abscissa.label(*x))
        .y_label_formatter(&|y| ordinate.label(*y))
        .label_style(ink::text(12, ink::TEXT))
        .axis_desc_style(ink::text(14, ink::TEXT))
        .x_desc(if is_last { abscissa.title.as_str() } else { "" })
        .y_desc(ordinate.title.as_str())
        .draw()
        .map_err(drawing)?;
    for curve in &panel.curves {
        let colour = colour(names, &curve.name);
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
    }
    Ok(())
}

/// Writes the names of the curves in one centred line, each after a piece of its curve.
fn draw_legend(foot: &Sheet, chart: &LineChart, names: &[&str]) -> Result<(), FigureError> {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> LineChart {
        let curve = |name: &str, stroke, points: &[(f64, f64)]| Curve {
            name: name.to_owned(),
            stroke,
            points: points.to_vec(),
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
    fn what_cannot_be_placed_does_not_stretch_the_axis() {
        let axis = Axis::logarithmic("error");
        assert_eq!(axis.extent([1e-3, 0.5, f64::NAN].into_iter()), (-3.0, 0.0));
        let (low, high) = Axis::linear("pitch").extent([2.0, 2.0].into_iter());
        assert!(low < 2.0 && high > 2.0);
        assert!(
            draw(&LineChart {
                panels: Vec::new(),
                ..chart()
            })
            .is_err()
        );
    }
}
