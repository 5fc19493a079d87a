//! The outer product of axes, the first varying slowest; axes of one group move together.
//!
//! A grid is never stored in full: the coordinates of a point follow from its index.

use crate::points::levels::Levels;

/// Axes that span a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    axes: Vec<Levels>,
    /// Axes that move together, as indices, slowest first.
    dimensions: Vec<Vec<usize>>,
    count: usize,
}

/// Most points of a sweep: each completed point takes one bit.
pub const MOST_POINTS: usize = 1_000_000_000;

/// Reasons why axes span no grid.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum GridFault {
    /// There are no axes.
    Empty,
    /// More points than [`MOST_POINTS`].
    TooMany,
    /// Two axes (by index) move together but have different numbers of values.
    Uneven([usize; 2]),
}

impl Grid {
    /// Builds the grid over axes, each with the name of its group, if any. A group varies at the place of its first
    /// axis.
    ///
    /// # Errors
    /// See [`GridFault`].
    pub fn new(axes: Vec<(Levels, Option<String>)>) -> Result<Self, GridFault> {
        let (axes, groups): (Vec<Levels>, Vec<Option<String>>) = axes.into_iter().unzip();
        let mut dimensions: Vec<Vec<usize>> = Vec::new();
        for (index, group) in groups.iter().enumerate() {
            let same =
                |dimension: &&mut Vec<usize>| group.is_some() && groups[dimension[0]] == *group;
            match dimensions.iter_mut().find(same) {
                Some(together) if axes[together[0]].count() == axes[index].count() => {
                    together.push(index);
                }
                Some(together) => return Err(GridFault::Uneven([together[0], index])),
                None => dimensions.push(vec![index]),
            }
        }
        let count = dimensions
            .iter()
            .try_fold(1usize, |count, together| {
                count.checked_mul(axes[together[0]].count())
            })
            .filter(|count| *count <= MOST_POINTS)
            .ok_or(GridFault::TooMany)?;
        if axes.is_empty() {
            return Err(GridFault::Empty);
        }
        Ok(Self {
            axes,
            dimensions,
            count,
        })
    }

    /// The axes, in the given order.
    pub fn axes(&self) -> &[Levels] {
        &self.axes
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Dimensions, slowest first: each a group of axes, as indices, that move together.
    pub fn dimensions(&self) -> &[Vec<usize>] {
        &self.dimensions
    }

    /// Coordinates of the `index`-th point, from 0, one for each axis.
    pub fn coordinates(&self, index: usize) -> Vec<f64> {
        let mut rest = index;
        let mut coordinates = vec![0.0; self.axes.len()];
        for together in self.dimensions.iter().rev() {
            let count = self.axes[together[0]].count();
            for &axis in together {
                coordinates[axis] = self.axes[axis].value(rest % count);
            }
            rest /= count;
        }
        coordinates
    }

    /// Coordinates that show every value of every axis, with the others at their first, and every corner. Long axes and
    /// grids of many dimensions are thinned evenly.
    pub fn probes(&self) -> Vec<Vec<f64>> {
        const MOST_VALUES: usize = 1000;
        const MOST_DIMENSIONS: u32 = 10;
        let mut probes = Vec::new();
        let at = |choice: &dyn Fn(usize, usize) -> usize| {
            let mut coordinates = vec![0.0; self.axes.len()];
            for (dimension, together) in self.dimensions.iter().enumerate() {
                for &axis in together {
                    let levels = &self.axes[axis];
                    coordinates[axis] = levels.value(choice(dimension, levels.count()));
                }
            }
            coordinates
        };
        for (varied, together) in self.dimensions.iter().enumerate() {
            let count = self.axes[together[0]].count();
            let shown = count.min(MOST_VALUES);
            for value in 0..shown {
                // The last probe is the last value.
                let index = value * (count - 1) / shown.max(2).saturating_sub(1);
                probes.push(at(&|dimension, _| {
                    if dimension == varied { index } else { 0 }
                }));
            }
        }
        let corners = 1usize << (self.dimensions.len() as u32).min(MOST_DIMENSIONS);
        for corner in 0..corners {
            probes.push(at(&|dimension, count| {
                let high = corner.checked_shr(dimension as u32).unwrap_or(0) & 1 == 1;
                if high { count - 1 } else { 0 }
            }));
        }
        probes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(values: &[f64]) -> Levels {
        Levels::list(values.to_vec()).unwrap()
    }

    fn points(grid: &Grid) -> Vec<Vec<f64>> {
        (0..grid.count()).map(|i| grid.coordinates(i)).collect()
    }

    #[test]
    fn first_axis_is_slowest() {
        let fast = Levels::range(0.0, 2.0, 1.0).unwrap();
        let grid = Grid::new(vec![(list(&[180.0, 170.0]), None), (fast, None)]).unwrap();
        let points = points(&grid);
        assert_eq!(points[1], [180.0, 1.0]);
        assert_eq!(points[3], [170.0, 0.0]);
        assert_eq!(points.len(), 6);
    }

    #[test]
    fn axes_of_one_group_move_together_where_the_first_of_them_stands() {
        let group = || Some("size".to_owned());
        let grid = Grid::new(vec![
            (list(&[18.0, 22.0]), group()),
            (list(&[0.0, 5.0]), None),
            (list(&[1.0, 2.0]), group()),
        ])
        .unwrap();
        assert_eq!(
            points(&grid),
            [
                [18.0, 0.0, 1.0],
                [18.0, 5.0, 1.0],
                [22.0, 0.0, 2.0],
                [22.0, 5.0, 2.0]
            ]
        );
        let uneven = vec![(list(&[1.0]), group()), (list(&[1.0, 2.0]), group())];
        assert_eq!(Grid::new(uneven), Err(GridFault::Uneven([0, 1])));
    }

    #[test]
    fn empty_and_endless_grids_are_faults() {
        assert_eq!(Grid::new(vec![]), Err(GridFault::Empty));
        let wide = (Levels::range(0.0, 9e6, 1.0).unwrap(), None);
        let wide = |count: usize| Grid::new(vec![wide.clone(); count]);
        assert!(wide(1).is_ok());
        assert_eq!(wide(2), Err(GridFault::TooMany));
        assert_eq!(wide(3), Err(GridFault::TooMany));
    }

    #[test]
    fn probes_show_every_value_and_every_corner() {
        let grid = Grid::new(vec![
            (list(&[1.0, 2.0, 3.0]), None),
            (list(&[4.0, 5.0]), None),
        ])
        .unwrap();
        let probes = grid.probes();
        for point in [[2.0, 4.0], [3.0, 4.0], [1.0, 5.0], [3.0, 5.0]] {
            assert!(probes.contains(&point.to_vec()), "{point:?}");
        }
        let long = Grid::new(vec![(Levels::range(0.0, 1e6, 1.0).unwrap(), None)]).unwrap();
        let probes = long.probes();
        assert_eq!(probes.len(), 1002);
        assert_eq!((probes[0][0], probes[999][0]), (0.0, 1e6));
    }
}
