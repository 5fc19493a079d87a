use super::*;
use std::fs;
use touchdown_dynamics::scene::CrushRule;

const SCENE: &str = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
                     horizontal_velocity_fps = 11\ncross_slope_deg = 180\nslope_deg = 15\n\
                     friction = 1.0\nroll_deg = 5\n";
const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");

fn read_text(cases: &str) -> Result<Vec<SceneCase>, InputError> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("surveyor.toml"), SURVEYOR).unwrap();
    let light = SURVEYOR.replacen("mass_slug = 20", "mass_slug = 18", 1);
    fs::write(folder.path().join("light.toml"), light).unwrap();
    let path = folder.path().join("deck.toml");
    fs::write(&path, format!("{SCENE}{cases}")).unwrap();
    read(&path).map(|file| file.cases)
}

fn complaint(cases: &str) -> String {
    read_text(cases).unwrap_err().to_string()
}

#[test]
fn a_file_without_cases_is_one_landing() {
    let cases = read_text("").unwrap();
    assert_eq!((cases.len(), cases[0].name.as_str()), (1, "1"));
    assert_eq!(cases[0].scene.conditions().horizontal_velocity, 11.0);
    assert_eq!(cases[0].settings.tolerance(), Settings::DEFAULT_TOLERANCE);
}

#[test]
fn a_case_keeps_what_it_does_not_change() {
    let cases = read_text(
        "[[case]]\nname = \"base\"\n\
         [[case]]\nhorizontal_velocity_fps = 12\nvehicle.strut.preload_lb = 200\n\
         [[case]]\nfriction = 0.8\n\"solver.crush_rule\" = \"section\"\n\
         \"vehicle.legs[2].footpad.height_ft\" = 0.5\n\
         [[case]]\nvehicle = \"light.toml\"\nsolver.tolerance = 1e-4\n",
    )
    .unwrap();
    let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
    assert_eq!(names, ["base", "2", "3", "4"]);
    let speeds = cases
        .iter()
        .map(|case| case.scene.conditions().horizontal_velocity);
    assert_eq!(speeds.collect::<Vec<_>>(), [11.0, 12.0, 12.0, 12.0]);
    let friction = cases
        .iter()
        .map(|case| case.scene.conditions().block_friction);
    assert_eq!(friction.collect::<Vec<_>>(), [1.0, 1.0, 0.8, 0.8]);
    let leg = |case: usize, leg: usize| cases[case].vehicle.vehicle.legs()[leg].design().clone();
    assert_eq!(leg(0, 0).strut.damper().unwrap().preload, 185.0);
    assert_eq!(leg(2, 0).strut.damper().unwrap().preload, 200.0);
    assert_eq!(
        (leg(2, 1).footpad.height, leg(2, 2).footpad.height),
        (0.5, 0.54167)
    );
    assert_eq!(cases[1].settings.crush_rule(), CrushRule::PivotRate);
    assert_eq!(cases[3].settings.crush_rule(), CrushRule::Section);
    assert_eq!(cases[3].settings.tolerance(), 1e-4);
    // Another vehicle file stands for itself.
    assert_eq!(
        (
            cases[3].vehicle.vehicle.mass(),
            leg(3, 0).strut.damper().unwrap().preload
        ),
        (18.0, 185.0)
    );
}

