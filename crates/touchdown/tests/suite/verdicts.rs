//! Verdicts that nothing later contradicts, as a user sees them.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::Bench;

const FOUR_LEGS: &str = include_str!("../../../../sweeps/vehicles/four-legs.toml");
const APOLLO_LIKE: &str = include_str!("../../../../sweeps/vehicles/apollo-like.toml");

/// A case of a scene file: its outcome, its end (s), its tilt then (deg).
#[derive(Debug, PartialEq)]
struct Told {
    outcome: String,
    end: f64,
    tilt: f64,
}

/// Columns of the table of a scene file, case by case. Its vehicles are the Surveyor, the lander with four legs, and the
/// Apollo-like one.
fn columns<const N: usize>(scene: &str, names: [&str; N]) -> Vec<[String; N]> {
    let bench = Bench::new();
    bench.write("four-legs.toml", FOUR_LEGS);
    bench.write("apollo-like.toml", APOLLO_LIKE);
    bench.write("scene.toml", scene);
    let done = bench.run(&["land", "scene.toml", "--out", "out", "--interval", "1"]);
    assert!(done.code.is_some_and(|code| code < 2), "{}", done.err);
    let table = bench.read("out/scene.csv");
    let mut rows = table.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let heading = rows.next().unwrap();
    let places = names.map(|name| heading.iter().position(|known| *known == name).unwrap());
    rows.map(|row| places.map(|place| row[place].to_owned()))
        .collect()
}

/// Outcomes of the cases of a scene file, in order.
fn land(scene: &str) -> Vec<Told> {
    let rows = columns(scene, ["outcome", "end_time_s", "tilt_deg"]).into_iter();
    rows.map(|[outcome, end, tilt]| Told {
        outcome,
        end: end.parse().unwrap(),
        tilt: tilt.parse().unwrap(),
    })
    .collect()
}

/// A scene of the lander with four legs, in SI.
fn four_legs(vertical: f64, slope: f64, friction: f64, more: &str) -> String {
    format!(
        "vehicle = \"four-legs.toml\"\n[scene]\nvertical_velocity_mps = {vertical}\nhorizontal_velocity_mps = 0\n\
         cross_slope_deg = 180\nslope_deg = {slope}\nfriction = {friction}\n{more}"
    )
}

