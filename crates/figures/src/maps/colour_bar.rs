//! The column that explains the colours of a map.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::figure_error::{FigureError, drawing};
use crate::ink;
use crate::levels::{self, LEVELS};
use crate::number;
use crate::sheet::Sheet;
use crate::surface::Surface;

/// Place of the column in its area, pixels.
const LEFT: i32 = 8;
const WIDTH: i32 = 20;
const TOP: i32 = 60;
const STEP: i32 = 34;

/// Draws the levels that a surface reaches, the highest on top.
pub fn draw(area: &Sheet, surface: &Surface) -> Result<(), FigureError> {
    let Some((least, greatest)) = surface.range() else {
        return Ok(());
    };
    let first = LEVELS.partition_point(|level| *level <= least);
    let last = LEVELS.partition_point(|level| *level < greatest);
    let title = ink::text(12, ink::TEXT);
    for (text, y) in [("V_H,", TOP - 40), ("ft/s", TOP - 24)] {
        area.draw(&Text::new(text, (LEFT, y), title.clone()))
            .map_err(drawing)?;
    }
    let beside = Pos::new(HPos::Left, VPos::Center);
    for (step, band) in (first..=last).rev().enumerate() {
        let top = TOP + STEP * step as i32;
        let low = if band == 0 { 0.0 } else { LEVELS[band - 1] };
        let corners = [(LEFT, top), (LEFT + WIDTH, top + STEP)];
        area.draw(&Rectangle::new(corners, levels::colour(low).filled()))
            .map_err(drawing)?;
        area.draw(&Rectangle::new(corners, ink::TEXT.stroke_width(1)))
            .map_err(drawing)?;
        if band > first {
            let style = ink::text(12, ink::TEXT).pos(beside);
            let place = (LEFT + WIDTH + 6, top + STEP);
            area.draw(&Text::new(number::label(low), place, style))
                .map_err(drawing)?;
        }
    }
    Ok(())
}
