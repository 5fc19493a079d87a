//! A map as a regular table: the surface and its estimated error at even steps.

use crate::maps::cell::Position;
use crate::maps::pieces::speed_within;
use crate::maps::surface_pieces::MapSurface;

/// A place of the regular table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resampled {
    /// Coordinates along the two refined axes.
    pub at: [f64; 2],
    /// First transition, ft/s; `None` without one.
    pub speed: Option<f64>,
    /// Estimated error of interpolation, ft/s, if known.
    pub error: Option<f64>,
}

impl MapSurface<'_> {
    /// Samples the surface at even steps, row by row of the slower axis.
    pub fn resampled(&self) -> Vec<Resampled> {
        let steps = self.grid.rules.grid_steps;
        let counts = self.grid.cells().map(|cells| cells * steps + 1);
        let parts = self.grid.parts();
        let at = |index: [usize; 2]| -> Position {
            [0, 1].map(|axis| index[axis] as f64 * parts[axis] as f64 / steps as f64)
        };
        let mut found: Vec<(Option<f64>, Option<f64>)> = vec![(None, None); counts[0] * counts[1]];
        // Rows or columns between two bounds in steps of places.
        let range = |axis: usize, low: f64, high: f64| {
            let scale = steps as f64 / parts[axis] as f64;
            let first = (low * scale - 1e-9).ceil().max(0.0) as usize;
            let last = ((high * scale + 1e-9).floor() as usize).min(counts[axis] - 1);
            first..=last
        };
        for part in &self.parts {
            let cell = &part.cell;
            let ends = |axis: usize| {
                let low = cell.low[axis] as f64;
                (low, low + cell.size[axis] as f64)
            };
            let [rows, columns] = [0, 1].map(|axis| range(axis, ends(axis).0, ends(axis).1));
            for row in rows {
                for column in columns.clone() {
                    found[row * counts[1] + column].1 = part.error;
                }
            }
            for corners in self.triangles_of(part) {
                let bound = |axis: usize| {
                    let all = corners.map(|corner| corner.at[axis]);
                    range(
                        axis,
                        all.into_iter().fold(f64::INFINITY, f64::min),
                        all.into_iter().fold(0.0, f64::max),
                    )
                };
                for row in bound(0) {
                    for column in bound(1) {
                        if let Some(speed) = speed_within(&corners, at([row, column])) {
                            found[row * counts[1] + column].0 = Some(speed);
                        }
                    }
                }
            }
        }
        let place = |(index, (speed, error)): (usize, (Option<f64>, Option<f64>))| Resampled {
            at: self.coordinates(at([index / counts[1], index % counts[1]])),
            speed,
            error,
        };
        found.into_iter().enumerate().map(place).collect()
    }
}
