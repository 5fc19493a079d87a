//! Landings that the laboratory's `stress` once found.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{Bench, rows};

/// Wild landings that could once not be computed or made no sense; the reason in the column `note`.
const FOUND: &str = include_str!("found-by-stress.csv");

/// Each of them still fails alike, or is computed: then with numbers throughout and an account of energy that closes, at
/// a tolerance at which it has to.
#[test]
fn what_stress_once_found_makes_sense() {
    let bench = Bench::new();
    bench.write("cases.csv", FOUND);
    let found = rows(FOUND);
    let landed = bench.land_again("surveyor.toml", "cases.csv", "1e-6");
    assert_eq!(landed.len(), found.len());
    for (found, landed) in found.iter().zip(&landed) {
        let is_number = |cell: &String| cell != "NaN" && cell != "inf" && cell != "-inf";
        assert!(landed.values().all(is_number), "{landed:?}");
        if landed["outcome"] == "failure" {
            assert!(
                found["note"].contains(&landed["failure"]),
                "{found:?} {landed:?}"
            );
            continue;
        }
        let number = |name: &str| -> f64 { landed[name].parse().unwrap() };
        let kinetic = number("initial_kinetic_energy_ftlb");
        let in_play = 1.0 + kinetic + number("potential_energy_change_ftlb").abs();
        let open = number("energy_closure_ftlb").abs() / in_play;
        assert!(open < 4e-6, "{found:?}: {open}");
    }
}
