//! Reads histories of landings: quantities over time, for one landing or several.

use crate::tables::{Table, has_column};
use crate::words::FigureError;

/// The column that makes a table one of histories.
pub const TIME: &str = "t_s";
/// Column that tells whether something touches the surface: 0 in free flight.
const TOUCHES: &str = "touches";
/// Part of the name of a column of printed values, before its unit.
const PRINTED: &str = "_1966";

/// Names of columns up to version 0.1, and those they have now.
const RENAMED: [(&str, &str); 6] = [
    ("psi", "pitch"),
    ("phi", "yaw"),
    ("xi", "roll"),
    ("omega_x", "angular_velocity_x"),
    ("omega_y", "angular_velocity_y"),
    ("omega_z", "angular_velocity_z"),
];

/// Histories of the same quantities.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryTable {
    /// Name of the condition that distinguishes landings, if there are several.
    pub condition: Option<String>,
    /// Names of the quantities, with units.
    pub quantities: Vec<String>,
    /// The landings, in the order of the table.
    pub landings: Vec<History>,
}

/// One landing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// Value of the condition that distinguishes it.
    pub condition: Option<f64>,
    /// Its instants.
    pub instants: Vec<Instant>,
}

/// An instant of a landing.
#[derive(Debug, Clone, PartialEq)]
pub struct Instant {
    /// Time after first contact, s.
    pub time: f64,
    /// True if nothing touches the surface, as far as the table tells.
    pub is_free: bool,
    /// The quantities.
    pub values: Vec<f64>,
    /// Their values printed in 1966.
    pub printed: Vec<Option<f64>>,
}

/// Returns whether the heading of a table is one of histories.
pub fn is_history(csv: &str) -> bool {
    has_column(csv, &[TIME])
}

/// The name that a column has now: with the words of input files.
pub fn present_name(column: &str) -> String {
    let renamed = RENAMED.iter().find_map(|(old, new)| {
        let rest = column.strip_prefix(old)?;
        rest.starts_with('_').then(|| format!("{new}{rest}"))
    });
    renamed.unwrap_or_else(|| column.to_owned())
}

impl HistoryTable {
    /// Reads a table of histories: the column of a condition if landings differ in it, time, quantities, their printed
    /// values (`name_1966_unit`), and `touches`.
    ///
    /// # Errors
    /// Names the row and column that is no number.
    pub fn parse(csv: &str) -> Result<Self, FigureError> {
        let table = Table::parse(csv)?;
        let names = table.names();
        let time = table.column(TIME)?;
        let (touches, condition) = (table.find(TOUCHES), (time > 0).then_some(0));
        let quantities: Vec<usize> = (time + 1..names.len())
            .filter(|index| Some(*index) != touches && !names[*index].contains(PRINTED))
            .collect();
        if quantities.is_empty() {
            return Err(FigureError::Table(format!("no quantity after {TIME}")));
        }
        let printed: Vec<Option<usize>> = quantities
            .iter()
            .map(|index| {
                let (name, unit) = names[*index].rsplit_once('_')?;
                table.find(&format!("{name}{PRINTED}_{unit}"))
            })
            .collect();
        let mut landings: Vec<History> = Vec::new();
        for row in table.nonempty_rows()? {
            let number = |column: usize| row.number(column);
            let told = |column: &Option<usize>| {
                column.map_or(Ok(None), |column| row.optional_number(column))
            };
            let instant = Instant {
                time: number(time)?,
                is_free: touches.map(number).transpose()? == Some(0.0),
                values: quantities
                    .iter()
                    .map(|column| number(*column))
                    .collect::<Result<_, _>>()?,
                printed: printed.iter().map(told).collect::<Result<_, _>>()?,
            };
            let condition = condition.map(number).transpose()?;
            match landings.last_mut() {
                Some(last) if last.condition == condition => last.instants.push(instant),
                _ => landings.push(History {
                    condition,
                    instants: vec![instant],
                }),
            }
        }
        let named = |column: usize| present_name(names[column]);
        Ok(Self {
            condition: condition.map(named),
            quantities: quantities.into_iter().map(named).collect(),
            landings,
        })
    }

    /// Time of the last instant of all, s.
    pub fn end(&self) -> f64 {
        let instants = self.landings.iter().flat_map(|landing| &landing.instants);
        instants.map(|instant| instant.time).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn landings_are_told_apart_by_the_column_before_time() {
        // The name of the column is one of the time before input's words.
        let text = "tip_azimuth_deg,t_s,psi_deg,touches\n90,0,1,1\n90,0.5,2,0\n-90,0,3,1\n";
        assert!(is_history(text));
        let table = HistoryTable::parse(text).unwrap();
        assert_eq!(table.condition.as_deref(), Some("tip_azimuth_deg"));
        assert_eq!(table.quantities, ["pitch_deg"]);
        assert_eq!(table.landings.len(), 2);
        let first = &table.landings[0];
        assert_eq!(first.condition, Some(90.0));
        assert!(!first.instants[0].is_free && first.instants[1].is_free);
        assert_eq!(table.end(), 0.5);
    }

    #[test]
    fn printed_values_belong_to_their_quantity_and_may_be_missing() {
        let text = "t_s,x_rate_fps,y_rate_fps,y_rate_1966_fps\n0,1,2,2.1\n1,1,2,\n";
        let table = HistoryTable::parse(text).unwrap();
        assert_eq!(table.quantities, ["x_rate_fps", "y_rate_fps"]);
        let printed: Vec<_> = table.landings[0]
            .instants
            .iter()
            .map(|i| &i.printed)
            .collect();
        assert_eq!(*printed[0], [None, Some(2.1)]);
        assert_eq!(*printed[1], [None, None]);
    }

    #[test]
    fn complaints_name_row_and_column() {
        let complaint = |text: &str| HistoryTable::parse(text).unwrap_err().to_string();
        assert!(complaint("a,b\n1,2\n").contains("column t_s is missing"));
        assert!(complaint("t_s\n1\n").contains("no quantity after t_s"));
        assert!(complaint("t_s,z_ft\n").contains("no rows"));
        assert!(complaint("t_s,z_ft\n0,up\n").contains("row 1: z_ft = up"));
    }
}
