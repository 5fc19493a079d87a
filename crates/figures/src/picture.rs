//! The pictures of a result table.

use crate::bands_table::BandsTable;
use crate::boundary_profile;
use crate::boundary_table::{Axis, BoundaryTable};
use crate::caption::Caption;
use crate::contour_map;
use crate::distribution_chart;
use crate::division::Division;
use crate::heights::Heights;
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
use crate::tables::{Cells, Table};
use crate::tornado_chart;
use crate::words::FigureError;
use crate::work_precision::{self, Cost};

/// A picture, and the suffix of its name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Suffix to the stem of the table's name, empty for the only picture.
    pub suffix: String,
    /// The picture.
    pub svg: String,
}

/// Suffixes of the pictures of maps.
const CONTOURS: &str = "-contours";
const PERSPECTIVE: &str = "-perspective";

impl Picture {
    /// A picture of some kind, of a family at these cells of its other axes.
    fn new(kind: &str, cells: &[(String, String)], svg: String) -> Self {
        let words = cells.iter().map(|(axis, value)| format!("-{axis}={value}"));
        let words = words.collect::<String>();
        let is_for_names = |letter: &char| letter.is_alphanumeric() || "-_.=+".contains(*letter);
        let words = words.chars().filter(is_for_names);
        Self {
            suffix: kind.chars().chain(words).collect(),
            svg,
        }
    }
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
/// a perspective, over more the same for the lowest transitions over the others; over three also a contour map for each value
/// of the third. A refined map over more than two axes gives a contour map for each of the values of the others. Histories
/// give a chart, sensitivities a tornado chart, and landings over two axes a chart of outcomes.
///
/// # Errors
/// When a table is not one that the program writes, a record is not JSON, a table has no picture, or
/// something was chosen that the table does not have.
pub fn draw(source: &Source, choices: &Choices) -> Result<Vec<Picture>, FigureError> {
    let only = |svg: String| vec![Picture::new("", &[], svg)];
    let table = source.table;
    if work_precision::is_one(table) {
        choices.check("work and precision", false, false)?;
        let mut pictures = only(work_precision::draw(table, Cost::Time)?);
        let evaluations = work_precision::draw(table, Cost::Evaluations)?;
        pictures.push(Picture::new("-evaluations", &[], evaluations));
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
    let levels = choices.levels.as_ref();
    if map_table::is_one(table) {
        return refined_maps(source, levels, &caption);
    }
    let all: Vec<String> = (BoundaryTable::axes(table)?.into_iter())
        .map(|axis| axis.name)
        .collect();
    let axes = match choices.worst_by.as_slice() {
        [] => drawn_axes(table)?,
        axes => axes.to_vec(),
    };
    let table = BoundaryTable::worst_by(table, &axes)?;
    let of_each = match table.others.as_slice() {
        [_] if choices.worst_by.is_empty() && axes.len() == 2 => {
            family(source.table, &table, levels, &caption)?
        }
        _ => Vec::new(),
    };
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
        2 => {
            let mut pictures = over_two_axes(table, levels, &caption)?;
            pictures.extend(of_each);
            Ok(pictures)
        }
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

/// A contour map and a perspective of a refined map; of one over more than two axes a family of contour maps, one for each of
/// the values of the others.
fn refined_maps(
    source: &Source,
    levels: Option<&Levels>,
    caption: &Caption,
) -> Result<Vec<Picture>, FigureError> {
    let tables = [source.edges, source.points, source.grid];
    let placed = |(cells, map): (Cells, MapTable)| {
        let divisions = map.axes.each_ref().map(|axis| caption.division(axis));
        (cells, map.placed(divisions))
    };
    let family = map_table::family(source.table, tables)?.into_iter();
    let family: Vec<(Cells, MapTable)> = family.map(placed).collect();
    let heights = Heights::of_maps(family.iter().map(|(_, map)| map), levels);
    let contours = |(cells, map): &(Cells, MapTable)| {
        let svg = refined_map::contours(map, &heights, &caption.at(cells));
        Picture::new(CONTOURS, cells, svg)
    };
    let mut pictures: Vec<Picture> = family.iter().map(contours).collect();
    if let [(cells, map)] = family.as_slice()
        && cells.is_empty()
    {
        let svg = refined_map::perspective(map, &heights, caption);
        pictures.push(Picture::new(PERSPECTIVE, &[], svg));
    }
    Ok(pictures)
}

/// Contour maps of a sweep over three axes, one for each value of the axis over which `worst` is the worst case. Those are
/// left out whose points do not fill a grid, as may be while a sweep is not complete.
fn family(
    table: &str,
    worst: &BoundaryTable,
    levels: Option<&Levels>,
    caption: &Caption,
) -> Result<Vec<Picture>, FigureError> {
    let table = Table::parse(table)?;
    let mut family = Vec::new();
    for cells in table.different(&worst.others)? {
        let table = BoundaryTable::worst_of(&table.with(&cells)?, &worst.axes)?;
        family.extend(Sides::of(table, caption).map(|sides| (cells, sides)));
    }
    let heights = Heights::of_surfaces(family.iter().flat_map(|(_, sides)| sides.all()), levels);
    let contours =
        |(cells, sides): &(Cells, Sides)| sides.contours(&heights, &caption.at(cells), cells);
    Ok(family.iter().flat_map(contours).collect())
}

/// Contour maps and a view.
fn over_two_axes(
    table: BoundaryTable,
    levels: Option<&Levels>,
    caption: &Caption,
) -> Result<Vec<Picture>, FigureError> {
    let axes = table.axes.join(" and ");
    let Some(sides) = Sides::of(table, caption) else {
        return Err(FigureError::NoPicture(format!(
            "its points over {axes} do not fill a grid of at least 2 by 2"
        )));
    };
    let levels = levels.map_or_else(|| Levels::of(&sides.surface), Levels::clone);
    let heights = Heights::of_surfaces(sides.all(), Some(&levels));
    let mut pictures = sides.contours(&heights, caption, &[]);
    let svg = perspective::draw(&sides.surface, &heights, caption);
    pictures.insert(1, Picture::new(PERSPECTIVE, &[], svg));
    Ok(pictures)
}

/// What a table over two axes shows.
struct Sides {
    view: View,
    surface: Surface,
    /// If cross-slopes of both signs were swept, the negative ones with both scales reversed, which symmetry would make
    /// equal to the others.
    mirrored: Option<Surface>,
}

impl Sides {
    /// `None` where the points of a table do not fill a grid.
    fn of(table: BoundaryTable, caption: &Caption) -> Option<Self> {
        let divisions: Vec<Division> = (table.axes.iter())
            .map(|axis| caption.division(axis))
            .collect();
        let is_cross_slope = table.axes[0] == "cross_slope_deg" && divisions[0] == Division::Linear;
        let table = table.changed(|axis, value| divisions[axis].place(value));
        let surface = Surface::of(&table, |slow| !is_cross_slope || slow >= 0.0)?;
        let has_negative = table.points.iter().any(|point| point.coordinates[0] < 0.0);
        let has_two = is_cross_slope && has_negative;
        Some(Self {
            view: View::of(&surface, caption),
            surface,
            mirrored: has_two
                .then(|| Surface::of(&mirrored(table), |slow| slow >= 0.0))
                .flatten(),
        })
    }

    fn all(&self) -> impl Iterator<Item = &Surface> {
        [&self.surface].into_iter().chain(&self.mirrored)
    }

    /// Contour maps of all sides, at some cells of the other axes of a sweep.
    fn contours(
        &self,
        heights: &Heights,
        caption: &Caption,
        cells: &[(String, String)],
    ) -> Vec<Picture> {
        let svg = contour_map::draw(&self.surface, &self.view, heights, caption);
        let mut pictures = vec![Picture::new(CONTOURS, cells, svg)];
        if let Some(surface) = &self.mirrored {
            let caption = Caption {
                title: format!("{}, signs of both scales reversed", caption.title),
                ..caption.clone()
            };
            let svg = contour_map::draw(surface, &self.view.mirrored(), heights, &caption);
            pictures.push(Picture::new("-contours-negative", cells, svg));
        }
        pictures
    }
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
