//! The work-precision diagram: error against time, both on logarithmic scales.

use plotters::prelude::*;

use crate::caption::Caption;
use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::sheet;

const SIZE: (u32, u32) = (900, 620);
const COST: &str = "mean_us_per_landing";
/// First column of the table.
const TOLERANCE: &str = "tolerance";
/// Errors drawn: column and words.
const ERRORS: [(&str, &str); 4] = [
    (
        "worst_transition_error_fps",
        "transition velocity V_H, ft/s",
    ),
    ("worst_least_angle_error_deg", "least stability angle, deg"),
    ("worst_pitch_error_at_1s_deg", "pitch at 1 s, deg"),
    ("worst_position_error_at_1s_ft", "position at 1 s, ft"),
];
/// Errors below this are not told apart: transitions are narrowed to 1e-6 ft/s.
const LEAST: f64 = 1e-10;

/// Whether a table is one of work and precision.
pub fn is_one(csv: &str) -> bool {
    csv.starts_with(&format!("{TOLERANCE},"))
}

/// A column of errors against cost, ms.
struct Curve {
    words: &'static str,
    points: Vec<(f64, f64)>,
}

/// Draws a table of `touchdown work-precision` as SVG.
///
/// # Errors
/// When a column is missing or a cell is not a number.
pub fn draw(csv: &str) -> Result<String, FigureError> {
    let (tolerances, curves) = read(csv)?;
    let caption = Caption {
        title: "Work and precision: worst error against run time".to_owned(),
        conditions: "level landings around the toppling boundary, slope 15 deg, V_V 14 ft/s; one \
                     thread; numbers at points: tolerance"
            .to_owned(),
        ..Caption::default()
    };
    let mut svg = String::new();
    let sheet = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    let (body, foot) = sheet::parts(&sheet, SIZE, &caption)?;
    let all = || curves.iter().flat_map(|curve| &curve.points);
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), v| {
            (low.min(v), high.max(v))
        });
        (low / 1.6)..(high * 1.6)
    };
    let (across, up) = (
        range(&mut all().map(|point| point.0)),
        range(&mut all().map(|point| point.1)),
    );
    let mut chart = ChartBuilder::on(&body)
        .margin_right(28)
        .margin_top(8)
        .margin_left(14)
        .x_label_area_size(46)
        .y_label_area_size(72)
        .build_cartesian_2d(across.log_scale().base(2.0), up.log_scale())
        .map_err(drawing)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(ink::GRID)
        .axis_style(ink::TEXT)
        .x_label_formatter(&|x| format!("{x}"))
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .label_style(ink::text(12, ink::TEXT))
        .axis_desc_style(ink::text(14, ink::TEXT))
        .x_desc("Time of a landing, mean, ms")
        .y_desc("Worst error")
        .draw()
        .map_err(drawing)?;
    for (index, curve) in curves.iter().enumerate() {
        let colour = ink::series(index);
        chart
            .draw_series(LineSeries::new(
                curve.points.iter().copied(),
                colour.stroke_width(2),
            ))
            .map_err(drawing)?;
        let marks = curve
            .points
            .iter()
            .map(|&place| Circle::new(place, ink::MARK - 1, colour.filled()));
        chart.draw_series(marks).map_err(drawing)?;
    }
    let names = curves[0]
        .points
        .iter()
        .zip(&tolerances)
        .map(|(&place, name)| {
            EmptyElement::at(place)
                + Text::new(name.clone(), (7, -14), ink::text(11, ink::PALE_TEXT))
        });
    chart.draw_series(names).map_err(drawing)?;
    let mut x = 60;
    for (index, curve) in curves.iter().enumerate() {
        let style = ink::series(index).filled();
        foot.draw(&Circle::new((x, 12), ink::MARK - 1, style))
            .map_err(drawing)?;
        foot.draw(&Text::new(
            curve.words,
            (x + 9, 6),
            ink::text(12, ink::TEXT),
        ))
        .map_err(drawing)?;
        x += 36 + (6.4 * curve.words.chars().count() as f64) as i32;
    }
    sheet.present().map_err(drawing)?;
    drop((chart, body, foot, sheet));
    Ok(sheet::with_subscripts(&svg))
}

/// The tolerances as written, and the curves.
fn read(csv: &str) -> Result<(Vec<String>, Vec<Curve>), FigureError> {
    let broken = |error: csv::Error| FigureError::Table(error.to_string());
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let heading = reader.headers().map_err(broken)?.clone();
    let column = |name: &str| {
        heading
            .iter()
            .position(|column| column == name)
            .ok_or_else(|| FigureError::Table(format!("column {name} is missing")))
    };
    let cost = column(COST)?;
    let rows: Vec<csv::StringRecord> =
        reader.records().collect::<Result<_, _>>().map_err(broken)?;
    if rows.is_empty() {
        return Err(FigureError::Table("has no rows".to_owned()));
    }
    let number = |row: usize, column: usize| match rows[row][column].parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number.max(LEAST)),
        _ => Err(FigureError::Table(format!(
            "row {}: {} = {}: allowed is a number that is not negative",
            row + 1,
            &heading[column],
            &rows[row][column]
        ))),
    };
    let curves = ERRORS.into_iter().map(|(name, words)| {
        let column = column(name)?;
        let points = (0..rows.len())
            .map(|row| Ok((1e-3 * number(row, cost)?, number(row, column)?)))
            .collect::<Result<_, FigureError>>()?;
        Ok(Curve { words, points })
    });
    let tolerances = rows.iter().map(|row| row[0].to_owned()).collect();
    Ok((tolerances, curves.collect::<Result<_, FigureError>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "tolerance,mean_us_per_landing,worst_transition_error_fps,\
        worst_least_angle_error_deg,worst_pitch_error_at_1s_deg,worst_position_error_at_1s_ft\n\
        1e-4,2000,1e-4,1e-2,1e-3,1e-5\n1e-6,6000,0e0,1e-4,1e-5,1e-7\n";

    #[test]
    fn every_error_of_every_tolerance_has_a_mark() {
        assert!(is_one(TABLE));
        let svg = draw(TABLE).unwrap();
        // Four curves of two points, and four marks in the legend.
        assert_eq!(svg.matches("<circle").count(), 12);
        assert!(svg.contains("1e-4") && svg.contains("1e-6"));
        let broken = draw(&TABLE.replace("1e-2", "NaN")).unwrap_err().to_string();
        assert!(broken.contains("row 1: worst_least_angle_error_deg = NaN"));
        assert!(draw(&TABLE.replace("worst_pitch", "pitch")).is_err());
    }
}
