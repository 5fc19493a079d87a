//! A chapter of the special studies: its text and its picture.

use touchdown_figures::caption::Caption;
use touchdown_figures::line_chart::{Axis, Curve, LineChart, Panel, Stroke, draw};
use touchdown_figures::png;

use crate::failure::Failure;

/// Text and pictures of a study.
pub struct Chapter {
    /// Section of the page.
    pub text: String,
    /// Stem of the picture's name, and the picture.
    pub pictures: Vec<(&'static str, LineChart)>,
}

impl Chapter {
    /// The pictures as files, SVG and PNG.
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        for (stem, chart) in &self.pictures {
            let svg = draw(chart).map_err(Failure::running)?;
            let png = png::render(&svg).map_err(Failure::running)?;
            files.push((format!("{stem}.svg"), svg.into_bytes()));
            files.push((format!("{stem}.png"), png));
        }
        Ok(files)
    }
}

/// A chart of one panel or several.
pub fn chart(title: &str, conditions: &str, abscissa: Axis, panels: Vec<Panel>) -> LineChart {
    LineChart {
        caption: Caption {
            title: title.to_owned(),
            conditions: conditions.to_owned(),
            ..Caption::default()
        },
        abscissa,
        panels,
    }
}

/// A panel.
pub fn panel(ordinate: Axis, curves: Vec<Curve>) -> Panel {
    Panel { ordinate, curves }
}

/// A curve.
pub fn curve(name: &str, stroke: Stroke, points: Vec<(f64, f64)>) -> Curve {
    Curve {
        name: name.to_owned(),
        stroke,
        points,
        remarks: Vec::new(),
    }
}
