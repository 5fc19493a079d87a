//! A picture under construction, as SVG. Places are pixels from the upper left corner, with decimals.

use std::fmt::Write;

use crate::style::{Colour, Style};
use crate::text::{Anchor, Font, escaped, with_subscripts};
use crate::thinning::thinned;

/// A place on the picture: pixels to the right and downward.
pub type Point = (f64, f64);

/// Typefaces, in the order in which a viewer should try them.
const TYPEFACE: &str = "Helvetica, Arial, DejaVu Sans, sans-serif";
/// Height of the middle of a capital letter over its base line, relative to the size of the type.
const MIDDLE: f64 = 0.36;
/// Greatest error of a curve by thinning, pixels.
const THINNED_BY: f64 = 0.03;

/// A picture under construction.
#[derive(Debug)]
pub struct Canvas {
    svg: String,
}

impl Canvas {
    /// A white sheet of a size in pixels.
    pub fn new((width, height): Point) -> Self {
        let svg = format!(
            "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             xmlns=\"http://www.w3.org/2000/svg\" font-family=\"{}\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\"/>\n",
            TYPEFACE
        );
        Self { svg }
    }

    /// The whole picture.
    pub fn into_svg(self) -> String {
        self.svg + "</svg>\n"
    }

    /// Draws a curve from point to point, without points of no visible effect.
    pub fn curve(&mut self, points: &[Point], style: Style) {
        let points = thinned(points, THINNED_BY);
        self.shape("polyline", &points, &style.attributes());
    }

    /// Draws a closed polygon.
    pub fn polygon(&mut self, corners: &[Point], style: Style) {
        self.shape("polygon", corners, &style.attributes());
    }

    fn shape(&mut self, name: &str, points: &[Point], attributes: &str) {
        let mut text = String::new();
        for (x, y) in points {
            let _ = write!(text, "{},{} ", number(*x), number(*y));
        }
        let _ = writeln!(
            self.svg,
            "<{name} points=\"{}\"{attributes}/>",
            text.trim_end()
        );
    }

    /// Fills polygons next to those of other colours; no paper shows between them.
    pub fn fill_tiles(&mut self, polygons: &[Vec<Point>], colour: Colour) {
        self.fill(polygons, colour, " shape-rendering=\"crispEdges\"");
    }

    /// Fills polygons as one shape; no paper shows between them.
    pub fn fill_areas(&mut self, polygons: &[Vec<Point>], colour: Colour) {
        self.fill(polygons, colour, "");
    }

    fn fill(&mut self, polygons: &[Vec<Point>], colour: Colour, rendering: &str) {
        if polygons.is_empty() {
            return;
        }
        let mut path = String::new();
        for polygon in polygons {
            for (index, (x, y)) in polygon.iter().enumerate() {
                let command = if index == 0 { 'M' } else { 'L' };
                let _ = write!(path, "{command}{} {}", coarse(*x), coarse(*y));
            }
            path.push('Z');
        }
        let fill = Style::fill(colour).attributes();
        let _ = writeln!(self.svg, "<path d=\"{path}\"{fill}{rendering}/>");
    }

    /// Draws a circle.
    pub fn circle(&mut self, (x, y): Point, radius: f64, style: Style) {
        let _ = writeln!(
            self.svg,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\"{}/>",
            number(x),
            number(y),
            style.attributes()
        );
    }

    /// Draws a rectangle between two opposite corners.
    pub fn rectangle(&mut self, (x0, y0): Point, (x1, y1): Point, style: Style) {
        let _ = writeln!(
            self.svg,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>",
            number(x0.min(x1)),
            number(y0.min(y1)),
            number((x1 - x0).abs()),
            number((y1 - y0).abs()),
            style.attributes()
        );
    }

    /// Writes a text, vertically centred at its place. V_H and V_V have subscripts.
    pub fn text(&mut self, text: &str, (x, y): Point, font: Font) {
        let Font { size, colour, .. } = font;
        let anchor = match font.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let turn = if font.is_upright {
            format!(" transform=\"rotate(-90 {} {})\"", number(x), number(y))
        } else {
            String::new()
        };
        let _ = writeln!(
            self.svg,
            "<text x=\"{}\" y=\"{}\" font-size=\"{size}\" fill=\"{}\"{anchor}{turn}>{}</text>",
            number(x),
            number(y + MIDDLE * size),
            colour.hex(),
            with_subscripts(&escaped(text))
        );
    }
}

/// A coordinate to a hundredth of a pixel.
fn number(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
}

/// A coordinate to a tenth of a pixel, for the corners of areas.
fn coarse(value: f64) -> f64 {
    (value * 10.0).round() / 10.0 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::style::WHITE;

    #[test]
    fn places_are_finer_than_pixels() {
        let mut canvas = Canvas::new((100.0, 50.0));
        canvas.curve(
            &[(0.125, 0.5), (10.0, 20.337), (30.0, 0.0)],
            Style::stroke(Colour(0, 0, 255), 2.0),
        );
        let svg = canvas.into_svg();
        assert!(svg.starts_with("<svg width=\"100\" height=\"50\""));
        assert!(
            svg.contains("points=\"0.13,0.5 10,20.34 30,0\" fill=\"none\" stroke=\"#0000FF\""),
            "{svg}"
        );
    }

    #[test]
    fn texts_are_escaped_and_velocities_have_subscripts() {
        let write = |text: &str| {
            let mut canvas = Canvas::new((100.0, 50.0));
            canvas.text(text, (1.0, 2.0), Font::new(10.0, WHITE));
            canvas.into_svg()
        };
        let svg = write("V_H < V_V\u{1}, V_x");
        assert!(
            svg.contains(
                ">V<tspan dy=\"3\" font-size=\"75%\">H</tspan><tspan dy=\"-3\"> &lt; </tspan>\
                 V<tspan dy=\"3\" font-size=\"75%\">V</tspan><tspan dy=\"-3\"> , </tspan>V_x</text>"
            ),
            "{svg}"
        );
    }
}
