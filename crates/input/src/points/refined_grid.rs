//! The places of a map: a grid of one or two axes (or a family of such grids) whose cells are subdivided.
//!
//! The given values of the axes are the first level. Each interval of the refined axes is divided into a power of two
//! of equal parts. Every place where such parts meet has a number, whether or not it is ever computed.

use crate::points::grid::Grid;
use crate::points::levels::Levels;

/// Refinement criteria of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapRules {
    /// Greatest interpolation error sought, ft/s; 0 if only the budget ends the refinement.
    pub error: f64,
    /// Least difference of first transitions across an edge width that makes an edge, ft/s.
    pub jump: f64,
    /// Number of landings after which refinement ends.
    pub budget: Option<u64>,
    /// Steps of the resampled table along each side of a first-level cell.
    pub grid_steps: usize,
}

/// All places of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct RefinedGrid {
    first_level: Grid,
    places: Grid,
    /// Index of each refined axis.
    axes: Vec<usize>,
    /// Parts per interval of each refined axis; 1 for an absent second axis.
    parts: [usize; 2],
    /// Number of places along each dimension, and the stride of the place numbers along it.
    dimensions: Vec<[usize; 2]>,
    /// Dimension of each refined axis.
    refined: Vec<usize>,
    /// Criteria of refinement.
    pub rules: MapRules,
}

/// A place of a map in steps of the finest division along the refined axes; 0 along an absent axis.
pub type Place = [usize; 2];

impl RefinedGrid {
    /// Divides the intervals of one or two axes of a grid, each not zipped with others, into a power of two of parts
    /// each; `None` if there are more than 2^26 places.
    pub fn new(first_level: Grid, refined: &[(usize, usize)], rules: MapRules) -> Option<Self> {
        const MOST_PLACES: usize = 1 << 26;
        let mut divided: Vec<(Levels, Option<String>)> = Vec::new();
        for (index, levels) in first_level.axes().iter().enumerate() {
            let levels = match refined.iter().find(|(axis, _)| *axis == index) {
                Some((_, parts)) => levels.divided(*parts, MOST_PLACES)?,
                None => levels.clone(),
            };
            let together = |dimension: &&Vec<usize>| dimension.contains(&index);
            let dimension = first_level.dimensions().iter().find(together)?;
            let group = (dimension.len() > 1).then(|| dimension[0].to_string());
            divided.push((levels, group));
        }
        let places = Grid::new(divided).ok()?;
        if places.count() > MOST_PLACES {
            return None;
        }
        let mut dimensions = Vec::new();
        let mut stride = places.count();
        for dimension in places.dimensions() {
            let count = places.axes()[dimension[0]].count();
            stride /= count;
            dimensions.push([count, stride]);
        }
        let dimension = |axis: usize| {
            let found = places.dimensions().iter();
            found.into_iter().position(|together| *together == [axis])
        };
        let axes: Vec<usize> = refined.iter().map(|(axis, _)| *axis).collect();
        let mut parts = [1, 1];
        for (known, (_, divided)) in parts.iter_mut().zip(refined) {
            *known = *divided;
        }
        let found: Option<Vec<usize>> = axes.iter().map(|axis| dimension(*axis)).collect();
        let refined = found?;
        Some(Self {
            first_level,
            places,
            axes,
            parts,
            dimensions,
            refined,
            rules,
        })
    }

    /// The grid of the first level.
    pub fn first_level(&self) -> &Grid {
        &self.first_level
    }

    /// Indices of the refined axes, the slower first.
    pub fn axes(&self) -> &[usize] {
        &self.axes
    }

    /// Parts per first-level interval of each refined axis; 1 for an absent axis.
    pub fn parts(&self) -> [usize; 2] {
        self.parts
    }

    /// Number of places, computed or not.
    pub fn count(&self) -> usize {
        self.places.count()
    }

    /// Coordinates of the place with a number, one for each axis.
    pub fn coordinates(&self, number: usize) -> Vec<f64> {
        self.places.coordinates(number)
    }

    /// Number of maps: one for each combination of values of the unrefined axes.
    pub fn maps(&self) -> usize {
        let places = self
            .refined
            .iter()
            .map(|dimension| self.dimensions[*dimension][0]);
        self.count() / places.product::<usize>()
    }

    /// Number of first-level cells of a map along each refined axis; 1 along an absent axis.
    pub fn cells(&self) -> [usize; 2] {
        [0, 1].map(|axis: usize| match self.refined.get(axis) {
            Some(dimension) => (self.dimensions[*dimension][0] - 1) / self.parts[axis],
            None => 1,
        })
    }

