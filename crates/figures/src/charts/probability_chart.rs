//! Probabilities over the bins of each axis, with their 95 % intervals: a panel for every axis.

use crate::axis_title::axis_title;
use crate::boundary_table::Kind;
use crate::canvas::Canvas;
use crate::caption::Caption;
use crate::figure_error::FigureError;
use crate::frame::{Area, Frame, Scale};
use crate::legend::{Entry, Mark};
use crate::sheet::{self, Height, Sheet};
use crate::style::{Colour, Style};
use crate::table::{Row, Table};
use crate::{palette, ticks};

/// Width of the picture and height of its panels, pixels.
const WIDTH: f64 = 900.0;
const PANEL: f64 = 250.0;
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
    let panels = panels(csv)?;
    if panels.is_empty() {
        return Err(FigureError::Table("has no bins of an axis".to_owned()));
    }
    let entries = legend();
    let height = Height::Body(PANEL * panels.len() as f64);
    let Sheet { mut canvas, body } = sheet::begin(WIDTH, height, caption, &entries);
    for (part, panel) in body.rows(panels.len()).into_iter().zip(&panels) {
        panel.draw(&mut canvas, part);
    }
    Ok(canvas.into_svg())
}

/// The bins of an axis.
struct Panel {
    axis: String,
    bins: Vec<Bin>,
}

/// A bin with landings.
struct Bin {
    /// Lower and upper end as written, empty if there is none.
    ends: [String; 2],
    /// The probability and its interval for each of [`DRAWN`].
    probabilities: [[f64; 3]; DRAWN.len()],
}

fn panels(csv: &str) -> Result<Vec<Panel>, FigureError> {
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
        let bin = bin(&row, &columns)?;
        match panels.last_mut().filter(|panel| panel.axis == axis) {
            Some(panel) => panel.bins.push(bin),
            None => panels.push(Panel {
                axis: axis.to_owned(),
                bins: vec![bin],
            }),
        }
    }
    panels.truncate(MOST_PANELS);
    Ok(panels)
}

fn bin(row: &Row, columns: &[[usize; 3]]) -> Result<Bin, FigureError> {
    let mut probabilities = [[0.0; 3]; DRAWN.len()];
    for (probabilities, columns) in probabilities.iter_mut().zip(columns) {
        for (probability, column) in probabilities.iter_mut().zip(columns) {
            *probability = row.number(*column)?;
        }
    }
    Ok(Bin {
        ends: [row.text(1).to_owned(), row.text(2).to_owned()],
        probabilities,
    })
}

impl Panel {
    /// Positions of the bins along the axis: the middles of their ends.
    fn places(&self) -> Vec<f64> {
        let number = |end: &String| end.parse::<f64>().ok();
        let middles = self.bins.iter().map(|bin| {
            let [from, to] = &bin.ends;
            match (number(from), number(to)) {
                (Some(from), Some(to)) => 0.5 * (from + to),
                (Some(end), None) => self.beyond(end, 1.0),
                (None, Some(end)) => self.beyond(end, -1.0),
                (None, None) => 0.0,
            }
        });
        middles.collect()
    }

    /// The middle of a bin that is open beyond `end`, as far from it as the middle of the adjacent bin.
    fn beyond(&self, end: f64, side: f64) -> f64 {
        let width = |bin: &Bin| {
            let [from, to] = &bin.ends;
            let (from, to) = (from.parse::<f64>().ok()?, to.parse::<f64>().ok()?);
            (from == end || to == end).then_some(to - from)
        };
        let width = self.bins.iter().find_map(width).unwrap_or(1.0);
        end + side * 0.5 * width
    }

    /// The axis of the bins.
    fn scale(&self, places: &[f64]) -> Scale {
        let least = places.iter().copied().fold(f64::INFINITY, f64::min);
        let most = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let margin = match most > least {
            true => 0.08 * (most - least),
            false => 0.5,
        };
        let ends = (least - margin, most + margin);
        let values = ticks::of_condition(&self.axis, ends.0, ends.1, 11);
        Scale::new(axis_title(&self.axis), ends, values)
    }

    fn draw(&self, canvas: &mut Canvas, part: Area) {
        let places = self.places();
        let values = ticks::round_values(0.0, 1.0, 5);
        let up = Scale::new("Probability", (-0.02, 1.02), values);
        let frame = Frame::new(part, self.scale(&places), up);
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
        let panels = panels(TABLE).unwrap();
        assert_eq!(panels[0].places(), [0.4, 0.6]);
        assert_eq!(panels[1].places(), [0.0, 2.0]);
        assert!(draw(&TABLE.replace("0.3", "x"), &Caption::default()).is_err());
        let empty: String = TABLE
            .lines()
            .take(2)
            .map(|row| format!("{row}\n"))
            .collect();
        assert!(draw(&empty, &Caption::default()).is_err());
    }
}
