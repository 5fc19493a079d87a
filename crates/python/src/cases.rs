//! Many landings, from input columns to result columns.

use std::collections::BTreeMap;
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use pyo3::buffer::PyBuffer;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::{Class, Outcome};
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_input::documents::column::{cells, headings};
use touchdown_input::documents::fingerprint::fingerprint_of_bytes;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::{OutputUnits, Quantity};
use touchdown_input::readers::scene_input::NamedConditions;
use touchdown_input::sweeps::cases::{CaseCell, CaseCells, CaseTable};
use touchdown_search::contact_warnings::ContactWarnings;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::output_guard::OutputGuard;
use touchdown_sweep::output::{case_results, landing_table, warnings};
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::{Observer, Workers};
use touchdown_sweep::threads::runner::{Runner, Task};

use crate::columns::Column;
use crate::documents::{Scene, Solver, Vehicle, output_units};
use crate::errors::{Failure, in_the_way};
use crate::interruptible::{self, Work};

/// Result columns by name, as passed to Python.
type PyColumns<'py> = Vec<(String, Bound<'py, PyTuple>)>;

/// Lands every row of a table of columns, each an array of numbers or a list of texts; `scene` has the default
/// conditions of rows. With `out`, results also go to this file, as CSV or Parquet by its name, and until then to a journal
/// beside it.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "Python gives them by name")]
pub fn land_many<'py>(
    py: Python<'py>,
    vehicle: &Vehicle,
    columns: Vec<(String, Bound<'py, PyAny>)>,
    scene: Option<&Scene>,
    solver: &Solver,
    units: &str,
    out: Option<PathBuf>,
    overwrite: bool,
    threads: Option<NonZeroUsize>,
    watch: Option<&Bound<'py, PyAny>>,
) -> PyResult<(PyColumns<'py>, [Vec<String>; 2])> {
    let units = output_units(units)?;
    let (names, values): (Vec<String>, Vec<_>) = columns.into_iter().unzip();
    let values = values.iter().map(Values::of);
    let cells = ColumnsOfCases {
        names: names.clone(),
        columns: values.collect::<PyResult<_>>()?,
    };
    let (file, settings) = (vehicle.file.clone(), solver.0);
    let shared = scene.map_or_else(NamedConditions::default, |scene| *scene.0.conditions());
    let (found, of_journal) = interruptible::run(py, watch, move |work| {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        if cells.is_empty() && out.is_none() {
            CaseTable::check_heading(&names, &shared)?;
            let legs = file.vehicle.leg_count();
            return Ok((Results::new(0, legs, units), Vec::new()));
        }
        let workers = Workers::start(threads)?;
        let (cells, cancel) = (Box::new(cells), &work.cancel);
        let table = workers
            .within(|| CaseTable::of_cells(&names, cells, &shared, &file, &settings, cancel))?;
        work.more(table.len());
        let results = Results::new(table.len(), table.most_legs(), units);
        match out {
            None => Ok((landed(&table, &workers, work, results)?, Vec::new())),
            Some(out) => {
                let guard = OutputGuard {
                    inputs: &[],
                    overwrite,
                };
                let is_own = |line: &str| case_results::is_table(&out, line);
                guard.check(&out, is_own).map_err(in_the_way)?;
                if !overwrite && out.exists() {
                    let there =
                        fs::read(&out).map_err(|error| InputError::unreadable(&out, error))?;
                    let found = landed_again(&out, &there, &table, &workers, work, results)?;
                    return Ok((found, Vec::new()));
                }
                landed_into(&out, &table, &workers, work, results)
            }
        }
    })?;
    let of_landings = found.warnings();
    let columns = found.columns.into_iter();
    let mut columns: PyColumns = columns
        .map(|(quantity, column)| Ok((quantity.name().to_owned(), column.into_python(py)?)))
        .collect::<PyResult<_>>()?;
    let classes = found.classes.into_python(py)?;
    columns.insert(1, ("outcome_class".to_owned(), classes));
    Ok((columns, [of_journal, of_landings]))
}

/// Results of all rows.
fn landed(
    table: &CaseTable,
    workers: &Workers,
    work: &Work,
    mut results: Results,
) -> Result<Results, Failure> {
    let rows = 0..table.len();
    workers.each_case(table, rows, work, &work.cancel, |landed| {
        if let Some((row, landing)) = landed {
            results.set(row, &landing);
        }
        Ok(())
    })?;
    Ok(results)
}

/// Computes the results of all rows and writes them to a file; also returns the warnings of its journal.
fn landed_into(
    out: &Path,
    table: &CaseTable,
    workers: &Workers,
    work: &Work,
    mut results: Results,
) -> Result<(Results, Vec<String>), Failure> {
    let folder = Folder::of(out)?;
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    let runner = Runner {
        workers,
        folder: &folder,
        observer: work,
        cancel: &work.cancel,
        version: crate::VERSION,
    };
    let run = runner.begin(Task::Cases(table, &name))?;
    let of_journal = run.warnings().to_vec();
    let mut found = run.compute()?.results()?;
    let mut landings = Vec::with_capacity(table.len());
    for row in 0..table.len() {
        let bytes = found.result(row)?;
        let finding = bytes.as_deref().and_then(Finding::decode);
        landings.push(finding.and_then(Finding::landing));
    }
    let written = results.set_all(table, landings, out)?;
    folder.write_files(&[(name.into_owned(), written)])?;
    found.remove_journals()?;
    Ok((results, of_journal))
}

