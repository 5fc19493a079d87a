//! A chapter of the special studies: its text and its picture.

use touchdown::terminal::Failure;
use touchdown_figures::caption::Caption;
use touchdown_figures::line_chart::{Axis, LineChart, Panel, draw};

/// Text and pictures of a study.
pub struct Chapter {
    /// Section of the page.
    pub text: String,
    /// Stem of the picture's name, and the picture.
    pub pictures: Vec<(&'static str, LineChart)>,
}

impl Chapter {
    /// The pictures as files, SVG.
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        for (stem, chart) in &self.pictures {
            let svg = draw(chart).map_err(Failure::running)?;
            files.push((format!("{stem}.svg"), svg.into_bytes()));
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
