//! The pictures of a result table.

use crate::bands_table::BandsTable;
use crate::boundary_profile;
use crate::boundary_table::{Axis, BoundaryTable};
use crate::caption::Caption;
use crate::contour_map;
use crate::distribution_chart;
use crate::division::Division;
use crate::figure_error::FigureError;
use crate::history_chart;
use crate::history_table::{self, HistoryTable};
use crate::levels::Levels;
use crate::map_table::{self, MapTable};
use crate::map_view::View;
use crate::outcome_chart;
use crate::perspective;
use crate::probability_chart;
use crate::refined_map;
use crate::sensitivity_table::{self, SensitivityTable};
use crate::surface::Surface;
use crate::tornado_chart;
use crate::work_precision::{self, Cost};

/// A picture, and the suffix of its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Suffix to the stem of the table's name, empty for the only picture.
    pub suffix: &'static str,
    /// The picture.
    pub svg: String,
}

/// Sources of pictures.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Source<'s> {
    /// Name of the table.
    pub name: &'s str,
    /// The table (CSV).
    pub table: &'s str,
    /// The table of bands beside it.
    pub bands: Option<&'s str>,
    /// The table of edges beside the triangles of a map.
    pub edges: Option<&'s str>,
    /// The table of points beside the triangles of a map.
    pub points: Option<&'s str>,
    /// The regular table beside the triangles of a map.
    pub grid: Option<&'s str>,
    /// The record beside it.
    pub record: Option<&'s str>,
}

/// Choices for a picture that do not follow from its table.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Choices {
    /// Levels of maps.
    pub levels: Option<Levels>,
    /// Axes of a sweep over which to draw the lowest transition.
    pub worst_by: Vec<String>,
    /// Columns of a history.
    pub columns: Vec<String>,
}

impl Choices {
    /// Checks that a table of some kind can use the choices.
    fn check(&self, kind: &str, has_axes: bool, has_columns: bool) -> Result<(), FigureError> {
        let given = [
            ("levels", self.levels.is_some() && !has_axes),
            ("axes", !self.worst_by.is_empty() && !has_axes),
            ("columns", !self.columns.is_empty() && !has_columns),
        ];
        match given.iter().find(|(_, is_useless)| *is_useless) {
            Some((name, _)) => Err(FigureError::Table(format!(
                "{name} cannot be chosen for {kind}"
            ))),
            None => Ok(()),
        }
    }
}

/// Draws all pictures of a table. Transitions of a sweep over one axis give a profile, over two axes a contour map and
/// a perspective, over more the same for the lowest transitions over the others. Histories give a chart, sensitivities
/// a tornado chart, and landings over two axes a chart of outcomes.
///
/// # Errors
/// When a table is not one that the program writes, a record is not JSON, a table has no picture, or
/// something was chosen that the table does not have.
pub fn draw(source: &Source, choices: &Choices) -> Result<Vec<Picture>, FigureError> {
    let only = |svg: String| vec![Picture { suffix: "", svg }];
    let table = source.table;
    if work_precision::is_one(table) {
        choices.check("work and precision", false, false)?;
        let mut pictures = only(work_precision::draw(table, Cost::Time)?);
        pictures.push(Picture {
            suffix: "-evaluations",
            svg: work_precision::draw(table, Cost::Evaluations)?,
        });
        return Ok(pictures);
    }
    if is_history(table) {
        return overlay(std::slice::from_ref(source), choices).map(only);
    }
    let caption = caption(source)?;
    if sensitivity_table::is_one(table) {
        choices.check("sensitivities", false, false)?;
        let table = SensitivityTable::parse(table)?;
        return tornado_chart::draw(&table, &caption).map(only);
    }
    if probability_chart::is_one(table) {
        choices.check("probabilities", false, false)?;
        return probability_chart::draw(table, &caption).map(only);
    }
    if distribution_chart::is_one(table) {
        choices.check("a distribution", false, false)?;
        return distribution_chart::draw(table, &caption).map(only);
    }
    if outcome_chart::is_one(table) {
        choices.check("landings", false, false)?;
        return outcome_chart::draw(table, &caption).map(only);
    }
    choices.check("a sweep", true, false)?;
    if map_table::is_one(table) {
        let map = MapTable::parse(table, source.edges, source.points, source.grid)?;
        let divisions = map.axes.each_ref().map(|axis| caption.division(axis));
        let map = map.placed(divisions);
        let levels = choices.levels.as_ref();
        return Ok(vec![
            Picture {
                suffix: "-contours",
                svg: refined_map::contours(&map, levels, &caption),
            },
            Picture {
                suffix: "-perspective",
                svg: refined_map::perspective(&map, levels, &caption),
            },
        ]);
    }
    let all: Vec<String> = (BoundaryTable::axes(table)?.into_iter())
        .map(|axis| axis.name)
        .collect();
    let axes = match choices.worst_by.as_slice() {
        [] => drawn_axes(table)?,
        axes => axes.to_vec(),
    };
    let table = BoundaryTable::worst_by(table, &axes)?;
    let caption = caption.worst_over(&table.others);
    match axes.len() {
        1 => {
            let bands = source.bands.filter(|_| axes == all);
            let bands = bands.map(BandsTable::parse).transpose()?;
            if let Some(bands) = &bands {
                bands.check_against(&table)?;
            }
            boundary_profile::draw(&table, bands.as_ref(), &caption).map(only)
        }
        2 => over_two_axes(table, choices.levels.as_ref(), &caption),
        count => Err(FigureError::NoPicture(format!(
            "{count} axes cannot be drawn: expected one or two of {}",
            all.join(", ")
        ))),
    }
}