/// Computes the results of all rows, which must equal those of an existing file. The file does not contain its input,
/// so they are computed anew.
fn landed_again(
    out: &Path,
    there: &[u8],
    table: &CaseTable,
    workers: &Workers,
    work: &Work,
    mut results: Results,
) -> Result<Results, Failure> {
    let refuse = || {
        let complaint = "holds other results: expected another file, or overwrite=True";
        Failure::from(InputError::in_file(out, complaint))
    };
    let lines = || there.split_inclusive(|byte| *byte == b'\n').count();
    if !case_results::is_parquet(out) && lines() != 1 + table.len() {
        return Err(refuse());
    }
    let mut landings = vec![None; table.len()];
    let rows = 0..table.len();
    workers.each_case(table, rows, work, &work.cancel, |landed| {
        if let Some((row, landing)) = landed {
            landings[row] = Some(landing);
        }
        Ok(())
    })?;
    if results.set_all(table, landings, out)? != there {
        return Err(refuse());
    }
    Ok(results)
}

/// A byte that occurs in no text.
const END_OF_CELL: u8 = 0xff;

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

/// Columns that form a table of cases.
#[derive(Debug)]
struct ColumnsOfCases {
    names: Vec<String>,
    columns: Vec<Values>,
}

impl CaseCells for ColumnsOfCases {
    fn len(&self) -> usize {
        let length = |column: &Values| match column {
            Values::Numbers(numbers) => numbers.len(),
            Values::Texts(texts) => texts.len(),
        };
        self.columns.first().map_or(0, length)
    }

    fn cell(&self, row: usize, column: usize) -> CaseCell<'_> {
        match &self.columns[column] {
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
        let print = |column: &Values| match column {
            Values::Numbers(numbers) => {
                fingerprint_of_bytes(numbers.iter().flat_map(|number| number.to_le_bytes()))
            }
            Values::Texts(texts) => {
                let cells = texts.iter().map(|text| text.as_deref().unwrap_or_default());
                fingerprint_of_bytes(cells.flat_map(|cell| cell.bytes().chain([END_OF_CELL])))
            }
        };
        let columns = self.names.iter().zip(&self.columns);
        let prints = columns.map(|(name, column)| format!("{name} {}", print(column)));
        prints.collect::<Vec<_>>().join(" ")
    }
}

/// Results of all rows, by column.
#[derive(Debug)]
struct Results {
    columns: Vec<(Quantity, Column)>,
    /// Classes of the outcomes, absent from tables of the command line.
    classes: Column,
    /// Warnings by row.
    warnings: BTreeMap<usize, ContactWarnings>,
    legs: usize,
    units: OutputUnits,
}

impl Results {
    fn new(rows: usize, legs: usize, units: OutputUnits) -> Self {
        let columns = headings(&landing_table::COLUMNS, legs).map(|heading| {
            let column = match heading.name.as_str() {
                "outcome" => Column::of_words(&Outcome::all(MOST_LEGS), rows),
                _ => Column::missing(heading.kind, rows),
            };
            (units.quantity(&heading.name), column)
        });
        Self {
            columns: columns.collect(),
            classes: Column::of_words(&Class::ALL, rows),
            warnings: BTreeMap::new(),
            legs,
            units,
        }
    }

    /// Warnings of all rows, in words.
    fn warnings(&self) -> Vec<String> {
        let rows = self.warnings.iter();
        let rows = rows.map(|(row, warnings)| (format!("row {row}"), *warnings));
        warnings::of_cases(rows, self.units)
    }

    /// Sets the results of all rows; returns their table for the file `out`.
    fn set_all(
        &mut self,
        table: &CaseTable,
        landings: Vec<Option<Landing>>,
        out: &Path,
    ) -> Result<Vec<u8>, Failure> {
        let mut rows = Vec::with_capacity(landings.len());
        for (row, landing) in landings.into_iter().enumerate() {
            let landing =
                landing.ok_or_else(|| Failure::engine(format!("row {row} has no result")))?;
            self.set(row, &landing);
            rows.push((table.name(row), landing));
        }
        let named = rows.iter().map(|(name, landing)| (name.as_str(), landing));
        case_results::table(out, named, self.units, &table.input).map_err(Failure::engine)
    }

    /// Sets the results of a row.
    fn set(&mut self, row: usize, landing: &Landing) {
        self.classes
            .set_word(row, &landing.outcome.class().to_string());
        let cells = cells(&landing_table::COLUMNS, landing, self.legs);
        for ((quantity, column), cell) in self.columns.iter_mut().zip(cells) {
            column.set(row, quantity.cell(cell));
        }
        let warnings = ContactWarnings::of(landing);
        if warnings != ContactWarnings::default() {
            self.warnings.insert(row, warnings);
        }
    }
}
