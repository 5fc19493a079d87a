//! Viewpoint of a surface, and projection of its points onto the sheet.

use crate::canvas::Point;
use crate::frame::Area;
use crate::surface::Surface;
use libm::sincos;

/// Turn of the eye about the vertical and its height over the horizon, deg.
const AZIMUTH: f64 = 32.0;
const ELEVATION: f64 = 34.0;
/// Height of the box relative to its sides.
const HEIGHT: f64 = 0.62;

/// A parallel projection of a box with sides along the axes of a surface and the speed.
#[derive(Debug, Clone, Copy)]
pub struct ViewPoint {
    /// Lowest value and extent of slow axis, fast axis and speed.
    origin: [f64; 3],
    extent: [f64; 3],
    /// Pixels per side of the box, and place of its middle.
    scale: f64,
    middle: [f64; 2],
}

impl ViewPoint {
    /// The view of a surface between two `heights` that fits a part of a picture.
    pub fn on(area: Area, surface: &Surface, heights: [f64; 2]) -> Self {
        let ends = |values: &[f64]| (values[0], values[values.len() - 1] - values[0]);
        let ((s, ds), (f, df)) = (ends(&surface.slow), ends(&surface.fast));
        Self {
            origin: [s, f, heights[0]],
            extent: [ds, df, heights[1] - heights[0]],
            scale: (area.width() / 1.62).min(area.height() / 1.38),
            middle: [
                0.5 * (area.left + area.right),
                0.5 * (area.top + area.bottom),
            ],
        }
    }

    /// Place in the box, each coordinate from −1/2 to 1/2. As on the map, the slow axis runs from far to near and the
    /// fast one from right to left.
    fn place(&self, slow: f64, fast: f64, speed: f64) -> [f64; 3] {
        let part = |axis: usize, value: f64| (value - self.origin[axis]) / self.extent[axis] - 0.5;
        [-part(1, fast), -part(0, slow), HEIGHT * part(2, speed)]
    }

    fn turned([right, far, up]: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = sincos(AZIMUTH.to_radians());
        [cos * right + sin * far, cos * far - sin * right, up]
    }

    /// Distance from the eye along the ground, from twice the mean coordinates.
    pub fn depth(&self, twice_slow: f64, twice_fast: f64) -> f64 {
        Self::turned(self.place(0.5 * twice_slow, 0.5 * twice_fast, self.origin[2]))[1]
    }

    /// Place of a point on the picture, pixels.
    pub fn pixel(&self, slow: f64, fast: f64, speed: f64) -> Point {
        self.project(self.place(slow, fast, speed))
    }

    /// Place for a text outside of the box: moved away from its middle along the slow and fast sides by parts of them.
    pub fn outside(&self, slow: f64, fast: f64, speed: f64, [by_slow, by_fast]: [f64; 2]) -> Point {
        let [right, far, up] = self.place(slow, fast, speed);
        let away = |part: f64, by: f64| part + by * if part < 0.0 { -1.0 } else { 1.0 };
        self.project([away(right, by_fast), away(far, by_slow), up])
    }

    fn project(&self, place: [f64; 3]) -> Point {
        let [right, far, up] = Self::turned(place);
        let (sin, cos) = sincos(ELEVATION.to_radians());
        let x = self.middle[0] + self.scale * right;
        let y = self.middle[1] - self.scale * (sin * far + cos * up);
        (x, y)
    }

    /// The ends of each axis: the one at the back, then the one in front.
    pub fn back_and_front(&self, slow: [f64; 2], fast: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let order = |ends: [f64; 2], depth: &dyn Fn(f64) -> f64| {
            if depth(ends[0]) > depth(ends[1]) {
                ends
            } else {
                [ends[1], ends[0]]
            }
        };
        (
            order(slow, &|end| self.depth(2.0 * end, fast[0] + fast[1])),
            order(fast, &|end| self.depth(slow[0] + slow[1], 2.0 * end)),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::example;

    #[test]
    fn higher_is_drawn_higher_and_the_box_lies_on_the_sheet() {
        let area = Area {
            left: 0.0,
            top: 0.0,
            right: 800.0,
            bottom: 600.0,
        };
        let point = ViewPoint::on(area, &example(), [10.0, 22.0]);
        let (x, low) = point.pixel(130.0, 0.0, 11.0);
        let (same, high) = point.pixel(130.0, 0.0, 20.0);
        assert!((x - same).abs() < 1e-9 && high < low);
        for slow in [80.0, 180.0] {
            for fast in [-30.0, 30.0] {
                for speed in [10.0, 22.0] {
                    let (x, y) = point.pixel(slow, fast, speed);
                    assert!(
                        (0.0..800.0).contains(&x) && (0.0..600.0).contains(&y),
                        "{x} {y}"
                    );
                }
            }
        }
    }
}
