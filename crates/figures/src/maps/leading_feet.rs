//! The line AB of Figure 4-21: the touchdown velocity bisects the line between the two leading feet.
//!
//! A foot at azimuth θ of a vehicle rolled by Ξ stands at azimuth θ − Ξ over the ground, and a
//! cross-slope of λ points to azimuth −λ. With feet every 120 deg the velocity points midway between
//! two of them where −λ = 180 − Ξ up to whole turns of 120 deg: Ξ = λ − 180 + 120 n.

/// Turn after which the three feet have the same places, deg.
const TURN: f64 = 120.0;

/// Rolls between `least` and `most` (deg) at which the velocity bisects two leading feet, for a
/// cross-slope in deg.
pub fn rolls(cross_slope: f64, least: f64, most: f64) -> Vec<f64> {
    let base = (cross_slope - 180.0 - least).rem_euclid(TURN) + least;
    std::iter::successors(Some(base), |roll| Some(roll + TURN))
        .take_while(|roll| *roll <= most)
        .collect()
}

/// The line through a map of cross-slopes and rolls (deg), cut where the feet change.
pub fn lines(cross_slopes: &[f64], rolls_on_map: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let ends = |values: &[f64]| Some((*values.first()?, *values.last()?));
    let (Some((from, to)), Some((least, most))) = (ends(cross_slopes), ends(rolls_on_map)) else {
        return Vec::new();
    };
    let mut lines: Vec<Vec<[f64; 2]>> = Vec::new();
    // The line has slope one, so it leaves the map at whole degrees.
    for step in 0..=(to - from).round() as usize {
        let cross_slope = from + step as f64;
        for roll in rolls(cross_slope, least, most) {
            let continued = lines.iter_mut().find(|line| {
                line.last()
                    .is_some_and(|[c, r]| cross_slope - c == 1.0 && (roll - r - 1.0).abs() < 0.5)
            });
            match continued {
                Some(line) => line.push([cross_slope, roll]),
                None => lines.push(vec![[cross_slope, roll]]),
            }
        }
    }
    lines.retain(|line| line.len() > 1);
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_passes_through_the_points_that_the_report_names() {
        assert_eq!(rolls(180.0, -60.0, 60.0), [0.0]);
        assert_eq!(rolls(150.0, -60.0, 60.0), [-30.0]);
        assert_eq!(rolls(90.0, -60.0, 60.0), [30.0]);
        assert_eq!(rolls(120.0, -60.0, 60.0), [-60.0, 60.0]);
    }

    #[test]
    fn the_line_is_cut_where_the_leading_feet_change() {
        let lines = lines(&[80.0, 180.0], &[-60.0, 60.0]);
        let ends: Vec<_> = lines
            .iter()
            .map(|line| (line[0], line[line.len() - 1]))
            .collect();
        assert_eq!(
            ends,
            [
                ([80.0, 20.0], [120.0, 60.0]),
                ([120.0, -60.0], [180.0, 0.0])
            ]
        );
    }

    #[test]
    fn velocity_lies_midway_between_two_feet() {
        for cross_slope in [80.0f64, 100.0, 165.0, 180.0] {
            let roll = rolls(cross_slope, -60.0, 60.0)[0];
            let distance = |foot: f64| {
                let angle = (foot - roll + cross_slope).rem_euclid(360.0);
                angle.min(360.0 - angle)
            };
            let mut distances = [0.0, 120.0, 240.0].map(distance);
            distances.sort_by(f64::total_cmp);
            assert_eq!(distances[..2], [60.0, 60.0]);
        }
    }
}
