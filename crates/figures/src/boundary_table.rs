//! Result tables of sweeps, read back: axes and the first transition at each point.

use csv::StringRecord;

use crate::figure_error::FigureError;

const KIND: &str = "first_transition_to";
const SPEED: &str = "first_transition_fps";
const LOW: &str = "bracket_low_fps";
const HIGH: &str = "bracket_high_fps";

/// How landings end above a transition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The vehicle topples.
    Unstable,
    /// A strut bottoms.
    Bottomed,
    /// The landing cannot be computed.
    Failure,
}

impl Kind {
    /// Its word in result tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Unstable => "unstable",
            Self::Bottomed => "bottomed",
            Self::Failure => "failure",
        }
    }

    /// The kind that a word of a result table stands for.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "unstable" => Some(Self::Unstable),
            "bottomed" => Some(Self::Bottomed),
            "failure" => Some(Self::Failure),
            _ => None,
        }
    }
}

/// A transition, ft/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// What begins there.
    pub kind: Kind,
    /// Speed, ft/s.
    pub speed: f64,
    /// Bracket of the speed, ft/s.
    pub bracket: [f64; 2],
}

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// One coordinate for each axis.
    pub coordinates: Vec<f64>,
    /// The first transition, if there is one.
    pub transition: Option<Transition>,
}

/// A result table.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryTable {
    /// Names of the axes, slowest first.
    pub axes: Vec<String>,
    /// The rows.
    pub points: Vec<Point>,
}

impl BoundaryTable {
    /// Reads a result table.
    ///
    /// # Errors
    /// Names the row and column of what is not as the sweep writes it.
    pub fn parse(csv: &str) -> Result<Self, FigureError> {
        let broken = |error: csv::Error| FigureError::Table(error.to_string());
        let mut reader = csv::Reader::from_reader(csv.as_bytes());
        let heading = reader.headers().map_err(broken)?.clone();
        let column = |name: &str| {
            heading
                .iter()
                .position(|column| column == name)
                .ok_or_else(|| FigureError::Table(format!("column {name} is missing")))
        };
        let kind = column(KIND)?;
        let speeds = [column(SPEED)?, column(LOW)?, column(HIGH)?];
        let axes: Vec<String> = heading.iter().take(kind).map(str::to_owned).collect();
        if axes.is_empty() {
            return Err(FigureError::Table(format!("no axis before {KIND}")));
        }
        let mut points = Vec::new();
        for (index, record) in reader.records().enumerate() {
            let record = record.map_err(broken)?;
            let row = Row {
                heading: &heading,
                record: &record,
                number: index + 1,
            };
            let coordinates = (0..axes.len())
                .map(|column| row.number(column))
                .collect::<Result<_, _>>()?;
            points.push(Point {
                coordinates,
                transition: row.transition(kind, speeds)?,
            });
        }
        if points.is_empty() {
            return Err(FigureError::Table("has no rows".to_owned()));
        }
        Ok(Self { axes, points })
    }
}

struct Row<'r> {
    heading: &'r StringRecord,
    record: &'r StringRecord,
    number: usize,
}

impl Row<'_> {
    fn number(&self, column: usize) -> Result<f64, FigureError> {
        let text = &self.record[column];
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(self.complain(column, "a finite number")),
        }
    }

    fn transition(
        &self,
        kind: usize,
        [speed, low, high]: [usize; 3],
    ) -> Result<Option<Transition>, FigureError> {
        let kind = match &self.record[kind] {
            "none" => return Ok(None),
            name => Kind::from_name(name)
                .ok_or_else(|| self.complain(kind, "unstable, bottomed, failure or none"))?,
        };
        Ok(Some(Transition {
            kind,
            speed: self.number(speed)?,
            bracket: [self.number(low)?, self.number(high)?],
        }))
    }

    fn complain(&self, column: usize, allowed: &str) -> FigureError {
        let (name, value) = (&self.heading[column], &self.record[column]);
        let row = self.number;
        FigureError::Table(format!("row {row}: {name} = {value}: allowed is {allowed}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,\
                           bracket_high_fps,landings,derivative_evaluations\n";

    #[test]
    fn transitions_and_their_absence_are_read() {
        let text = format!("{HEADING}-5,unstable,11.4,11.3,11.5,55,1\n0,none,,,,101,2\n");
        let table = BoundaryTable::parse(&text).unwrap();
        assert_eq!(table.axes, ["roll_deg"]);
        assert_eq!(table.points[0].coordinates, [-5.0]);
        let found = table.points[0].transition.unwrap();
        assert_eq!((found.kind, found.bracket), (Kind::Unstable, [11.3, 11.5]));
        assert_eq!(table.points[1].transition, None);
    }

    #[test]
    fn complaints_name_row_and_column() {
        let complaint = |text: &str| BoundaryTable::parse(text).unwrap_err().to_string();
        assert!(complaint("a,b\n1,2\n").contains("column first_transition_to is missing"));
        assert!(complaint(HEADING).contains("no rows"));
        let odd = format!("{HEADING}0,toppled,1,1,1,1,1\n");
        assert!(complaint(&odd).contains("row 1: first_transition_to = toppled"));
        let nan = format!("{HEADING}0,unstable,NaN,1,1,1,1\n");
        assert!(complaint(&nan).contains("row 1: first_transition_fps = NaN"));
    }
}
