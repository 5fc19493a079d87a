//! Reads a table of transitions.

use csv::StringRecord;
use serde_json::{Map, Value, json};
use touchdown_figures::axis_title::axis_title;
use touchdown_figures::unit::{bare_name, unit_of};

use crate::interface::complaint::{Complaint, of_table};
use crate::named::Results;

/// Transitions over axes.
pub struct Transitions {
    /// The axes, slowest first.
    pub axes: Vec<Axis>,
    /// The points in table order.
    pub points: Vec<Point>,
}

/// An axis: numbers in order, or words.
pub struct Axis {
    /// Name.
    pub name: String,
    /// Values.
    pub values: Vec<Value>,
}

/// A point.
pub struct Point {
    /// One value for each axis.
    pub place: Vec<Value>,
    /// Transition, if any.
    pub transition: Option<Transition>,
    certainty: String,
    disputed: Option<[f64; 2]>,
}

/// A transition, in the unit of the table.
pub struct Transition {
    /// Class of the landings above it.
    pub to: String,
    /// Speed.
    pub speed: f64,
    /// Lower end of the bracket; `None` at or below the lowest speed searched.
    pub low: Option<f64>,
    /// Upper end of the bracket.
    pub high: f64,
    /// Speed up to which stable landings and others alternate, if they do.
    pub patchy_to: Option<f64>,
}

impl Point {
    /// The point as written in answers, with its place over some axes.
    pub fn told(&self, place: Vec<Value>) -> Value {
        let transition = self.transition.as_ref();
        json!({
            "place": place,
            "to": transition.map(|found| &found.to),
            "speed": transition.map(|found| found.speed),
            "low": transition.and_then(|found| found.low),
            "high": transition.map(|found| found.high),
            "certainty": Some(&self.certainty).filter(|word| !word.is_empty()),
            "disputed": self.disputed,
            "patchy_to": transition.and_then(|found| found.patchy_to),
        })
    }
}

impl Transitions {
    /// Reads a table.
    ///
    /// # Errors
    /// If it does not have the form that a sweep writes.
    pub fn read(results: &Results) -> Result<Self, Complaint> {
        let mut reader = csv::Reader::from_reader(results.table.as_bytes());
        let heading = reader
            .headers()
            .map_err(|error| of_table(results, error))?
            .clone();
        let count = results.axes.len();
        let rows: Vec<StringRecord> = reader
            .records()
            .collect::<Result<_, _>>()
            .map_err(|error| of_table(results, error))?;
        let columns = Columns::of(&heading);
        let points = rows.iter().enumerate().map(|(index, row)| {
            let point = columns.point(row, count);
            point.ok_or_else(|| {
                let said = format!("row {} is not as a sweep writes it", index + 1);
                of_table(results, said)
            })
        });
        let points = points.collect::<Result<Vec<Point>, Complaint>>()?;
        let axes = results.axes.iter().enumerate().map(|(axis, name)| Axis {
            name: name.clone(),
            values: different(points.iter().map(|point| &point.place[axis])),
        });
        Ok(Self {
            axes: axes.collect(),
            points,
        })
    }

    /// Description of an axis.
    pub fn described(&self, axis: usize) -> Value {
        let Axis { name, values } = &self.axes[axis];
        described(name, &unit_of(name), values.clone())
    }

    /// Indices of the axes of a request: one for a table over one axis, else two.
    pub fn chosen(&self, asked: &[String]) -> Result<Vec<usize>, Complaint> {
        let names: Vec<&str> = self.axes.iter().map(|axis| axis.name.as_str()).collect();
        if asked.is_empty() {
            return Ok((0..names.len().min(2)).collect());
        }
        let place = |name: &String| names.iter().position(|known| known == name);
        let chosen: Option<Vec<usize>> = asked.iter().map(place).collect();
        match chosen {
            Some(axes) if axes.len() == names.len().min(2) && !has_double(&axes) => Ok(axes),
            _ => {
                let known = names.join(", ");
                let allowed = match names.len() {
                    1 => known,
                    _ => format!("two different ones of {known}"),
                };
                Err(Complaint::value("axes", json!(asked), &allowed))
            }
        }
    }

    /// Values of the axes that are not drawn: their first unless the request gives another.
    pub fn fixed(
        &self,
        chosen: &[usize],
        asked: &Map<String, Value>,
    ) -> Result<Vec<Option<Value>>, Complaint> {
        if let Some((name, value)) = (asked.iter()).find(|(name, _)| {
            !self
                .axes
                .iter()
                .enumerate()
                .any(|(axis, known)| known.name == **name && !chosen.contains(&axis))
        }) {
            return Err(Complaint::value(
                &format!("fixed.{name}"),
                value,
                "an axis that is not drawn over",
            ));
        }
        let fixed = self.axes.iter().enumerate().map(|(axis, known)| {
            if chosen.contains(&axis) {
                return Ok(None);
            }
            let Some(value) = asked.get(&known.name) else {
                return Ok(known.values.first().cloned());
            };
            let found = known.values.iter().find(|one| same(one, value));
            let found = found.ok_or_else(|| {
                let allowed = format!("one of its values, {}", json!(known.values));
                Complaint::value(&format!("fixed.{}", known.name), value, &allowed)
            });
            found.cloned().map(Some)
        });
        fixed.collect()
    }

