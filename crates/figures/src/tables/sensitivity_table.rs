//! Reads tables of sensitivities: the change of the transition velocity with each parameter, point by point.

use crate::tables::{Row, Table, has_column};
use crate::unit::in_si;
use crate::words::FigureError;

/// The column that makes a table one of sensitivities.
const DERIVATIVE: &str = "dvh_dp_fps_per_unit";
const PARAMETER: &str = "parameter";

/// Sensitivities at one or more points.
#[derive(Debug, Clone, PartialEq)]
pub struct SensitivityTable {
    /// The points, in the order of the table.
    pub points: Vec<Point>,
}

/// The sensitivities of a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Names and coordinates of the point, as written.
    pub place: Vec<(String, String)>,
    /// First transition, if there is one.
    pub speed: Option<f64>,
    /// One for each parameter, in the same order at every point.
    pub slopes: Vec<Slope>,
}

/// The dependence on one parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Slope {
    /// Its dotted name.
    pub parameter: String,
    /// Its unit; 1 for pure numbers.
    pub unit: String,
    /// Its value, if it has one.
    pub value: Option<f64>,
    /// Step over which the dependence was examined, in the unit of the parameter.
    pub step: Option<f64>,
    /// Dependence of the transition on it, in a word.
    pub dependence: String,
    /// Effect of a change, if it is known.
    pub change: Option<Change>,
}

/// Changes of the transition velocity with one of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Change of the parameter, in its unit.
    pub span: f64,
    /// Change of the transition velocity where the parameter falls by the span, if there is a transition.
    pub falls: Option<f64>,
    /// Change of the transition velocity where the parameter grows by the span, if there is a transition.
    pub grows: Option<f64>,
    /// Their estimated error, if they follow from a derivative.
    pub error: Option<f64>,
}

impl Change {
    /// The larger of both changes, without sign.
    pub fn size(&self) -> f64 {
        let ends = [self.falls, self.grows].into_iter().flatten();
        ends.fold(0.0, |most, end| most.max(end.abs()))
    }
}

/// Returns whether the heading of a table is one of sensitivities.
pub fn is_one(csv: &str) -> bool {
    has_column(csv, &[DERIVATIVE, &in_si(DERIVATIVE).unwrap_or_default()])
}

impl SensitivityTable {
    /// Reads a table of sensitivities.
    ///
    /// # Errors
    /// Names the row and column that is not as a sweep writes it.
    pub fn parse(csv: &str) -> Result<Self, FigureError> {
        let table = Table::parse(csv)?;
        let axes = table.column(PARAMETER)?;
        let speed = table.column("first_transition_fps")?;
        let columns = Columns::of(&table)?;
        let mut points: Vec<Point> = Vec::new();
        for row in table.nonempty_rows()? {
            let here = row.optional_number(speed)?;
            let slope = columns.slope(row, here)?;
            let names = table.names().into_iter().take(axes).enumerate();
            let place: Vec<(String, String)> = names
                .map(|(axis, name)| (name.to_owned(), row.text(axis).to_owned()))
                .collect();
            match points.last_mut().filter(|point| point.place == place) {
                Some(point) => point.slopes.push(slope),
                None => points.push(Point {
                    place,
                    speed: here,
                    slopes: vec![slope],
                }),
            }
        }
        let names = |point: &Point| -> Vec<String> {
            let slopes = point.slopes.iter();
            slopes.map(|slope| slope.parameter.clone()).collect()
        };
        match points
            .iter()
            .find(|point| names(point) != names(&points[0]))
        {
            Some(_) => Err(FigureError::Table(
                "points differ in their parameters".to_owned(),
            )),
            None => Ok(Self { points }),
        }
    }

    /// Index of the point with the lowest transition, the first of those with a known change.
    pub fn lowest(&self) -> Option<usize> {
        let has_change = |point: &Point| point.slopes.iter().any(|slope| slope.change.is_some());
        let known = self.points.iter().enumerate();
        known
            .filter(|(_, point)| has_change(point))
            .filter_map(|(index, point)| Some((index, point.speed?)))
            .min_by(|(_, a), (_, b)| a.total_cmp(b))
            .map(|(index, _)| index)
    }
}

/// Indices of the columns of a slope.
struct Columns {
    parameter: usize,
    unit: usize,
    value: usize,
    step: usize,
    dependence: usize,
    span: usize,
    /// Change by the derivative, and its estimated error.
    change: [usize; 2],
    /// Transitions at both ends of the span; tables of earlier versions have none.
    ends: [Option<usize>; 2],
}

