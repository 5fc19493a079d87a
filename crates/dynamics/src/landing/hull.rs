//! Convex hull of supports in plan, and tipping of the CG over its edges.
//!
//! Supports are seen from the CG in axes whose z points down; in plan means along z. Edges go round in the order of
//! azimuths (from y to x), so that inboard is to their right.

use std::f64::consts::{FRAC_PI_2, PI};

use arrayvec::ArrayVec;
use libm::{atan2, sqrt};
use nalgebra::Vector3;

use crate::per_leg::MOST_LEGS;

/// Most supports of a vehicle: a footpad and a block for each leg.
pub(super) const MOST_SUPPORTS: usize = 2 * MOST_LEGS;

/// Supports by their indices, one corner of a polygon after another.
type Corners = ArrayVec<usize, MOST_SUPPORTS>;

/// The convex hull of supports in plan.
#[derive(Debug, Clone)]
pub(super) struct Hull<'a> {
    supports: &'a [Vector3<f64>],
    corners: Corners,
}

impl<'a> Hull<'a> {
    /// The hull of at least one support. Each corner is followed by the support that leaves none to the left.
    #[inline(always)]
    pub(super) fn of(supports: &'a [Vector3<f64>]) -> Self {
        let mut first = 0;
        for (index, support) in supports.iter().enumerate() {
            let least = &supports[first];
            if support.x < least.x || support.x == least.x && support.y < least.y {
                first = index;
            }
        }
        let mut corners = Corners::new();
        let mut corner = first;
        while corners.len() < supports.len() {
            corners.push(corner);
            let from = &supports[corner];
            let mut next = corner;
            let (mut x, mut y) = (0.0, 0.0);
            for (index, support) in supports.iter().enumerate() {
                let (along, across) = (support.x - from.x, support.y - from.y);
                let left = x * across - y * along;
                let is_farther = along * along + across * across > x * x + y * y;
                if left > 0.0 || left == 0.0 && is_farther {
                    (next, x, y) = (index, along, across);
                }
            }
            if next == first {
                break;
            }
            corner = next;
        }
        Self { supports, corners }
    }

    /// Indices of the supports at the ends of each edge.
    #[inline(always)]
    fn ends(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let next = self.corners.iter().cycle().skip(1);
        (self.corners.iter().zip(next)).map(|(&from, &to)| [from, to])
    }

