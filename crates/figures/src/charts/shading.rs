//! Shaded regions of a profile: from all bands if they are known, or else from the first transition upward.

use crate::bands_table::Band;
use crate::boundary_table::Kind;
use crate::profile_points::ProfilePoint;

/// A region, its corners in the units of the axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Outcome in it.
    pub kind: Kind,
    /// Its four corners.
    pub corners: [(f64, f64); 4],
}

/// All regions of a profile up to the speed `high`.
///
/// Between neighbours with the same sequence of outcomes, a region's borders are straight lines. Where the sequences
/// differ the border is unknown, and each point's bands hold half-way.
pub fn regions(points: &[ProfilePoint], high: f64) -> Vec<Region> {
    let columns: Vec<(f64, Vec<Band>)> = points
        .iter()
        .map(|point| (point.x, bands(point, high)))
        .collect();
    let mut regions = Vec::new();
    for pair in columns.windows(2) {
        let [(x0, left), (x1, right)] = [&pair[0], &pair[1]];
        let alike =
            left.len() == right.len() && left.iter().zip(right).all(|(a, b)| a.kind == b.kind);
        if alike {
            let joined = left.iter().zip(right);
            regions.extend(joined.filter_map(|(a, b)| quadrilateral(*x0, a, *x1, b)));
        } else {
            let middle = 0.5 * (x0 + x1);
            let (left_end, right_end) = meeting(left, right);
            let halves = |x0: f64, a: &[Band], x1: f64, b: &[Band]| -> Vec<Region> {
                let pairs = a.iter().zip(b);
                pairs
                    .filter_map(|(a, b)| quadrilateral(x0, a, x1, b))
                    .collect()
            };
            regions.extend(halves(*x0, left, middle, &left_end));
            regions.extend(halves(middle, &right_end, *x1, right));
        }
    }
    regions
}

/// The bands of two unlike neighbours where they meet. They are unchanged except for the first transition, which is
/// known to run from one to the other if its kind is the same.
fn meeting(left: &[Band], right: &[Band]) -> (Vec<Band>, Vec<Band>) {
    let (mut left, mut right) = (left.to_vec(), right.to_vec());
    if let ([_, a, ..], [_, b, ..]) = (&mut left[..], &mut right[..])
        && a.kind.is_some()
        && a.kind == b.kind
    {
        let border = 0.5 * (a.from + b.from);
        a.from = border.min(a.to);
        b.from = border.min(b.to);
    }
    (left, right)
}

fn quadrilateral(x0: f64, a: &Band, x1: f64, b: &Band) -> Option<Region> {
    Some(Region {
        kind: a.kind?,
        corners: [(x0, a.from), (x1, b.from), (x1, b.to), (x0, a.to)],
    })
}

/// The bands of a point, or those implied by its first transition. Speeds below the lowest searched are left out.
fn bands(point: &ProfilePoint, high: f64) -> Vec<Band> {
    if !point.bands.is_empty() {
        return point.bands.clone();
    }
    let band = |from, to, kind| Band { from, to, kind };
    match point.transition {
        None => vec![band(0.0, high, None)],
        Some(found) => vec![
            band(0.0, found.speed, None),
            band(found.speed, high, Some(found.kind)),
        ],
    }
}

/// Ranges of speeds, up to `high`, in which stable landings and others alternate above a first transition: half-way to each neighbour, or up
/// to a neighbour that has one too: corners as those of a region.
pub fn patchy(points: &[ProfilePoint], high: f64) -> Vec<[(f64, f64); 4]> {
    let ends = |point: &ProfilePoint| {
        let found = point.transition?;
        Some((found.speed, found.patchy_to?.min(high)))
    };
    let speed = |point: &ProfilePoint| Some(point.transition?.speed);
    let mut found = Vec::new();
    for pair in points.windows(2) {
        let [left, right] = [&pair[0], &pair[1]];
        if let (Some((a, b)), Some((c, d))) = (ends(left), ends(right)) {
            found.push([(left.x, a), (right.x, c), (right.x, d), (left.x, b)]);
            continue;
        }
        for (point, beside) in [(left, right), (right, left)] {
            if let Some((from, to)) = ends(point) {
                let middle = 0.5 * (point.x + beside.x);
                let border = speed(beside).map_or(from, |beside| 0.5 * (from + beside));
                let top = to.max(border);
                found.push([
                    (point.x, from),
                    (middle, border),
                    (middle, top),
                    (point.x, to),
                ]);
            }
        }
    }
    found
}

