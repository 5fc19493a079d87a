//! Tests of the program as a user runs it, in one binary.

mod common;

mod ask;
mod bad_landings;
mod bad_sweeps;
mod committed_results;
mod document_examples;
mod dry_runs;
mod explore;
mod found_by_stress;
mod full_disk;
mod golden;
mod interruptions;
mod legs;
mod maps;
mod nothing_silent;
mod output_columns;
mod output_in_si;
mod pictures;
mod plots;
mod promised_refusals;
mod runs;
mod samples;
mod scene_files;
mod sensitivities;
mod set_values;
mod soil;
mod starting_files;
mod surface;
mod verdicts;

/// The program as built for the tests.
const PROGRAM: &str = env!("CARGO_BIN_EXE_touchdown");
