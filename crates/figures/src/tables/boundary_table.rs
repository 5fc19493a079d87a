//! Result tables of sweeps, read back: axes and the first transition at each point.

use crate::figure_error::FigureError;
use crate::table::{Row, Table};

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
    /// The vehicle still moves at the time limit.
    Undecided,
}

impl Kind {
    /// All of them, in the order of legends.
    pub const ALL: [Self; 4] = [
        Self::Unstable,
        Self::Bottomed,
        Self::Failure,
        Self::Undecided,
    ];
}

impl Kind {
    /// Its word in result tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Unstable => "unstable",
            Self::Bottomed => "bottomed",
            Self::Failure => "failure",
            Self::Undecided => "undecided",
        }
    }

    /// The kind that a word of a result table stands for.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// A transition, ft/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// What begins there.
    pub kind: Kind,
    /// Speed, ft/s.
    pub speed: f64,
    /// Lower end of its bracket, ft/s; `None` where landings at the lowest speed searched were not stable already, so
    /// that the transition lies at or below it.
    pub low: Option<f64>,
    /// Upper end of its bracket, ft/s.
    pub high: f64,
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
        let table = Table::parse(csv)?;
        let kind = table.column(KIND)?;
        let speeds = [
            table.column(SPEED)?,
            table.column(LOW)?,
            table.column(HIGH)?,
        ];
        let axes: Vec<String> = table.names()[..kind]
            .iter()
            .map(|name| (*name).to_owned())
            .collect();
        if axes.is_empty() {
            return Err(FigureError::Table(format!("no axis before {KIND}")));
        }
        let points = table.some_rows()?.map(|row| {
            Ok(Point {
                coordinates: (0..kind)
                    .map(|axis| row.number(axis))
                    .collect::<Result<_, _>>()?,
                transition: transition(row, kind, speeds)?,
            })
        });
        let points = points.collect::<Result<_, FigureError>>()?;
        Ok(Self { axes, points })
    }
}

fn transition(
    row: Row,
    kind: usize,
    [speed, low, high]: [usize; 3],
) -> Result<Option<Transition>, FigureError> {
    let kind = match row.text(kind) {
        "none" => return Ok(None),
        name => Kind::from_name(name)
            .ok_or_else(|| row.complain(kind, "unstable, bottomed, failure, undecided or none"))?,
    };
    Ok(Some(Transition {
        kind,
        speed: row.number(speed)?,
        low: match row.text(low) {
            "" => None,
            _ => Some(row.number(low)?),
        },
        high: row.number(high)?,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADING: &str = "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,\
                           bracket_high_fps,landings,derivative_evaluations\n";

    #[test]
    fn transitions_and_their_absence_are_read() {
        let rows = "-5,unstable,11.4,11.3,11.5,55,1\n0,none,,25,,101,2\n5,failure,8,,8,1,1\n";
        let text = format!("{HEADING}{rows}");
        let table = BoundaryTable::parse(&text).unwrap();
        assert_eq!(table.axes, ["roll_deg"]);
        assert_eq!(table.points[0].coordinates, [-5.0]);
        let found = table.points[0].transition.unwrap();
        assert_eq!(found.kind, Kind::Unstable);
        assert_eq!((found.low, found.high), (Some(11.3), 11.5));
        assert_eq!(table.points[1].transition, None);
        let open = table.points[2].transition.unwrap();
        assert_eq!((open.speed, open.low), (8.0, None));
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
