use super::*;
use touchdown_dynamics::methods::Method;
use touchdown_dynamics::scene::CrushRule;

use crate::readers::vehicle_file::tests::surveyor;

const HEADING: &str = "case,note,vertical_velocity_fps,horizontal_velocity_fps,\
    cross_slope_deg,pitch_deg,yaw_deg,roll_deg,slope_deg,friction";

fn read_text(text: &str) -> Result<Vec<CaseRow>, InputError> {
    let table = read_table(text)?;
    (0..table.len()).map(|row| table.case(row)).collect()
}

fn read_table(text: &str) -> Result<CaseTable, InputError> {
    let settings = Settings::new(1e-5, 20.0, CrushRule::default()).unwrap();
    parse(Path::new("c.csv"), text, &surveyor(), &settings)
}

fn complaint(text: &str) -> String {
    read_text(text).unwrap_err().to_string()
}

#[test]
fn empty_cells_are_defaults_and_cases_without_a_name_have_their_number() {
    let text = format!(
        "{HEADING},angular_velocity_z_dps\na, red,14,11,180,,1,2,15,1,\n,,14,12,180,0,0,0,15,1,90\n"
    );
    let table = read_table(&text).unwrap();
    assert_eq!([table.name(0), table.name(1)], ["a", "2"]);
    let cases = read_text(&text).unwrap();
    let rate = |case: usize| cases[case].scene.conditions().angular_velocity[2];
    assert_eq!((rate(0), rate(1)), (0.0, std::f64::consts::FRAC_PI_2));
    let least = "vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction\n\
                 14,11,180,15,1\n";
    let scene = read_text(least).unwrap()[0].scene;
    assert_eq!(scene.conditions().slope, 15f64.to_radians());
}

#[test]
fn the_first_fault_of_a_long_table_is_told_and_checks_can_be_cancelled() {
    let rows = |wrong: &[usize]| -> String {
        let row = |row| {
            let friction = if wrong.contains(&row) { -1 } else { 1 };
            format!("{row},,14,11,180,0,0,0,15,{friction}\n")
        };
        (1..=3000).map(row).collect()
    };
    for (wrong, told) in [
        (&[1, 2, 2999][..], 1),
        (&[1500, 1499], 1499),
        (&[3000], 3000),
    ] {
        let said = complaint(&format!("{HEADING}\n{}", rows(wrong)));
        assert!(
            said.contains(&format!("row {told}: friction = -1")),
            "{said}"
        );
    }
    let text = format!("{HEADING}\n{}", rows(&[]));
    let (heading, cells) = cells::CsvRows::parse(Path::new("c.csv"), &text).unwrap();
    let heading: Vec<&str> = heading.iter().collect();
    let settings = Settings::new(1e-5, 20.0, CrushRule::default()).unwrap();
    let check = |cells: Box<dyn CaseCells>, cancel| {
        let shared = NamedConditions::default();
        let cancel = AtomicBool::new(cancel);
        CaseTable::of_cells(&heading, cells, &shared, &surveyor(), &settings, &cancel)
    };
    let cancelled = check(Box::new(cells), true).unwrap_err();
    assert_eq!(cancelled.to_string(), "cancelled");
}

#[test]
fn columns_that_say_nothing_are_refused() {
    let row = "1,,14,11,180,0,0,0,15,1";
    for (column, guess) in [
        ("block_frction", "did you mean block_friction"),
        ("crush_rule", "did you mean solver.crush_rule"),
        ("solver.tolerence", "did you mean solver.tolerance"),
        ("search.from_fps", "no such column"),
        ("colour", "there is the column note"),
    ] {
        let said = complaint(&format!("{HEADING},{column}\n{row},1\n"));
        let place = format!("c.csv:1: column {column}: ");
        assert!(said.starts_with(&place) && said.contains(guess), "{said}");
    }
    let twice = complaint(&format!("{HEADING},friction\n{row},1\n"));
    assert!(twice.contains("column friction is there twice"), "{twice}");
}

#[test]
fn rows_may_differ_in_how_they_are_computed() {
    let text = format!(
        "{HEADING},solver.tolerance,solver.crush_rule,solver.method,solver.interval_s\n\
         1,,14,11,180,0,0,0,15,1,1e-8,section,,\n2,,14,11,180,0,0,0,15,1,,,,\n\
         3,,14,11,180,0,0,0,15,1,,,rk4,0.001\n"
    );
    let cases = read_text(&text).unwrap();
    let settings = |case: usize| cases[case].settings;
    let of = |case| {
        (
            settings(case).tolerance(),
            settings(case).rule_choices().crush.unwrap(),
        )
    };
    assert_eq!(of(0), (1e-8, CrushRule::Section));
    assert_eq!(of(1), (1e-5, CrushRule::PivotRate));
    assert_eq!(settings(0).time_limit(), 20.0);
    assert!(matches!(settings(2).method(), Method::RungeKutta(_)));
    let wrong = complaint(&text.replace("section", "sections"));
    assert!(
        wrong.contains("solver.crush_rule = sections: expected one of"),
        "{wrong}"
    );
    let wrong = complaint(&text.replace("1e-8", "8"));
    assert!(
        wrong.starts_with("c.csv:2: row 1: at solver.tolerance = 8"),
        "{wrong}"
    );
}

