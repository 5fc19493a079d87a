//! Probabilities over the bins of each axis, with their 95 % intervals: a panel for every axis.

use plotters::prelude::*;

use crate::axis_title::axis_title;
use crate::boundary_table::Kind;
use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::mesh::{self, Along};
use crate::number::label;
use crate::sheet::{self, Sheet};
use crate::table::{Row, Table};

/// Width of the picture and height of its frame and panels, pixels.
const WIDTH: u32 = 900;
const FRAME: u32 = 110;
const PANEL: u32 = 250;
/// Axes that are drawn, those of the table from the first on.
const MOST_PANELS: usize = 20;
/// Probabilities that are drawn: their words, and the beginning of the names of their columns.
const DRAWN: [(&str, &str); 3] = [
    ("not stable", "not_stable"),
    ("toppled", "topple"),
    ("bottomed a strut", "bottom"),
];
/// Distance between the bars of one bin, over the width of the panel.
const BESIDE: f64 = 0.006;

/// Whether a table is one of probabilities.
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
    let size = (WIDTH, FRAME + PANEL * panels.len() as u32);
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
    draw_sheet(area, size, &panels, caption)?;
    Ok(sheet::with_subscripts(&svg))
}

/// The bins of an axis.
struct Panel {
    axis: String,
    bins: Vec<Bin>,
}

/// A bin with landings.
struct Bin {
    /// Lower and upper end as written, empty where there is none.
    ends: [String; 2],
    /// For each of [`DRAWN`] the probability and its interval.
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
    /// Where the bins lie along the axis: in the middle of their ends, or one after the other where ends are words.
    fn places(&self) -> Vec<f64> {
        let number = |end: &String| end.parse::<f64>().ok();
        let middles = self.bins.iter().map(|bin| {
            let [from, to] = &bin.ends;
            match (number(from), number(to)) {
                (Some(from), Some(to)) => Some(0.5 * (from + to)),
                (Some(end), None) => Some(self.beyond(end, 1.0)),
                (None, Some(end)) => Some(self.beyond(end, -1.0)),
                (None, None) => None,
            }
        });
        let middles: Option<Vec<f64>> = middles.collect();
        middles.unwrap_or_else(|| (0..self.bins.len()).map(|index| index as f64).collect())
    }

    /// The middle of a bin that is open beyond `end`: as far from it as that of the bin beside it.
    fn beyond(&self, end: f64, side: f64) -> f64 {
        let width = |bin: &Bin| {
            let [from, to] = &bin.ends;
            let (from, to) = (from.parse::<f64>().ok()?, to.parse::<f64>().ok()?);
            (from == end || to == end).then_some(to - from)
        };
        let width = self.bins.iter().find_map(width).unwrap_or(1.0);
        end + side * 0.5 * width
    }

    /// What stands at a place: the word of a bin with words, else the number.
    fn label(&self, place: f64) -> String {
        let word = |end: &str| !end.is_empty() && end.parse::<f64>().is_err();
        match self.bins.get(place.round().max(0.0) as usize) {
            Some(bin) if word(&bin.ends[0]) && (place - place.round()).abs() < 1e-6 => {
                bin.ends[0].clone()
            }
            Some(bin) if word(&bin.ends[0]) => String::new(),
            _ => label(place),
        }
    }
}

fn colour(drawn: usize) -> RGBColor {
    [
        ink::TEXT,
        ink::mark(Kind::Unstable),
        ink::mark(Kind::Bottomed),
    ][drawn % DRAWN.len()]
}

fn draw_sheet(
    sheet: Sheet,
    size: (u32, u32),
    panels: &[Panel],
    caption: &Caption,
) -> Result<(), FigureError> {
    let (body, foot) = sheet::parts(&sheet, size, caption)?;
    for (part, panel) in body.split_evenly((panels.len(), 1)).iter().zip(panels) {
        draw_panel(part, panel)?;
    }
    draw_legend(&foot)?;
    sheet.present().map_err(drawing)
}

