//! First transitions between known places of a map, on a quadratic fitted to the surroundings.
//!
//! Planes between places are wrong by the curvature between them. So within each triangle of the surface the middles of
//! its sides are lifted to the quadratic that best fits the nearest known transitions, with nearer places weighted
//! more. The fit minimizes the sum of deviations, not of their squares: where a step too small for an edge separates
//! the places, it follows the side with most of them. Both triangles at a side lift its middle equally.

use std::collections::HashMap;

use nalgebra::{Matrix6, Vector6};

use crate::maps::cell::{Position, middle};
use crate::maps::pieces::Corner;

/// Greatest and least number of places in a fit; the least is twice the number of coefficients.
const NEAREST: usize = 16;
const LEAST: usize = 12;
/// Number of least-squares fits that approach least deviations, each weighted by the deviations of the last, and the
/// deviation below which all weigh the same, ft/s.
const FITS: usize = 5;
const DEVIATION: f64 = 0.02;
/// Bins searched to each side for such places.
const BINS: usize = 2;
/// Least remaining part of a diagonal element in the factorization of the normal equations.
const DEFINITE: f64 = 1e-9;
/// Least distance assumed of a place, in bins.
const SOFTENED: f64 = 0.06;

/// Number of halvings of a side, and the error of the surface at which a side is halved, ft/s.
const HALVINGS: usize = 2;
const OFF: f64 = 0.02;

/// A corner of a triangle.
#[derive(Debug, Clone, Copy)]
struct Vertex {
    corner: Corner,
    /// True if it is on one side of every edge, like known places and fits to them.
    is_beside_edges: bool,
}

/// A side of a triangle.
#[derive(Debug, Clone, Copy)]
struct Side {
    from: Vertex,
    /// Remaining halvings.
    halvings: usize,
}

/// Known transitions, sorted into bins.
#[derive(Debug)]
pub(crate) struct CurvedSurface {
    /// Steps of a bin along each axis: a first-level cell.
    size: [f64; 2],
    bins: HashMap<[usize; 2], Vec<Corner>>,
    /// Segments of the lines along which transitions jump.
    jumps: Vec<[Position; 2]>,
}

impl CurvedSurface {
    /// Builds the surface through transitions, split along lines; `cell` is the number of steps of a first-level cell.
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

    /// Divides a triangle by halving sides that are off the surface.
    pub(crate) fn triangles(&self, corners: [Corner; 3]) -> Vec<[Corner; 3]> {
        let mut triangles = Vec::new();
        let sides = corners.map(|corner| Side {
            from: Vertex {
                corner,
                is_beside_edges: self.is_known(corner),
            },
            halvings: HALVINGS,
        });
        self.divide(sides, &mut triangles);
        triangles
    }

