//! Curves without points of no visible effect (Ramer, Douglas and Peucker).

use libm::hypot;
/// A place on the picture, pixels.
type Point = (f64, f64);

/// The points needed to keep a curve within `tolerance` of its course.
pub fn thinned(points: &[Point], tolerance: f64) -> Vec<Point> {
    let mut is_kept = vec![false; points.len()];
    for end in [0, points.len().saturating_sub(1)] {
        if let Some(kept) = is_kept.get_mut(end) {
            *kept = true;
        }
    }
    let mut spans = vec![(0, points.len().saturating_sub(1))];
    while let Some((first, last)) = spans.pop() {
        let inner = first + 1..last;
        let off = |index: usize| distance(points[index], points[first], points[last]);
        let farthest = inner.max_by(|a, b| off(*a).total_cmp(&off(*b)));
        if let Some(index) = farthest.filter(|index| off(*index) > tolerance) {
            is_kept[index] = true;
            spans.extend([(first, index), (index, last)]);
        }
    }
    let kept = points.iter().zip(is_kept).filter(|(_, is_kept)| *is_kept);
    kept.map(|(point, _)| *point).collect()
}

/// Distance of a point from the line between two others, or from both if they coincide.
fn distance((x, y): Point, (x0, y0): Point, (x1, y1): Point) -> f64 {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let square = dx * dx + dy * dy;
    if square == 0.0 {
        return hypot(x - x0, y - y0);
    }
    let part = (((x - x0) * dx + (y - y0) * dy) / square).clamp(0.0, 1.0);
    hypot(x - x0 - part * dx, y - y0 - part * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_stretches_lose_their_points_and_corners_stay() {
        let line: Vec<Point> = (0..=10).map(|i| (f64::from(i), 0.0)).collect();
        assert_eq!(thinned(&line, 0.01), [(0.0, 0.0), (10.0, 0.0)]);
        let corner = [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 0.0)];
        assert_eq!(thinned(&corner, 0.01), [(0.0, 0.0), (2.0, 2.0), (3.0, 0.0)]);
        // A curve that comes back to where it began.
        let loop_ = [(0.0, 0.0), (5.0, 5.0), (0.0, 0.0)];
        assert_eq!(thinned(&loop_, 0.01), loop_);
        assert_eq!(thinned(&[], 0.01), []);
        assert_eq!(thinned(&[(1.0, 1.0)], 0.01), [(1.0, 1.0)]);
    }

    #[test]
    fn every_point_stays_within_the_tolerance() {
        let curve: Vec<Point> = (0..1000)
            .map(|i| (f64::from(i), 50.0 * (0.02 * f64::from(i)).sin()))
            .collect();
        let thin = thinned(&curve, 0.05);
        assert!(thin.len() < 300, "{}", thin.len());
        for point in &curve {
            let off = thin
                .windows(2)
                .map(|ends| distance(*point, ends[0], ends[1]))
                .fold(f64::INFINITY, f64::min);
            assert!(off <= 0.05, "{point:?} {off}");
        }
    }
}
