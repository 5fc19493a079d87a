//! The points of a sweep: a grid, a sample, or the places of a map.

use crate::points::distribution::Distribution;
use crate::points::grid::Grid;
use crate::points::levels::Levels;
use crate::points::refined_grid::RefinedGrid;
use crate::points::sample::{Sample, SampledAxis};

/// Arrangement of the points of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub enum Design {
    /// The outer product of axes.
    Grid(Grid),
    /// Drawn from distributions.
    Sample(Sample),
    /// Chosen among the places of a map from earlier results.
    Map(RefinedGrid),
}

/// Points of a sample checked before a run.
const MOST_PROBES: usize = 1000;

impl Design {
    /// Number of points, at least one; for a map, of all possible places.
    pub fn count(&self) -> usize {
        match self {
            Self::Grid(grid) => grid.count(),
            Self::Sample(sample) => sample.count(),
            Self::Map(map) => map.count(),
        }
    }

    /// True of a sample whose first points are the same for any number of points.
    pub fn is_nested(&self) -> bool {
        matches!(self, Self::Sample(sample) if sample.design().is_nested())
    }

    /// Coordinates of the `index`-th point, from 0, one for each axis.
    pub fn coordinates(&self, index: usize) -> Vec<f64> {
        match self {
            Self::Grid(grid) => grid.coordinates(index),
            Self::Sample(sample) => sample.coordinates(index),
            Self::Map(map) => map.coordinates(index),
        }
    }

    /// True if the values of an axis, from 0, were given or are distributed with `spacing = "log"`.
    pub fn is_logarithmic(&self, axis: usize) -> bool {
        let has_one_ratio = |grid: &Grid| matches!(grid.axes()[axis], Levels::Logarithmic { .. });
        match self {
            Self::Grid(grid) => has_one_ratio(grid),
            Self::Map(map) => has_one_ratio(map.first_level()),
            Self::Sample(sample) => matches!(
                sample.axes()[axis],
                SampledAxis::Single {
                    distribution: Distribution::LogUniform { .. },
                    ..
                }
            ),
        }
    }

    /// Coordinates to check before a run: values and corners of a grid ([`Grid::probes`]), the first points of a
    /// sample, or probes of the first level of a map.
    pub fn probes(&self) -> Vec<Vec<f64>> {
        match self {
            Self::Grid(grid) => grid.probes(),
            Self::Map(map) => map.first_level().probes(),
            Self::Sample(sample) => {
                let first = 0..sample.count().min(MOST_PROBES);
                first.map(|index| sample.coordinates(index)).collect()
            }
        }
    }
}
