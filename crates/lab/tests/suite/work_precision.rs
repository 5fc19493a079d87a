//! The work-precision table: what it says falls and rises as it must.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::Bench;

#[test]
fn tighter_tolerances_cost_more_and_err_less() {
    let bench = Bench::new();
    let done = bench.run(&[
        "work-precision",
        "--quick",
        "--vehicle",
        "surveyor.toml",
        "--out",
        "new",
    ]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(
        bench.list("new"),
        [
            "work-precision-evaluations.svg",
            "work-precision.csv",
            "work-precision.svg"
        ]
    );
    let picture = bench.read("new/work-precision-evaluations.svg");
    assert!(picture.contains("Evaluations of the equations of motion"));
    let table = std::fs::read_to_string(bench.path("new/work-precision.csv")).unwrap();
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let heading = lines.next().unwrap();
    let rows: Vec<_> = lines.collect();
    let column = |name: &str| -> Vec<f64> {
        let index = heading.iter().position(|column| *column == name).unwrap();
        rows.iter().map(|row| row[index].parse().unwrap()).collect()
    };
    assert_eq!(column("tolerance"), [1e-3, 1e-4, 1e-6]);
    assert_eq!(column("transitions"), [5.0; 3]);
    let evaluations = column("mean_derivative_evaluations");
    assert!(
        evaluations.is_sorted() && evaluations[0] > 1000.0,
        "{evaluations:?}"
    );
    for (name, most) in [
        ("worst_position_error_at_1s_ft", 1e-6),
        ("worst_pitch_error_at_1s_deg", 1e-5),
        ("worst_least_angle_error_deg", 1e-3),
        ("worst_transition_error_fps", 1e-4),
    ] {
        let errors = column(name);
        assert!(errors.is_sorted_by(|a, b| a > b), "{name}: {errors:?}");
        assert!(errors[2] < most, "{name}: {errors:?}");
    }
}
