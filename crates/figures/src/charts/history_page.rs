//! Panels of a picture of histories, and their curves.

use crate::axis_title::{axis_title, column_words};
use crate::history_table::present_name;
use crate::unit::{in_si, unit_of};
use crate::words::FigureError;

/// A panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Quantity and unit.
    pub title: String,
    /// Its curves.
    pub curves: Vec<Curve>,
}

/// A curve: a column, or the sum of several.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name within its panel.
    pub name: String,
    /// Columns whose sum it shows.
    pub columns: Vec<String>,
}

/// Most columns of a table for which each has its own panel.
const FEW: usize = 6;

/// The panels by which a landing is judged: quantity, and name and columns of each curve, named in units of 1966. A `#`
/// stands for the number of a leg.
type PagePanel = (
    &'static str,
    &'static [(&'static str, &'static [&'static str])],
);
const PAGE: [PagePanel; 6] = [
    (
        "Velocity",
        &[
            ("across", &["x_rate_fps"]),
            ("up the slope", &["y_rate_fps"]),
            ("down", &["z_rate_fps"]),
        ],
    ),
    (
        "Attitude",
        &[
            ("pitch Ψ", &["pitch_deg"]),
            ("yaw Φ", &["yaw_deg"]),
            ("roll Ξ", &["roll_deg"]),
        ],
    ),
    ("Stability angle σ", &[("σ", &["sigma_deg"])]),
    ("Strut force", &[("leg #", &["strut_force_#_lb"])]),
    ("Footpad load", &[("leg #", &["pad_normal_#_lb"])]),
    (
        "Energy",
        &[
            ("kinetic", &["kinetic_energy_ftlb"]),
            ("released by gravity", &["potential_energy_change_ftlb"]),
            ("work of the thrust", &["thrust_work_ftlb"]),
            ("work on struts", &["strut_work_#_ftlb"]),
            (
                "crushing",
                &["pad_crush_work_#_ftlb", "block_crush_work_#_ftlb"],
            ),
            (
                "friction",
                &["pad_friction_work_#_ftlb", "block_friction_work_#_ftlb"],
            ),
        ],
    ),
];

/// The panels of a table with these quantities.
pub fn panels(quantities: &[String]) -> Vec<Panel> {
    let page: Vec<Panel> = PAGE
        .iter()
        .filter_map(|panel| of_page(quantities, panel))
        .collect();
    if quantities.len() > FEW && !page.is_empty() {
        return page;
    }
    let panel = |column: &String| Panel {
        title: axis_title(column),
        curves: vec![curve(column)],
    };
    quantities.iter().map(panel).collect()
}

/// A panel of the page, if the table has a column for it.
fn of_page(quantities: &[String], (title, curves): &PagePanel) -> Option<Panel> {
    let mut found = Vec::new();
    for (name, patterns) in *curves {
        let columns: Vec<String> = patterns
            .iter()
            .flat_map(|pattern| {
                let in_si = in_si(pattern).unwrap_or_default();
                [matching(quantities, pattern), matching(quantities, &in_si)].concat()
            })
            .collect();
        if name.contains('#') {
            found.extend(columns.into_iter().enumerate().map(|(leg, column)| Curve {
                name: name.replace('#', &(leg + 1).to_string()),
                columns: vec![column],
            }));
        } else if !columns.is_empty() {
            found.push(Curve {
                name: (*name).to_owned(),
                columns,
            });
        }
    }
    let unit = unit_of(found.first()?.columns.first()?);
    Some(Panel {
        title: format!("{title}, {unit}"),
        curves: found,
    })
}

/// Panels of chosen columns, one for each unit. A `#` in a name stands for the number of any leg.
///
/// # Errors
/// Names the column that the table does not have.
pub fn chosen(quantities: &[String], names: &[String]) -> Result<Vec<Panel>, FigureError> {
    let mut panels: Vec<(String, Vec<Curve>)> = Vec::new();
    for name in names.iter().map(|name| present_name(name)) {
        let columns = matching(quantities, &name);
        if columns.is_empty() {
            return Err(FigureError::Table(format!(
                "has no column {name}: expected {}",
                patterns(quantities).join(", ")
            )));
        }
        let unit = unit_of(&name);
        let curves = columns.iter().map(|column| curve(column));
        match panels.iter_mut().find(|(known, _)| *known == unit) {
            Some((_, panel)) => panel.extend(curves),
            None => panels.push((unit, curves.collect())),
        }
    }
    let panel = |(unit, curves): (String, Vec<Curve>)| Panel {
        title: match curves.as_slice() {
            [curve] => axis_title(&curve.columns[0]),
            _ => of_unit(&unit),
        },
        curves,
    };
    Ok(panels.into_iter().map(panel).collect())
}

