//! Probabilities over the bins of each axis, with their 95 % intervals: a panel for every axis.

use crate::boundary_table::Kind;
use crate::canvas::Canvas;
use crate::caption::Caption;
use crate::division::Division;
use crate::frame::{Area, Frame, Scale};
use crate::legend::{Entry, Mark};
use crate::sheet::{self, Height, Sheet};
use crate::style::{Colour, Style};
use crate::tables::{Row, Table};
use crate::words::FigureError;
use crate::{palette, ticks};

/// Width of the picture, pixels.
const WIDTH: f64 = 900.0;
/// Most panels in one, two and three columns, and their height in these, pixels: as many as there are fit a page.
const COLUMNS: [(usize, f64); 3] = [(3, 250.0), (8, 230.0), (MOST_PANELS, 170.0)];
/// Numbers along the axis of a panel, by the number of columns, and up its side.
const ACROSS: [usize; 3] = [11, 7, 5];
const UP: usize = 5;
/// Most axes drawn, from the first of the table on.
const MOST_PANELS: usize = 20;
/// Probabilities drawn: their words, and the prefixes of their columns.
const DRAWN: [(&str, &str); 3] = [
    ("not stable", "not_stable"),
    ("toppled", "topple"),
    ("bottomed", "bottom"),
];
/// Distance between the bars of one bin, pixels.
const BESIDE: f64 = 5.0;

/// Returns whether a table is one of probabilities.
pub fn is_one(csv: &str) -> bool {
    csv.starts_with("axis,from,to,")
}

/// Draws a table of probabilities as SVG.
///
/// # Errors
/// When a column is missing, a cell is not a number, or the table has no axis.
pub fn draw(csv: &str, caption: &Caption) -> Result<String, FigureError> {
    let panels = panels(csv, caption)?;
    if panels.is_empty() {
        return Err(FigureError::Table("has no bins of an axis".to_owned()));
    }
    let entries = legend();
    let layouts = (1..).zip(COLUMNS);
    let fits = |(_, (most, _)): &(usize, (usize, f64))| panels.len() <= *most;
    let (columns, (_, height)) = layouts.clone().find(fits).unwrap_or((1, COLUMNS[0]));
    let height = Height::Body(height * panels.len().div_ceil(columns) as f64);
    let Sheet { mut canvas, body } = sheet::begin(WIDTH, height, caption, &entries);
    let top = greatest(&panels);
    for (part, panel) in body.parts(columns, panels.len()).into_iter().zip(&panels) {
        panel.draw(&mut canvas, part, ACROSS[columns - 1], top);
    }
    Ok(canvas.into_svg())
}

/// The upper end of all probabilities: the greatest end of an interval, rounded up.
fn greatest(panels: &[Panel]) -> f64 {
    let bins = panels.iter().flat_map(|panel| &panel.bins);
    let ends = bins.flat_map(|bin| bin.probabilities.map(|[_, _, high]| high));
    let greatest = ends.fold(0.0, f64::max);
    let step = ticks::round_step(greatest / UP as f64);
    (step * (greatest / step - 1e-9).ceil()).clamp(step, 1.0)
}

/// The bins of an axis.
struct Panel {
    axis: String,
    division: Division,
    bins: Vec<Bin>,
}

/// A bin with landings.
struct Bin {
    /// Positions of its lower and upper end, if there are any.
    ends: [Option<f64>; 2],
    /// The probability and its interval for each of [`DRAWN`].
    probabilities: [[f64; 3]; DRAWN.len()],
}

fn panels(csv: &str, caption: &Caption) -> Result<Vec<Panel>, FigureError> {
    let table = Table::parse(csv)?;
    let columns = |(_, name): &(&str, &str)| {
        let column = |end: &str| table.column(&format!("{name}{end}"));
        Ok([
            column("_probability")?,
            column("_low_95")?,
            column("_high_95")?,
        ])
    };
    let columns: Vec<[usize; 3]> = DRAWN
        .iter()
        .map(columns)
        .collect::<Result<_, FigureError>>()?;
    let landings = table.column("landings")?;
    let mut panels: Vec<Panel> = Vec::new();
    for row in table.rows() {
        let axis = row.text(0);
        if axis == "all" || row.number(landings)? == 0.0 {
            continue;
        }
        let division = caption.division(axis);
        let bin = bin(&row, &columns, division)?;
        match panels.last_mut().filter(|panel| panel.axis == axis) {
            Some(panel) => panel.bins.push(bin),
            None => panels.push(Panel {
                axis: axis.to_owned(),
                division,
                bins: vec![bin],
            }),
        }
    }
    panels.truncate(MOST_PANELS);
    Ok(panels)
}

fn bin(row: &Row, columns: &[[usize; 3]], division: Division) -> Result<Bin, FigureError> {
    let mut probabilities = [[0.0; 3]; DRAWN.len()];
    for (probabilities, columns) in probabilities.iter_mut().zip(columns) {
        for (probability, column) in probabilities.iter_mut().zip(columns) {
            *probability = row.number(*column)?;
        }
    }
    Ok(Bin {
        ends: [1, 2].map(|column| Some(division.place(row.text(column).parse().ok()?))),
        probabilities,
    })
}

impl Panel {
    /// Positions of the bins along the axis: the middles of their ends.
    fn places(&self) -> Vec<f64> {
        let middles = self.bins.iter().map(|bin| match bin.ends {
            [Some(from), Some(to)] => 0.5 * (from + to),
            [Some(end), None] => self.beyond(end, 1.0),
            [None, Some(end)] => self.beyond(end, -1.0),
            [None, None] => 0.0,
        });
        middles.collect()
    }