impl Columns {
    fn of(table: &Table) -> Result<Self, FigureError> {
        Ok(Self {
            parameter: table.column(PARAMETER)?,
            unit: table.column("unit")?,
            value: table.column("value")?,
            step: table.column("step")?,
            dependence: table.column("dependence")?,
            span: table.column("span")?,
            change: [
                table.column("vh_change_fps")?,
                table.column("vh_change_error_fps")?,
            ],
            ends: ["vh_at_minus_span_fps", "vh_at_plus_span_fps"].map(|name| table.find(name)),
        })
    }

    /// The dependence in a row, at a point with a transition `here`.
    fn slope(&self, row: Row, here: Option<f64>) -> Result<Slope, FigureError> {
        let number = |column| row.optional_number(column);
        let [by_derivative, error] = self.change.map(number);
        let [minus, plus] = self.ends.map(|column| column.map_or(Ok(None), number));
        let from_here = |end: Option<f64>| Some(end? - here?);
        let by_derivative = by_derivative?;
        let falls = by_derivative.map(|change| -change).or(from_here(minus?));
        let grows = by_derivative.or(from_here(plus?));
        let error = error?;
        let change = |span| Change {
            span,
            falls,
            grows,
            error,
        };
        Ok(Slope {
            parameter: row.text(self.parameter).to_owned(),
            unit: row.text(self.unit).to_owned(),
            value: row.optional_number(self.value)?,
            step: row.optional_number(self.step)?,
            dependence: row.text(self.dependence).to_owned(),
            change: (row.optional_number(self.span)?)
                .map(change)
                .filter(|change| change.falls.or(change.grows).is_some()),
        })
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Two points over roll, three parameters; the second point has the lower transition.
    pub const TABLE: &str = "\
roll_deg,parameter,unit,value,first_transition_to,first_transition_fps,dependence,step,dvh_dp_fps_per_unit,\
dvh_dp_error_fps_per_unit,span,vh_change_fps,vh_change_error_fps,vh_at_minus_span_fps,vh_at_plus_span_fps
0,friction,1,1,unstable,12.5,smooth,0.03,4,0.1,0.1,0.4,0.01,,
0,vehicle.strut.preload_lb,lb,185,unstable,12.5,smooth,6,-0.01,0.001,18.5,-0.185,0.0185,,
0,slope_deg,deg,15,unstable,12.5,smooth,1,-0.3,0.001,1,-0.3,0.001,,
5,friction,1,1,unstable,11.25,smooth,0.03,2,0.2,0.1,0.2,0.02,,
5,vehicle.strut.preload_lb,lb,185,unstable,11.25,jumps,6,,,18.5,,,11.5,
5,slope_deg,deg,15,unstable,11.25,smooth,1,-0.5,0.001,1,-0.5,0.001,,
";

    #[test]
    fn points_are_told_apart_and_words_have_no_number() {
        assert!(is_one(TABLE));
        let table = SensitivityTable::parse(TABLE).unwrap();
        assert_eq!((table.points.len(), table.lowest()), (2, Some(1)));
        let point = &table.points[1];
        assert_eq!(point.place, [("roll_deg".to_owned(), "5".to_owned())]);
        let change = |span, falls, grows, error| Change {
            span,
            falls,
            grows,
            error,
        };
        // No transition is left where the parameter grows.
        let jump = change(18.5, Some(0.25), None, None);
        assert_eq!(point.slopes[1].change, Some(jump));
        assert_eq!(point.slopes[1].dependence, "jumps");
        let smooth = change(1.0, Some(0.5), Some(-0.5), Some(0.001));
        assert_eq!(point.slopes[2].change, Some(smooth));
        // Tables of earlier versions end after the derivatives.
        let cut = |row: &str| format!("{}\n", row.rsplitn(3, ',').nth(2).unwrap());
        let earlier: String = TABLE.lines().map(cut).collect();
        let table = SensitivityTable::parse(&earlier).unwrap();
        assert_eq!(table.points[1].slopes[1].change, None);
        assert_eq!(table.points[1].slopes[2].change, Some(smooth));
    }

    #[test]
    fn complaints_name_row_and_column() {
        let complaint = |text: &str| SensitivityTable::parse(text).unwrap_err().to_string();
        let wrong = complaint(&TABLE.replace("0.4,0.01", "NaN,0.01"));
        assert!(wrong.contains("row 1: vh_change_fps = NaN"), "{wrong}");
        let wrong = complaint(&TABLE.replace("5,slope_deg", "5,pitch_deg"));
        assert!(wrong.contains("points differ"), "{wrong}");
        let heading = TABLE.lines().next().unwrap();
        assert!(complaint(heading).contains("no rows"));
    }
}