#[test]
fn small_differences_of_feet_and_of_the_center_of_gravity_topple_nothing() {
    let bench = Bench::new();
    bench.write("four-legs.toml", FOUR_LEGS);
    let height = |leg: usize| {
        format!(
            "\"vehicle.legs[{leg}].footpad.height_m\" = {{ distribution = \"normal\", mean = 0.1, sd = 0.002 }}\n"
        )
    };
    let offset = |axis: &str| {
        format!(
            "vehicle.center_of_gravity_offset_{axis}_m = {{ distribution = \"normal\", mean = 0, sd = 0.005 }}\n"
        )
    };
    let axes: String = ["x", "y"]
        .map(offset)
        .into_iter()
        .chain((1..=4).map(height))
        .collect();
    bench.write(
        "sweep.toml",
        &format!(
            "title = \"feet\"\njob = \"outcome\"\nvehicle = \"four-legs.toml\"\n[scene]\nvertical_velocity_mps = 2\n\
             horizontal_velocity_mps = 0.5\ncross_slope_deg = 0\nslope_deg = 0\nfriction = 0.8\n[axes]\n{axes}\
             [sample]\ndesign = \"monte-carlo\"\ncount = 300\nseed = 1\n"
        ),
    );
    let done = bench.run(&["sweep", "sweep.toml", "--out", "out", "--quiet"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let table = bench.read("out/sweep.csv");
    assert_eq!(
        table.matches("stable-subsided").count(),
        300,
        "{}",
        done.out
    );
}

#[test]
fn a_foot_over_a_pit_is_no_support() {
    let pit = "roll_deg = 180\n[[scene.footing]]\nheight_m = -1.2\n[[case]]\n[[case]]\n\"footing[1].height_m\" = 0\n";
    let told = land(&four_legs(1.0, 0.0, 0.8, pit));
    assert_eq!(told[0].outcome, "unstable-toppled");
    assert_eq!(told[1].outcome, "stable-subsided");
    assert!(told[1].tilt < 1.0);
}

#[test]
fn a_strut_that_gives_way_under_the_weight_is_not_at_rest() {
    let weak = "gravity_mps2 = 9.81\n[[case]]\nvehicle.strut.crush_load.scale = 0.2\n[[case]]\nvehicle.strut.crush_load.scale = 1\n";
    let told = land(&four_legs(0.0, 9.0, 1.0, weak));
    assert!(told[0].outcome.starts_with("bottomed-leg"), "{told:?}");
    assert_eq!(told[1].outcome, "stable-subsided");
}

#[test]
fn rest_is_measured_over_the_ground_under_the_feet() {
    let tilted = "[[scene.footing]]\ntilt_along_deg = 6\n".repeat(4);
    let slope = (1..=4).map(|leg| format!("\"footing[{leg}].tilt_along_deg\" = 0\n"));
    let cases = format!(
        "{tilted}[[case]]\n[[case]]\nslope_deg = 6\n{}",
        slope.collect::<String>()
    );
    let told = land(&four_legs(1.0, 0.0, 0.5, &cases));
    assert!(
        told.iter().all(|case| case.outcome == "stable-subsided"),
        "{told:?}"
    );
    assert!((told[0].end - told[1].end).abs() < 0.5, "{told:?}");
}

#[test]
fn nothing_is_at_rest_while_the_engine_lifts_it() {
    // Five times the weight, for half a second; and an engine that never pushes is none.
    let engine = "[scene.thrust]\ntime_s = [0, 0.5]\nforce_n = [4050, 4050]\nscale = 1\n[[case]]\nthrust.scale = 0\n";
    let off = land(&four_legs(0.3, 0.0, 0.8, engine));
    let none = land(&four_legs(0.3, 0.0, 0.8, "[[case]]\n"));
    assert_eq!(off, none);
    for rules in ["1966", "physical"] {
        let lifted = format!(
            "[scene.thrust]\ntime_s = [0, 0.2, 0.4]\nforce_n = [4050, 4050, 0]\n[solver]\nrules = \"{rules}\"\n[[case]]\n"
        );
        let told = land(&four_legs(0.3, 0.0, 0.8, &lifted));
        assert!(told[0].end > 0.4, "{told:?}");
    }
}

#[test]
fn rest_that_waits_for_the_end_of_the_thrust_is_found_there() {
    let scene = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 6\nhorizontal_velocity_fps = 3\n\
                 cross_slope_deg = 180\nslope_deg = 0\nfriction = 1\n[scene.thrust]\ntime_s = [0, 3]\nforce_lb = [20, 0]\n[[case]]\n";
    let told = land(scene);
    assert_eq!(told[0].outcome, "stable-subsided");
    assert!((told[0].end - 3.0).abs() < 1e-6, "{told:?}");
}

#[test]
fn a_slope_that_friction_does_not_hold_ends_as_sliding_whatever_the_speed() {
    let told = land(&four_legs(
        0.2,
        12.0,
        0.1,
        "[[case]]\n[[case]]\nhorizontal_velocity_mps = 1\n",
    ));
    assert!(
        told.iter().all(|case| case.outcome == "sliding"),
        "{told:?}"
    );
    let mirrored = land(&four_legs(0.2, -12.0, 0.1, "[[case]]\n"));
    assert_eq!(mirrored[0].outcome, "sliding");
    // Nor is it at rest where blocks would hold it that do not touch.
    let with_blocks = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_mps = 2\nhorizontal_velocity_mps = 0.5\ncross_slope_deg = 180\n\
                       slope_deg = -12\nfriction = 0.2\nblock_friction = 1\n[solver]\nrules = \"physical\"\ntime_limit_s = 5\n[[case]]\n\
                       [[case]]\nfriction = 0.5\n";
    let told = land(with_blocks);
    assert_eq!(told[0].outcome, "time-expired");
    assert_eq!(told[1].outcome, "stable-subsided");
    let steeper = "[solver]\nrules = \"1966\"\n[[case]]\nhorizontal_velocity_mps = 3\n[[case]]\nsolver.stop = \"time\"\nsolver.time_limit_s = 30\n";
    let told = land(&four_legs(0.2, 20.0, 0.1, steeper));
    assert!(
        told.iter().all(|case| case.outcome == "sliding"),
        "{told:?}"
    );
}

/// tan 10 deg is 0.176: sliding friction does not hold there, and static friction of 0.5 does while nothing slides. So a
/// vehicle that starts downhill slides on, and one that starts uphill stays where its feet stop.
#[test]
fn static_friction_holds_a_vehicle_that_does_not_slide() {
    let cases = "[[case]]\n[[case]]\nstatic_friction_ratio = 5\n[[case]]\nstatic_friction_ratio = 1.7\n\
                 [[case]]\nstatic_friction_ratio = 5\nhorizontal_velocity_mps = 1\n";
    let outcomes =
        |told: Vec<Told>| -> Vec<String> { told.into_iter().map(|case| case.outcome).collect() };
    for (slope, with_speed) in [(10.0, "sliding"), (-10.0, "stable-subsided")] {
        let told = outcomes(land(&four_legs(0.0, slope, 0.1, cases)));
        let expected = ["sliding", "stable-subsided", "sliding", with_speed];
        assert_eq!(told, expected, "{slope} deg");
    }
}

/// Sliding friction hardly exceeds the slope: a vehicle that slides downhill has not stopped at the time limit.
#[test]
fn static_friction_holds_no_vehicle_that_slides() {
    let cases = "static_friction_ratio = 3.86\n[[case]]\nhorizontal_velocity_mps = 1\n[[case]]\nhorizontal_velocity_mps = 2\n";
    for told in land(&four_legs(1.0, 14.85, 0.2661, cases)) {
        assert_eq!(told.outcome, "time-expired", "{told:?}");
    }
}

/// After the verdict, at 1.15 s, it settles further, and loses 0.046 deg.
#[test]
fn the_least_stability_angle_of_three_struts_is_that_up_to_the_verdict() {
    let scene = "vehicle = \"apollo-like.toml\"\n[scene]\nvertical_velocity_fps = 10\nhorizontal_velocity_mps = 0.975872617291248\n\
         cross_slope_deg = 169.18371874\ntip_deg = 0.735952946861\ntip_azimuth_deg = 21.6342484541\n\
         nominal_roll_deg = 16.666018812\nslope_deg = 3.72063653104\nfriction = 0.970766018972\n[solver]\n\
         time_limit_s = 10\n[[case]]\nsolver.stop = \"verdict\"\n[[case]]\nsolver.stop = \"time\"\n\
         [[case]]\nsolver.stop = \"rest\"\n";
    let told = columns(scene, ["min_stability_angle_deg"]).into_iter();
    let told: Vec<f64> = told.map(|[angle]| angle.parse().unwrap()).collect();
    let [at_verdict, whole, at_rest] = told[..] else {
        panic!("three landings")
    };
    assert_eq!(at_verdict, whole);
    assert!(
        at_rest < at_verdict - 0.02,
        "{at_rest} at rest, {at_verdict} deg"
    );
}

#[test]
fn damping_of_hinges_acts_at_the_face_and_is_refused_at_the_pivot() {
    let cases = "[[case]]\n[[case]]\nvehicle.footpad.hinge_damping_ftlb_s = 2\n\
                 [[case]]\nvehicle.footpad.hinge_damping_nm_s = 2.7116358966628\n";
    let told = land(&four_legs(0.5, 3.0, 0.8, cases));
    let [free, damped, in_si] = &told[..] else {
        panic!("three landings")
    };
    assert!((damped.end - in_si.end).abs() < 1e-9, "{told:?}");
    assert!((free.end - damped.end).abs() > 1e-6, "{told:?}");
    let bench = Bench::new();
    bench.write("four-legs.toml", FOUR_LEGS);
    bench.write(
        "scene.toml",
        &four_legs(
            0.5,
            3.0,
            0.8,
            &cases.replacen(
                "[[case]]",
                "[solver]\ncontact_rule = \"pivot\"\n[[case]]",
                1,
            ),
        ),
    );
    let done = bench.run(&["land", "scene.toml", "--out", "out"]);
    done.refused(&[
        "vehicle.footpad.hinge_damping_ftlb_s = 2",
        "no damping: only the contact rule \"face\" knows it",
    ]);
}

#[test]
fn limits_of_1966_hold_beside_the_hull_too() {
    let scene = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 6\nhorizontal_velocity_fps = 1\n\
                 cross_slope_deg = 180\nslope_deg = 0\nfriction = 1\n[[case]]\n[[case]]\nsolver.toppling_rule = \"hull\"\n";
    let told = land(scene);
    assert_eq!(told[0].outcome, "stable-subsided");
    assert_eq!(told[0], told[1]);
}

#[test]
fn reports_and_records_name_the_rules_in_force() {
    let bench = Bench::new();
    bench.write("four-legs.toml", FOUR_LEGS);
    let land = |vehicle: &str, more: &[&str]| {
        let touchdown = [
            "land",
            "--vehicle",
            vehicle,
            "--vertical-velocity-mps",
            "1",
            "--horizontal-velocity",
            "0",
            "--cross-slope",
            "0",
            "--slope",
            "0",
            "--friction",
            "1",
        ];
        bench.run(&[&touchdown[..], more].concat()).out
    };
    assert!(land("four-legs.toml", &[]).contains("physical rules\n"));
    assert!(land("surveyor.toml", &[]).contains("1966 rules\n"));
    let mixed = land("four-legs.toml", &["--crush-rule", "pivot-rate"]);
    assert!(
        mixed.contains("physical rules, crush rule pivot-rate"),
        "{mixed}"
    );
    let report = land("surveyor.toml", &["--rules", "physical", "--json"]);
    for said in [
        "\"rules\": \"physical\"",
        "\"toppling_rule\": \"hull\"",
        "\"contact_rule\": \"face\"",
    ] {
        assert!(report.contains(said), "{said}");
    }
    // The methods of 1966 judge as the program of 1966 did.
    assert!(
        land("surveyor.toml", &["--method", "rk4", "--rules", "physical"])
            .contains("1966 rules, crush rule section")
    );
}

#[test]
fn a_footpad_crushed_through_its_height_is_told_or_bottoms() {
    let bench = Bench::new();
    let soft = FOUR_LEGS
        .replace(
            "interference_mm = [0, 5, 60, 95]",
            "interference_mm = [0, 5, 60]",
        )
        .replace(
            "relative_pressure = [0, 1, 1.5, 8]",
            "relative_pressure = [0, 1, 1]",
        )
        .replace("crush_pressure_kpa = 30", "crush_pressure_kpa = 3");
    bench.write("soft.toml", &soft);
    let touchdown = [
        "land",
        "--vehicle",
        "soft.toml",
        "--vertical-velocity-mps",
        "2",
        "--horizontal-velocity",
        "0",
        "--cross-slope",
        "0",
        "--slope",
        "0",
        "--friction",
        "1",
        "--rules",
    ];
    let land = |rules: &str| bench.run(&[&touchdown[..], &[rules]].concat());
    let told = land("1966").err;
    assert!(
        told.contains("which is more than the 0.328 ft up to its hinge"),
        "{told}"
    );
    assert!(land("physical").out.contains("bottomed-pad-"));
    let sweep = |rules: &str| {
        let text = format!(
            "title = \"Soft\"\nvehicle = \"soft.toml\"\nunits = \"SI\"\n[scene]\nvertical_velocity_mps = 2\n\
             cross_slope_deg = 0\nslope_deg = 0\nfriction = 1\n[axes]\nroll_deg = [0, 45]\n\
             [search]\nfrom_mps = 0\nto_mps = 2\nscan_step_mps = 1\ntolerance_mps = 0.01\nbands = \"first\"\n\
             [solver]\nrules = \"{rules}\"\n"
        );
        bench.write("soft-sweep.toml", &text);
        let done = bench.run(&["sweep", "soft-sweep.toml", "--overwrite"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        done.out
    };
    let warning = "warning: at 2 points: footpads were crushed beyond their hinges";
    assert!(sweep("1966").contains(warning), "{}", sweep("1966"));
    let physical = sweep("physical");
    assert!(
        physical.contains("first transition to: 2 bottomed")
            && !physical.contains("warning: at 2 points: footpads"),
        "{physical}"
    );
}

/// Strokes a tenth of what was meant: the load stays that of the last knot, which is told where a strut comes so far.
#[test]
fn struts_that_outrun_their_crush_tables_are_told() {
    let bench = Bench::new();
    let told = |strokes: &str, loads: &str, speed: &str| {
        let lander = FOUR_LEGS
            .replace("stroke_mm = [0, 120, 120, 300]", strokes)
            .replace("load_n = [2500, 2500, 7000, 7000]", loads);
        bench.write("lander.toml", &lander);
        let done = bench.run(&[
            "land",
            "--vehicle",
            "lander.toml",
            "--units=SI",
            "--horizontal-velocity=0",
            "--cross-slope=0",
            "--slope=0",
            "--friction=1",
            "--vertical-velocity-mps",
            speed,
        ]);
        assert!(done.code.is_some_and(|code| code < 2), "{}", done.err);
        (done.out, done.err)
    };
    let short = "stroke_mm = [0, 12, 12, 30]";
    let loads = "load_n = [2500, 2500, 7000, 7000]";
    let (report, warning) = told(short, loads, "3");
    assert!(report.contains("- of its crush table, %"), "{report}");
    assert!(
        warning.contains("beyond the 0.0300 m at which its crush_load ends")
            && warning.contains("a knot at the full stroke, 0.3000 m,"),
        "{warning}"
    );
    for (strokes, loads, speed) in [
        // Not reached; said to be meant; reaching the stop but for rounding; one load for all strokes.
        (short, loads, "0.1"),
        (
            "stroke_mm = [0, 12, 12, 30, 300]",
            "load_n = [2500, 2500, 7000, 7000, 7000]",
            "3",
        ),
        ("stroke_mm = [0, 120, 120, 299.9]", loads, "3"),
        ("stroke_mm = [0]", "load_n = [5000]", "3"),
    ] {
        let (report, warning) = told(strokes, loads, speed);
        assert_eq!(warning, "", "{strokes}");
        assert!(!report.contains("crush table"), "{report}");
    }

    told(short, loads, "3");
    let heading =
        "vertical_velocity_mps,horizontal_velocity_mps,cross_slope_deg,slope_deg,friction";
    bench.write("cases.csv", &format!("{heading}\n0.1,0,0,0,1\n3,0,0,0,1\n"));
    let done = bench.run(&[
        "land",
        "--vehicle=lander.toml",
        "--cases=cases.csv",
        "--out=out.csv",
    ]);
    let expected =
        "warning: in 1 case, first in case 2: struts stroked beyond the end of their crush_load";
    assert!(done.err.contains(expected), "{}", done.err);
    let sweep = "vehicle = \"lander.toml\"\n[scene]\ncross_slope_deg = 0\nslope_deg = 0\nfriction = 1\n\
                 [axes]\nvertical_velocity_mps = [0.1, 3]\n\
                 [search]\nfrom_mps = 0\nto_mps = 1\nscan_step_mps = 1\ntolerance_mps = 0.5\n";
    bench.write("short.toml", sweep);
    let done = bench.run(&["sweep", "short.toml"]);
    assert!(
        done.out
            .contains("warning: at 1 point: struts stroked beyond the end"),
        "{}{}",
        done.out,
        done.err
    );
}
