//! The first transition over a grid of two conditions, with its gaps and jumps.

use std::collections::HashSet;

use crate::boundary_table::{BoundaryTable, Kind, Transition};
use crate::legend::Mark;
use crate::palette;
use crate::ticks::round_step;

/// Part of the whole range below which a difference between neighbours is never a jump.
const LEAST_JUMP: f64 = 0.125;
/// A jump exceeds the upper quartile of all differences by more than this many interquartile ranges:
/// the outer fence of Tukey's box plot.
const FENCE: f64 = 3.0;

/// First transition velocities over a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Names of the slow and of the fast axis.
    pub axes: [String; 2],
    /// Values of the slow axis, increasing.
    pub slow: Vec<f64>,
    /// Values of the fast axis, increasing.
    pub fast: Vec<f64>,
    /// Velocities, one row for each value of the slow axis; `None` without a transition.
    pub speeds: Vec<Vec<Option<f64>>>,
    /// Points whose transition is no boundary between stable landings and others: landings there cannot be computed or
    /// are undecided, those at the lowest speed searched are not stable, or stable landings and others alternate above it.
    pub doubtful: Vec<([f64; 2], Mark)>,
    /// Difference above which the transitions of neighbours belong to different kinds of motion: the boundary jumps
    /// between them, and nothing between them is known.
    pub jump: f64,
}

/// A cell of the grid between four neighbouring points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cell {
    /// Its corners, in the order (slow, fast), (slow, fast + 1), (slow + 1, fast + 1),
    /// (slow + 1, fast): the boundary may be interpolated.
    Whole([f64; 4]),
    /// The boundary jumps between its corners.
    Jump,
    /// At least one corner has no transition.
    Open,
}

impl Surface {
    /// Takes the points of a table over two axes whose slow coordinate `within` accepts. `None` if the table has
    /// another number of axes, or does not fill a grid of at least 2 by 2.
    pub fn of(table: &BoundaryTable, within: impl Fn(f64) -> bool) -> Option<Self> {
        let [slow_name, fast_name] = table.axes.as_slice() else {
            return None;
        };
        let points: Vec<([f64; 2], Option<Transition>)> = table
            .points
            .iter()
            .filter_map(|point| match point.coordinates[..] {
                [slow, fast] if within(slow) => Some(([slow, fast], point.transition)),
                _ => None,
            })
            .collect();
        let values = |axis: usize| {
            let mut values: Vec<f64> = points.iter().map(|(place, _)| place[axis]).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            values
        };
        let (slow, fast) = (values(0), values(1));
        if slow.len() < 2 || fast.len() < 2 || slow.len() * fast.len() != points.len() {
            return None;
        }
        let mut speeds = vec![vec![None; fast.len()]; slow.len()];
        for &([a, b], found) in &points {
            let row = slow.partition_point(|value| *value < a);
            let column = fast.partition_point(|value| *value < b);
            speeds[row][column] = found.map(|found| found.speed);
        }
        let doubtful = points.iter();
        let doubtful = doubtful.filter_map(|(place, found)| Some((*place, doubt((*found)?)?)));
        Some(Self {
            axes: [slow_name.clone(), fast_name.clone()],
            doubtful: doubtful.collect(),
            jump: jump(&speeds),
            slow,
            fast,
            speeds,
        })
    }

    /// The cell above a point of the grid.
    pub fn cell(&self, row: usize, column: usize) -> Cell {
        let at = |r: usize, c: usize| self.speeds[r][c];
        let corners = [
            at(row, column),
            at(row, column + 1),
            at(row + 1, column + 1),
            at(row + 1, column),
        ];
        let [Some(a), Some(b), Some(c), Some(d)] = corners else {
            return Cell::Open;
        };
        let is_jump = [(a, b), (b, c), (c, d), (d, a)]
            .into_iter()
            .any(|(one, other)| (one - other).abs() > self.jump);
        if is_jump {
            Cell::Jump
        } else {
            Cell::Whole([a, b, c, d])
        }
    }

    /// All cells with their place: row and column of their lower corner.
    pub fn cells(&self) -> impl Iterator<Item = ([usize; 2], Cell)> {
        let rows = 0..self.slow.len() - 1;
        let columns = self.fast.len() - 1;
        rows.flat_map(move |row| {
            (0..columns).map(move |column| ([row, column], self.cell(row, column)))
        })
    }

    /// Bars across the grid edges over which the boundary jumps. Their ends lie half-way to the next rows or columns.
    pub fn jump_bars(&self) -> Vec<[[f64; 2]; 2]> {
        let (s, f) = (&self.slow, &self.fast);
        let half = |values: &[f64], index: usize| {
            let below = values[index.saturating_sub(1)];
            let above = values[(index + 1).min(values.len() - 1)];
            [0.5 * (values[index] + below), 0.5 * (values[index] + above)]
        };
        let index = |values: &[f64], value: f64| values.partition_point(|known| *known < value);
        let bar = |([s0, f0], _): ([f64; 2], f64), ([s1, f1], _): ([f64; 2], f64)| {
            if s0 == s1 {
                half(s, index(s, s0)).map(|slow| [slow, 0.5 * (f0 + f1)])
            } else {
                half(f, index(f, f0)).map(|fast| [0.5 * (s0 + s1), fast])
            }
        };
        let edges = self.jump_edges().into_iter();
        edges.map(|[a, b]| bar(a, b)).collect()
    }

