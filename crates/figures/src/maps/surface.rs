//! The first transition over a grid of two conditions, with its gaps and jumps.

use crate::boundary_table::BoundaryTable;

/// Neighbours whose transitions differ by more, ft/s, belong to different kinds of motion: the
/// boundary jumps between them and nothing between them is known.
pub const JUMP: f64 = 2.5;

/// First transition velocities over a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Names of the slow and of the fast axis.
    pub axes: [String; 2],
    /// Values of the slow axis, increasing.
    pub slow: Vec<f64>,
    /// Values of the fast axis, increasing.
    pub fast: Vec<f64>,
    /// Velocities, ft/s, one row for each value of the slow axis; `None` without a transition.
    pub speeds: Vec<Vec<Option<f64>>>,
}

/// What is known of a cell of the grid between four neighbouring points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cell {
    /// Its corners, in the order (slow, fast), (slow, fast + 1), (slow + 1, fast + 1),
    /// (slow + 1, fast): the boundary may be interpolated.
    Whole([f64; 4]),
    /// The boundary jumps between its corners.
    Torn,
    /// At least one corner has no transition.
    Open,
}

impl Surface {
    /// Takes the points of a table over two axes whose slow coordinate `within` accepts; `None` when
    /// the table has another number of axes, or does not fill a grid of at least 2 by 2.
    pub fn of(table: &BoundaryTable, within: impl Fn(f64) -> bool) -> Option<Self> {
        let [slow_name, fast_name] = table.axes.as_slice() else {
            return None;
        };
        let points: Vec<([f64; 2], Option<f64>)> = table
            .points
            .iter()
            .filter_map(|point| match point.coordinates[..] {
                [slow, fast] if within(slow) => {
                    Some(([slow, fast], point.transition.map(|found| found.speed)))
                }
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
        for ([a, b], speed) in points {
            let row = slow.partition_point(|value| *value < a);
            let column = fast.partition_point(|value| *value < b);
            speeds[row][column] = speed;
        }
        Some(Self {
            axes: [slow_name.clone(), fast_name.clone()],
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
        let torn = [(a, b), (b, c), (c, d), (d, a)]
            .into_iter()
            .any(|(one, other)| (one - other).abs() > JUMP);
        if torn {
            Cell::Torn
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

    /// Bars across the edges of the grid over which the boundary jumps: their ends lie half-way to
    /// the next rows or columns.
    pub fn jumps(&self) -> Vec<[[f64; 2]; 2]> {
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
        let edges = self.torn_edges().into_iter();
        edges.map(|[a, b]| bar(a, b)).collect()
    }

    /// Neighbours along either axis between which the boundary jumps: their places and heights.
    pub fn torn_edges(&self) -> Vec<[([f64; 2], f64); 2]> {
        let at = |r: usize, c: usize| Some(([self.slow[r], self.fast[c]], self.speeds[r][c]?));
        let mut edges = Vec::new();
        for r in 0..self.slow.len() {
            for c in 0..self.fast.len() {
                let next = [(r, c + 1), (r + 1, c)];
                for (row, column) in next {
                    if row < self.slow.len()
                        && column < self.fast.len()
                        && let (Some(a), Some(b)) = (at(r, c), at(row, column))
                        && (a.1 - b.1).abs() > JUMP
                    {
                        edges.push([a, b]);
                    }
                }
            }
        }
        edges
    }

    /// Lowest and highest transition, ft/s, if there is any.
    pub fn range(&self) -> Option<(f64, f64)> {
        let speeds = || self.speeds.iter().flatten().flatten();
        let least = speeds().copied().reduce(f64::min)?;
        Some((least, speeds().copied().reduce(f64::max)?))
    }

    /// For each value of the slow axis the fast one with the lowest transition.
    pub fn valley(&self) -> Vec<[f64; 2]> {
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

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Three by four points, one without transition, one across a jump.
    pub(crate) const TABLE: &str = "\
cross_slope_deg,roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps
80,-30,unstable,12,12,12
80,-10,unstable,13,13,13
80,10,unstable,14,14,14
80,30,none,,,
130,-30,unstable,12,12,12
130,-10,unstable,11,11,11
130,10,unstable,13,13,13
130,30,unstable,20,20,20
180,-30,unstable,13,13,13
180,-10,unstable,12,12,12
180,10,unstable,11.5,11.5,11.5
180,30,unstable,20.5,20.5,20.5
";

    pub(crate) fn example() -> Surface {
        Surface::of(&BoundaryTable::parse(TABLE).unwrap(), |_| true).unwrap()
    }

    #[test]
    fn gaps_and_jumps_are_told_apart() {
        let surface = example();
        assert_eq!(surface.cell(0, 0), Cell::Whole([12.0, 13.0, 11.0, 12.0]));
        assert_eq!(surface.cell(0, 2), Cell::Open);
        assert_eq!(surface.cell(1, 2), Cell::Torn);
        assert_eq!(surface.cells().count(), 6);
        assert_eq!(surface.range(), Some((11.0, 20.5)));
    }

    #[test]
    fn jumps_are_bars_between_their_points() {
        let bars = example().jumps();
        assert_eq!(bars.len(), 2);
        assert_eq!(bars[0], [[105.0, 20.0], [155.0, 20.0]]);
        assert_eq!(bars[1], [[155.0, 20.0], [180.0, 20.0]]);
    }

    #[test]
    fn the_valley_is_the_lowest_of_each_row() {
        let lowest = [[80.0, -30.0], [130.0, -10.0], [180.0, 10.0]];
        assert_eq!(example().valley(), lowest);
    }

    #[test]
    fn what_fills_no_grid_is_no_surface() {
        let cut = TABLE.rsplit_once("180,30").unwrap().0;
        let table = BoundaryTable::parse(cut).unwrap();
        assert_eq!(Surface::of(&table, |_| true), None);
        assert_eq!(Surface::of(&table, |slow| slow < 100.0), None);
        assert!(Surface::of(&table, |slow| slow < 150.0).is_some());
    }
}