/// Middle of the widest run of at least two regions of a kind, and its mean height there.
pub fn broadest(points: &[ProfilePoint], kind: Kind, high: f64) -> Option<(f64, f64)> {
    let regions = regions(points, high);
    // Adjacent regions count as one: the widest run of touching ones.
    let same: Vec<_> = regions
        .iter()
        .filter(|region| region.kind == kind)
        .collect();
    let runs = same.chunk_by(|a, b| a.corners[1] == b.corners[0] || a.corners[2] == b.corners[3]);
    let width = |run: &&[&Region]| {
        let (first, last) = (run.first(), run.last());
        last.map_or(0.0, |region| region.corners[1].0)
            - first.map_or(0.0, |region| region.corners[0].0)
    };
    let run = runs
        .filter(|run| run.len() > 1)
        .max_by(|a, b| width(a).total_cmp(&width(b)))?;
    let [(x0, a), (x1, b), (_, c), (_, d)] = run[run.len() / 2].corners;
    Some((0.5 * (x0 + x1), 0.25 * (a + b + c + d)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile_points::tests::point;

    #[test]
    fn like_neighbours_are_joined_and_unlike_ones_meet_half_way() {
        let points = [
            point(0.0, Some(11.0)),
            point(1.0, Some(12.0)),
            point(3.0, None),
        ];
        let found = regions(&points, 25.0);
        assert_eq!(found.len(), 2);
        assert_eq!(
            found[0].corners,
            [(0.0, 11.0), (1.0, 12.0), (1.0, 25.0), (0.0, 25.0)]
        );
        assert_eq!(
            found[1].corners,
            [(1.0, 12.0), (2.0, 12.0), (2.0, 25.0), (1.0, 25.0)]
        );
    }

    #[test]
    fn the_first_transition_runs_on_where_only_what_is_above_differs() {
        let band = |from, to, kind| Band { from, to, kind };
        let low = |from, to| vec![band(0.0, from, None), band(from, to, Some(Kind::Unstable))];
        let left = ProfilePoint {
            bands: low(11.0, 25.0),
            ..point(0.0, Some(11.0))
        };
        let mut bands = low(12.0, 20.0);
        bands.push(band(20.0, 25.0, None));
        let right = ProfilePoint {
            bands,
            ..point(1.0, Some(12.0))
        };
        let found = regions(&[left, right], 25.0);
        assert_eq!(found[0].corners[1], (0.5, 11.5));
        assert_eq!(found[1].corners[0], (0.5, 11.5));
    }

    #[test]
    fn bands_above_the_first_transition_are_regions_too() {
        let band = |from, to, kind| Band { from, to, kind };
        let bands = vec![
            band(0.0, 11.0, None),
            band(11.0, 16.0, Some(Kind::Unstable)),
            band(16.0, 20.0, None),
            band(20.0, 25.0, Some(Kind::Bottomed)),
        ];
        let at = |x| ProfilePoint {
            bands: bands.clone(),
            ..point(x, Some(11.0))
        };
        let found = regions(&[at(0.0), at(1.0)], 25.0);
        assert_eq!(found.len(), 2);
        assert_eq!(found[1].kind, Kind::Bottomed);
        assert_eq!(found[1].corners[0], (0.0, 20.0));
    }

    #[test]
    fn a_patchy_stretch_ends_half_way_to_a_sharp_neighbour() {
        let mut points = [0.0, 1.0, 2.0, 3.0].map(|x| point(x, Some(11.0 + x)));
        for (point, to) in points[..2].iter_mut().zip([12.0, 14.0]) {
            point.transition.as_mut().unwrap().patchy_to = Some(to);
        }
        points[3].transition = None;
        assert_eq!(
            patchy(&points, 13.5),
            [
                [(0.0, 11.0), (1.0, 12.0), (1.0, 13.5), (0.0, 12.0)],
                [(1.0, 12.0), (1.5, 12.5), (1.5, 13.5), (1.0, 13.5)],
            ]
        );
        assert!(patchy(&points[2..], 25.0).is_empty());
    }

    #[test]
    fn broadest_run_has_at_least_three_points() {
        let run: Vec<ProfilePoint> = (0..5).map(|i| point(i as f64, Some(12.0))).collect();
        assert_eq!(broadest(&run, Kind::Unstable, 20.0), Some((2.5, 16.0)));
        assert_eq!(broadest(&run[..2], Kind::Unstable, 20.0), None);
        assert_eq!(broadest(&run, Kind::Bottomed, 20.0), None);
    }
}