fn draw_panel(part: &Sheet, panel: &Panel) -> Result<(), FigureError> {
    let places = panel.places();
    let least = places.iter().copied().fold(f64::INFINITY, f64::min);
    let most = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let margin = match most > least {
        true => 0.08 * (most - least),
        false => 0.5,
    };
    let (left, right) = (least - margin, most + margin);
    let mut chart = ChartBuilder::on(part)
        .margin_right(28)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(52)
        .y_label_area_size(72)
        .build_cartesian_2d(left..right, -0.02..1.02)
        .map_err(drawing)?;
    mesh::draw(
        &mut chart,
        ink::GRID,
        &Along {
            title: &axis_title(&panel.axis),
            count: 11,
            label: &|x| panel.label(*x),
        },
        &Along {
            title: "Probability",
            count: 6,
            label: &|y| label(*y),
        },
    )?;
    for drawn in 0..DRAWN.len() {
        let colour = colour(drawn);
        let aside = BESIDE * (right - left) * (drawn as f64 - 1.0);
        let mut line = Vec::new();
        for (bin, place) in panel.bins.iter().zip(&places) {
            let ([at, low, high], x) = (bin.probabilities[drawn], place + aside);
            let interval = PathElement::new([(x, low), (x, high)], colour.stroke_width(1));
            chart.draw_series([interval]).map_err(drawing)?;
            let mark = Circle::new((x, at), ink::SMALL_MARK, colour.filled());
            chart.draw_series([mark]).map_err(drawing)?;
            line.push((x, at));
        }
        let line = PathElement::new(line, colour.stroke_width(1));
        chart.draw_series([line]).map_err(drawing)?;
    }
    Ok(())
}

/// Each probability in words after its mark, and what the bars are.
fn draw_legend(foot: &Sheet) -> Result<(), FigureError> {
    const STEP: i32 = 190;
    let mut x = (foot.dim_in_pixel().0 as i32 - STEP * (DRAWN.len() as i32 + 1)) / 2;
    let write = |text: &str, x: i32| {
        let text = Text::new(text.to_owned(), (x + 12, 7), ink::text(12, ink::TEXT));
        foot.draw(&text).map_err(drawing)
    };
    for (drawn, (words, _)) in DRAWN.iter().enumerate() {
        let mark = Circle::new((x, 12), ink::SMALL_MARK, colour(drawn).filled());
        foot.draw(&mark).map_err(drawing)?;
        write(words, x)?;
        x += STEP;
    }
    let bar = PathElement::new([(x, 5), (x, 19)], ink::TEXT.stroke_width(1));
    foot.draw(&bar).map_err(drawing)?;
    write("95 % interval", x)
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
        solver.crush_rule,pivot-rate,pivot-rate,20,0.1,0,0.2,0,0,0.1,0.1,0,0.2\n\
        solver.crush_rule,section,section,10,0.2,0.1,0.3,0,0,0.1,0.2,0.1,0.3\n";

    #[test]
    fn every_axis_has_a_panel_with_a_mark_for_each_bin_that_holds_landings() {
        assert!(is_one(TABLE));
        let svg = draw(TABLE, &Caption::default()).unwrap();
        // Two bins of either axis and a legend, three marks each.
        assert_eq!(svg.matches("<circle").count(), 15);
        for text in ["Friction coefficient", "section", "95 % interval"] {
            assert!(svg.contains(text), "{text}");
        }
        let panels = panels(TABLE).unwrap();
        assert_eq!(panels[0].places(), [0.4, 0.6]);
        assert_eq!(panels[1].places(), [0.0, 1.0]);
        assert!(draw(&TABLE.replace("0.3", "x"), &Caption::default()).is_err());
        let empty: String = TABLE
            .lines()
            .take(2)
            .map(|row| format!("{row}\n"))
            .collect();
        assert!(draw(&empty, &Caption::default()).is_err());
    }
}
