//! The points of a profile along its axis: their extent, neighbours and runs.

use crate::bands_table::{Band, BandsTable};
use crate::boundary_table::{BoundaryTable, Transition};
use crate::division::Division;

/// A point of the profile.
#[derive(Debug, Clone)]
pub struct ProfilePoint {
    /// Position along the axis.
    pub x: f64,
    /// The transition that the sweep found there.
    pub transition: Option<Transition>,
    /// All bands there, if they are known.
    pub bands: Vec<Band>,
}

/// The points of a table with one axis of this division, from left to right.
pub fn along(
    table: &BoundaryTable,
    bands: Option<&BandsTable>,
    division: Division,
) -> Vec<ProfilePoint> {
    let mut points: Vec<ProfilePoint> = table
        .points
        .iter()
        .filter_map(|point| {
            Some(ProfilePoint {
                x: division.place(*point.coordinates.first()?),
                transition: point.transition,
                bands: bands.map_or(Vec::new(), |bands| bands.at(&point.coordinates).to_vec()),
            })
        })
        .collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    points
}

/// Positions on the axis from the first to the last point, with a margin.
pub fn horizontal_range(points: &[ProfilePoint]) -> (f64, f64) {
    let first = points.first().map_or(0.0, |point| point.x);
    let last = points.last().map_or(1.0, |point| point.x);
    // A single point still needs a picture with some width.
    let margin = if last > first {
        0.025 * (last - first)
    } else {
        1.0
    };
    (first - margin, last + margin)
}

/// Speeds from well below the lowest transition, so that the stable side shows, to the top.
pub fn vertical_range(points: &[ProfilePoint], searched_to: Option<f64>) -> (f64, f64) {
    let speeds = || {
        points
            .iter()
            .filter_map(|point| Some(point.transition?.speed))
    };
    let least = speeds().fold(f64::INFINITY, f64::min);
    let greatest = speeds().fold(0.0, f64::max);
    let high = searched_to
        .unwrap_or(2.0 * (greatest / 2.0 + 0.5).ceil())
        .max(greatest);
    if least.is_infinite() {
        return (0.0, high.max(1.0));
    }
    let below = least - 0.3 * (high - least).max(1.0);
    ((2.0 * (below / 2.0).floor()).max(0.0), high)
}

/// Neighbours that both have a transition. Lines are drawn only between them.
pub fn segments(
    points: &[ProfilePoint],
) -> impl Iterator<Item = (&ProfilePoint, &ProfilePoint, Transition, Transition)> {
    points
        .windows(2)
        .filter_map(|pair| Some((&pair[0], &pair[1], pair[0].transition?, pair[1].transition?)))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::boundary_table::Kind;

    pub(crate) fn point(x: f64, speed: Option<f64>) -> ProfilePoint {
        let transition = speed.map(|speed| Transition {
            kind: Kind::Unstable,
            speed,
            low: Some(speed),
            high: speed,
            patchy_to: None,
        });
        ProfilePoint {
            x,
            transition,
            bands: Vec::new(),
        }
    }

    #[test]
    fn lines_join_neighbours_with_a_transition_only() {
        let speeds = [Some(11.0), Some(12.0), None, Some(13.0)];
        let points: Vec<ProfilePoint> = (0..4).map(|i| point(i as f64, speeds[i])).collect();
        let joined: Vec<_> = segments(&points).map(|(a, b, ..)| (a.x, b.x)).collect();
        assert_eq!(joined, [(0.0, 1.0)]);
    }

    #[test]
    fn the_picture_reaches_from_below_the_boundary_to_the_top_of_the_search() {
        let points = [point(-1.0, Some(11.4)), point(1.0, None)];
        assert_eq!(vertical_range(&points, Some(25.0)), (6.0, 25.0));
        assert_eq!(vertical_range(&points[1..], Some(25.0)), (0.0, 25.0));
        assert_eq!(vertical_range(&points, None), (10.0, 14.0));
        assert_eq!(horizontal_range(&points), (-1.05, 1.05));
    }
}
