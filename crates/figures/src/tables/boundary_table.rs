//! Result tables of sweeps, read back: axes and the first transition at each point.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

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

impl Point {
    /// Velocity of the first transition, ft/s; infinite where there is none.
    fn velocity(&self) -> f64 {
        self.transition.map_or(f64::INFINITY, |found| found.speed)
    }
}

/// An axis of a sweep as its table shows it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    /// Name of its column.
    pub name: String,
    /// How many values it has.
    pub values: usize,
    /// Whether its values are numbers; they may be words.
    pub is_numeric: bool,
}

/// A result table.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryTable {
    /// Names of the axes, slowest first.
    pub axes: Vec<String>,
    /// The rows. Of all rows that agree in the axes, the one with the lowest first transition.
    pub points: Vec<Point>,
    /// Names of the other axes of the sweep, in which these rows differed.
    pub others: Vec<String>,
}

impl BoundaryTable {
    /// Reads a result table over all its axes.
    ///
    /// # Errors
    /// Names the row and column of what is not as the sweep writes it.
    pub fn parse(csv: &str) -> Result<Self, FigureError> {
        let axes: Vec<String> = Self::axes(csv)?.into_iter().map(|axis| axis.name).collect();
        Self::worst_by(csv, &axes)
    }

    /// The axes of a result table.
    ///
    /// # Errors
    /// When the table is not one that a sweep writes.
    pub fn axes(csv: &str) -> Result<Vec<Axis>, FigureError> {
        let table = Table::parse(csv)?;
        let kind = table.column(KIND)?;
        if kind == 0 {
            return Err(FigureError::Table(format!("no axis before {KIND}")));
        }
        let axis = |index: usize| {
            let cells = || table.rows().map(|row| row.text(index));
            Axis {
                name: table.names()[index].to_owned(),
                values: cells().collect::<HashSet<_>>().len(),
                is_numeric: cells().all(|cell| cell.parse::<f64>().is_ok()),
            }
        };
        Ok((0..kind).map(axis).collect())
    }

    /// Reads a result table over some of its axes, in this order: of all rows that agree in them, the
    /// one with the lowest first transition. A row without a transition is above all others.
    ///
    /// # Errors
    /// Names the axis that the table does not have or that was named twice, and the row and column of
    /// what is not as the sweep writes it.
    pub fn worst_by(csv: &str, axes: &[String]) -> Result<Self, FigureError> {
        let table = Table::parse(csv)?;
        let kind = table.column(KIND)?;
        let velocities = [
            table.column(SPEED)?,
            table.column(LOW)?,
            table.column(HIGH)?,
        ];
        let known = &table.names()[..kind];
        let mut columns: Vec<usize> = Vec::new();
        for axis in axes {
            let found = known.iter().position(|name| name == axis);
            match found.filter(|column| !columns.contains(column)) {
                Some(column) => columns.push(column),
                None => {
                    let problem = match found {
                        Some(_) => "is named twice",
                        None => "is no axis of this table",
                    };
                    let known = known.join(", ");
                    return Err(FigureError::Table(format!(
                        "{axis} {problem}: allowed are {known}, each once"
                    )));
                }
            }
        }
        let mut points: Vec<Point> = Vec::new();
        let mut places: HashMap<Vec<u64>, usize> = HashMap::new();
        for row in table.some_rows()? {
            let coordinates: Vec<f64> = columns
                .iter()
                .map(|column| Ok(row.number(*column)? + 0.0))
                .collect::<Result<_, FigureError>>()?;
            let point = Point {
                transition: transition(row, kind, velocities)?,
                coordinates,
            };
            let bits = point.coordinates.iter().map(|value| value.to_bits());
            match places.entry(bits.collect()) {
                Entry::Vacant(place) => {
                    place.insert(points.len());
                    points.push(point);
                }
                Entry::Occupied(place) => {
                    let known = &mut points[*place.get()];
                    if point.velocity() < known.velocity() {
                        *known = point;
                    }
                }
            }
        }
        let varies = |column: usize| {
            let mut cells = table.rows().map(|row| row.text(column));
            let first = cells.next();
            cells.any(|cell| Some(cell) != first)
        };
        let others = (0..kind).filter(|column| !columns.contains(column) && varies(*column));
        Ok(Self {
            others: others.map(|column| known[column].to_owned()).collect(),
            axes: axes.to_vec(),
            points,
        })
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
        speed: row.velocity(speed)?,
        low: match row.text(low) {
            "" => None,
            _ => Some(row.velocity(low)?),
        },
        high: row.velocity(high)?,
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

    #[test]
    fn absurd_numbers_are_refused_with_their_row() {
        for absurd in ["1e9", "1e16", "1e308", "-1", "inf"] {
            for row in [
                format!("0,unstable,{absurd},1,1,1,1\n"),
                format!("0,unstable,1,1,{absurd},1,1\n"),
            ] {
                let text = format!("{HEADING}5,none,,25,,101,2\n{row}");
                let complaint = BoundaryTable::parse(&text).unwrap_err().to_string();
                assert!(complaint.contains("row 2: "), "{complaint}");
                assert!(complaint.contains(&format!(" = {absurd}: allowed is a number from 0")));
            }
        }
        let far = format!("{HEADING}1e200,none,,25,,101,2\n");
        let complaint = BoundaryTable::parse(&far).unwrap_err().to_string();
        assert!(complaint.contains("row 1: roll_deg = 1e200"), "{complaint}");
    }

    const MANY: &str = "\
a,roll_deg,vehicle,b,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps
1,0,x,5,unstable,12,11,13
1,0,y,6,none,,,
1,5,x,5,unstable,11,10,12
1,5,y,6,bottomed,9,8,10
2,0,x,5,none,,,
2,5,x,5,none,,,
2,5,x,6,none,,,
";

    #[test]
    fn the_lowest_of_the_rows_that_agree_remains() {
        let axes = BoundaryTable::axes(MANY).unwrap();
        let told: Vec<_> = axes
            .iter()
            .map(|axis| (axis.name.as_str(), axis.values, axis.is_numeric))
            .collect();
        assert_eq!(
            told,
            [
                ("a", 2, true),
                ("roll_deg", 2, true),
                ("vehicle", 2, false),
                ("b", 2, true)
            ]
        );
        let by = |axes: &[&str]| {
            let axes: Vec<String> = axes.iter().map(|axis| (*axis).to_owned()).collect();
            BoundaryTable::worst_by(MANY, &axes)
        };
        let table = by(&["b", "a"]).unwrap();
        assert_eq!(table.others, ["roll_deg", "vehicle"]);
        let found: Vec<_> = table
            .points
            .iter()
            .map(|point| (point.coordinates.as_slice(), point.velocity()))
            .collect();
        assert_eq!(
            found,
            [
                (&[5.0, 1.0][..], 11.0),
                (&[6.0, 1.0], 9.0),
                (&[5.0, 2.0], f64::INFINITY),
                (&[6.0, 2.0], f64::INFINITY)
            ]
        );
        for (axes, expected) in [
            (
                &["c"][..],
                "c is no axis of this table: allowed are a, roll_deg",
            ),
            (&["a", "a"], "a is named twice"),
            (&["vehicle"], "row 1: vehicle = x"),
        ] {
            let complaint = by(axes).unwrap_err().to_string();
            assert!(complaint.contains(expected), "{complaint}");
        }
    }
}
