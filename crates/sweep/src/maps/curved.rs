//! First transitions between known places of a map, on the quadratic surface nearest to those around.
//!
//! Planes between places are off by the curvature between them. Within each triangle of the surface the middles of its sides
//! are therefore lifted to the quadratic that fits the nearest known transitions best, by least squares, nearer places
//! counting more. A middle is lifted alike from either triangle beside it.

use std::collections::HashMap;

use crate::cell::{Position, middle};
use crate::pieces::Corner;

/// Places that a quadratic is fitted to: twice its coefficients.
const NEAREST: usize = 12;
/// Bins around one that are searched for them.
const BINS: usize = 2;
/// Coefficients of a quadratic over two axes.
const COEFFICIENTS: usize = 6;
/// How far each place is taken to be at least, in bins.
const SOFTENED: f64 = 0.06;
/// Least part that is left of a diagonal element in its elimination.
const DEFINITE: f64 = 1e-9;

/// Known transitions by where they lie.
#[derive(Debug)]
pub(crate) struct CurvedSurface {
    /// Steps of a bin along each axis: a first-level cell.
    size: [f64; 2],
    bins: HashMap<[usize; 2], Vec<Corner>>,
    /// Pieces of the lines along which transitions jump.
    jumps: Vec<[Position; 2]>,
}

impl CurvedSurface {
    /// The surface through some transitions, parted along some lines; a first-level cell has so many steps along each axis.
    pub(crate) fn new(
        known: impl Iterator<Item = Corner>,
        jumps: Vec<[Position; 2]>,
        cell: [usize; 2],
    ) -> Self {
        let size = cell.map(|steps| steps as f64);
        let mut bins: HashMap<[usize; 2], Vec<Corner>> = HashMap::new();
        for corner in known {
            bins.entry(bin(corner.at, size)).or_default().push(corner);
        }
        Self { size, bins, jumps }
    }

    /// The four triangles of a triangle, with its sides' middles on the surface.
    pub(crate) fn quarters(&self, [a, b, c]: [Corner; 3]) -> [[Corner; 3]; 4] {
        let [ab, bc, ca] = [self.between(a, b), self.between(b, c), self.between(c, a)];
        [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    }

    /// The surface half-way between two of its corners.
    fn between(&self, a: Corner, b: Corner) -> Corner {
        // In one order, so that every bit is the same from either side.
        let (a, b) = match a.at <= b.at {
            true => (a, b),
            false => (b, a),
        };
        let at = middle(a.at, b.at);
        let straight = 0.5 * (a.speed + b.speed);
        // What joins two points of an edge lies on neither side of it.
        let is_beside = self.is_known(a) || self.is_known(b);
        let fitted = is_beside.then(|| self.fitted(at)).flatten();
        let speed = fitted.unwrap_or(straight);
        Corner { at, speed }
    }

    fn is_known(&self, corner: Corner) -> bool {
        let there = self.bins.get(&bin(corner.at, self.size));
        there.is_some_and(|there| there.contains(&corner))
    }

    /// Whether a jump passes between two positions.
    fn is_parted(&self, one: Position, other: Position) -> bool {
        let side = |[p, q]: [Position; 2], at: Position| {
            (q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]) > 0.0
        };
        self.jumps.iter().any(|&[p, q]| {
            side([p, q], one) != side([p, q], other)
                && side([one, other], p) != side([one, other], q)
        })
    }

    /// The quadratic through the places around one, there; `None` where too few are near.
    fn fitted(&self, at: Position) -> Option<f64> {
        let near = self.nearest(at);
        if near.len() < NEAREST {
            return None;
        }
        let mut matrix = [[0.0; COEFFICIENTS]; COEFFICIENTS];
        let mut right = [0.0; COEFFICIENTS];
        for (square, corner) in near {
            let [x, y] = self.offset(at, corner.at);
            let row = [1.0, x, y, x * x, x * y, y * y];
            let root = square.sqrt() + SOFTENED;
            let weight = 1.0 / (root * root * root * root);
            for i in 0..COEFFICIENTS {
                for j in 0..COEFFICIENTS {
                    matrix[i][j] += weight * row[i] * row[j];
                }
                right[i] += weight * row[i] * corner.speed;
            }
        }
        first_unknown(matrix, right)
    }

