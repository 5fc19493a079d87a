use super::*;
use std::fs;
use touchdown_dynamics::scene::CrushRule;
use touchdown_search::boundary::Extent;

const FIGURE: &str = include_str!("../../../../sweeps/figure-4-09.toml");
const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");

/// The sweep of Figure 4-9, as shipped with the program.
pub(crate) fn figure_4_09() -> Sweep {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-09.toml");
    Sweep::read(Path::new(path)).unwrap()
}

pub(crate) fn read(text: &str) -> Result<Sweep, InputError> {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("vehicles")).unwrap();
    fs::write(
        folder.path().join("vehicles/surveyor-table-4-1.toml"),
        SURVEYOR,
    )
    .unwrap();
    let path = folder.path().join("figure.toml");
    fs::write(&path, text).unwrap();
    Sweep::read(&path)
}

#[test]
fn figure_4_9_is_read() {
    let sweep = read(FIGURE).unwrap();
    assert_eq!(sweep.stem(), "figure");
    assert_eq!(sweep.design.count(), 25);
    assert_eq!(sweep.search().unwrap().most_landings(), 109);
    assert_eq!(sweep.settings.tolerance(), 3e-5);
    let scene = sweep.case(24).unwrap().scene;
    let roll = scene.conditions().attitude.euler().roll.to_degrees();
    assert!((roll - 60.0).abs() < 1e-12);
    assert_eq!(scene.conditions().block_friction, 1.0);
}

#[test]
fn solver_may_be_left_out_and_friction_may_vary() {
    let (head, _) = FIGURE.split_once("[solver]").unwrap();
    let text = head
        .replace("friction = 1.0", "")
        .replace("[axes]", "[axes]\nfriction = [0.4, 0.8]");
    let sweep = read(&text).unwrap();
    assert_eq!(sweep.design.count(), 50);
    assert_eq!(sweep.axes[0].name(), "friction");
    assert_eq!(sweep.settings.time_limit(), 40.0);
    assert_eq!(
        sweep.case(30).unwrap().scene.conditions().block_friction,
        0.8
    );
}

#[test]
fn tip_form_is_an_axis_like_any_other() {
    let text = FIGURE
        .replace("friction = 1.0", "friction = 1.0\ntip_deg = 9")
        .replace("roll_deg =", "tip_azimuth_deg =");
    assert_eq!(read(&text).unwrap().design.count(), 25);
    let mixed = FIGURE.replace(
        "friction = 1.0",
        "friction = 1.0\ntip_deg = 9\ntip_azimuth_deg = 0",
    );
    let complaint = read(&mixed).unwrap_err().to_string();
    assert!(
        complaint.contains(":15: axes.roll_deg = { from = -60, to = 60, step = 5 }: includes -60"),
        "{complaint}"
    );
    assert!(complaint.contains("not both"), "{complaint}");
}

fn with_axes(axes: &str) -> Result<Sweep, InputError> {
    read(&FIGURE.replace("[axes]", &format!("[axes]\n{axes}")))
}

#[test]
fn ground_thrust_and_gravity_are_axes_too() {
    let thrust = "[scene.thrust]\ntime_s = [0, 1]\nforce_lb = [80, 0]\n\n[axes]\n";
    let axes =
        "thrust.scale = [0.5, 2]\ngravity_mps2 = [1.62, 3.71]\n\"footing[*].height_ft\" = [0, 1]\n";
    let sweep = read(&FIGURE.replace("[axes]", &format!("{thrust}{axes}"))).unwrap();
    // Each leg has an axis of its own.
    assert_eq!(sweep.design.count(), 2 * 2 * 8 * 25);
    let case = sweep.case(sweep.design.count() - 1).unwrap();
    let conditions = case.scene.conditions();
    assert_eq!(conditions.thrust.line_from(0.0).0.at(0.0), 160.0);
    assert!((conditions.gravity.unwrap() * 0.3048 - 3.71).abs() < 1e-12);
    let heights = [0, 1, 2].map(|leg| conditions.ground.leg(leg).pad.height);
    assert_eq!(heights, [1.0; 3]);

    let said = |text: &str| read(text).unwrap_err().to_string();
    let both = thrust.replace("force_lb", "scale = 1\nforce_lb") + axes;
    let both = said(&FIGURE.replace("[axes]", &both));
    assert!(both.contains("axes.thrust.scale"), "{both}");
    assert!(both.contains("also in [scene]"), "{both}");
    let negative = format!("{thrust}thrust.scale = [-1]\n");
    let negative = said(&FIGURE.replace("[axes]", &negative));
    assert!(negative.contains("axes.thrust.scale"), "{negative}");
    assert!(negative.contains("includes -1"), "{negative}");
    let beyond = said(&FIGURE.replace("[axes]", "[axes]\n\"footing[5].height_ft\" = [0, 1]"));
    assert!(beyond.contains("footing[5].height_ft"), "{beyond}");
    let stop = said(&FIGURE.replace("[solver]", "[solver]\nstop = \"time\""));
    assert!(
        stop.contains("solver.stop = \"time\": expected \"verdict\""),
        "{stop}"
    );
}