#[test]
fn tip_form_needs_no_euler_columns() {
    let text = "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,\
                friction,tip_deg,tip_azimuth_deg\n1,14,11,180,15,1,9,90\n";
    let tip = read_text(text).unwrap()[0]
        .scene
        .conditions()
        .attitude
        .tip();
    assert!((tip.tip.to_degrees() - 9.0).abs() < 1e-12);
}

#[test]
fn rows_may_differ_in_numbers_of_the_vehicle() {
    let text = format!(
        "{HEADING},vehicle.mass_slug,vehicle.legs[2].strut.preload_lb\n1,,14,11,180,0,0,0,15,1,25,\n\
         2,,14,11,180,0,0,0,15,1,,200\n"
    );
    let cases = read_text(&text).unwrap();
    let of = |case: usize| {
        let vehicle = &cases[case].vehicle;
        let preload = vehicle.hinged_legs()[1]
            .design()
            .strut
            .damper()
            .unwrap()
            .preload;
        (vehicle.mass(), preload)
    };
    assert_eq!((of(0), of(1)), ((25.0, 185.0), (20.0, 200.0)));
    let wrong = complaint(&text.replace(",25,", ",-25,"));
    let expected = "c.csv:2: row 1: at vehicle.mass_slug = -25:";
    assert!(
        wrong.starts_with(expected) && wrong.contains("0 < value"),
        "{wrong}"
    );
    let wrong = complaint(&text.replace("mass_slug", "mas_slug"));
    assert!(
        wrong.contains(
            "c.csv:1: column vehicle.mas_slug: no such column; did you mean vehicle.mass_slug"
        ),
        "{wrong}"
    );
    assert!(complaint(&text.replace(",25,", ",x,")).contains("vehicle.mass_slug = x"));
}

#[test]
fn columns_may_be_in_si() {
    let heading = HEADING
        .replace("slope_deg", "slope_rad")
        .replace("cross_slope_rad", "cross_slope_deg");
    let text = format!(
        "{heading},vehicle.mass_kg\n1,,14,11,180,0,0,0,0.2617993877991494,1,291.8780587441273\n\
         2,,14,11,180,0,0,0,1.6,1,\n"
    );
    let steep = complaint(&text);
    assert!(
        steep.ends_with(
            "row 2: slope_rad = 1.6: expected -90 < value < 90 (in deg: this is 91.6732)"
        ),
        "{steep}"
    );
    let cases = read_text(&text.replace("1.6", "0.1")).unwrap();
    assert_eq!(cases[0].scene.conditions().slope, 15f64.to_radians());
    assert_eq!(cases[0].vehicle.mass(), 20.0);
    let both = complaint(&format!(
        "{heading},slope_deg\n1,,14,11,180,0,0,0,0.1,1,15\n"
    ));
    assert!(
        both.contains("columns slope_rad and slope_deg: expected one spelling of a quantity"),
        "{both}"
    );
}

#[test]
fn complaints_name_line_row_column_and_value() {
    let good = "1,,14,11,180,0,0,0,15,1";
    let row = |bad: &str| complaint(&format!("{HEADING}\n{good}\n{bad}\n"));
    assert_eq!(
        row("2,,14,x,180,0,0,0,15,1"),
        "c.csv:3: row 2: horizontal_velocity_fps = x: expected a finite number"
    );
    assert!(row("2,,14,NaN,180,0,0,0,15,1").contains("horizontal_velocity_fps = NaN"));
    assert!(row("2,,14,11,180,0,0,0,95,1").contains("c.csv:3: row 2: slope_deg = 95"));
    assert!(row("2,,14,11,180,0,0,0,15,").contains("row 2: friction is missing"));
    let of_windows = complaint(&format!(
        "{HEADING}\r\n{good}\r\n2,,14,11,180,0,0,0,15,\r\n"
    ));
    assert!(
        of_windows.starts_with("c.csv:3: row 2: friction is missing"),
        "{of_windows}"
    );
    assert!(row("2,,14").contains("c.csv:3: not a table"));
    assert!(complaint(HEADING).contains("no rows"));
    let without = HEADING.replace(",slope_deg,fr", ",fr");
    assert!(complaint(&without).contains("c.csv:1: column slope_deg is missing: expected"));
    let both = format!("{HEADING},tip_deg,tip_azimuth_deg\n{good},3,0\n");
    assert!(complaint(&both).contains("not both"));
}
