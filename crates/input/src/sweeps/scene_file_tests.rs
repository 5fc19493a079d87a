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
    let leg = |case: usize, leg: usize| {
        cases[case].vehicle.vehicle.hinged_legs()[leg]
            .design()
            .clone()
    };
    assert_eq!(leg(0, 0).strut.damper().unwrap().preload, 185.0);
    assert_eq!(leg(2, 0).strut.damper().unwrap().preload, 200.0);
    assert_eq!(
        (leg(2, 1).footpad.height, leg(2, 2).footpad.height),
        (0.5, 0.54167)
    );
    assert_eq!(cases[1].settings.rule_choices().crush, None);
    assert_eq!(
        cases[3].settings.rule_choices().crush,
        Some(CrushRule::Section)
    );
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
        assert!(
            (vehicle.hinged_legs()[0]
                .design()
                .strut
                .damper()
                .unwrap()
                .preload
                - 200.0)
                .abs()
                < 1e-9
        );
        assert!((vehicle.inertia()[(0, 0)] - 140.0).abs() < 1e-9);
        assert_eq!(vehicle.hinged_legs()[1].design().footpad.height, 0.5);
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

#[test]
fn the_ground_under_each_leg_may_differ() {
    let text = "[[scene.footing]]\n[[scene.footing]]\nheight_m = 0.3048\ntilt_across_deg = 3\nblock_height_ft = 0\n\
                [[case]]\n[[case]]\n\"footing[3].height_ft\" = -0.5\n";
    let cases = read_text(text).unwrap();
    let footing = |case: usize, leg: usize| *cases[case].scene.conditions().ground.leg(leg);
    assert_eq!(footing(0, 0), Default::default());
    let rock = footing(0, 1);
    assert_eq!((rock.pad.height, rock.block.height), (1.0, 0.0));
    assert_eq!(rock.pad.tilt_across, 3f64.to_radians());
    assert_eq!(rock.block.tilt_across, rock.pad.tilt_across);
    assert_eq!(footing(0, 2), Default::default());
    assert_eq!((footing(1, 1), footing(1, 2).block.height), (rock, -0.5));
}

#[test]
fn ground_that_cannot_be_is_refused_where_it_is_said() {
    for (text, said) in [
        (
            "[[scene.footing]]\nheight_ft = 2000\n",
            "deck.toml:10: scene.footing[1].height_ft = 2000: expected -1000 ≤ value ≤ 1000",
        ),
        (
            "[[scene.footing]]\n[[scene.footing]]\nblock_tilt_across_deg = -70\n",
            "scene.footing[2].block_tilt_across_deg = -70: expected -60 ≤ value ≤ 60",
        ),
        ("slope_rad = 1.5\n", "one spelling of a quantity"),
        (
            "[[scene.footing]]\nheight_in = 3\n",
            "scene.footing[1].height_in = 3: unknown key",
        ),
        (
            "[[case]]\n\"footing[4].height_ft\" = 1\n",
            "the number of a leg: the vehicle has 3",
        ),
        (
            "[[scene.footing]]\n[[scene.footing]]\n[[scene.footing]]\n[[scene.footing]]\nheight_ft = 1\n",
            "scene.footing[4].height_ft = 1: expected the number of a leg: the vehicle has 3",
        ),
    ] {
        let complaint = complaint(text);
        assert!(complaint.contains(said), "{complaint}");
    }
}

#[test]
fn gravity_thrust_and_stop_are_of_the_scene() {
    let text = "gravity = \"mars\"\n[scene.thrust]\ntime_s = [0, 0.5]\nforce_n = [444.82216152605, 0]\n\
                offset_x_m = 0.3048\n[solver]\nstop = \"time\"\n\
                [[case]]\n[[case]]\ngravity_mps2 = 9.80665\n\"thrust.scale\" = 0.5\nsolver.stop = \"verdict\"\n";
    let cases = read_text(text).unwrap();
    let conditions = |case: usize| *cases[case].scene.conditions();
    let gravity = [0, 1].map(|case| conditions(case).gravity.unwrap() * 0.3048);
    assert!((gravity[0] - 3.71).abs() < 1e-12 && (gravity[1] - 9.80665).abs() < 1e-12);
    let force = |case: usize| conditions(case).thrust.line_from(0.0).0.at(0.25);
    assert!((force(0) - 50.0).abs() < 1e-12 && (force(1) - 25.0).abs() < 1e-12);
    assert_eq!(conditions(0).thrust.offset(), [1.0, 0.0]);
    let goes_on = [0, 1].map(|case| cases[case].settings.goes_on());
    assert_eq!(goes_on, [true, false]);
    // Journals tell the two apart.
    let solver = [0, 1].map(|case| {
        let case = &cases[case];
        crate::readers::settings_input::solver_in_record(&case.settings, &case.vehicle.vehicle)
    });
    assert_eq!(
        (&solver[0]["stop"], solver[1].get("stop")),
        (&"time".into(), None)
    );
}

#[test]
fn gravity_and_thrust_that_cannot_be_are_refused_where_they_are_said() {
    for (text, said) in [
        (
            "gravity = \"pluto\"\n",
            "deck.toml:9: scene.gravity = \"pluto\": expected \"moon\", \"mars\"",
        ),
        (
            "gravity = \"moon\"\ngravity_fps2 = 5\n",
            "scene.gravity = \"moon\": also given as a number",
        ),
        (
            "gravity_fps2 = 0\n",
            "scene.gravity_fps2 = 0: expected 0 < value",
        ),
        (
            "[scene.thrust]\ntime_s = [0, 1]\nforce_lb = [80]\n",
            "1 numbers: expected as many as in time_s, 2",
        ),
        (
            "[scene.thrust]\ntime_s = [0, 1, 1]\nforce_lb = [80, 0, 0]\n",
            "expected a time after the one before, 1",
        ),
        (
            "[scene.thrust]\ntime_s = [0]\nforce_lb = [-80]\n",
            "expected 0 ≤ value ≤ 1e9",
        ),
        (
            "[scene.thrust]\nforce_lb = [80]\n",
            "scene.thrust.time_s is missing",
        ),
        (
            "[scene.thrust]\ntime_s = [0]\nforce_lb = [80]\n[solver]\nmethod = \"rk4\"\n",
            "only the method \"located\" knows it",
        ),
        ("[[case]]\n\"thrust.scale\" = 2\n", "a table [scene.thrust]"),
        (
            "[[case]]\nvehicle.footpad.edge_angle_deg = 65\nvehicle.footpad.edge_load_lb = 187\nsolver.method = \"rk4\"\n",
            "vehicle.footpad.edge_load_lb = 187: expected footpads without an edge",
        ),
        (
            "[solver]\nstop = \"never\"\n",
            "solver.stop = \"never\": expected \"verdict\" or \"rest\" or \"time\"",
        ),
        (
            "[solver]\nmethod = \"rk4\"\nstop = \"time\"\n",
            "only the method \"located\" goes on",
        ),
    ] {
        let complaint = complaint(text);
        assert!(complaint.contains(said), "{text}: {complaint}");
    }
}
