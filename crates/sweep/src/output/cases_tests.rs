use super::*;

const HEADING: &str = "case,colour,vertical_velocity_fps,horizontal_velocity_fps,\
    cross_slope_deg,pitch_deg,yaw_deg,roll_deg,slope_deg,friction";

fn read_text(text: &str) -> Result<Cases, InputError> {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../sweeps/vehicles/surveyor-table-4-1.toml"
    );
    let surveyor = VehicleFile::read(Path::new(path)).unwrap();
    parse(&Place::file(Path::new("c.csv")), text, &surveyor)
}

fn complaint(text: &str) -> String {
    read_text(text).unwrap_err().to_string()
}

#[test]
fn unknown_columns_are_ignored_and_empty_cells_are_defaults() {
    let text = format!(
        "{HEADING},angular_velocity_z_dps\na, red,14,11,180,,1,2,15,1,\nb,,14,12,180,0,0,0,15,1,90\n"
    );
    let cases = read_text(&text).unwrap();
    assert_eq!(cases.names, ["a", "b"]);
    let rate = cases.scenes[1].conditions().angular_velocity[2];
    assert_eq!(rate, std::f64::consts::FRAC_PI_2);
    assert_eq!(cases.scenes[0].conditions().angular_velocity[2], 0.0);
}

#[test]
fn tip_form_needs_no_euler_columns() {
    let text = "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,\
                friction,tip_deg,tip_azimuth_deg\n1,14,11,180,15,1,9,90\n";
    let tip = read_text(text).unwrap().scenes[0]
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
        let vehicle = cases.vehicle(case);
        let preload = vehicle.legs()[1].design().strut.preload;
        (vehicle.mass(), preload)
    };
    assert_eq!((of(0), of(1)), ((25.0, 185.0), (20.0, 200.0)));
    let wrong = complaint(&text.replace(",25,", ",-25,"));
    let expected = "c.csv:2: row 1: at vehicle.mass_slug = -25:";
    assert!(
        wrong.starts_with(expected) && wrong.contains("> 0"),
        "{wrong}"
    );
    let wrong = complaint(&text.replace("mass_slug", "mas_slug"));
    assert!(
        wrong.contains(
            "c.csv:1: column vehicle.mas_slug: no such parameter; did you mean vehicle.mass_slug"
        ),
        "{wrong}"
    );
    assert!(complaint(&text.replace(",25,", ",x,")).contains("vehicle.mass_slug = x"));
}

#[test]
fn complaints_name_line_row_column_and_value() {
    let good = "1,,14,11,180,0,0,0,15,1";
    let row = |bad: &str| complaint(&format!("{HEADING}\n{good}\n{bad}\n"));
    assert_eq!(
        row("2,,14,x,180,0,0,0,15,1"),
        "c.csv:3: row 2: horizontal_velocity_fps = x: allowed is a finite number"
    );
    assert!(row("2,,14,NaN,180,0,0,0,15,1").contains("horizontal_velocity_fps = NaN"));
    assert!(row("2,,14,11,180,0,0,0,95,1").contains("c.csv:3: row 2: slope_deg = 95"));
    assert!(row("2,,14,11,180,0,0,0,15,").contains("row 2: friction is missing"));
    assert!(row("2,,14").contains("c.csv:3: not a table"));
    assert!(complaint(HEADING).contains("no rows"));
    assert!(
        complaint(&format!(
            "{}\n",
            HEADING.replace("slope_deg,fr", "slope_rad,fr")
        ))
        .contains("c.csv:1: column slope_deg is missing (there is a column slope_rad)")
    );
    let both = format!("{HEADING},tip_deg,tip_azimuth_deg\n{good},3,0\n");
    assert!(complaint(&both).contains("not both"));
}

#[test]
fn results_begin_with_the_case() {
    let names = ["a,b".to_owned(), "c".to_owned()];
    let landings = [
        landing_table::tests::example(),
        landing_table::tests::example(),
    ];
    let text = String::from_utf8(table(&names, &landings).unwrap()).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("case,outcome,end_time_s"));
    assert!(lines[1].starts_with("\"a,b\",failure,1.5"));
    assert_eq!(lines.len(), 3);
}