    /// The nearest known places, with the squares of their distances in bins.
    fn nearest(&self, at: Position) -> Vec<(f64, Corner)> {
        let [i, j] = bin(at, self.size);
        let mut near: Vec<(f64, Corner)> = Vec::new();
        for row in i.saturating_sub(BINS)..=i + BINS {
            for column in j.saturating_sub(BINS)..=j + BINS {
                let corners = self.bins.get(&[row, column]).into_iter().flatten();
                near.extend(corners.map(|corner| {
                    let [x, y] = self.offset(at, corner.at);
                    (x * x + y * y, *corner)
                }));
            }
        }
        let order = |(square, corner): &(f64, Corner)| (*square, corner.at);
        near.sort_by(|a, b| {
            let (a, b) = (order(a), order(b));
            a.partial_cmp(&b).unwrap_or(std::cmp::Ordering::Equal)
        });
        let near = near.into_iter();
        near.filter(|(_, corner)| !self.is_parted(at, corner.at))
            .take(NEAREST)
            .collect()
    }

    fn offset(&self, from: Position, to: Position) -> [f64; 2] {
        [0, 1].map(|axis| (to[axis] - from[axis]) / self.size[axis])
    }
}

fn bin(at: Position, size: [f64; 2]) -> [usize; 2] {
    [0, 1].map(|axis| (at[axis] / size[axis]) as usize)
}

/// The first unknown of symmetric, positive definite equations, by elimination from the last; `None` of any others.
fn first_unknown(
    mut matrix: [[f64; COEFFICIENTS]; COEFFICIENTS],
    mut right: [f64; COEFFICIENTS],
) -> Option<f64> {
    let diagonal = [0, 1, 2, 3, 4, 5].map(|index: usize| matrix[index][index]);
    for pivot in (0..COEFFICIENTS).rev() {
        let whole = matrix[pivot][pivot];
        // Not so where it is not a number.
        let is_definite = whole > DEFINITE * diagonal[pivot];
        if !is_definite {
            return None;
        }
        let last = matrix[pivot];
        for row in 0..pivot {
            let part = matrix[row][pivot] / whole;
            for (cell, below) in matrix[row].iter_mut().zip(last).take(pivot) {
                *cell -= part * below;
            }
            right[row] -= part * right[pivot];
        }
    }
    Some(right[0] / matrix[0][0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(at: Position) -> Corner {
        let [x, y] = at;
        let speed = 11.0 + 0.3 * x - 0.2 * y + 0.02 * x * x + 0.01 * x * y - 0.03 * y * y;
        Corner { at, speed }
    }

    fn surface(rows: usize) -> CurvedSurface {
        let places =
            (0..rows * 5).map(|index| [4.0 * (index / 5) as f64, 4.0 * (index % 5) as f64]);
        CurvedSurface::new(places.map(corner), Vec::new(), [8, 8])
    }

    #[test]
    fn what_lies_beyond_a_jump_counts_for_nothing() {
        let beyond = |at: Position| at[0] > 13.0;
        let stepped = |at: Position| {
            let step = if beyond(at) { 3.0 } else { 0.0 };
            let Corner { at, speed } = corner(at);
            Corner {
                at,
                speed: speed + step,
            }
        };
        let places = (0..30).map(|index| [4.0 * (index / 5) as f64, 4.0 * (index % 5) as f64]);
        let jump = vec![[[13.0, -1.0], [13.0, 8.5]], [[13.0, 8.5], [13.0, 30.0]]];
        let curved = CurvedSurface::new(places.map(stepped), jump, [8, 8]);
        let lifted = curved.between(corner([8.0, 8.0]), corner([12.0, 8.0]));
        let expected = corner([10.0, 8.0]);
        assert!((lifted.speed - expected.speed).abs() < 1e-9, "{lifted:?}");
    }

    #[test]
    fn a_quadratic_is_followed_between_places_and_few_places_are_joined_by_lines() {
        let ends = [corner([4.0, 8.0]), corner([8.0, 8.0])];
        let expected = corner([6.0, 8.0]);
        let lifted = surface(5).between(ends[0], ends[1]);
        assert!((lifted.speed - expected.speed).abs() < 1e-9, "{lifted:?}");
        let straight = surface(2).between(ends[0], ends[1]);
        assert_eq!(straight.speed, 0.5 * (ends[0].speed + ends[1].speed));
        assert_eq!(surface(5).between(ends[1], ends[0]), lifted);
    }
}
