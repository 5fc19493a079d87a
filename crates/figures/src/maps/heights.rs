//! What the maps of a family have in common: how far their transitions reach, and levels with their colours.

use crate::levels::Levels;
use crate::map_table::{Corner, MapTable};
use crate::surface::Surface;

/// Heights of one map or of several.
#[derive(Debug, Clone, PartialEq)]
pub struct Heights {
    /// Lowest and highest transition, if there is any.
    pub range: Option<(f64, f64)>,
    /// Levels and colours.
    pub levels: Levels,
}

impl Heights {
    /// Heights of surfaces; levels lie closer where more of their points do, unless they are chosen.
    pub fn of_surfaces<'s>(
        surfaces: impl IntoIterator<Item = &'s Surface>,
        chosen: Option<&Levels>,
    ) -> Self {
        let heights = surfaces.into_iter().flat_map(Surface::heights);
        Self::of(heights.map(|height| (height, 1.0)).collect(), chosen)
    }

    /// Heights of refined maps; levels lie closer where more of their area does, as their points crowd at edges.
    pub fn of_maps<'m>(
        maps: impl IntoIterator<Item = &'m MapTable>,
        chosen: Option<&Levels>,
    ) -> Self {
        let triangles = maps.into_iter().flat_map(|map| &map.triangles);
        let corners = triangles.flat_map(|triangle| {
            let area = twice_the_area(triangle);
            triangle.map(|(_, height)| (height, area))
        });
        Self::of(corners.collect(), chosen)
    }

    fn of(weighted: Vec<(f64, f64)>, chosen: Option<&Levels>) -> Self {
        let heights = || weighted.iter().map(|(height, _)| *height);
        let ends = heights().reduce(f64::min).zip(heights().reduce(f64::max));
        Self {
            range: ends,
            levels: chosen.map_or_else(|| Levels::through_weighted(&weighted), Levels::clone),
        }
    }
}

fn twice_the_area([(a, _), (b, _), (c, _)]: &[Corner; 3]) -> f64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_of_a_refined_map_lie_where_its_area_does_however_fine_its_triangles() {
        // V_H rises from 10 to 12 over nine tenths of the map, and to 20 over the last.
        let strips = |ends: [(f64, f64); 2], parts: usize| {
            let at = move |index: usize| {
                let part = index as f64 / parts as f64;
                let between = |a: f64, b: f64| a + part * (b - a);
                (between(ends[0].0, ends[1].0), between(ends[0].1, ends[1].1))
            };
            (0..parts).flat_map(move |index| {
                let corner = |across: f64, (along, height): (f64, f64)| ([across, along], height);
                let [near, far] = [at(index), at(index + 1)];
                let [a, b] = [0.0, 1.0].map(|across| corner(across, near));
                let [c, d] = [0.0, 1.0].map(|across| corner(across, far));
                [[a, b, c], [b, d, c]]
            })
        };
        let levels = |parts: usize| {
            let valley = strips([(0.0, 10.0), (9.0, 12.0)], 80);
            let wall = strips([(9.0, 12.0), (10.0, 20.0)], parts);
            let map = MapTable {
                axes: ["cross_slope_deg", "roll_deg"].map(str::to_owned),
                triangles: valley.chain(wall).collect(),
                edges: Vec::new(),
                patchy: Vec::new(),
                grid: None,
            };
            Heights::of_maps([&map], None).levels
        };
        let expected = [
            10.25, 10.5, 10.75, 11.0, 11.25, 11.5, 11.75, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0,
            19.0,
        ];
        for parts in [80, 8000] {
            assert_eq!(levels(parts).values(), expected, "{parts}");
        }
    }
}
