//! Which pictures a result table gives.

use crate::bands_table::BandsTable;
use crate::boundary_profile;
use crate::boundary_table::BoundaryTable;
use crate::caption::Caption;
use crate::contour_map;
use crate::distribution_chart;
use crate::figure_error::FigureError;
use crate::history_chart;
use crate::history_table::{self, HistoryTable};
use crate::map_view::View;
use crate::perspective;
use crate::probability_chart;
use crate::sensitivity_table::{self, SensitivityTable};
use crate::surface::Surface;
use crate::tornado_chart;
use crate::work_precision;

/// A picture and what is appended to the table's name to name it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// What follows the stem of the table's name, empty for the only picture.
    pub suffix: &'static str,
    /// The picture.
    pub svg: String,
}

/// Draws all pictures of a result table: a profile for one axis, a contour map and a perspective
/// view for a grid of two, none for anything else; for a table of histories, one of these, for one of
/// sensitivities a tornado chart.
///
/// # Errors
/// When a table is not one that a sweep writes, or a record is not JSON.
pub fn draw(
    table: &str,
    bands: Option<&str>,
    record: Option<&str>,
) -> Result<Vec<Picture>, FigureError> {
    if work_precision::is_one(table) {
        return Ok(vec![Picture {
            suffix: "",
            svg: work_precision::draw(table)?,
        }]);
    }
    let caption = match record {
        Some(record) => Caption::from_record(record)?,
        None => Caption::default(),
    };
    if history_table::is_history(table) {
        return Ok(vec![Picture {
            suffix: "",
            svg: history_chart::draw(&HistoryTable::parse(table)?, &caption)?,
        }]);
    }
    if sensitivity_table::is_one(table) {
        return Ok(vec![Picture {
            suffix: "",
            svg: tornado_chart::draw(&SensitivityTable::parse(table)?, &caption)?,
        }]);
    }
    if probability_chart::is_one(table) {
        return Ok(vec![Picture {
            suffix: "",
            svg: probability_chart::draw(table, &caption)?,
        }]);
    }
    if distribution_chart::is_one(table) {
        return Ok(vec![Picture {
            suffix: "",
            svg: distribution_chart::draw(table, &caption)?,
        }]);
    }
    let table = BoundaryTable::parse(table)?;
    let bands = bands.map(BandsTable::parse).transpose()?;
    if let Some(bands) = &bands {
        bands.check_against(&table)?;
    }
    match table.axes.len() {
        1 => Ok(vec![Picture {
            suffix: "",
            svg: boundary_profile::draw(&table, bands.as_ref(), &caption)?,
        }]),
        2 => over_two_axes(&table, &caption),
        _ => Ok(Vec::new()),
    }
}

/// A map and a view; where cross-slopes of both signs were swept, another map of the negative ones
/// with both scales reversed, which symmetry would make equal to the first.
fn over_two_axes(table: &BoundaryTable, caption: &Caption) -> Result<Vec<Picture>, FigureError> {
    let is_cross_slope = table.axes[0] == "cross_slope_deg";
    let Some(surface) = Surface::of(table, |slow| !is_cross_slope || slow >= 0.0) else {
        return Ok(Vec::new());
    };
    let view = View::of(&surface);
    let mut pictures = vec![
        Picture {
            suffix: "-contours",
            svg: contour_map::draw(&surface, &view, caption)?,
        },
        Picture {
            suffix: "-perspective",
            svg: perspective::draw(&surface, caption)?,
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
            svg: contour_map::draw(&surface, &view.mirrored(), &caption)?,
        });
    }
    Ok(pictures)
}

/// The table with the signs of both axes reversed; straight downhill stays where it is.
fn mirrored(table: &BoundaryTable) -> BoundaryTable {
    let mut table = table.clone();
    for point in &mut table.points {
        for (axis, value) in point.coordinates.iter_mut().enumerate() {
            if axis != 0 || *value != 180.0 {
                *value = -*value + 0.0;
            }
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::tests::TABLE;

    fn suffixes(table: &str) -> Vec<&'static str> {
        let pictures = draw(table, None, None).unwrap();
        pictures.into_iter().map(|picture| picture.suffix).collect()
    }

    #[test]
    fn two_axes_have_a_map_and_a_view_and_negative_cross_slopes_a_map_of_their_own() {
        assert_eq!(suffixes(TABLE), ["-contours", "-perspective"]);
        let (heading, rows) = TABLE.split_once('\n').unwrap();
        let negative: Vec<String> = rows
            .lines()
            .filter(|row| !row.starts_with("180"))
            .map(|row| format!("-{row}\n"))
            .collect();
        let both = format!("{heading}\n{rows}{}", negative.concat());
        assert_eq!(suffixes(&both).last(), Some(&"-contours-negative"));
    }

    #[test]
    fn three_axes_and_single_rows_have_no_picture() {
        let row: String = TABLE
            .lines()
            .take(5)
            .map(|line| format!("{line}\n"))
            .collect();
        assert!(suffixes(&row).is_empty());
        let three = row
            .replace("cross", "slope_deg,cross")
            .replace("\n80", "\n15,80");
        assert!(suffixes(&three).is_empty());
    }
}