    /// The number of a place of a map.
    pub fn number(&self, map: usize, place: Place) -> usize {
        let mut rest = map;
        let mut number = 0;
        for (dimension, [count, stride]) in self.dimensions.iter().enumerate().rev() {
            let refined = self.refined.iter().position(|known| *known == dimension);
            let index = match refined {
                Some(axis) => place[axis],
                None => {
                    let index = rest % count;
                    rest /= count;
                    index
                }
            };
            number += index * stride;
        }
        number
    }

    /// The place that a number has in its map.
    pub fn place(&self, number: usize) -> Place {
        [0, 1].map(|axis: usize| match self.refined.get(axis) {
            Some(dimension) => {
                let [count, stride] = self.dimensions[*dimension];
                number / stride % count
            }
            None => 0,
        })
    }

    /// The map that the place with a number belongs to.
    pub fn map_of(&self, number: usize) -> usize {
        let others = self.dimensions.iter().enumerate();
        let others = others.filter(|(dimension, _)| !self.refined.contains(dimension));
        others.fold(0, |map, (_, [count, stride])| {
            map * count + number / stride % count
        })
    }

    /// Number of halvings of a first-level cell until the place is a corner.
    pub fn level(&self, number: usize) -> usize {
        let place = self.place(number);
        let halvings = |axis: usize| {
            let parts = self.parts[axis];
            let common = (place[axis] % parts).trailing_zeros();
            (parts.trailing_zeros()).saturating_sub(common) as usize
        };
        halvings(0).max(halvings(1))
    }

    /// Value of a refined axis at a position in steps, which may lie between places.
    pub fn value(&self, axis: usize, position: f64) -> f64 {
        let levels = &self.places.axes()[self.axes[axis]];
        let last = levels.count() - 1;
        let below = (position.max(0.0) as usize).min(last);
        let above = (below + 1).min(last);
        let part = position - below as f64;
        let (low, high) = (levels.value(below), levels.value(above));
        match part == 0.0 {
            true => low,
            false => low + part * (high - low),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULES: MapRules = MapRules {
        error: 0.1,
        jump: 0.2,
        budget: None,
        grid_steps: 4,
    };

    fn map() -> RefinedGrid {
        let list = |values: &[f64]| Levels::list(values.to_vec()).unwrap();
        let group = || Some("size".to_owned());
        let axes = vec![
            (list(&[1.0, 2.0]), group()),
            (list(&[0.0, 1.0, 3.0]), None),
            (list(&[5.0, 6.0]), group()),
            (list(&[10.0, 30.0]), None),
        ];
        RefinedGrid::new(Grid::new(axes).unwrap(), &[(1, 4), (3, 2)], RULES).unwrap()
    }

    #[test]
    fn every_place_has_a_number_and_its_coordinates() {
        let map = map();
        assert_eq!((map.count(), map.maps(), map.cells()), (54, 2, [2, 1]));
        let number = map.number(1, [6, 1]);
        assert_eq!(map.coordinates(number), [2.0, 2.0, 6.0, 20.0]);
        assert_eq!((map.map_of(number), map.place(number)), (1, [6, 1]));
        assert_eq!(map.value(0, 6.5), 2.25);
        let mut seen = vec![false; map.count()];
        for of in 0..2 {
            for slow in 0..9 {
                for fast in 0..3 {
                    seen[map.number(of, [slow, fast])] = true;
                }
            }
        }
        assert!(seen.iter().all(|seen| *seen));
    }

    #[test]
    fn the_level_of_a_place_counts_halvings() {
        let map = map();
        let level = |place| map.level(map.number(0, place));
        assert_eq!(level([0, 0]), 0);
        assert_eq!(level([4, 2]), 0);
        assert_eq!(level([2, 2]), 1);
        assert_eq!(level([4, 1]), 1);
        assert_eq!(level([3, 0]), 2);
    }

    #[test]
    fn a_map_over_one_axis_has_one_row_of_cells() {
        let list = |values: &[f64]| (Levels::list(values.to_vec()).unwrap(), None);
        let axes = vec![list(&[1.0, 2.0]), list(&[0.0, 1.0, 3.0])];
        let map = RefinedGrid::new(Grid::new(axes).unwrap(), &[(1, 4)], RULES).unwrap();
        assert_eq!((map.count(), map.maps(), map.cells()), (18, 2, [2, 1]));
        let number = map.number(1, [6, 0]);
        assert_eq!(map.coordinates(number), [2.0, 2.0]);
        assert_eq!((map.map_of(number), map.place(number)), (1, [6, 0]));
        assert_eq!((map.level(number), map.parts()), (1, [4, 1]));
    }

    #[test]
    fn too_many_places_are_none() {
        let fine = || Levels::range(0.0, 1000.0, 1.0).unwrap();
        let grid = Grid::new(vec![(fine(), None), (fine(), None)]).unwrap();
        assert_eq!(RefinedGrid::new(grid, &[(0, 64), (1, 64)], RULES), None);
    }
}
