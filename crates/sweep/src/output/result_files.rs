//! The files written by a sweep: tables, record, and pictures if drawn.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::sweeps::sweep::{Sweep, partial};

use crate::journal::shard::Shard;
use crate::journal::{InOrder, kept};
use crate::output::file_writer::{Draft, Folder, WriteError};
use crate::output::output_guard::OutputGuard;
use crate::output::results;
use crate::output::tables::{Tables, TablesError};
use crate::summary::sweep_counts::SweepCounts;

/// Files by name.
pub type NamedFiles = Vec<(String, Vec<u8>)>;

/// Suffixes of the names of tables, each with a column that the table always has.
const TABLES: [(&str, &str); 9] = [
    ("", "first_transition_to"),
    ("-bands", "bracket_width_fps"),
    ("-probabilities", "topple_probability"),
    ("-sensitivity", "dvh_dp_fps_per_unit"),
    ("-quantiles", "low_95_fps"),
    ("-distribution", "cumulative_share"),
    ("-edges", "edge_kind"),
    ("-grid", "estimated_error_fps"),
    ("-surface", "triangle"),
];
/// Suffixes of the names of pictures.
const PICTURES: [&str; 7] = [
    "",
    "-contours",
    "-contours-negative",
    "-perspective",
    "-sensitivity",
    "-probabilities",
    "-distribution",
];

/// True if a file with this first line is a table of a sweep. The table of its points may also be one of landings.
fn is_table(line: &str, column: &str) -> bool {
    let has = |name: &str| {
        let in_si = OutputUnits::Si.quantity(name);
        (line.split(',')).any(|known| known == name || known == in_si.name())
    };
    has(column) || column == TABLES[0].1 && has("outcome") && has("end_time_s")
}

/// Checks that the results of a sweep may be written: files in their places must be earlier results of the same input.
///
/// # Errors
/// Names a file that is not.
pub fn check_places(sweep: &Sweep, folder: &Folder, overwrite: bool) -> Result<(), InputError> {
    let inputs: Vec<&Path> = [sweep.path.as_path(), sweep.vehicle.document.path()].into();
    let guard = OutputGuard {
        inputs: &inputs,
        overwrite,
    };
    let stem = sweep.stem();
    for (end, column) in TABLES {
        let table = folder.path(&format!("{stem}{end}.csv"));
        guard.check(&table, |line| is_table(line, column))?;
    }
    let record = folder.path(&format!("{stem}.json"));
    let there = record_in(&record);
    guard.check(&record, |_| there["program"]["name"] == "touchdown")?;
    let mut tables = [".csv", ".parquet"]
        .map(|form| folder.path(&format!("{stem}{form}")))
        .into_iter();
    match tables.find(|table| table.exists()) {
        Some(table) if !overwrite && !includes(sweep, input_of(there)) => {
            let complaint =
                "holds results of other input: expected another folder or name, or --overwrite";
            Err(InputError::in_file(&table, complaint))
        }
        _ => Ok(()),
    }
}

/// True if results of this sweep are there already, computed by this version of the program.
pub fn are_there(sweep: &Sweep, folder: &Folder, version: &str, has_parquet: bool) -> bool {
    let [table, record, parquet] =
        ["csv", "json", "parquet"].map(|form| folder.path(&format!("{}.{form}", sweep.stem())));
    let there = record_in(&record);
    // The table is written last.
    table.exists()
        && (!has_parquet || parquet.exists())
        && there["program"] == results::program(version)
        && input_of(there) == own_input(sweep)
}

/// True if the input of a sweep is that of existing results, or a sample that has grown beyond theirs: it has their rows.
fn includes(sweep: &Sweep, mut existing: Value) -> bool {
    if let Some(count) = existing.pointer_mut("/input/sample/count")
        && sweep.design.is_nested()
        && (count.as_u64()).is_some_and(|count| count <= sweep.design.count() as u64)
    {
        *count = sweep.design.count().into();
    }
    own_input(sweep) == existing
}

/// The record in a file; null if there is none.
fn record_in(file: &Path) -> Value {
    let text = fs::read_to_string(file).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

fn own_input(sweep: &Sweep) -> Value {
    input_of(results::record(sweep, &SweepCounts::of(sweep), ""))
}

/// The content of a record except results, the program, file names and the fingerprint of the rest.
fn input_of(mut record: Value) -> Value {
    for (part, key) in [
        ("", "counts"),
        ("", "program"),
        ("", "input_fingerprint"),
        ("/input", "sweep_file"),
        ("/input", "vehicle_file"),
    ] {
        if let Some(Value::Object(fields)) = record.pointer_mut(part) {
            fields.remove(key);
        }
    }
    record
}

/// Removes files that an earlier run of a sweep of this name wrote and this one did not, so that results of two runs
/// never mix.
fn remove_stale(stem: &str, folder: &Folder, written: &[&Path]) -> Result<(), WriteError> {
    let tables = TABLES.iter().flat_map(|(end, _)| {
        [".csv", ".parquet"].map(|form| folder.path(&format!("{stem}{end}{form}")))
    });
    let tables = tables.chain([folder.path(&format!("{stem}.json"))]);
    let kept = kept(&folder.path(&Shard::WHOLE.journal(stem)));
    let pictures = PICTURES
        .iter()
        .flat_map(|end| [".svg", ".png"].map(|form| folder.path(&format!("{stem}{end}{form}"))));
    for file in tables.chain(pictures).chain([kept]) {
        if !written.contains(&file.as_path()) && file.is_file() {
            fs::remove_file(&file).map_err(|error| WriteError { path: file, error })?;
        }
    }
    Ok(())
}

/// Writes all results of a sweep into a folder, with the pictures that `draw` makes from the tables and the record.
/// Returns the counts and the files.
///
/// # Errors
/// If a result is missing, something cannot be read or written, or a picture cannot be drawn.
pub fn write<E: From<TablesError> + From<WriteError>>(
    sweep: &Sweep,
    results: &mut InOrder,
    folder: &Folder,
    version: &str,
    has_parquet: bool,
    draw: impl FnOnce(&Tables, &str) -> Result<NamedFiles, E>,
) -> Result<(SweepCounts, Vec<PathBuf>), E> {
    let tables = Tables::write(sweep, results, folder, has_parquet)?;
    let record = results::record(sweep, &tables.counts, version);
    let record = format!("{record:#}\n");

    let mut files = draw(&tables, &record)?;
    files.push((format!("{}.json", sweep.stem()), record.into_bytes()));
    let mut drafts = files
        .iter()
        .map(|(name, bytes)| folder.draft_of(name, bytes))
        .collect::<Result<Vec<_>, _>>()?;
    drafts.extend(tables.parquet);
    let beside = [
        tables.bands,
        tables.probabilities,
        tables.quantiles,
        tables.distribution,
        tables.sensitivity,
    ];
    drafts.extend(beside.into_iter().flatten());
    drafts.extend(tables.of_map);
    // The table of points comes last: if it exists, so do the others.
    drafts.push(tables.points);
    let places: Vec<&Path> = drafts.iter().map(Draft::place).collect();
    remove_stale(&sweep.stem(), folder, &places)?;
    if sweep.part.is_none() {
        remove_stale(&partial(&sweep.stem()), folder, &places)?;
    }
    Ok((tables.counts, Draft::put_in_place(drafts)?))
}