    /// Points with the fixed values.
    pub fn within<'t>(&'t self, fixed: &'t [Option<Value>]) -> impl Iterator<Item = &'t Point> {
        self.points.iter().filter(move |point| {
            let mut held = point.place.iter().zip(fixed);
            held.all(|(value, fixed)| fixed.as_ref().is_none_or(|fixed| same(value, fixed)))
        })
    }

    /// The place of a point, by axis.
    pub fn place(&self, point: usize) -> Map<String, Value> {
        let axes = self.axes.iter().zip(&self.points[point].place);
        axes.map(|(axis, value)| (axis.name.clone(), value.clone()))
            .collect()
    }

    /// The number of the point nearest to a place; distances are relative to the range of each axis.
    pub fn nearest(&self, place: &Map<String, Value>) -> Result<usize, Complaint> {
        if let Some((name, value)) = place
            .iter()
            .find(|(name, _)| self.axes.iter().all(|axis| axis.name != **name))
        {
            let known: Vec<&str> = self.axes.iter().map(|axis| axis.name.as_str()).collect();
            return Err(Complaint::value(
                &format!("place.{name}"),
                value,
                &format!("an axis: {}", known.join(", ")),
            ));
        }
        let distance = |point: &&Point| -> f64 {
            let axes = self.axes.iter().zip(&point.place);
            let parts = axes.map(|(axis, value)| match place.get(&axis.name) {
                None => 0.0,
                Some(asked) => axis.distance(value, asked),
            });
            parts.map(|part| part * part).sum()
        };
        let distances = self.points.iter().map(|point| distance(&point));
        let nearest = distances
            .enumerate()
            .min_by(|(_, a), (_, b)| a.total_cmp(b));
        let nearest = nearest.map(|(point, _)| point);
        nearest.ok_or_else(|| Complaint::request("the table has no rows"))
    }
}

impl Axis {
    fn distance(&self, value: &Value, asked: &Value) -> f64 {
        match (value.as_f64(), asked.as_f64()) {
            (Some(value), Some(asked)) => {
                let ends = self.values.iter().filter_map(Value::as_f64);
                let [low, high] = ends
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], end| {
                        [low.min(end), high.max(end)]
                    });
                (value - asked) / if high > low { high - low } else { 1.0 }
            }
            _ if same(value, asked) => 0.0,
            _ => f64::MAX.sqrt(),
        }
    }
}

/// Indices of the columns of a table.
struct Columns {
    kind: Option<usize>,
    speed: Option<usize>,
    low: Option<usize>,
    high: Option<usize>,
    certainty: Option<usize>,
    disputed: [Option<usize>; 2],
    patchy_to: Option<usize>,
}

impl Columns {
    fn of(heading: &StringRecord) -> Self {
        let named = |bare: &str| {
            let is_one = |name: &str| bare_name(name) == bare;
            heading.iter().position(is_one)
        };
        Self {
            kind: named("first_transition_to"),
            speed: named("first_transition"),
            low: named("bracket_low"),
            high: named("bracket_high"),
            certainty: named("certainty"),
            disputed: [named("disputed_from"), named("disputed_to")],
            patchy_to: named("patchy_to"),
        }
    }

    /// The point of a row; `None` if a sweep does not write such rows.
    fn point(&self, row: &StringRecord, axes: usize) -> Option<Point> {
        let text = |column: Option<usize>| row.get(column?);
        let number = |column: Option<usize>| -> Option<f64> {
            text(column)?
                .parse()
                .ok()
                .filter(|number: &f64| number.is_finite())
        };
        let transition = match text(self.kind)? {
            "none" => None,
            to => {
                let high = number(self.high)?;
                Some(Transition {
                    to: to.to_owned(),
                    speed: number(self.speed).unwrap_or(high),
                    low: number(self.low),
                    high,
                    patchy_to: number(self.patchy_to),
                })
            }
        };
        let disputed = self.disputed.map(number);
        Some(Point {
            place: (0..axes).map(|axis| cell(&row[axis])).collect(),
            transition,
            certainty: text(self.certainty).unwrap_or_default().to_owned(),
            disputed: match disputed {
                [Some(from), Some(to)] => Some([from, to]),
                _ => None,
            },
        })
    }
}

/// A cell: a number, a word, or null if empty.
pub fn cell(text: &str) -> Value {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => json!(number + 0.0),
        _ if text.is_empty() => Value::Null,
        _ => json!(text),
    }
}

/// Description of a column.
pub fn described(name: &str, unit: &str, values: Vec<Value>) -> Value {
    json!({"name": name, "title": axis_title(name), "unit": unit, "values": values})
}

/// Distinct values: sorted numbers, then words as they appear.
fn different<'v>(values: impl Iterator<Item = &'v Value>) -> Vec<Value> {
    let (mut numbers, mut words): (Vec<f64>, Vec<Value>) = (Vec::new(), Vec::new());
    for value in values {
        match value.as_f64() {
            Some(number) => numbers.push(number),
            None if !words.contains(value) => words.push(value.clone()),
            None => {}
        }
    }
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers
        .into_iter()
        .map(|number| json!(number))
        .chain(words)
        .collect()
}

fn same(a: &Value, b: &Value) -> bool {
    match (a.as_f64(), b.as_f64()) {
        (Some(a), Some(b)) => a == b,
        _ => a == b,
    }
}

fn has_double(axes: &[usize]) -> bool {
    axes.iter()
        .enumerate()
        .any(|(index, axis)| axes[..index].contains(axis))
}
