//! Many landings, from columns to columns.

use std::num::NonZeroUsize;

use pyo3::buffer::PyBuffer;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use touchdown_sweep::cases::{CaseCell, CaseCells, CaseTable};
use touchdown_sweep::fingerprint::fingerprint;
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::landing_table::{self, Cell};
use touchdown_sweep::output_units::{OutputUnits, Quantity};
use touchdown_sweep::run::{Observer, Workers};

use crate::columns::{Column, WordList};
use crate::documents::{Solver, Vehicle, output_units};
use crate::interruptible;

/// Columns of results by name, as Python takes them.
type PyColumns<'py> = Vec<(String, Bound<'py, PyTuple>)>;

/// Lands every row of a table of columns, each an array of numbers or a list of texts.
#[pyfunction]
pub fn land_many<'py>(
    py: Python<'py>,
    vehicle: &Vehicle,
    columns: Vec<(String, Bound<'py, PyAny>)>,
    solver: &Solver,
    units: &str,
    threads: Option<NonZeroUsize>,
    watch: Option<&Bound<'py, PyAny>>,
) -> PyResult<PyColumns<'py>> {
    let units = output_units(units)?;
    let (names, values): (Vec<String>, Vec<_>) = columns.into_iter().unzip();
    let values = values.iter().map(Values::of);
    let cells = ColumnsOfCases(values.collect::<PyResult<_>>()?);
    let (file, settings) = (vehicle.file.clone(), solver.0);
    let found = interruptible::run(py, watch, move |work| {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let table = CaseTable::of_cells(&names, Box::new(cells), &file, &settings)?;
        let workers = Workers::start(threads)?;
        work.more(table.len());
        let mut results = Results::new(&table, units);
        workers.each_case(&table, 0..table.len(), work, &work.cancel, |landed| {
            if let Some((row, landing)) = landed {
                results.set(row, landing_table::columns(&landing));
            }
            Ok(())
        })?;
        Ok(results)
    })?;
    let columns = found.columns.into_iter();
    columns
        .map(|(quantity, column)| Ok((quantity.name().to_owned(), column.into_python(py)?)))
        .collect()
}

/// The values of a column of cases.
#[derive(Debug)]
enum Values {
    Numbers(Vec<f64>),
    Texts(Vec<Option<String>>),
}

impl Values {
    fn of(column: &Bound<PyAny>) -> PyResult<Self> {
        match PyBuffer::<f64>::get(column) {
            Ok(numbers) => numbers.to_vec(column.py()).map(Self::Numbers),
            Err(_) => column.extract().map(Self::Texts),
        }
    }
}

/// Columns as a table of cases.
#[derive(Debug)]
struct ColumnsOfCases(Vec<Values>);

impl CaseCells for ColumnsOfCases {
    fn len(&self) -> usize {
        self.0.first().map_or(0, |column| match column {
            Values::Numbers(numbers) => numbers.len(),
            Values::Texts(texts) => texts.len(),
        })
    }

    fn cell(&self, row: usize, column: usize) -> CaseCell<'_> {
        match &self.0[column] {
            Values::Numbers(numbers) => CaseCell::Number(numbers[row]),
            Values::Texts(texts) => match texts[row].as_deref() {
                None | Some("") => CaseCell::Empty,
                Some(text) => CaseCell::Text(text),
            },
        }
    }

    fn at_row(&self, row: usize, error: InputError) -> InputError {
        error.within(&format!("row {row}"))
    }

    fn fingerprint(&self) -> String {
        let prints = self.0.iter().map(|column| match column {
            Values::Numbers(numbers) => {
                let bits: Vec<String> = numbers.iter().map(f64::to_string).collect();
                fingerprint(&bits.join(","))
            }
            Values::Texts(texts) => fingerprint(&format!("{texts:?}")),
        });
        prints.collect::<Vec<_>>().join(" ")
    }
}

/// Results of all rows, column by column.
#[derive(Debug)]
struct Results {
    columns: Vec<(Quantity, Column)>,
    legs: usize,
}

impl Results {
    fn new(table: &CaseTable, units: OutputUnits) -> Self {
        let rows = table.len();
        let column = |name: &String| {
            let column = match name.as_str() {
                "outcome" | "failure" => Column::Words(vec![-1; rows], WordList::default()),
                "steps" | "derivative_evaluations" => Column::Counts(vec![0; rows]),
                _ => Column::Numbers(vec![f64::NAN; rows]),
            };
            (units.quantity(name), column)
        };
        let legs = table.most_legs();
        Self {
            columns: landing_table::names(legs).iter().map(column).collect(),
            legs,
        }
    }

    /// Sets the results of a row.
    fn set(&mut self, row: usize, results: Vec<(String, Cell)>) {
        let places = landing_table::places(results.len(), self.legs);
        for (place, (_, cell)) in places.into_iter().zip(results) {
            let (quantity, column) = &mut self.columns[place];
            match (column, cell) {
                (Column::Numbers(numbers), Cell::Number(number)) => {
                    numbers[row] = quantity.number(number);
                }
                (Column::Counts(counts), Cell::Count(count)) => counts[row] = count as i64,
                (Column::Words(codes, words), Cell::Word(word)) if !word.is_empty() => {
                    codes[row] = words.place(&word);
                }
                _ => {}
            }
        }
    }
}
