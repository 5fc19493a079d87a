//! Lines and bands of equal height over the whole cells of a surface.
//!
//! The `contour` crate interpolates over its whole grid. Here cells without a transition and cells across which the
//! boundary jumps must stay empty. Each whole cell is cut into four triangles about its middle, on which heights are
//! linear, so lines and bands fit each other exactly.

use crate::surface::{Cell, Surface};

/// A place on the map: slow and fast coordinate.
pub type Place = [f64; 2];

/// A corner of a triangle: place and height.
pub type Corner = (Place, f64);

/// The four corners of a whole cell, and the place and mean height of its middle.
fn corners(surface: &Surface) -> impl Iterator<Item = ([Corner; 4], Corner)> {
    surface.cells().filter_map(|([row, column], cell)| {
        let Cell::Whole([a, b, c, d]) = cell else {
            return None;
        };
        let (s, f) = (&surface.slow, &surface.fast);
        let ([s0, s1], [f0, f1]) = ([s[row], s[row + 1]], [f[column], f[column + 1]]);
        let middle = ([0.5 * (s0 + s1), 0.5 * (f0 + f1)], 0.25 * (a + b + c + d));
        let corners = [([s0, f0], a), ([s0, f1], b), ([s1, f1], c), ([s1, f0], d)];
        Some((corners, middle))
    })
}

/// The four triangles of a cell about its middle.
fn triangles(corners: [Corner; 4], middle: Corner) -> [[Corner; 3]; 4] {
    [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4], middle])
}

/// The point between two corners with height `level`.
fn crossing((p, a): Corner, (q, b): Corner, level: f64) -> Place {
    let part = (level - a) / (b - a);
    [p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])]
}

/// Polygons that cover heights from `low` up to `high`.
pub fn band(surface: &Surface, low: f64, high: f64) -> Vec<Vec<Place>> {
    let places = |polygon: &[Corner]| polygon.iter().map(|(place, _)| *place).collect();
    let cut = |triangle: [Corner; 3]| clip(&clip(&triangle, low, 1.0), high, -1.0);
    corners(surface)
        .flat_map(|(corners, middle)| {
            if corners
                .iter()
                .all(|(_, height)| (low..high).contains(height))
            {
                return vec![places(&corners)];
            }
            let parts = triangles(corners, middle).map(cut);
            let parts = parts.iter().filter(|polygon| polygon.len() > 2);
            parts.map(|polygon| places(polygon)).collect()
        })
        .collect()
}

/// Polygons that cover heights of triangles from `low` up to `high`.
pub fn band_of(triangles: &[[Corner; 3]], low: f64, high: f64) -> Vec<Vec<Corner>> {
    let cut = |triangle: &[Corner; 3]| clip(&clip(triangle, low, 1.0), high, -1.0);
    let polygons = triangles.iter().map(cut);
    polygons.filter(|polygon| polygon.len() > 2).collect()
}

/// The part of a polygon above `level`, or below it for a `side` of −1.
fn clip(polygon: &[Corner], level: f64, side: f64) -> Vec<Corner> {
    let inside = |corner: &Corner| side * (corner.1 - level) >= 0.0;
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (index, corner) in polygon.iter().enumerate() {
        let next = polygon[(index + 1) % polygon.len()];
        if inside(corner) {
            kept.push(*corner);
        }
        if inside(corner) != inside(&next) {
            kept.push((crossing(*corner, next, level), level));
        }
    }
    kept
}

/// The lines at a level, each from end to end.
pub fn lines(surface: &Surface, level: f64) -> Vec<Vec<Place>> {
    let cells = corners(surface);
    lines_of(
        cells.flat_map(|(corners, middle)| triangles(corners, middle)),
        level,
    )
}

/// The lines of triangles at a level, each from end to end.
pub fn lines_of(triangles: impl Iterator<Item = [Corner; 3]>, level: f64) -> Vec<Vec<Place>> {
    let mut pieces: Vec<[Place; 2]> = triangles
        .filter_map(|triangle| {
            let ends: Vec<Place> = (0..3)
                .map(|i| (triangle[i], triangle[(i + 1) % 3]))
                .filter(|(a, b)| (a.1 < level) != (b.1 < level))
                // Always from the lower corner, so that adjacent triangles agree to the bit.
                .map(|(a, b)| {
                    if a.1 < b.1 {
                        crossing(a, b, level)
                    } else {
                        crossing(b, a, level)
                    }
                })
                .collect();
            <[Place; 2]>::try_from(ends).ok()
        })
        .collect();
    let mut lines = Vec::new();
    while let Some([start, end]) = pieces.pop() {
        let mut line = vec![start, end];
        extend(&mut line, &mut pieces);
        line.reverse();
        extend(&mut line, &mut pieces);
        lines.push(line);
    }
    lines
}

/// Appends the pieces that continue a line at its end.
fn extend(line: &mut Vec<Place>, pieces: &mut Vec<[Place; 2]>) {
    let same = |a: Place, b: Place| (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-9;
    while let Some(&end) = line.last() {
        let next = pieces
            .iter()
            .position(|piece| same(piece[0], end) || same(piece[1], end));
        let Some(index) = next else { break };
        let [a, b] = pieces.swap_remove(index);
        line.push(if same(a, end) { b } else { a });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::example;

    #[test]
    fn a_line_runs_where_the_height_is_its_level() {
        let lines = lines(&example(), 12.5);
        // Between (80, -30) at 12 and (80, -10) at 13 it starts half-way.
        let ends: Vec<Place> = lines
            .iter()
            .flat_map(|line| [line[0], line[line.len() - 1]])
            .collect();
        assert!(ends.contains(&[80.0, -20.0]), "{ends:?}");
    }

    #[test]
    fn nothing_is_drawn_in_torn_and_open_cells() {
        let surface = example();
        for level in [12.5, 15.0, 18.0, 20.2] {
            assert!(
                lines(&surface, level)
                    .iter()
                    .flatten()
                    .all(|place| place[1] <= 10.0)
            );
            assert!(
                band(&surface, level, 25.0)
                    .iter()
                    .flatten()
                    .all(|place| place[1] <= 10.0)
            );
        }
    }

    #[test]
    fn bands_share_out_the_whole_cells() {
        let area = |polygon: &Vec<Place>| -> f64 {
            let next = polygon.iter().cycle().skip(1);
            let twice: f64 = polygon
                .iter()
                .zip(next)
                .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
                .sum();
            0.5 * twice.abs()
        };
        let surface = example();
        let levels = [0.0, 11.7, 12.2, 13.0, 99.0];
        let total: f64 = levels
            .windows(2)
            .flat_map(|pair| band(&surface, pair[0], pair[1]))
            .map(|polygon| area(&polygon))
            .sum();
        assert!((total - 4.0 * 50.0 * 20.0).abs() < 1e-6, "{total}");
    }
}
