//! Sweeps: whole, from a document or file to result files; the boundary at a single point.

use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::points::set_value::SetValue;
use touchdown_input::sweeps::overrides::Overrides;
use touchdown_input::sweeps::sweep_file;
use touchdown_search::boundary::Boundary;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::result_files::{self, NamedFiles};
use touchdown_sweep::output::{bands_table, results, warnings};
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::summary::sweep_counts::SweepCounts;
use touchdown_sweep::threads::run::{Observer, Workers};
use touchdown_sweep::threads::runner::{Runner, Task};

use crate::VERSION;
use crate::columns::by_name;
use crate::documents::{Vehicle, output_units};
use crate::errors::{Failure, guarded, in_the_way};
use crate::interruptible::{self, Work};

/// A sweep ready to run.
#[pyclass(frozen, module = "touchdown._engine")]
#[derive(Debug)]
pub struct Sweep(pub sweep_file::Sweep);

#[pymethods]
impl Sweep {
    /// Reads the text of a sweep file; it names its vehicle `vehicle.toml` and may use any other `files`. `name` is the
    /// name of the results.
    #[new]
    fn new(
        name: &str,
        text: &str,
        vehicle: &Vehicle,
        files: HashMap<String, String>,
    ) -> Result<Self, Failure> {
        let path = PathBuf::from(format!("{name}.toml"));
        let own = [
            (path.clone(), text.to_owned()),
            (
                PathBuf::from("vehicle.toml"),
                vehicle.file.document.source().text,
            ),
        ];
        let others = files
            .into_iter()
            .map(|(path, text)| (PathBuf::from(path), text));
        let copies: Vec<Source> = (own.into_iter().chain(others))
            .map(|(path, text)| Source { path, text })
            .collect();
        guarded(|| {
            let sweep = sweep_file::Sweep::read_from(&path, Library::Copies(&copies));
            sweep.map(Self).map_err(InputError::nowhere)
        })
    }

    /// Reads a sweep file and replaces some of its values, like the options of the command line.
    #[staticmethod]
    fn from_file(
        path: PathBuf,
        vehicle: Option<&Vehicle>,
        set: Vec<(String, String)>,
        units: Option<&str>,
    ) -> Result<Self, Failure> {
        let set = set.iter().map(|(name, text)| SetValue::new(name, text));
        let overrides = Overrides {
            vehicle: vehicle.map(|vehicle| vehicle.file.clone()),
            set: set.collect::<Result<_, _>>()?,
            units: units.map(output_units).transpose()?,
            ..Overrides::default()
        };
        guarded(|| sweep_file::Sweep::read(&path)?.with(&overrides).map(Self))
    }

    /// Name used for its files.
    #[getter]
    fn name(&self) -> String {
        self.0.stem()
    }

    /// Runs the sweep into a folder, as the command line does, with a journal beside the results; returns warnings of
    /// the journal and of the results. Keeps existing results of the same input; refuses to replace those of other input
    /// unless `overwrite` is set.
    fn run(
        &self,
        py: Python,
        out: PathBuf,
        is_parquet: bool,
        overwrite: bool,
        threads: Option<NonZeroUsize>,
        watch: Option<&Bound<PyAny>>,
    ) -> PyResult<[Vec<String>; 2]> {
        let sweep = self.0.clone();
        interruptible::run(py, watch, move |work| {
            let folder = Folder::open(&out)?;
            result_files::check_places(&sweep, &folder, overwrite).map_err(in_the_way)?;
            if !overwrite && result_files::are_there(&sweep, &folder, VERSION, is_parquet) {
                return Ok([Vec::new(), Vec::new()]);
            }
            run(&sweep, &folder, is_parquet, overwrite, threads, work)
        })
    }
}

fn run(
    sweep: &sweep_file::Sweep,
    folder: &Folder,
    is_parquet: bool,
    overwrite: bool,
    threads: Option<NonZeroUsize>,
    work: &Work,
) -> Result<[Vec<String>; 2], Failure> {
    let workers = Workers::start(threads)?;
    let runner = Runner {
        workers: &workers,
        folder,
        observer: work,
        cancel: &work.cancel,
        version: VERSION,
    };
    // The number of points of a map emerges round by round.
    let known_before = sweep.map().is_none().then(|| sweep.design.count());
    work.more(known_before.unwrap_or(0));
    let task = Task::Sweep(sweep, Shard::WHOLE);
    let run = match overwrite {
        true => runner.begin(task)?,
        false => runner.begin_or_grow(task)?.0,
    };
    let of_journal = run.warnings().to_vec();
    let mut found = run.compute()?.results()?;
    let draw = |_: &_, _: &str| Ok::<_, Failure>(NamedFiles::new());
    let written = workers
        .within(|| result_files::write(sweep, &mut found, folder, VERSION, is_parquet, draw));
    let (counts, _) = written?;
    found.end_journal(sweep)?;
    Ok([of_journal, warnings::of_sweep(sweep, &counts)])
}

/// Searches the boundary at the first point of a sweep; returns the result and its warnings.
#[pyfunction]
pub fn boundary<'py>(
    py: Python<'py>,
    sweep: &Sweep,
    threads: Option<NonZeroUsize>,
    watch: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
    let sweep = sweep.0.clone();
    let (found, told) = interruptible::run(py, watch, move |work| {
        let workers = Workers::start(threads)?;
        work.more(1);
        let mut found = None;
        workers.each_point(&sweep, &[0], 1, work, &work.cancel, &mut |_, finding| {
            found = Some(finding);
        })?;
        let mut counts = SweepCounts::of(&sweep);
        if let Some(finding) = &found {
            counts.add(&sweep, 0, finding);
        }
        match found {
            Some(Finding::Boundary(boundary)) => {
                Ok((boundary, warnings::of_sweep(&sweep, &counts)))
            }
            _ => Err(Failure::Engine("the search gave no boundary".to_owned())),
        }
    })?;
    Ok((results(py, &found)?, told))
}

fn results<'py>(py: Python<'py>, found: &Boundary) -> PyResult<Bound<'py, PyDict>> {
    let results = by_name(py, &results::COLUMNS, found, 0)?;
    let bands = PyList::empty(py);
    for band in bands_table::numbered(found) {
        // Their number is their place in the list.
        bands.append(by_name(py, &bands_table::COLUMNS[1..], &band, 0)?)?;
    }
    results.set_item("bands", bands)?;
    Ok(results)
}