    /// Halves the first eligible side. Both triangles at a side halve it equally.
    fn divide(&self, sides: [Side; 3], triangles: &mut Vec<[Corner; 3]>) {
        for first in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|next| sides[(first + next) % 3]);
            let Some(from) = self.off_side(a, b.from) else {
                continue;
            };
            let halvings = a.halvings - 1;
            let (half, across) = (Side { halvings, ..a }, Side { from, halvings });
            self.divide([half, across, c], triangles);
            self.divide([across, b, Side { halvings, ..c }], triangles);
            return;
        }
        triangles.push(sides.map(|side| side.from.corner));
    }

    /// The surface at the middle of a side, if the side may be halved and is off it.
    fn off_side(&self, Side { from: a, halvings }: Side, b: Vertex) -> Option<Vertex> {
        // The line between two points of an edge lies on neither side of it.
        if halvings == 0 || !(a.is_beside_edges || b.is_beside_edges) {
            return None;
        }
        // A fixed order, so that every bit is the same from either side.
        let (a, b) = match a.corner.at <= b.corner.at {
            true => (a.corner, b.corner),
            false => (b.corner, a.corner),
        };
        let at = middle(a.at, b.at);
        let speed = self.fitted(at)?;
        let is_off = (speed - 0.5 * (a.speed + b.speed)).abs() > OFF;
        is_off.then_some(Vertex {
            corner: Corner { at, speed },
            is_beside_edges: true,
        })
    }

    fn is_known(&self, corner: Corner) -> bool {
        let there = self.bins.get(&bin(corner.at, self.size));
        there.is_some_and(|there| there.contains(&corner))
    }

    /// True if a jump passes between two positions.
    fn is_parted(&self, one: Position, other: Position) -> bool {
        let side = |[p, q]: [Position; 2], at: Position| {
            (q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]) > 0.0
        };
        self.jumps.iter().any(|&[p, q]| {
            side([p, q], one) != side([p, q], other)
                && side([one, other], p) != side([one, other], q)
        })
    }

    /// Value at a position of the quadratic through the nearest places; `None` if too few are near.
    fn fitted(&self, at: Position) -> Option<f64> {
        let near = self.nearest(at);
        if near.len() < LEAST {
            return None;
        }
        let places: Vec<(Vector6<f64>, f64, f64)> = near
            .into_iter()
            .map(|(square, corner)| {
                let [x, y] = self.offset(at, corner.at);
                let root = square.sqrt() + SOFTENED;
                let terms = Vector6::new(1.0, x, y, x * x, x * y, y * y);
                (terms, corner.speed, 1.0 / (root * root * root * root))
            })
            .collect();
        let mut deviations = [DEVIATION; NEAREST];
        let mut quadratic = Vector6::zeros();
        for _ in 0..FITS {
            let (mut matrix, mut right) = (Matrix6::zeros(), Vector6::zeros());
            for ((terms, speed, nearness), deviation) in places.iter().zip(deviations) {
                let weight = nearness / deviation.max(DEVIATION);
                matrix.ger(weight, terms, terms, 1.0);
                right.axpy(weight * speed, terms, 1.0);
            }
            let factor = matrix.cholesky()?;
            let left = factor.l_dirty().diagonal();
            // False for NaN too.
            let is_definite = (0..6).all(|k| left[k] * left[k] > DEFINITE * matrix[(k, k)]);
            if !is_definite {
                return None;
            }
            quadratic = factor.solve(&right);
            for ((terms, speed, _), deviation) in places.iter().zip(&mut deviations) {
                *deviation = (terms.dot(&quadratic) - speed).abs();
            }
        }
        Some(quadratic[0])
    }

    /// The nearest known places, with squared distances in bins.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(at: Position) -> Corner {
        let [x, y] = at;
        let speed = 11.0 + 0.3 * x - 0.2 * y + 0.02 * x * x + 0.01 * x * y - 0.03 * y * y;
        Corner { at, speed }
    }

    /// The surface half-way between two known places.
    fn halfway(curved: &CurvedSurface, ends: [Corner; 2]) -> f64 {
        let [a, b] = ends.map(|corner| Vertex {
            corner,
            is_beside_edges: true,
        });
        let side = Side {
            from: a,
            halvings: 1,
        };
        let straight = 0.5 * (a.corner.speed + b.corner.speed);
        let off = curved.off_side(side, b);
        off.map_or(straight, |vertex| vertex.corner.speed)
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
        let lifted = halfway(&curved, [corner([8.0, 8.0]), corner([12.0, 8.0])]);
        let expected = corner([10.0, 8.0]).speed;
        assert!((lifted - expected).abs() < 1e-9, "{lifted}");
    }

    #[test]
    fn where_a_small_step_parts_the_places_most_of_them_count() {
        let stepped = |at: Position| Corner {
            at,
            speed: corner(at).speed + if at[0] > 15.0 { 0.3 } else { 0.0 },
        };
        let places = (0..30).map(|index| [4.0 * (index / 5) as f64, 4.0 * (index % 5) as f64]);
        let curved = CurvedSurface::new(places.map(stepped), Vec::new(), [8, 8]);
        let lifted = halfway(&curved, [corner([4.0, 8.0]), corner([8.0, 8.0])]);
        let off = lifted - corner([6.0, 8.0]).speed;
        assert!(off.abs() < 0.01, "{off}");
    }

    #[test]
    fn a_quadratic_is_followed_between_places_and_few_places_are_joined_by_lines() {
        let ends = [corner([4.0, 8.0]), corner([8.0, 8.0])];
        let expected = corner([6.0, 8.0]).speed;
        let lifted = halfway(&surface(5), ends);
        assert!((lifted - expected).abs() < 1e-9, "{lifted}");
        let straight = 0.5 * (ends[0].speed + ends[1].speed);
        assert_eq!(halfway(&surface(2), ends), straight);
        assert_eq!(halfway(&surface(5), [ends[1], ends[0]]), lifted);
    }

    #[test]
    fn neighbouring_triangles_halve_a_side_alike() {
        let curved = surface(7);
        let [a, b] = [corner([4.0, 8.0]), corner([12.0, 8.0])];
        let [left, right] = [corner([8.0, 16.0]), corner([8.0, 0.0])];
        // Speeds along the side, from end to end, of the triangles on either side of it.
        let along = |third: Corner| -> Vec<[f64; 2]> {
            let triangles = curved.triangles([a, b, third]).into_iter().flatten();
            let on_side = triangles.filter(|corner| corner.at[1] == 8.0);
            let mut on_side: Vec<_> = on_side.map(|corner| [corner.at[0], corner.speed]).collect();
            on_side.sort_by(|p, q| p[0].total_cmp(&q[0]));
            on_side.dedup();
            on_side
        };
        assert_eq!(along(left), along(right));
        assert_eq!(along(left).len(), 5);
    }
}
