//! The contour map and the perspective of an adaptively refined map, with its exact edges.

use crate::canvas::{Canvas, Point};
use crate::caption::Caption;
use crate::heights::Heights;
use crate::isolines;
use crate::legend::{Entry, Mark, draw_mark, hatch};
use crate::levels::Levels;
use crate::map_table::{EdgeKind, Grid, MapTable};
use crate::map_view::View;
use crate::sheet::{self, Height, Sheet};
use crate::style::{Style, WHITE};
use crate::surface::Surface;
use crate::view_point::ViewPoint;
use crate::words::label;
use crate::{colour_bar, contour_map, palette, perspective};

/// Draws the contour map as SVG.
pub(crate) fn contours(map: &MapTable, heights: &Heights, caption: &Caption) -> String {
    let extent = extent(map);
    let levels = &heights.levels;
    let view = View::of(&extent, caption);
    let (width, height) = contour_map::SIZE;
    let whole = Height::Whole(height);
    let Sheet { mut canvas, body } = sheet::begin(width, whole, caption, &legend(map, caption));
    let [left, right] = colour_bar::beside(body, colour_bar::OVERLAP);
    let frame = contour_map::frame(left, &extent, &view);
    let places = |places: &[[f64; 2]]| frame.places(places.iter().map(|place| view.at(*place)));
    for [low, high] in levels.bands() {
        let polygons = isolines::band_of(&map.triangles, low, high);
        let polygons: Vec<Vec<Point>> = (polygons.iter())
            .map(|corners| frame.places(corners.iter().map(|(place, _)| view.at(*place))))
            .collect();
        canvas.fill_tiles(&polygons, levels.colour(low));
    }
    frame.draw(&mut canvas, Style::stroke(palette::TEXT, 1.0).opacity(0.12));
    if let Some((grid, asked)) = estimates(map, caption) {
        let width = frame.area.width() / (grid.coordinates[1].len() as f64 - 1.0);
        for line in hatching(grid, asked, width) {
            canvas.curve(&places(&line), hatch());
        }
    }
    let lines = levels.values().iter().map(|level| {
        let lines = isolines::lines_of(map.triangles.iter().copied(), *level);
        (*level, lines.iter().map(|line| places(line)).collect())
    });
    contour_map::draw_lines(&mut canvas, &frame.area, &[], lines);
    for edge in &map.edges {
        canvas.curve(&places(&edge.places), style(edge.kind));
    }
    for place in frame.places(map.patchy.iter().map(|place| view.at(*place))) {
        draw_mark(&mut canvas, patchy(), place, palette::SMALL_MARK);
    }
    colour_bar::draw(&mut canvas, right, heights, caption.speed_unit);
    canvas.into_svg()
}

/// Mark of a point above which stable landings and others alternate.
fn patchy() -> Mark {
    Mark::Ring(palette::PATCHY)
}

/// The regular table, and the error that was asked for, if both are known.
fn estimates<'m>(map: &'m MapTable, caption: &Caption) -> Option<(&'m Grid, f64)> {
    let asked = caption.map_error.filter(|error| *error > 0.0)?;
    Some((map.grid.as_ref()?, asked))
}

/// Lines of hatching, as coordinates, over the places of a regular table whose estimated error is unknown or larger
/// than asked; the columns of the table lie `width` pixels apart.
fn hatching(grid: &Grid, asked: f64, width: f64) -> Vec<[[f64; 2]; 2]> {
    let [slow, fast] = &grid.coordinates;
    let is_coarse = |row: usize, column: usize| {
        grid.errors[row * fast.len() + column].is_none_or(|error| error > asked)
    };
    let apart = (palette::HATCH_APART / width).round().max(1.0) as usize;
    let at = |along: &[f64], index: f64| {
        let low = (index.floor() as usize).min(along.len().saturating_sub(2));
        let high = (low + 1).min(along.len() - 1);
        along[low] + (index - low as f64) * (along[high] - along[low])
    };
    diagonals([slow.len(), fast.len()], apart, is_coarse)
        .into_iter()
        .map(|ends| ends.map(|[row, column]| [at(slow, row), at(fast, column)]))
        .collect()
}

/// Lines between places, as indices of row and column, on every `apart`-th diagonal of a table of this many rows and
/// columns. They end half a step beyond the last marked place, or at the border.
fn diagonals(
    [rows, columns]: [usize; 2],
    apart: usize,
    is_marked: impl Fn(usize, usize) -> bool,
) -> Vec<[[f64; 2]; 2]> {
    let mut lines = Vec::new();
    for diagonal in (0..(rows + columns).saturating_sub(1)).step_by(apart) {
        let first = (diagonal + 1).saturating_sub(columns);
        let along: Vec<usize> = (first..=diagonal.min(rows - 1)).collect();
        let runs =
            along.chunk_by(|a, b| is_marked(*a, diagonal - a) == is_marked(*b, diagonal - b));
        let marked = runs.filter(|run| is_marked(run[0], diagonal - run[0]));
        lines.extend(marked.map(|run| {
            let end = |row: usize, is_last: bool| {
                let column = diagonal - row;
                let beyond = match is_last {
                    false if row == 0 || column + 1 == columns => 0.0,
                    true if row + 1 == rows || column == 0 => 0.0,
                    false => -0.5,
                    true => 0.5,
                };
                [row as f64 + beyond, column as f64 - beyond]
            };
            [end(run[0], false), end(run[run.len() - 1], true)]
        }));
    }
    lines
}

