//! A cell of a map: a rectangle of places.

use touchdown_input::points::refined_grid::Place;

/// A position on a map in steps of its places; it may lie between places.
pub(crate) type Position = [f64; 2];

/// The position of a place.
pub(crate) fn position(place: Place) -> Position {
    [place[0] as f64, place[1] as f64]
}

/// The place nearest to a position.
pub(crate) fn nearest(position: Position) -> Place {
    position.map(|step| step.round() as usize)
}

/// The position half-way between two others.
pub(crate) fn middle(a: Position, b: Position) -> Position {
    [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
}

/// A rectangle of places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Cell {
    /// The corner with the least coordinates.
    pub(crate) low: Place,
    /// Steps along both axes, powers of two.
    pub(crate) size: [usize; 2],
}

/// Steps of the smallest cells along each axis.
const LEAST_SIZE: usize = 4;

impl Cell {
    /// The corners, around the cell.
    pub(crate) fn corners(&self) -> [Place; 4] {
        let Self {
            low: [i, j],
            size: [di, dj],
        } = *self;
        [[i, j], [i, j + dj], [i + di, j + dj], [i + di, j]]
    }

    /// The ends of the sides, around the cell.
    pub(crate) fn sides(&self) -> [[Place; 2]; 4] {
        let [a, b, c, d] = self.corners();
        [[a, b], [b, c], [c, d], [d, a]]
    }

    /// Area in steps.
    pub(crate) fn area(&self) -> f64 {
        self.size[0] as f64 * self.size[1] as f64
    }

    pub(crate) fn centre(&self) -> Place {
        [0, 1].map(|axis| self.low[axis] + self.size[axis] / 2)
    }

    /// The middles of the sides, around the cell.
    pub(crate) fn side_middles(&self) -> [Place; 4] {
        self.sides().map(|[a, b]| half_way(a, b))
    }

    /// The four quarters; `None` if they would be too small.
    pub(crate) fn quarters(&self) -> Option<[Self; 4]> {
        let size = self.size.map(|steps| steps / 2);
        if size.iter().any(|steps| *steps < LEAST_SIZE) {
            return None;
        }
        let at = |i: usize, j: usize| Self {
            low: [self.low[0] + i * size[0], self.low[1] + j * size[1]],
            size,
        };
        Some([at(0, 0), at(0, 1), at(1, 1), at(1, 0)])
    }

    /// True if a place lies inside, not on a side.
    pub(crate) fn encloses(&self, place: Place) -> bool {
        (0..2).all(|axis| {
            let low = self.low[axis];
            (low + 1..low + self.size[axis]).contains(&place[axis])
        })
    }
}

/// The place half-way between two on one line.
pub(crate) fn half_way(a: Place, b: Place) -> Place {
    [0, 1].map(|axis| (a[axis] + b[axis]) / 2)
}

/// Steps between two places on one line.
pub(crate) fn steps(a: Place, b: Place) -> usize {
    a[0].abs_diff(b[0]) + a[1].abs_diff(b[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_cover_the_cell_until_they_are_too_small() {
        let cell = Cell {
            low: [8, 16],
            size: [8, 16],
        };
        let quarters = cell.quarters().unwrap();
        assert_eq!(quarters.iter().map(Cell::area).sum::<f64>(), cell.area());
        assert_eq!(quarters[2].corners()[2], cell.corners()[2]);
        assert_eq!(quarters[0].corners()[2], cell.centre());
        assert_eq!(quarters[0].quarters(), None);
        assert!(cell.encloses([9, 17]) && !cell.encloses([8, 20]));
    }
}