    /// The middle of a bin that is open beyond `end`, as far from it as the middle of the adjacent bin.
    fn beyond(&self, end: f64, side: f64) -> f64 {
        let width = |bin: &Bin| {
            let (from, to) = (bin.ends[0]?, bin.ends[1]?);
            (from == end || to == end).then_some(to - from)
        };
        let width = self.bins.iter().find_map(width).unwrap_or(1.0);
        end + side * 0.5 * width
    }

    /// The axis of the bins.
    fn scale(&self, places: &[f64], count: usize) -> Scale {
        let least = places.iter().copied().fold(f64::INFINITY, f64::min);
        let most = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let margin = match most > least {
            true => 0.08 * (most - least),
            false => 0.5,
        };
        let ends = (least - margin, most + margin);
        Scale::of_condition(&self.axis, self.division, ends, count)
    }

    /// Draws the panel with about `count` numbers along its axis, and probabilities up to `top`.
    fn draw(&self, canvas: &mut Canvas, part: Area, count: usize, top: f64) {
        let places = self.places();
        let values = ticks::round_values(0.0, top, UP);
        let up = Scale::new("Probability", (-0.02 * top, 1.02 * top), values);
        let frame = Frame::new(part, self.scale(&places, count), up);
        frame.draw(canvas, Style::stroke(palette::GRID, 1.0));
        for drawn in 0..DRAWN.len() {
            let style = Style::stroke(colour(drawn), 1.0);
            let aside = BESIDE * (drawn as f64 - 1.0);
            let mut line = Vec::new();
            for (bin, place) in self.bins.iter().zip(&places) {
                let marks = frame.places(bin.probabilities[drawn].map(|value| (*place, value)));
                let marks: Vec<_> = marks.into_iter().map(|(x, y)| (x + aside, y)).collect();
                canvas.curve(&marks[1..], style);
                canvas.circle(marks[0], palette::SMALL_MARK, Style::fill(colour(drawn)));
                line.push(marks[0]);
            }
            canvas.curve(&line, style);
        }
    }
}

fn colour(drawn: usize) -> Colour {
    [
        palette::TEXT,
        palette::mark(Kind::Unstable),
        palette::mark(Kind::Bottomed),
    ][drawn % DRAWN.len()]
}

/// Each probability after its mark, and the meaning of the bars.
fn legend() -> Vec<Entry> {
    let drawn = DRAWN.iter().enumerate();
    let disc = |drawn| Mark::Disc(colour(drawn));
    let mut entries: Vec<Entry> = drawn
        .map(|(index, (words, _))| (disc(index), (*words).to_owned()))
        .collect();
    entries.push((Mark::Interval, "95 % interval".to_owned()));
    entries
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "axis,from,to,landings,topple_probability,topple_low_95,topple_high_95,\
        bottom_probability,bottom_low_95,bottom_high_95,not_stable_probability,not_stable_low_95,not_stable_high_95\n\
        all,,,30,0.1,0,0.2,0,0,0.1,0.1,0,0.2\n\
        friction,,0.5,10,0.1,0,0.2,0,0,0.1,0.1,0,0.2\n\
        friction,0.5,0.7,10,0.2,0.1,0.3,0,0,0.1,0.2,0.1,0.3\n\
        friction,0.7,,0,,0,1,,0,1,,0,1\n\
        slope_deg,-1,1,20,0.1,0,0.2,0,0,0.1,0.1,0,0.2\n\
        slope_deg,1,3,10,0.2,0.1,0.3,0,0,0.1,0.2,0.1,0.3\n";

    #[test]
    fn every_axis_has_a_panel_with_a_mark_for_each_bin_that_holds_landings() {
        assert!(is_one(TABLE));
        let svg = draw(TABLE, &Caption::default()).unwrap();
        // Two bins of either axis and a legend, three marks each.
        assert_eq!(svg.matches("<circle").count(), 15);
        for text in ["Friction coefficient", "Slope", "95 % interval"] {
            assert!(svg.contains(text), "{text}");
        }
        let panels = panels(TABLE, &Caption::default()).unwrap();
        assert_eq!(panels[0].places(), [0.4, 0.6]);
        assert_eq!(panels[1].places(), [0.0, 2.0]);
        // The greatest interval ends at 0.3: there is the highest number.
        assert!(svg.contains(">0.3</text>") && !svg.contains(">0.8</text>"));
        assert!(draw(&TABLE.replace("0.3", "x"), &Caption::default()).is_err());
        let empty: String = TABLE
            .lines()
            .take(2)
            .map(|row| format!("{row}\n"))
            .collect();
        assert!(draw(&empty, &Caption::default()).is_err());
    }

    #[test]
    fn any_number_of_axes_fits_a_page() {
        let (heading, _) = TABLE.split_once('\n').unwrap();
        let values = ",0,1,10,0.1,0,0.2,0,0,0.1,0.1,0,0.2\n";
        let size = |axes: usize| {
            let rows = (0..axes).map(|axis| format!("axis_{axis}{values}"));
            let table = format!("{heading}\n{}", rows.collect::<String>());
            let svg = draw(&table, &Caption::default()).unwrap();
            assert_eq!(
                svg.matches(">Probability</text>").count(),
                axes.min(MOST_PANELS)
            );
            let (_, height) = svg.split_once("height=\"").unwrap();
            height.split('"').next().unwrap().parse::<f64>().unwrap()
        };
        for axes in [1, 3, 4, 8, 9, 20, 30] {
            // The sides of a page are as 1 to 1.42.
            assert!(size(axes) < 1.42 * WIDTH, "{axes}: {}", size(axes));
        }
    }
}
