//! Tests of the laboratory as its user runs it, in one binary.

// Some of it only the tests of the program use.
#[allow(dead_code)]
#[path = "../../../touchdown/tests/suite/common/mod.rs"]
mod common;

mod stress;
mod study;
mod verdicts;
mod work_precision;

/// The laboratory as built for the tests.
const PROGRAM: &str = env!("CARGO_BIN_EXE_touchdown-lab");
