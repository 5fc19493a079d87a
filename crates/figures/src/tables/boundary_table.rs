//! Reads result tables of sweeps: axes and the first transition at each point.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

use crate::tables::{Row, Table};
use crate::words::FigureError;

const KIND: &str = "first_transition_to";
const SPEED: &str = "first_transition_fps";
const LOW: &str = "bracket_low_fps";
const HIGH: &str = "bracket_high_fps";
const PATCHY: &str = "patchy_to_fps";

/// Outcome of landings above a transition.
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

/// A transition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// Outcome that begins there.
    pub kind: Kind,
    /// Speed.
    pub speed: f64,
    /// Lower end of its bracket; `None` if landings at the lowest speed searched were already not stable, so that the
    /// transition lies at or below it.
    pub low: Option<f64>,
    /// Upper end of its bracket.
    pub high: f64,
    /// Speed up to which stable landings and others alternate; `None` where it is sharp, or where nobody looked.
    pub patchy_to: Option<f64>,
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
    /// Velocity of the first transition; infinite if there is none.
    fn velocity(&self) -> f64 {
        self.transition.map_or(f64::INFINITY, |found| found.speed)
    }
}

/// An axis of a sweep in its table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Axis {
    /// Name of its column.
    pub name: String,
    /// Number of its values.
    pub values: usize,
    /// True if its values are numbers; else they are words.
    pub is_numeric: bool,
}

/// A result table.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryTable {
    /// Names of the axes, slowest first.
    pub axes: Vec<String>,
    /// The rows. Of all rows with the same values on the axes, only the one with the lowest first transition.
    pub points: Vec<Point>,
    /// Names of the other axes of the sweep, in which these rows differed.
    pub others: Vec<String>,
}

impl BoundaryTable {
    /// The table with other coordinates: `change` takes the number of an axis and a coordinate along it.
    pub fn changed(mut self, change: impl Fn(usize, f64) -> f64) -> Self {
        for point in &mut self.points {
            for (axis, value) in point.coordinates.iter_mut().enumerate() {
                *value = change(axis, *value);
            }
        }
        self
    }

    /// Reads a result table over all its axes.
    ///
    /// # Errors
    /// Names the row and column that is not as the sweep writes it.
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

    /// Reads a result table over some of its axes, in this order. Of all rows with the same values on them, it keeps
    /// the one with the lowest first transition. A row without a transition is above all others.
    ///
    /// # Errors
    /// Names the axis that the table does not have or that was named twice, and the row and column
    /// that is not as the sweep writes it.
    pub fn worst_by(csv: &str, axes: &[String]) -> Result<Self, FigureError> {
        Self::worst_of(&Table::parse(csv)?, axes)
    }

    /// As [`BoundaryTable::worst_by`].
    pub(crate) fn worst_of(table: &Table, axes: &[String]) -> Result<Self, FigureError> {
        let kind = table.column(KIND)?;
        let velocities = [
            table.column(SPEED)?,
            table.column(LOW)?,
            table.column(HIGH)?,
        ];
        let patchy = table.find(PATCHY);
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
                        "{axis} {problem}: expected {known}, each once"
                    )));
                }
            }
        }
        let mut points: Vec<Point> = Vec::new();
        let mut places: HashMap<Vec<u64>, usize> = HashMap::new();
        for row in table.nonempty_rows()? {
            let coordinates: Vec<f64> = columns
                .iter()
                .map(|column| Ok(row.number(*column)? + 0.0))
                .collect::<Result<_, FigureError>>()?;
            let point = Point {
                transition: transition(row, kind, velocities, patchy)?,
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
    patchy: Option<usize>,
) -> Result<Option<Transition>, FigureError> {
    let kind = match row.text(kind) {
        "none" => return Ok(None),
        name => Kind::from_name(name)
            .ok_or_else(|| row.error(kind, "unstable, bottomed, failure, undecided or none"))?,
    };
    let optional = |column: usize| match row.text(column) {
        "" => Ok(None),
        _ => row.velocity(column).map(Some),
    };
    Ok(Some(Transition {
        kind,
        speed: row.velocity(speed)?,
        low: optional(low)?,
        high: row.velocity(high)?,
        patchy_to: patchy.map_or(Ok(None), optional)?,
    }))
}

#[cfg(test)]
#[path = "boundary_table_tests.rs"]
mod tests;