/// Returns whether a table is one of histories.
pub fn is_history(table: &str) -> bool {
    history_table::is_history(table)
}

/// Draws histories over each other.
///
/// # Errors
/// When a table is not one of histories, or has none of the columns that were chosen.
pub fn overlay(sources: &[Source], choices: &Choices) -> Result<String, FigureError> {
    choices.check("histories", false, true)?;
    let named = |source: &Source| Ok((source.name.to_owned(), HistoryTable::parse(source.table)?));
    let tables = sources.iter().map(named);
    let tables = tables.collect::<Result<Vec<_>, FigureError>>()?;
    let caption = match sources {
        [source] => caption(source)?,
        _ => Caption {
            title: "Histories of landings".to_owned(),
            ..Caption::default()
        },
    };
    history_chart::draw(&tables, &choices.columns, &caption)
}

fn caption(source: &Source) -> Result<Caption, FigureError> {
    Caption::of_table(source.name, source.table, source.record)
}

/// The axes over which a sweep is drawn: all if there are no more than two, or the two with the most values. Axes of
/// words, and axes of a single value next to others, are not drawn over.
fn drawn_axes(table: &str) -> Result<Vec<String>, FigureError> {
    let mut axes = BoundaryTable::axes(table)?;
    if axes.len() > 1 {
        let drawable = |axis: &Axis| axis.is_numeric && axis.values > 1;
        axes.retain(drawable);
    }
    while axes.len() > 2 {
        let values = axes.iter().map(|axis| axis.values);
        let least = values.min().unwrap_or(0);
        if let Some(last) = axes.iter().rposition(|axis| axis.values == least) {
            axes.remove(last);
        }
    }
    match axes.as_slice() {
        [] => Err(FigureError::NoPicture(
            "no axis has numbers to draw over".to_owned(),
        )),
        axes => Ok(axes.iter().map(|axis| axis.name.clone()).collect()),
    }
}

/// A map and a view. If cross-slopes of both signs were swept, also a map of the negative ones with both scales
/// reversed, which symmetry would make equal to the first.
fn over_two_axes(
    table: BoundaryTable,
    levels: Option<&Levels>,
    caption: &Caption,
) -> Result<Vec<Picture>, FigureError> {
    let divisions: Vec<Division> = (table.axes.iter())
        .map(|axis| caption.division(axis))
        .collect();
    let is_cross_slope = table.axes[0] == "cross_slope_deg" && divisions[0] == Division::Linear;
    let table = table.changed(|axis, value| divisions[axis].place(value));
    let Some(surface) = Surface::of(&table, |slow| !is_cross_slope || slow >= 0.0) else {
        return Err(FigureError::NoPicture(format!(
            "its points over {} do not fill a grid of at least 2 by 2",
            table.axes.join(" and ")
        )));
    };
    let levels = levels.map_or_else(|| Levels::of(&surface), Levels::clone);
    let view = View::of(&surface, caption);
    let mut pictures = vec![
        Picture {
            suffix: "-contours",
            svg: contour_map::draw(&surface, &view, &levels, caption),
        },
        Picture {
            suffix: "-perspective",
            svg: perspective::draw(&surface, &levels, caption),
        },
    ];
    let has_negative = table.points.iter().any(|point| point.coordinates[0] < 0.0);
    if is_cross_slope
        && has_negative
        && let Some(surface) = Surface::of(&mirrored(table), |slow| slow >= 0.0)
    {
        let caption = Caption {
            title: format!("{}, signs of both scales reversed", caption.title),
            ..caption.clone()
        };
        pictures.push(Picture {
            suffix: "-contours-negative",
            svg: contour_map::draw(&surface, &view.mirrored(), &levels, &caption),
        });
    }
    Ok(pictures)
}

/// The table with the signs of both axes reversed; straight downhill stays where it is.
fn mirrored(table: BoundaryTable) -> BoundaryTable {
    table.changed(|axis, value| match (axis, value) {
        (0, 180.0) => value,
        _ => -value + 0.0,
    })
}

#[cfg(test)]
#[path = "picture_tests.rs"]
mod tests;
