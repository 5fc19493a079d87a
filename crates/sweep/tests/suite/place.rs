//! A sweep at a single place, from its file and from its record: what the sweep itself found there.

use std::fs;
use std::path::{Path, PathBuf};

use touchdown_input::documents::column::Cell;
use touchdown_input::points::assignment::Assignment;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::output::results;
use touchdown_sweep::threads::run::Workers;

fn home() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The cells of a result row by name; the axes come first.
fn row(table: &str, number: usize) -> Vec<(String, String)> {
    let text = fs::read_to_string(home().join(table)).unwrap();
    let cells = |line: &str| -> Vec<String> { line.split(',').map(str::to_owned).collect() };
    let heading = cells(text.lines().next().unwrap());
    let row = cells(text.lines().nth(number).unwrap());
    heading.into_iter().zip(row).collect()
}

/// Results of the sweep at its first point, by name.
fn found(sweep: &Sweep) -> Vec<(String, String)> {
    let found = Workers::start(None).unwrap().points(sweep, &[0]).unwrap();
    let cells = results::row(sweep, 0, &found[0]).into_iter();
    let heading = results::heading(sweep).into_iter();
    heading
        .zip(cells)
        .map(|(heading, cell): (_, Cell)| {
            let quantity = sweep.units.quantity(&heading.name);
            (quantity.name().to_owned(), quantity.cell(cell).to_string())
        })
        .collect()
}

/// Pitch, tip and cross-slope, SI and physical rules, other vehicles, grids and maps.
#[test]
fn a_place_of_a_record_has_what_the_table_says() {
    for (stem, number, axes) in [
        ("results/figure-4-09", 12, 1),
        ("results/figure-4-17", 3, 1),
        ("results/figure-4-24", 9, 1),
        ("results/no-products/figure-4-23", 4, 1),
        ("results/section-rule/figure-4-05", 5, 1),
        ("results/surface-4-20", 700, 2),
        ("results/landers/six-legs-map", 80, 2),
        ("results/landers/four-legs-roll", 25, 1),
    ] {
        let expected = row(&format!("{stem}.csv"), number);
        let value = |(name, value): &(String, String)| Assignment::new(name, value).unwrap();
        let at: Vec<Assignment> = expected[..axes].iter().map(value).collect();
        let record = home().join(format!("{stem}.json"));
        let text = fs::read_to_string(&record).unwrap();
        let sweep = Sweep::of_record(&text, &record, &at).unwrap();
        let found = found(&sweep);
        // Tables of maps have a column more.
        let of_points = expected.iter().filter(|(name, _)| name != "level");
        assert!(found.iter().eq(of_points), "{stem}: {found:?}");
    }
}

#[test]
fn a_place_between_the_points_of_a_sweep_file_is_searched_in_any_unit() {
    let sweep = || Sweep::read(&home().join("sweeps/figure-4-09.toml")).unwrap();
    let at = |text: &str| sweep().at(&[Assignment::parse(text).unwrap()]);
    let [degrees, radians] = ["roll_deg=31", "roll_rad=0.5410520681182421"].map(|text| {
        let found = found(&at(text).unwrap());
        found[2].1.parse::<f64>().unwrap()
    });
    assert!((degrees - radians).abs() < 1e-9 && (12.0..14.0).contains(&degrees));
    for (text, complaint) in [
        (
            "slope_deg=3",
            "slope_deg = 3: does not vary in the sweep: expected roll_deg",
        ),
        ("roll_deg=36001", "roll_deg"),
    ] {
        let said = at(text).unwrap_err().to_string();
        assert!(said.contains(complaint), "{said}");
    }
    let said = sweep().at(&[]).unwrap_err().to_string();
    assert!(said.contains("roll_deg is missing"), "{said}");
    for record in ["", "{}", "{\"input\": 3}"] {
        let said = Sweep::of_record(record, Path::new("x.json"), &[]).unwrap_err();
        assert_eq!(said.to_string(), "x.json: expected the record of a sweep");
    }
}