#[test]
fn a_case_may_change_numbers_in_si() {
    let cases = read_text(
        "[[case]]\nhorizontal_velocity_mps = 3.048\nvehicle.strut.preload_n = 889.6443230521\n\
         vehicle.inertia_kg_m2.xx = 189.814512766396\n\"vehicle.legs[2].footpad.height_mm\" = 152.4\n\
         [[case]]\nroll_rad = 0.3490658503988659\n",
    )
    .unwrap();
    let roll = cases[1].scene.conditions().attitude.euler().roll;
    assert!((roll.to_degrees() - 20.0).abs() < 1e-12);
    for case in cases {
        assert_eq!(case.scene.conditions().horizontal_velocity, 10.0);
        let vehicle = case.vehicle.vehicle;
        assert!((vehicle.legs()[0].design().strut.damper().unwrap().preload - 200.0).abs() < 1e-9);
        assert!((vehicle.inertia()[(0, 0)] - 140.0).abs() < 1e-9);
        assert_eq!(vehicle.legs()[1].design().footpad.height, 0.5);
    }
    let twice = complaint("[[case]]\nslope_deg = 5\nslope_rad = 0.1\n");
    assert!(
        twice.contains("slope_rad = 0.1: said twice: expected one of slope_deg and slope_rad"),
        "{twice}"
    );
    let steep = complaint("[[case]]\nslope_rad = 1.6\n");
    assert!(
        steep.contains(
            "case 1: slope_rad = 1.6: expected -90 < value < 90 (in deg: this is 91.6732)"
        ),
        "{steep}"
    );
}

#[test]
fn the_other_form_of_an_attitude_replaces_it() {
    let cases = read_text(
        "[[case]]\ntip_deg = 9\ntip_azimuth_deg = 90\n[[case]]\ntip_deg = 5\n[[case]]\npitch_deg = 2\n",
    )
    .unwrap();
    let tip = |case: usize| {
        cases[case]
            .scene
            .conditions()
            .attitude
            .tip()
            .tip
            .to_degrees()
    };
    assert!(
        (tip(0) - 9.0).abs() < 1e-9 && (tip(1) - 5.0).abs() < 1e-9 && (tip(2) - 2.0).abs() < 1e-9
    );
    let roll = cases[2].scene.conditions().attitude.euler().roll;
    assert!(roll.abs() < 1e-12, "{roll}");
}

#[test]
fn complaints_name_line_case_key_value_and_what_is_allowed() {
    #[rustfmt::skip]
    let cases = [
        ("[[case]]\n[[case]]\nfriction = -1\n", &["deck.toml:11: case 2: friction = -1", "0 ≤ value ≤ 1000"][..]),
        ("[[case]]\nrol_deg = 4\n", &["deck.toml:10: case[1].rol_deg = 4", "did you mean roll_deg"]),
        ("[[case]]\nroll_deg = \"x\"\n", &["deck.toml:10: case[1].roll_deg", "a number"]),
        ("[[case]]\ntip_deg = 4\n", &["deck.toml:9: case 1: tip_azimuth_deg is missing"]),
        ("[[case]]\n\"search.from_fps\" = 4\n", &["case[1].search.from_fps = 4", "unknown key of a case"]),
        ("[[case]]\nsolver.tolerance = 2\n", &["deck.toml:10: case 1: solver.tolerance = 2", "1e-12"]),
        ("[[case]]\nsolver.crush_rule = \"soft\"\n", &["case[1].solver.crush_rule = \"soft\"", "pivot-rate"]),
        ("[[case]]\nvehicle.mass_slug = 0\n", &["deck.toml:10: case 1: mass_slug = 0", "0 < value"]),
        ("[[case]]\nvehicle = \"no.toml\"\n", &["deck.toml:10: case[1].vehicle = \"no.toml\"", "no file"]),
        ("[[case]]\nname = \"a/b\"\n", &["case[1].name = \"a/b\"", "letters"]),
        ("[[case]]\nname = \"2\"\n[[case]]\nname = \"2\"\n", &["deck.toml:12: case[2].name", "not the name of a case before"]),
        ("[[case]]\nname = \"2\"\n[[case]]\n", &["deck.toml:11: case 2: has no name", "is named 2"]),
        ("[case]\nroll_deg = 1\n", &["case", "tables [[case]]"]),
        ("[other]\n", &["other", "unknown key"]),
    ];
    for (text, fragments) in cases {
        let said = complaint(text);
        for fragment in fragments {
            assert!(said.contains(fragment), "{fragment} is not in: {said}");
        }
    }
}