/// Draws the perspective as SVG.
pub(crate) fn perspective(map: &MapTable, heights: &Heights, caption: &Caption) -> String {
    let extent = extent(map);
    let (width, height) = perspective::SIZE;
    let whole = Height::Whole(height);
    let Sheet { mut canvas, body } = sheet::begin(width, whole, caption, &[]);
    let [left, right] = colour_bar::beside(body, 0.0);
    if let Some((ends, step)) = perspective::floor_and_top(heights) {
        let point = ViewPoint::on(left, &extent, ends);
        perspective::draw_box(&mut canvas, &extent, &point, (ends, step), caption);
        draw_surface(&mut canvas, map, &heights.levels, &point);
    }
    colour_bar::draw(&mut canvas, right, heights, caption.speed_unit);
    canvas.into_svg()
}

/// Draws the triangles from back to front, each in bands of colour with the lines between them.
fn draw_surface(canvas: &mut Canvas, map: &MapTable, levels: &Levels, point: &ViewPoint) {
    let mut triangles = map.triangles.clone();
    let depth = |corners: &[([f64; 2], f64); 3]| {
        let sum =
            |axis: usize| corners.iter().map(|(place, _)| place[axis]).sum::<f64>() * 2.0 / 3.0;
        point.depth(sum(0), sum(1))
    };
    triangles.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
    let pixel = |([slow, fast], height): &([f64; 2], f64)| point.pixel(*slow, *fast, *height);
    for triangle in triangles {
        for [low, high] in levels.bands() {
            for corners in isolines::band_of(&[triangle], low, high) {
                let corners: Vec<Point> = corners.iter().map(pixel).collect();
                let colour = levels.colour(low);
                canvas.polygon(&corners, Style::fill(colour).outlined(colour, 0.4));
            }
        }
        for level in levels.values() {
            for line in isolines::lines_of([triangle].into_iter(), *level) {
                let line: Vec<Point> = line.iter().map(|place| pixel(&(*place, *level))).collect();
                canvas.curve(&line, Style::stroke(palette::TEXT, 0.8));
            }
        }
    }
}

/// The default levels of a map.
pub fn levels(map: &MapTable) -> Levels {
    Heights::of_maps([map], None).levels
}

/// A surface with only the extent of a map: it is as wide as what was searched, if that is known.
fn extent(map: &MapTable) -> Surface {
    let ends = |axis: usize| {
        let of_corners = map.triangles.iter().flatten().map(|(place, _)| place[axis]);
        let of_edges = map.edges.iter().flat_map(|edge| &edge.places);
        let of_grid = map.grid.iter().flat_map(|grid| &grid.coordinates[axis]);
        let all = of_corners
            .chain(of_edges.map(|place| place[axis]))
            .chain(of_grid.copied());
        let ends = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        ends.to_vec()
    };
    Surface {
        axes: map.axes.clone(),
        slow: ends(0),
        fast: ends(1),
        speeds: Vec::new(),
        doubtful: Vec::new(),
        jump: f64::INFINITY,
    }
}

fn style(kind: EdgeKind) -> Style {
    match kind {
        EdgeKind::End => Style::stroke(palette::NONE, 2.0),
        EdgeKind::Jump => Style::stroke(palette::JUMP, 2.0),
        EdgeKind::Bands => Style::stroke(palette::BISECTOR, 1.5).dashed(Some((4.0, 3.0))),
    }
}

/// Words for the meaning of an edge.
pub fn words(kind: EdgeKind) -> &'static str {
    match kind {
        EdgeKind::End => "transitions end",
        EdgeKind::Jump => "V_H jumps",
        EdgeKind::Bands => "bands change in number",
    }
}

fn legend(map: &MapTable, caption: &Caption) -> Vec<Entry> {
    let is_there = |kind: &EdgeKind| map.edges.iter().any(|edge| edge.kind == *kind);
    let mut entries: Vec<Entry> = (EdgeKind::ALL.into_iter().filter(is_there))
        .map(|kind| (Mark::Line(style(kind)), words(kind).to_owned()))
        .collect();
    if !map.patchy.is_empty() {
        entries.push((patchy(), palette::PATCHY_WORDS.to_owned()));
    }
    if let Some((_, asked)) = estimates(map, caption) {
        let words = format!(
            "estimated error above {} {}",
            label(asked),
            caption.speed_unit
        );
        entries.push((Mark::Hatched, words));
    }
    let words = format!("white: {}", caption.without_transition());
    entries.push((
        Mark::Area(Style::fill(WHITE).outlined(palette::GRID, 1.0)),
        words,
    ));
    entries
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_run_through_what_is_marked_and_nothing_else() {
        let whole = diagonals([3, 4], 1, |_, _| true);
        assert_eq!(whole.len(), 6, "one for each diagonal");
        assert_eq!(whole[3], [[0.0, 3.0], [2.0, 1.0]]);
        assert_eq!(diagonals([3, 4], 2, |_, _| true).len(), 3);
        assert_eq!(diagonals([3, 4], 1, |_, _| false).len(), 0);
        // A gap in the middle of the third diagonal.
        let parted = diagonals([3, 4], 1, |row, column| row + column == 2 && row != 1);
        assert_eq!(parted, [[[0.0, 2.0], [0.5, 1.5]], [[1.5, 0.5], [2.0, 0.0]]]);
        assert!(diagonals([1, 1], 1, |_, _| true).len() == 1);
    }
}
