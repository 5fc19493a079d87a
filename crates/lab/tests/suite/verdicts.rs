//! Landings of the campaign of verdicts, a few.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::Bench;

#[test]
fn a_center_of_gravity_that_comes_back_over_the_feet_has_not_toppled() {
    let bench = Bench::new();
    // It touches down with its CG beyond its feet and a soft strut moves a foot out; a strut pushes it back.
    for landing in ["14189", "14330"] {
        let told = bench.run(&["verdicts", "--landing", landing]).out;
        let verdict = told.lines().find(|line| line.starts_with("verdict"));
        let verdict = verdict.unwrap();
        assert!(verdict.starts_with("verdict stable-subsided"), "{verdict}");
        assert!(verdict.contains("then time-expired"), "{verdict}");
    }
}