fn curve(column: &str) -> Curve {
    Curve {
        name: column_words(column),
        columns: vec![column.to_owned()],
    }
}

/// Title of an axis that several quantities with one unit share.
fn of_unit(unit: &str) -> String {
    let quantity = match unit {
        "deg" => "Angle",
        "deg/s" => "Angular velocity",
        "ft" | "m" => "Length",
        "ft/s" | "m/s" => "Velocity",
        "lb" | "N" => "Force",
        "ft lb" | "J" => "Energy and work",
        "" => return "Number".to_owned(),
        unit => return unit.to_owned(),
    };
    format!("{quantity}, {unit}")
}

/// Names of columns, with `#` for the number of a leg, each once.
fn patterns(columns: &[String]) -> Vec<String> {
    let mut patterns: Vec<String> = Vec::new();
    for column in columns {
        let words = column.split('_').map(|word| match word.as_bytes() {
            [b'1'..=b'9'] => "#",
            _ => word,
        });
        let pattern = words.collect::<Vec<_>>().join("_");
        if !patterns.contains(&pattern) {
            patterns.push(pattern);
        }
    }
    patterns
}

/// The columns that match a name with or without `#`.
fn matching(columns: &[String], name: &str) -> Vec<String> {
    let is_match = |column: &&String| match name.split_once('#') {
        None => *column == name,
        Some((before, after)) => {
            let leg = column.strip_prefix(before);
            let leg = leg.and_then(|rest| rest.strip_suffix(after));
            leg.is_some_and(|leg| leg.len() == 1 && leg.as_bytes()[0].is_ascii_digit())
        }
    };
    columns.iter().filter(is_match).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn owned(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    fn titles(panels: &[Panel]) -> Vec<(&str, usize)> {
        let told = panels.iter();
        told.map(|panel| (panel.title.as_str(), panel.curves.len()))
            .collect()
    }

    #[test]
    fn a_landing_has_a_page_and_few_columns_a_panel_each() {
        let columns = owned(&[
            "z_ft",
            "x_rate_fps",
            "z_rate_fps",
            "pitch_deg",
            "sigma_deg",
            "strut_force_1_lb",
            "strut_force_2_lb",
            "strut_work_1_ftlb",
            "strut_work_2_ftlb",
            "kinetic_energy_ftlb",
        ]);
        let panels = panels(&columns);
        assert_eq!(
            titles(&panels),
            [
                ("Velocity, ft/s", 2),
                ("Attitude, deg", 1),
                ("Stability angle σ, deg", 1),
                ("Strut force, lb", 2),
                ("Energy, ft lb", 2)
            ]
        );
        assert_eq!(panels[3].curves[1].name, "leg 2");
        let in_si: Vec<String> = (columns.iter())
            .map(|column| in_si(column).unwrap_or_else(|| column.clone()))
            .collect();
        assert_eq!(
            titles(&super::panels(&in_si)),
            [
                ("Velocity, m/s", 2),
                ("Attitude, deg", 1),
                ("Stability angle σ, deg", 1),
                ("Strut force, N", 2),
                ("Energy, J", 2)
            ]
        );
        let work = &panels[4].curves[1];
        assert_eq!(work.columns, ["strut_work_1_ftlb", "strut_work_2_ftlb"]);
        let few = super::panels(&columns[..3]);
        assert_eq!(
            titles(&few),
            [
                ("Position down, ft", 1),
                ("Velocity across, ft/s", 1),
                ("Velocity down, ft/s", 1)
            ]
        );
    }

    #[test]
    fn chosen_columns_share_a_panel_if_they_share_their_unit() {
        let columns = owned(&["pitch_deg", "stroke_1_ft", "stroke_2_ft", "roll_deg"]);
        let panels = chosen(&columns, &owned(&["pitch_deg", "stroke_#_ft", "roll_deg"])).unwrap();
        assert_eq!(titles(&panels), [("Angle, deg", 2), ("Length, ft", 2)]);
        assert_eq!(panels[1].curves[0].name, "stroke, leg 1");
        let complaint = chosen(&columns, &owned(&["stroke_ft"])).unwrap_err();
        let complaint = complaint.to_string();
        assert!(
            complaint.contains("no column stroke_ft: expected pitch_deg, stroke_#_ft, roll_deg")
        );
    }
}