#[test]
fn any_number_of_the_input_is_an_axis() {
    let sweep = with_axes(
        "vehicle.center_of_gravity_height_ft = [1.4, 1.6]\n\
         \"vehicle.legs[2].strut.compression_damping\" = [50, 60]\n\
         vehicle.footpad.profile.scale = [1, 1.5]\n\
         solver.tolerance = [1e-6, 1e-7]\n\
         solver.crush_rule = [\"pivot-rate\", \"section\"]\n\
         search.scan_step_fps = [0.25, 0.5]\n",
    )
    .unwrap();
    assert_eq!(sweep.design.count(), 64 * 25);
    let case = sweep.case(sweep.design.count() - 1).unwrap();
    assert_eq!(case.vehicle.center_of_gravity_height(), 1.6);
    let damping = |leg: usize| {
        case.vehicle.hinged_legs()[leg]
            .design()
            .strut
            .damper()
            .unwrap()
            .compression_damping
    };
    assert_eq!((damping(0), damping(1)), (54.0, 60.0));
    let pad = &case.vehicle.hinged_legs()[2].design().footpad;
    assert_eq!(pad.profile.knots()[9][1], 1.5);
    assert_eq!(case.settings.tolerance(), 1e-7);
    assert_eq!(case.settings.rule_choices().crush, Some(CrushRule::Section));
    let Job::Boundary(search) = case.job else {
        panic!("a boundary is asked");
    };
    assert_eq!(search.scan_step, 0.5);
    assert_eq!(
        sweep.place(25),
        "vehicle.center_of_gravity_height_ft = 1.4, \
         vehicle.legs[2].strut.compression_damping = 50, vehicle.footpad.profile.scale = 1, \
         solver.tolerance = 0.000001, solver.crush_rule = pivot-rate, \
         search.scan_step_fps = 0.5, roll_deg = -60"
    );
    // The file as it was read is what the record tells.
    assert_eq!(sweep.vehicle.vehicle.center_of_gravity_height(), 1.4);
}

#[test]
fn values_of_axes_are_checked_before_the_run() {
    let complaint = |axes| with_axes(axes).unwrap_err().to_string();
    let said = complaint("vehicle.strut.preload_lb = [185, -5]\n");
    for fragment in [
        "axes.vehicle.strut.preload_lb = [185, -5]",
        "at vehicle.strut.preload_lb = -5",
        "surveyor-table-4-1.toml:27: strut.preload_lb = -5: expected",
    ] {
        assert!(said.contains(fragment), "{fragment} is not in: {said}");
    }
    let said = complaint("search.tolerance_fps = [0.001, 7]\n");
    assert!(said.contains("search.tolerance_fps = 7"), "{said}");
    // Each is allowed alone, but not both together.
    let said = complaint(
        "vehicle.footpad.minimum_angle_deg = [0.75, 17]\n\
         vehicle.linkage.hardpoint_angle_deg = [41, 30]\n",
    );
    assert!(
        said.contains("below the angle of the extended link"),
        "{said}"
    );
    let said = complaint(
        "friction = { values = [1, 2], zip = \"a\" }\n\
                          slope_deg = { values = [1], zip = \"a\" }\n",
    );
    assert!(said.contains("also in [scene]"), "{said}");
}

/// Figure 4-9 with one landing per point, friction and speed sampled.
fn outcome(sample: &str, axes: &str) -> String {
    let (head, _) = FIGURE.split_once("[search]").unwrap();
    let head = head
        .replace("friction = 1.0", "")
        .replace("vehicle =", "job = \"outcome\"\nvehicle =");
    let (head, _) = head.split_once("[axes]").unwrap();
    format!("{head}\n[axes]\n{axes}\n[sample]\n{sample}\n")
}

