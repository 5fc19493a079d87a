//! Results in SI units: the same numbers times the factors of the units, in tables, records, reports and pictures.

#![allow(missing_docs, reason = "tests are not an interface")]

mod landings;
mod sweeps;

use touchdown_input::documents::output_units::OutputUnits;

use crate::common::{BASELINE, Bench, Done};

const FOOT: f64 = 0.3048;
const POUND: f64 = 4.4482216152605;
/// Endings of columns in US and in SI units, and how many of the latter one of the former is; those first that end with
/// another.
const FACTORS: [(&str, &str, f64); 5] = [
    ("_fps", "_mps", FOOT),
    ("_ftlb", "_j", POUND * FOOT),
    ("_ft", "_m", FOOT),
    ("_lb", "_n", POUND),
    ("_fps_per_unit", "_mps_per_unit", FOOT),
];

fn run(bench: &Bench, arguments: &[&str]) -> Done {
    let done = bench.run(arguments);
    assert_eq!(done.code, Some(0), "{arguments:?}: {}", done.err);
    done
}

/// Name and factor of a column in SI.
fn in_si(column: &str) -> (String, f64) {
    let found = (FACTORS.iter()).find_map(|(us, si, factor)| {
        let bare = column.strip_suffix(us)?;
        Some((format!("{bare}{si}"), *factor))
    });
    found.unwrap_or_else(|| (column.to_owned(), 1.0))
}

fn assert_is(si: &str, us: &str, factor: f64, place: &str) {
    match (si.parse::<f64>(), us.parse::<f64>()) {
        (Ok(si), Ok(us)) => {
            let expected = us * factor;
            let error = (si - expected).abs();
            assert!(
                error <= 4.0 * f64::EPSILON * expected.abs(),
                "{place}: {us} gives {si}"
            );
        }
        _ => assert_eq!(si, us, "{place}"),
    }
}

/// Checks every cell of a table. The columns `of_parameter` are in the unit of the parameter that another column names.
fn compare(us: &str, si: &str, of_parameter: &[&str], parameter: &str) {
    let rows = |text: &str| -> Vec<Vec<String>> {
        let rows = text.lines();
        rows.map(|row| row.split(',').map(str::to_owned).collect())
            .collect()
    };
    let (us, si) = (rows(us), rows(si));
    assert_eq!(us.len(), si.len());
    let heading = &us[0];
    let named: Vec<String> = heading.iter().map(|name| in_si(name).0).collect();
    assert_eq!(si[0], named);
    let parameter = heading.iter().position(|name| name == parameter);
    for (row, (us, si)) in us.iter().zip(&si).enumerate().skip(1) {
        for (column, name) in heading.iter().enumerate() {
            let place = format!("row {row}, {name}");
            let own = parameter.map_or(1.0, |column| in_si(&us[column]).1);
            if Some(column) == parameter {
                assert_eq!(si[column], in_si(&us[column]).0);
            } else if name == "unit" {
                assert!(us[column] != "ft" || si[column] == "m", "{place}");
            } else if of_parameter.contains(&name.as_str()) {
                assert_is(&si[column], &us[column], own, &place);
            } else {
                let per = if name.ends_with("_per_unit") {
                    own
                } else {
                    1.0
                };
                assert_is(&si[column], &us[column], in_si(name).1 / per, &place);
            }
        }
    }
}

#[test]
fn pictures_have_the_units_of_their_tables() {
    let bench = Bench::new();
    run(
        &bench,
        &["sweep", "sweep.toml", "--out", "si", "--units", "SI"],
    );
    run(&bench, &["sweep", "sweep.toml", "--out", "us"]);
    let drawn = bench.read("si/sweep.svg");
    run(&bench, &["plot", "si/sweep.csv"]);
    assert_eq!(bench.read("si/sweep.svg"), drawn);
    assert!(drawn.contains("vertical velocity 4.2672 m/s") && !drawn.contains("ft/s"));
    std::fs::copy(bench.path("us/sweep.json"), bench.path("si/sweep.json")).unwrap();
    bench.run(&["plot", "si/sweep.csv"]).refused(&[
        "si/sweep.csv",
        "record: expected speeds in m/s, as in the table",
    ]);

    for (name, units) in [("us.csv", "US"), ("si.csv", "SI")] {
        run(
            &bench,
            &[&BASELINE[..], &["--history", name, "--units", units]].concat(),
        );
    }
    run(&bench, &["plot", "si.csv"]);
    let drawn = bench.read("si.svg");
    for title in [
        "Velocity, m/s",
        "Strut force, N",
        "Footpad load, N",
        "Energy, J",
    ] {
        assert!(drawn.contains(title), "{title}");
    }
    run(
        &bench,
        &[
            "plot",
            "si.csv",
            "--columns",
            "stroke_#_m",
            "--out",
            "strokes.svg",
        ],
    );
    bench
        .run(&["plot", "us.csv", "si.csv", "--out", "both.svg"])
        .refused(&["expected histories in the same units"]);
}

#[test]
fn every_column_with_a_unit_comes_out_in_si() {
    const PAGE: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/output.md"));
    let mut converted = 0;
    for row in PAGE.lines().filter(|row| row.starts_with("| `")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let [_, column, unit, _, _] = cells[..] else {
            continue;
        };
        let column = column.trim_matches('`');
        let quantity = OutputUnits::Si.quantity(column);
        let (name, _) = in_si(column);
        assert_eq!(quantity.name(), name);
        // Nothing else has a unit of length or force.
        assert_eq!(
            name != column,
            unit.contains("ft") || unit.contains("lb"),
            "{column}, {unit}"
        );
        converted += usize::from(name != column);
    }
    assert!(converted > 40, "{converted} columns");
}
