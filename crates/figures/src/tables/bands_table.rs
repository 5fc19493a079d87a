//! Reads tables of bands: the ranges of speed at each point with the same outcome.

use crate::boundary_table::{BoundaryTable, Kind, Point};
use crate::tables::Table;
use crate::words::FigureError;

/// Columns that follow the axes.
const COLUMNS: [&str; 4] = ["band", "from_fps", "to_fps", "outcome"];

/// A range of speeds at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// Outcome of landings in it; `None` if they are stable.
    pub kind: Option<Kind>,
}

/// The bands of every point, in the order of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct BandsTable {
    /// Coordinates of each point, and its bands from below.
    pub points: Vec<(Vec<f64>, Vec<Band>)>,
}

impl BandsTable {
    /// Reads a table of bands.
    ///
    /// # Errors
    /// Names the row and column that is not as the sweep writes it.
    pub fn parse(csv: &str) -> Result<Self, FigureError> {
        Self::read(csv).map_err(|error| match error {
            FigureError::Table(complaint) => FigureError::Table(format!("bands: {complaint}")),
            other => other,
        })
    }

    fn read(csv: &str) -> Result<Self, FigureError> {
        let table = Table::parse(csv)?;
        let [first, from, to, outcome] = COLUMNS.map(|name| table.column(name));
        let [first, from, to, outcome] = [first?, from?, to?, outcome?];
        let mut points: Vec<(Vec<f64>, Vec<Band>)> = Vec::new();
        for row in table.rows() {
            let kind = match row.text(outcome) {
                "stable" => None,
                name => Some(Kind::from_name(name).ok_or_else(|| {
                    row.error(outcome, "stable, unstable, bottomed, failure or undecided")
                })?),
            };
            let band = Band {
                from: row.velocity(from)?,
                to: row.velocity(to)?,
                kind,
            };
            let coordinates: Vec<f64> = (0..first)
                .map(|axis| row.number(axis))
                .collect::<Result<_, _>>()?;
            // A point's first band is number 1, whatever the rows before.
            match points.last_mut() {
                Some((last, bands)) if *last == coordinates && row.number(first)? > 1.0 => {
                    bands.push(band);
                }
                _ => points.push((coordinates, vec![band])),
            }
        }
        Ok(Self { points })
    }

    /// Checks that these are the bands of a result table: at each point the first band that is not stable begins at the
    /// first transition.
    ///
    /// # Errors
    /// Names the first point at which they do not fit together.
    pub fn check_against(&self, table: &BoundaryTable) -> Result<(), FigureError> {
        let fits = |point: &Point| {
            let first = (self.at(&point.coordinates).iter()).find(|band| band.kind.is_some());
            match (first, point.transition) {
                (None, None) => true,
                (Some(band), Some(found)) => {
                    band.kind == Some(found.kind)
                        && found
                            .low
                            .is_none_or(|low| (low..=found.high).contains(&band.from))
                }
                _ => false,
            }
        };
        match table.points.iter().position(|point| !fits(point)) {
            None => Ok(()),
            Some(row) => Err(FigureError::Table(format!(
                "bands: they do not belong to this table, whose row {} has another first transition: run the sweep again",
                row + 1
            ))),
        }
    }

    /// The bands at a point; none when the table lacks it.
    pub fn at(&self, coordinates: &[f64]) -> &[Band] {
        self.points
            .iter()
            .find(|(place, _)| place == coordinates)
            .map_or(&[], |(_, bands)| bands)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps,kind\n\
                         0,1,0,11.4,stable,0.001,stable-rockback\n\
                         0,2,11.4,25,unstable,,unstable-pitch\n\
                         5,1,0,25,stable,,stable-subsided\n";

    #[test]
    fn bands_are_gathered_by_point() {
        let table = BandsTable::parse(TABLE).unwrap();
        assert_eq!(table.points.len(), 2);
        let bands = table.at(&[0.0]);
        assert_eq!(bands[1].kind, Some(Kind::Unstable));
        assert_eq!((bands[1].from, bands[1].to), (11.4, 25.0));
        assert!(table.at(&[1.0]).is_empty());
    }

    #[test]
    fn complaints_name_row_and_column() {
        let complaint = |text: &str| BandsTable::parse(text).unwrap_err().to_string();
        assert!(complaint("a,b\n").contains("bands: column band is missing"));
        let absurd = TABLE.replace(",25,", ",1e9,");
        assert!(complaint(&absurd).contains("bands: row 2: to_fps = 1e9"));
        let odd = TABLE.replace(",unstable,", ",odd,");
        assert!(complaint(&odd).contains("bands: row 2: outcome = odd"));
    }
}