#[test]
fn a_sample_draws_from_distributions() {
    let text = outcome(
        "design = \"sobol\"\ncount = 100\nseed = 7\nstop_at_interval_width = 0.1",
        "friction = { mean = 0.8, sd = 0.1, from = 0.5, to = 1.1 }\n\
         horizontal_velocity_fps = { from = 0, to = 20 }\n\
         vehicle.strut.preload_lb = { from = 100, to = 300, spacing = \"log\", zip = \"a\" }\n\
         slope_deg = { from = 0, to = 20, zip = \"a\" }",
    );
    let text = text.replace("slope_deg = 15", "");
    let sweep = read(&text).unwrap();
    assert_eq!(sweep.design.count(), 100);
    assert_eq!(sweep.job, Job::Outcome { enough: Some(0.1) });
    let low = sweep.design.coordinates(3);
    let share = (low[2] / 100.0).ln() / 3f64.ln();
    assert!((share - low[3] / 20.0).abs() < 1e-9, "they move together");
    let case = sweep.case(3).unwrap();
    assert_eq!(case.scene.conditions().horizontal_velocity, low[1]);
}

#[test]
fn wrong_samples_are_complained_about() {
    let good = "design = \"monte-carlo\"\ncount = 10\nseed = 1";
    let speed = "horizontal_velocity_fps = { from = 0, to = 20 }";
    #[rustfmt::skip]
    let wrong = [
        ("design = \"halton\"\ncount = 10\nseed = 1", speed, "\"latin-hypercube\""),
        ("design = \"sobol\"\ncount = 70000\nseed = 1", speed, "from 1 to 65536"),
        ("design = \"sobol\"\ncount = 2.5\nseed = 1", speed, "a whole number"),
        ("design = \"sobol\"\ncount = 2", speed, "sample.seed is missing"),
        ("design = \"monte-carlo\"\ncount = 10000000000\nseed = 1", speed, "from 1 to 1000000000"),
        // A seed that TOML reads as 2^53, which it is not.
        ("design = \"sobol\"\ncount = 2\nseed = 9007199254740993", speed, "a whole number from 0 to 9007199254740991"),
        (good, "horizontal_velocity_fps = [1, 2]", "a table such as"),
        (good, "horizontal_velocity_fps = { mean = 1, sd = 0 }", "sd = 0: expected a number > 0"),
        (good, "horizontal_velocity_fps = { mean = 1, to = 0 }", "from is missing"),
        (good, "horizontal_velocity_fps = { file = \"x.csv\", column = \"v\" }", "there is no file"),
        (good, "horizontal_velocity_fps = { mean = 0, sd = 1 }", "includes -"),
    ];
    for (sample, axis, fragment) in wrong {
        let text = outcome(
            sample,
            &format!("friction = {{ from = 0, to = 1 }}\n{axis}"),
        );
        let said = read(&text).unwrap_err().to_string();
        assert!(said.contains(fragment), "{fragment} is not in: {said}");
    }
    let searched = outcome(good, speed).replace("[sample]", "[search]\nfrom_fps = 0\n[sample]");
    let said = read(&searched).unwrap_err().to_string();
    assert!(said.contains("not used with job"), "{said}");
}

#[test]
fn columns_of_one_file_stay_together() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    fs::create_dir(folder.path().join("vehicles")).unwrap();
    write("vehicles/surveyor-table-4-1.toml", SURVEYOR);
    write("flown.csv", "v, mu\n1, 0.1\n2, 0.2\n3, 0.3\n");
    let text = outcome(
        "design = \"latin-hypercube\"\ncount = 30\nseed = 1",
        "friction = { file = \"flown.csv\", column = \"mu\" }\n\
         horizontal_velocity_fps = { file = \"flown.csv\", column = \"v\" }",
    );
    write("s.toml", &text);
    let sweep: Sweep = Sweep::read(&folder.path().join("s.toml")).unwrap();
    let mut rows = [0; 3];
    for point in 0..30 {
        let drawn = sweep.design.coordinates(point);
        assert_eq!(drawn[0], drawn[1] / 10.0);
        rows[drawn[1] as usize - 1] += 1;
    }
    assert_eq!(rows, [10; 3]);
    write("flown.csv", "v, mu, v\n1, 0.1, 2\n");
    let said = Sweep::read(&folder.path().join("s.toml")).unwrap_err();
    assert!(said.to_string().contains("several of that name"), "{said}");
    write("flown.csv", "v, mu\n1, x\n");
    let said = Sweep::read(&folder.path().join("s.toml"))
        .unwrap_err()
        .to_string();
    assert!(said.contains("flown.csv:2: row 1: mu = x"), "{said}");
}

