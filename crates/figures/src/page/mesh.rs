//! Grid lines, numbers and titles of a chart's axes, as all charts have them.

use plotters::coord::ranged1d::{Ranged, ValueFormatter};
use plotters::prelude::*;

use crate::figure_error::{FigureError, drawing};
use crate::ink;

/// What is written along an axis.
pub struct Along<'a> {
    /// Quantity and unit.
    pub title: &'a str,
    /// About so many numbers.
    pub count: usize,
    /// A number in words.
    pub label: &'a dyn Fn(&f64) -> String,
}

/// Draws the mesh of a chart, its lines in colour `lines`.
pub fn draw<X, Y>(
    chart: &mut ChartContext<'_, SVGBackend<'_>, Cartesian2d<X, Y>>,
    lines: impl Into<ShapeStyle>,
    across: &Along,
    up: &Along,
) -> Result<(), FigureError>
where
    X: Ranged<ValueType = f64> + ValueFormatter<f64>,
    Y: Ranged<ValueType = f64> + ValueFormatter<f64>,
{
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(lines)
        .axis_style(ink::TEXT)
        .x_labels(across.count)
        .y_labels(up.count)
        .x_label_formatter(across.label)
        .y_label_formatter(up.label)
        .label_style(ink::text(12, ink::TEXT))
        .axis_desc_style(ink::text(14, ink::TEXT))
        .x_desc(across.title)
        .y_desc(up.title)
        .draw()
        .map_err(drawing)
}
