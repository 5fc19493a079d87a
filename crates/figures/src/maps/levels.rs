//! Levels of transition velocity and their colours: dark where the vehicle topples soonest.

use plotters::prelude::*;

/// Borders of the bands of colour, ft/s: close where most of the surface lies.
pub const LEVELS: [f64; 13] = [
    11.0, 11.5, 12.0, 12.5, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0, 20.0, 22.0, 25.0,
];

/// Dark blue to pale yellow, even in lightness, so that grey prints and all eyes keep the order
/// (after the colour map cividis).
const ENDS: [(f64, [f64; 3]); 4] = [
    (0.0, [28.0, 52.0, 98.0]),
    (0.35, [92.0, 100.0, 118.0]),
    (0.7, [166.0, 156.0, 120.0]),
    (1.0, [250.0, 232.0, 140.0]),
];

/// Colour of a velocity, ft/s: that of the band it lies in.
pub fn colour(speed: f64) -> RGBColor {
    let above = LEVELS.partition_point(|level| *level <= speed);
    let part = above as f64 / LEVELS.len() as f64;
    let upper = ENDS
        .partition_point(|(end, _)| *end < part)
        .clamp(1, ENDS.len() - 1);
    let ((a, low), (b, high)) = (ENDS[upper - 1], ENDS[upper]);
    let weight = (part - a) / (b - a);
    let [r, g, b] = [0, 1, 2].map(|i| (low[i] + weight * (high[i] - low[i])).round() as u8);
    RGBColor(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_rises_with_speed() {
        let light = |speed: f64| {
            let RGBColor(r, g, b) = colour(speed);
            0.3 * f64::from(r) + 0.59 * f64::from(g) + 0.11 * f64::from(b)
        };
        let speeds: Vec<f64> = LEVELS
            .windows(2)
            .map(|pair| 0.5 * (pair[0] + pair[1]))
            .collect();
        assert!(
            speeds
                .windows(2)
                .all(|pair| light(pair[0]) < light(pair[1]))
        );
    }
}