/// Replaced text of the file of Figure 4-9, its replacement, and text that the error must contain.
const WRONG: [(&str, &str, &[&str]); 15] = [
    (
        "slope_deg = 15",
        "slope_grad = 0.26",
        &[
            ":9: scene.slope_grad = 0.26",
            "mean slope_deg or slope_rad?",
        ],
    ),
    (
        "friction = 1.0",
        "",
        &[
            "scene.friction is missing",
            "0 ≤ value ≤ 1000, nominal friction coefficient",
        ],
    ),
    (
        "slope_deg = 15",
        "slope_deg = 90",
        &[":9: scene.slope_deg = 90", "< 90"],
    ),
    (
        "friction = 1.0",
        "friction = -1",
        &[":10: scene.friction = -1", "0 ≤ value ≤ 1000"],
    ),
    (
        "friction = 1.0",
        "friction = true",
        &[":10: scene.friction = true", "a number"],
    ),
    (
        "step = 5",
        "step = -5",
        &[":13: axes.roll_deg.step = -5", "sign of to - from"],
    ),
    (
        "from = -60",
        "from = 60",
        &[":13: axes.roll_deg.from = 60", "other than to"],
    ),
    (
        "roll_deg = {",
        "roll = {",
        &[":13: axes.roll", "mean roll_deg?"],
    ),
    (
        "roll_deg = { from = -60, to = 60, step = 5 }",
        "roll_deg = []",
        &["axes.roll_deg = []"],
    ),
    (
        "roll_deg = { from = -60, to = 60, step = 5 }",
        "",
        &[":12: axes", "at least one"],
    ),
    (
        "roll_deg = {",
        "cross_slope_deg = {",
        &[":13: axes.cross_slope_deg", "[scene]"],
    ),
    (
        "roll_deg = {",
        "horizontal_velocity_fps = {",
        &["axes.horizontal_velocity_fps", "[search]"],
    ),
    (
        "from_fps = 0",
        "from_fps = 25",
        &[":16: search.from_fps = 25", "below to_fps = 25"],
    ),
    (
        "tolerance_fps = 0.001",
        "tolerance_fps = 1",
        &["search.tolerance_fps = 1", "≤ scan_step_fps"],
    ),
    (
        "\"pivot-rate\"",
        "\"pivot\"",
        &["solver.crush_rule = \"pivot\"", "\"section\""],
    ),
];

#[test]
fn complaints_name_line_key_value_and_what_is_allowed() {
    for (right, wrong, fragments) in WRONG {
        let text = FIGURE.replacen(right, wrong, 1);
        assert_ne!(text, FIGURE, "{right} is not in the file");
        let complaint = read(&text).unwrap_err().to_string();
        for fragment in fragments {
            assert!(complaint.contains(fragment), "{wrong}: {complaint}");
        }
    }
}

#[test]
fn extent_and_statement_are_read_and_may_be_left_out() {
    let sweep = read(FIGURE).unwrap();
    assert_eq!(sweep.search().unwrap().extent, Extent::All);
    assert!(sweep.statement.unwrap().starts_with("1966: between 11"));
    let (head, tail) = FIGURE.split_once("statement").unwrap();
    let text = format!("{head}{}", tail.split_once('\n').unwrap().1);
    let text = text.replace("bands = \"all\"", "");
    let sweep = read(&text).unwrap();
    assert_eq!(
        (sweep.search().unwrap().extent, sweep.statement),
        (Extent::First, None)
    );
    let complaint = read(&FIGURE.replace("\"all\"", "\"some\"")).unwrap_err();
    assert!(
        complaint
            .to_string()
            .contains("search.bands = \"some\": expected \"first\" or \"all\""),
        "{complaint}"
    );
}

#[test]
fn every_value_of_an_axis_is_checked() {
    let text = FIGURE
        .replace("slope_deg = 15", "")
        .replace("roll_deg = { from = -60", "slope_deg = { from = 0")
        .replace("to = 60", "to = 90");
    let complaint = read(&text).unwrap_err().to_string();
    assert!(complaint.contains("includes 90"), "{complaint}");
}

#[test]
fn a_missing_vehicle_is_named() {
    let text = FIGURE.replace("surveyor-table", "surveyor-chair");
    let complaint = read(&text).unwrap_err().to_string();
    assert!(
        complaint.contains(":3: vehicle = \"vehicles/surveyor-chair-4-1.toml\""),
        "{complaint}"
    );
}