    /// Ends of each edge.
    #[inline(always)]
    fn edges(&self) -> impl Iterator<Item = [&'a Vector3<f64>; 2]> + '_ {
        self.ends().map(|ends| ends.map(|end| &self.supports[end]))
    }

    /// Stability angle, rad: the least angle between the vertical through the CG and the line from the CG to the point
    /// of an edge that is nearest in plan. Positive where the CG is within the hull and above the edge.
    #[inline(always)]
    pub(super) fn stability_angle(&self) -> f64 {
        let (_, [inboard, height]) = self.critical_edge();
        let angle = atan2(inboard, height);
        // A vehicle on its back, below all its supports, is not stable anywhere.
        if angle > FRAC_PI_2 { angle - PI } else { angle }
    }

    /// Supports at the ends of the edge over which the CG is nearest to tipping.
    pub(super) fn critical_supports(&self) -> [usize; 2] {
        self.critical_edge().0
    }

    /// These supports, the distance of the CG inboard of their edge in plan, and its height over it, ft.
    #[inline(always)]
    fn critical_edge(&self) -> ([usize; 2], [f64; 2]) {
        // Any edge is nearer than half a turn.
        let mut critical = ([0; 2], [0.0, -1.0]);
        for ends in self.ends() {
            let [from, to] = ends.map(|end| &self.supports[end]);
            let (x, y) = (to.x - from.x, to.y - from.y);
            let squared = x * x + y * y;
            if squared == 0.0 {
                continue;
            }
            let inboard = (from.y * to.x - from.x * to.y) / squared.sqrt();
            let share = -(from.x * x + from.y * y) / squared;
            let height = from.z + share * (to.z - from.z);
            // On the far side of an inclined vehicle an edge may be above the CG.
            let edge = [inboard, height];
            let least = critical.1;
            let is_less = if edge[1] > 0.0 && least[1] > 0.0 {
                edge[0] * least[1] < least[0] * edge[1]
            } else {
                atan2(edge[0], edge[1]) < atan2(least[0], least[1])
            };
            if is_less {
                critical = (ends, edge);
            }
        }
        critical
    }

    /// Returns whether the CG is within.
    pub(super) fn has_center(&self) -> bool {
        self.corners.len() > 2
            && (self.edges()).all(|[from, to]| from.y * to.x - from.x * to.y > 0.0)
    }

    /// Least rise of the CG until it is over an edge, ft.
    pub(super) fn least_rise(&self) -> f64 {
        (self.edges()).fold(f64::INFINITY, |least, [from, to]| {
            least.min(rise_over(from, to))
        })
    }

    /// Greatest share of the weight that support `index` can bear, with the CG within the hull. The rest is then all
    /// borne where the line from the support through the CG leaves the hull.
    pub(super) fn greatest_share(&self, index: usize) -> f64 {
        let support = &self.supports[index];
        // Distance from the CG to where the line leaves the hull, over that from the support to the CG.
        let mut beyond = f64::INFINITY;
        for [from, to] in self.edges() {
            let (x, y) = (to.x - from.x, to.y - from.y);
            // Distance of the CG inboard of the edge, and how much farther inboard the support is, times the edge's
            // length.
            let center = from.y * x - from.x * y;
            let farther = support.x * y - support.y * x;
            if farther > 0.0 {
                beyond = beyond.min(center / farther);
            }
        }
        if beyond.is_finite() {
            beyond / (1.0 + beyond)
        } else {
            1.0
        }
    }
}

/// Rise of the CG until it is over an edge, ft; if it is beyond, the rise back, negative.
fn rise_over(from: &Vector3<f64>, to: &Vector3<f64>) -> f64 {
    let span = to - from;
    let along = span / sqrt(span.norm_squared());
    let nearest = from - along * from.dot(&along);
    let upright = sqrt(nearest.norm_squared() * (1.0 - along.z * along.z).max(0.0));
    let rise = upright - nearest.z;
    let is_inboard = from.y * to.x - from.x * to.y > 0.0;
    if is_inboard { rise } else { -rise }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::extremes::greatest;

    /// Feet at these azimuths (deg) and reaches, 4 ft below a CG that is off the centre.
    fn feet(places: &[[f64; 2]], [x, y]: [f64; 2]) -> Vec<Vector3<f64>> {
        (places.iter())
            .map(|[azimuth, reach]| {
                let (sine, cosine) = azimuth.to_radians().sin_cos();
                Vector3::new(reach * sine - x, reach * cosine - y, 4.0)
            })
            .collect()
    }

    #[test]
    fn a_hull_has_the_outermost_supports_in_the_order_of_azimuths() {
        let places = [
            [0.0, 5.0],
            [200.0, 1.0],
            [90.0, 5.0],
            [270.0, 5.0],
            [180.0, 5.0],
        ];
        let feet = feet(&places, [0.0; 2]);
        assert_eq!(Hull::of(&feet).corners.as_slice(), [3, 0, 2, 4]);
        let one = [Vector3::new(1.0, 2.0, 3.0)];
        assert!(!Hull::of(&one).has_center());
        assert!(!Hull::of(&[one[0], one[0], one[0]]).has_center());
    }

    #[test]
    fn on_its_back_a_vehicle_is_stable_nowhere() {
        let square = [[45.0, 5.0], [135.0, 5.0], [225.0, 5.0], [315.0, 5.0]];
        for x in [-4.5, -1.0, 0.0, 2.0, 3.5, 4.5] {
            let mut feet = feet(&square, [x, 0.2]);
            for foot in &mut feet {
                foot.z = -foot.z;
            }
            let angle = Hull::of(&feet).stability_angle();
            assert!(angle < 0.0, "{x}: {angle}");
        }
    }

    #[test]
    fn the_stability_angle_is_that_to_the_nearest_edge_and_negative_beyond_it() {
        let square = [[45.0, 5.0], [135.0, 5.0], [225.0, 5.0], [315.0, 5.0]];
        let half = 5.0 / f64::sqrt(2.0);
        for x in [-4.5, -1.0, 0.0, 2.0, 3.5, 4.5] {
            let feet = feet(&square, [x, 0.2]);
            let expected = ((half - f64::abs(x).max(0.2)) / 4.0).atan();
            let angle = Hull::of(&feet).stability_angle();
            assert!((angle - expected).abs() < 1e-12, "{x}: {angle}");
            assert_eq!(Hull::of(&feet).has_center(), expected > 0.0);
        }
    }

    #[test]
    fn the_greatest_share_is_borne_with_the_opposite_edge_or_foot() {
        let square = feet(
            &[[0.0, 3.0], [90.0, 3.0], [180.0, 3.0], [270.0, 3.0]],
            [0.0; 2],
        );
        assert!((Hull::of(&square).greatest_share(1) - 0.5).abs() < 1e-12);
        let triangle = feet(&[[0.0, 3.0], [120.0, 3.0], [240.0, 3.0]], [0.0; 2]);
        assert!((Hull::of(&triangle).greatest_share(2) - 1.0 / 3.0).abs() < 1e-12);
        // The CG is 1 ft before the foot and 3.5 ft behind the opposite edge.
        let triangle = feet(&[[0.0, 3.0], [120.0, 3.0], [240.0, 3.0]], [0.0, 2.0]);
        assert!((Hull::of(&triangle).greatest_share(0) - 3.5 / 4.5).abs() < 1e-12);
    }

    #[test]
    fn the_rise_over_a_level_line_is_that_of_a_pendulum_turned_over() {
        // Feet 3 ft ahead of the CG and 4 ft below it: the CG turns about them on a circle of 5 ft.
        let [from, to] = [[-2.0, 3.0, 4.0], [2.0, 3.0, 4.0]].map(Vector3::from);
        assert_eq!(rise_over(&from, &to), 1.0);
        assert_eq!(rise_over(&to, &from), -1.0);
    }

    #[test]
    fn the_rise_over_an_inclined_line_is_that_of_all_turns_about_it() {
        let (from, to) = (Vector3::new(-2.0, 1.0, 3.5), Vector3::new(2.5, 0.5, 4.5));
        let axis = nalgebra::Unit::new_normalize(to - from);
        let height = |angle: f64| {
            let turned = nalgebra::Rotation3::from_axis_angle(&axis, angle) * -from;
            -(from + turned).z
        };
        let highest = greatest((0..100_000).map(|k| height(f64::from(k) * 1e-4)));
        assert!((rise_over(&from, &to) - highest).abs() < 1e-7);
    }
}
