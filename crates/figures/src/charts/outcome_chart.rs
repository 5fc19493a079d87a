//! Outcomes of landings over two axes: a mark for every landing.

use crate::axis_title::axis_title;
use crate::boundary_table::Kind;
use crate::caption::Caption;
use crate::frame::{Area, Frame, Scale};
use crate::legend::{Entry, Mark, draw_mark};
use crate::palette;
use crate::sheet::{self, Height, Sheet};
use crate::style::Style;
use crate::tables::Table;
use crate::words::FigureError;

/// Width and height of the picture, pixels.
const SIZE: (f64, f64) = (900.0, 760.0);
/// Distance of marks below which they are small, pixels.
const ROOMY: f64 = 14.0;
/// Space between the outermost marks and the frame, as a share of the range of an axis.
const MARGIN: f64 = 0.04;

/// Column of outcomes; the axes precede it.
const OUTCOME: &str = "outcome";

/// Returns whether a table is one of the landings of a sweep.
pub fn is_one(csv: &str) -> bool {
    let heading = csv.lines().next().unwrap_or("");
    heading.split(',').any(|name| name == OUTCOME) && !heading.starts_with("t_s,")
}

/// Draws a table of landings over two axes as SVG.
///
/// # Errors
/// When a cell of an axis is not a number, or there are not two axes.
pub fn draw(csv: &str, caption: &Caption) -> Result<String, FigureError> {
    let table = Table::parse(csv)?;
    let outcome = table.column(OUTCOME)?;
    if outcome != 2 {
        return Err(FigureError::NoPicture(format!(
            "landings over {outcome} axes cannot be drawn: expected two"
        )));
    }
    let names = table.names();
    let mut landings = Vec::new();
    for row in table.rows() {
        let mark = mark(row.text(outcome));
        let place = |column| {
            let value = row.number(column)?;
            Ok(caption.division(names[column]).place(value))
        };
        landings.push(([place(1)?, place(0)?], mark));
    }
    if landings.is_empty() {
        return Err(FigureError::NoPicture("there are no landings".to_owned()));
    }
    let entries: Vec<Entry> = (legend().into_iter())
        .filter(|(known, _)| landings.iter().any(|(_, mark)| mark == known))
        .collect();
    let (width, height) = SIZE;
    let Sheet { mut canvas, body } = sheet::begin(width, Height::Whole(height), caption, &entries);
    let scale = |axis: usize, column: usize, count| {
        let values = || landings.iter().map(|(at, _)| at[axis]);
        let least = values().fold(f64::INFINITY, f64::min);
        let most = values().fold(f64::NEG_INFINITY, f64::max);
        let margin = match most > least {
            true => MARGIN * (most - least),
            false => 0.5,
        };
        let division = caption.division(names[column]);
        Scale {
            title: axis_title(names[column]),
            ends: (least - margin, most + margin),
            ticks: division.ticks(names[column], least, most, count),
        }
    };
    let frame = Frame::new(body, scale(0, 1, 13), scale(1, 0, 11));
    frame.draw(&mut canvas, Style::stroke(palette::GRID, 1.0));
    let side = side(&frame.area, landings.len());
    for ([x, y], mark) in &landings {
        draw_mark(&mut canvas, *mark, frame.place((*x, *y)), side);
    }
    Ok(canvas.into_svg())
}

/// Half the breadth of marks when there are this many in an area.
fn side(area: &Area, marks: usize) -> f64 {
    let apart = (area.width() * area.height() / marks as f64).sqrt();
    if apart > ROOMY {
        palette::MARK
    } else {
        palette::SMALL_MARK
    }
}

/// The mark of a landing by its outcome.
fn mark(outcome: &str) -> Mark {
    match outcome.split('-').next().unwrap_or_default() {
        "stable" => Mark::Ring(palette::NONE),
        class => Mark::Transition(Kind::from_name(class).unwrap_or(Kind::Undecided)),
    }
}

fn legend() -> Vec<Entry> {
    let kinds = Kind::ALL.map(|kind| (Mark::Transition(kind), palette::word(kind).to_owned()));
    let stable = (Mark::Ring(palette::NONE), "stable".to_owned());
    std::iter::once(stable).chain(kinds).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "vertical_velocity_fps,horizontal_velocity_fps,outcome,end_time_s\n\
        2,0,stable-subsided,1\n\
        2,8,unstable-toppled,1\n\
        10,0,bottomed-leg-2,1\n\
        10,8,sliding,1\n";

    #[test]
    fn every_landing_has_the_mark_of_its_class_where_it_belongs() {
        assert!(is_one(TABLE));
        let svg = draw(TABLE, &Caption::default()).unwrap();
        for word in ["stable", "topples", "strut bottoms", "undecided"] {
            assert!(svg.contains(word), "{word}");
        }
        assert!(!svg.contains("not computed"));
        // Its mark and that of the legend.
        let toppled = format!("fill=\"{}\"", palette::mark(Kind::Unstable).hex());
        let circles: Vec<&str> = (svg.split("<circle").skip(1))
            .filter(|circle| circle.split("/>").next().unwrap().contains(&toppled))
            .collect();
        assert_eq!(circles.len(), 2);
        let number = |circle: &str, name: &str| -> f64 {
            let (_, after) = circle.split_once(&format!("{name}=\"")).unwrap();
            after.split('"').next().unwrap().parse().unwrap()
        };
        // At the right, where V_H is 8 ft/s, and below, where V_V is 2 ft/s.
        let in_chart = |circle: &&str| number(circle, "cx") > 700.0 && number(circle, "cy") > 500.0;
        assert_eq!(circles.iter().copied().filter(in_chart).count(), 1);
    }

    #[test]
    fn what_has_not_two_axes_has_no_picture() {
        let one = "horizontal_velocity_fps,outcome\n8,sliding\n";
        let told = draw(one, &Caption::default()).unwrap_err().to_string();
        assert!(told.contains("expected two"), "{told}");
    }
}
