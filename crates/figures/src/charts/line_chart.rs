//! Curves over a common abscissa, in panels one above the other: histories of a landing, errors against cost.

mod axis;

use crate::canvas::{Canvas, Point};
use crate::caption::Caption;
use crate::frame::{Frame, Scale};
use crate::legend::{Entry, Mark};
use crate::palette;
use crate::sheet::{self, Height, Sheet};
use crate::style::{Colour, Style};
use crate::text::Font;
use crate::words::FigureError;

pub use axis::Axis;

/// Width of the picture and height of a panel, pixels.
const WIDTH: f64 = 900.0;
const PANEL: f64 = 330.0;
/// Height of a remark below its point, pixels.
const ROOM: f64 = 22.0;
/// Dashes and gaps of broken lines, pixels.
const DASHES: (f64, f64) = (8.0, 5.0);

/// Curves over a common abscissa.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// Caption above the chart.
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

impl Panel {
    /// A panel of these curves.
    pub fn new(ordinate: Axis, curves: Vec<Curve>) -> Self {
        Self { ordinate, curves }
    }
}

/// A curve. Curves of one name have one colour and one entry in the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Its line style.
    pub stroke: Stroke,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// Remarks at the points, if any.
    pub remarks: Vec<String>,
}

impl Curve {
    /// A curve without remarks.
    pub fn new(name: &str, stroke: Stroke, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.to_owned(),
            stroke,
            points,
            remarks: Vec::new(),
        }
    }
}

/// Line style of a curve.
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
/// When it has no panel.
pub fn draw(chart: &LineChart) -> Result<String, FigureError> {
    if chart.panels.is_empty() {
        return Err(FigureError::Table("a chart has at least one panel".into()));
    }
    let names = names(chart);
    let entries: Vec<Entry> = names
        .iter()
        .map(|name| entry(chart, &names, name))
        .collect();
    let height = PANEL * chart.panels.len() as f64;
    let Sheet { mut canvas, body } =
        sheet::begin(WIDTH, Height::Body(height), &chart.caption, &entries);
    let values = |coordinate: fn(&Point) -> f64, curves: &mut dyn Iterator<Item = &Curve>| {
        let points = curves.flat_map(|curve| &curve.points);
        points.map(coordinate).collect::<Vec<f64>>()
    };
    let abscissas = values(|point| point.0, &mut curves(chart));
    let ordinates = chart.panels.iter().map(|panel| {
        let values = values(|point| point.1, &mut panel.curves.iter());
        panel.ordinate.scale(values.into_iter(), true)
    });
    let ordinates: Vec<Scale> = ordinates.collect();
    let left = ordinates.iter().map(Scale::room).fold(0.0, f64::max);
    let parts = body.rows(ordinates.len()).into_iter().zip(ordinates);
    for (index, ((part, ordinate), panel)) in parts.zip(&chart.panels).enumerate() {
        let is_last = index + 1 == chart.panels.len();
        let across = chart.abscissa.scale(abscissas.iter().copied(), is_last);
        let frame = Frame::with_left(part, left, across, ordinate);
        draw_panel(&mut canvas, &frame, &chart.abscissa, panel, &names);
    }
    Ok(canvas.into_svg())
}

fn curves(chart: &LineChart) -> impl Iterator<Item = &Curve> {
    chart.panels.iter().flat_map(|panel| &panel.curves)
}

/// Names of the curves, each once.
fn names(chart: &LineChart) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for curve in curves(chart) {
        if !names.contains(&curve.name.as_str()) {
            names.push(&curve.name);
        }
    }
    names
}

/// Colour of the curves with this name.
fn colour(names: &[&str], name: &str) -> Colour {
    palette::curve(names.iter().position(|other| *other == name).unwrap_or(0))
}

/// The legend entry of a name.
fn entry(chart: &LineChart, names: &[&str], name: &str) -> Entry {
    let is_broken = curves(chart).any(|c| c.name == name && c.stroke == Stroke::Dashes);
    let style = Style::stroke(colour(names, name), 2.0).dashed(is_broken.then_some(DASHES));
    (Mark::Line(style), name.to_owned())
}

fn draw_panel(canvas: &mut Canvas, frame: &Frame, abscissa: &Axis, panel: &Panel, names: &[&str]) {
    frame.draw(canvas, Style::stroke(palette::GRID, 1.0));
    for curve in &panel.curves {
        let colour = colour(names, &curve.name);
        let place = |(x, y): &Point| (abscissa.place(*x), panel.ordinate.place(*y));
        let places = curve.points.iter().map(place);
        let points: Vec<Point> = places
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .map(|place| frame.place(place))
            .collect();
        let is_broken = curve.stroke == Stroke::Dashes;
        let style = Style::stroke(colour, 2.0).dashed(is_broken.then_some(DASHES));
        canvas.curve(&points, style);
        if curve.stroke == Stroke::Marks {
            for point in &points {
                canvas.circle(*point, palette::SMALL_MARK, Style::fill(colour));
            }
        }
        for ((x, y), remark) in points.iter().zip(&curve.remarks) {
            let font = Font::new(11.0, palette::PALE_TEXT);
            // Above the point if there is no room below it.
            let down = if y + ROOM < frame.area.bottom {
                13.0
            } else {
                -13.0
            };
            canvas.text(remark, (*x, y + down), font);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> LineChart {
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
                        Curve::new("one", Stroke::Line, vec![(0.0, 5.0), (1.0, -30.0)]),
                        Curve::new("other", Stroke::Dashes, vec![(0.0, 5.0), (1.0, -20.0)]),
                    ],
                },
                Panel {
                    ordinate: Axis::logarithmic("error, ft"),
                    curves: vec![Curve::new(
                        "one",
                        Stroke::Marks,
                        vec![(0.0, 1e-7), (1.0, 2e-3)],
                    )],
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
        assert_eq!(svg.matches(">one</text>").count(), 1, "{svg}");
        // Decades of the lower panel.
        for decade in ["1e\u{2212}7", "1e\u{2212}5", "0.01"] {
            assert!(
                svg.contains(&format!(">{decade}</text>")),
                "{decade}: {svg}"
            );
        }
    }

    #[test]
    fn a_chart_has_a_panel() {
        let panels = Vec::new();
        assert!(draw(&LineChart { panels, ..chart() }).is_err());
    }

    #[test]
    fn remarks_stand_at_their_points() {
        let mut chart = chart();
        chart.panels[1].curves[0].remarks = vec!["first".to_owned(), "second".to_owned()];
        let svg = draw(&chart).unwrap();
        let lines = |end: &str| {
            svg.lines()
                .filter(|line| line.contains(end))
                .collect::<Vec<_>>()
        };
        let number = |line: &str, key: &str| -> f64 {
            let rest = line.split(key).nth(1).unwrap();
            rest.split('"').next().unwrap().parse().unwrap()
        };
        let [lowest, highest] = lines("<circle")[..] else {
            panic!("two points");
        };
        // Below the point, and above that on the axis.
        let below = |text: &str, point: &str| {
            let [text] = lines(text)[..] else {
                panic!("one remark");
            };
            assert_eq!(number(text, " x=\""), number(point, "cx=\""));
            number(text, " y=\"") - number(point, "cy=\"")
        };
        assert!(below(">first</text>", lowest) < 0.0);
        assert!(below(">second</text>", highest) > 0.0);
    }
}