    /// Neighbours along either axis between which the boundary jumps: their places and heights.
    pub fn jump_edges(&self) -> Vec<[([f64; 2], f64); 2]> {
        let at = |r: usize, c: usize| Some(([self.slow[r], self.fast[c]], self.speeds[r][c]?));
        let mut edges = Vec::new();
        for r in 0..self.slow.len() {
            for c in 0..self.fast.len() {
                let next = [(r, c + 1), (r + 1, c)];
                for (row, column) in next {
                    if row < self.slow.len()
                        && column < self.fast.len()
                        && let (Some(a), Some(b)) = (at(r, c), at(row, column))
                        && (a.1 - b.1).abs() > self.jump
                    {
                        edges.push([a, b]);
                    }
                }
            }
        }
        edges
    }

    /// Lowest and highest transition, if there is any.
    pub fn range(&self) -> Option<(f64, f64)> {
        let least = self.heights().reduce(f64::min)?;
        Some((least, self.heights().reduce(f64::max)?))
    }

    /// All transitions.
    pub fn heights(&self) -> impl Iterator<Item = f64> {
        self.speeds.iter().flatten().flatten().copied()
    }

    /// Places and heights of points with a transition but without a whole cell beside them: no surface shows them.
    pub fn lone(&self) -> Vec<([f64; 2], f64)> {
        let whole: HashSet<[usize; 2]> = (self.cells())
            .filter(|(_, cell)| matches!(cell, Cell::Whole(_)))
            .flat_map(|([row, column], _)| {
                [[0, 0], [0, 1], [1, 0], [1, 1]].map(|[down, right]| [row + down, column + right])
            })
            .collect();
        let rows = self.speeds.iter().enumerate();
        let points = rows.flat_map(|(row, speeds)| {
            let columns = speeds.iter().enumerate();
            columns.filter_map(move |(column, speed)| Some(([row, column], (*speed)?)))
        });
        points
            .filter(|(point, _)| !whole.contains(point))
            .map(|([row, column], speed)| ([self.slow[row], self.fast[column]], speed))
            .collect()
    }

    /// Places of the points without a transition.
    pub fn gaps(&self) -> impl Iterator<Item = [f64; 2]> {
        let rows = self.slow.iter().zip(&self.speeds);
        rows.flat_map(|(slow, row)| {
            let points = self.fast.iter().zip(row);
            points.filter_map(|(fast, speed)| speed.is_none().then_some([*slow, *fast]))
        })
    }

    /// For each value of the slow axis, the fast one with the lowest transition.
    pub fn lowest_in_rows(&self) -> Vec<[f64; 2]> {
        let lowest = |row: &Vec<Option<f64>>| {
            let with_speed = row.iter().zip(&self.fast);
            with_speed
                .filter_map(|(speed, fast)| Some((speed.as_ref()?, *fast)))
                .min_by(|(a, _), (b, _)| a.total_cmp(b))
                .map(|(_, fast)| fast)
        };
        let rows = self.slow.iter().zip(&self.speeds);
        rows.filter_map(|(slow, row)| Some([*slow, lowest(row)?]))
            .collect()
    }
}

/// The mark of a transition that is no boundary between stable landings and others, or a patchy one.
fn doubt(found: Transition) -> Option<Mark> {
    match found {
        Transition {
            kind, low: None, ..
        } => Some(Mark::AtOrBelow(kind)),
        Transition {
            kind: kind @ (Kind::Failure | Kind::Undecided),
            ..
        } => Some(Mark::Transition(kind)),
        Transition {
            patchy_to: Some(_), ..
        } => Some(Mark::Ring(palette::PATCHY)),
        _ => None,
    }
}

/// Difference between neighbours above which the boundary jumps: far more than most neighbours differ, and a good part
/// of the whole range; a round number.
fn jump(speeds: &[Vec<Option<f64>>]) -> f64 {
    let along = |row: &[Option<f64>], next: &[Option<f64>]| -> Vec<f64> {
        let pairs = row.iter().zip(next);
        pairs
            .filter_map(|(a, b)| Some(((*a)? - (*b)?).abs()))
            .collect()
    };
    let fast = speeds.iter().flat_map(|row| along(row, &row[1..]));
    let slow = speeds.windows(2).flat_map(|rows| along(&rows[0], &rows[1]));
    let mut differences: Vec<f64> = fast.chain(slow).collect();
    differences.sort_by(f64::total_cmp);
    let quartile = |quarters: usize| {
        let index = quarters * differences.len().saturating_sub(1) / 4;
        differences.get(index).copied().unwrap_or(0.0)
    };
    let fence = quartile(3) + FENCE * (quartile(3) - quartile(1));
    let heights = || speeds.iter().flatten().flatten().copied();
    let range = heights().fold(0.0, f64::max) - heights().fold(f64::INFINITY, f64::min);
    // Nearly equal differences are no jumps.
    round_step(1.01 * fence.max(LEAST_JUMP * range))
}

#[cfg(test)]
#[path = "surface_tests.rs"]
pub(crate) mod tests;
