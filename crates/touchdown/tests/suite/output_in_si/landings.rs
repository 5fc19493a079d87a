//! Landings, tables of cases and surfaces.

use serde_json::Value;

use super::{FOOT, assert_is, compare, in_si, run};
use crate::common::{BASELINE, Bench};

#[test]
fn landings_come_out_in_si() {
    let bench = Bench::new();
    let land = |more: &[&str]| run(&bench, &[&BASELINE, more].concat()).out;
    let table = |name: &str, more: &[&str]| {
        land(&[&["--history", name], more].concat());
        bench.read(name)
    };
    compare(
        &table("us.csv", &[]),
        &table("si.csv", &["--units", "si"]),
        &[],
        "",
    );
    let text = land(&["--units", "SI"]);
    assert!(
        text.contains("vertical_velocity_mps 4.2672, horizontal_velocity_mps 3.429"),
        "{text}"
    );
    for unit in [" ft", "lb"] {
        assert!(!text.contains(unit), "{text}");
    }
    let json = |more: &[&str]| -> Value {
        serde_json::from_str(&land(&[&["--json"], more].concat())).unwrap()
    };
    let (us, si) = (json(&[]), json(&["--units", "SI"]));
    for part in ["/scene", "/result", ""] {
        let [us, si] = [&us, &si].map(|report| report.pointer(part).unwrap().as_object().unwrap());
        assert_eq!(us.len(), si.len());
        for (name, value) in us.iter().filter(|(_, value)| value.is_f64()) {
            let (named, factor) = in_si(name);
            assert_is(&si[&named].to_string(), &value.to_string(), factor, name);
        }
    }
    // Velocities may be given in m/s.
    let given = [
        &["land", "--vehicle", "surveyor.toml"][..],
        &[
            "--vertical-velocity-mps=4.2672",
            "--horizontal-velocity-mps",
            "3.429",
        ],
        &BASELINE[6..],
    ];
    assert_eq!(run(&bench, &given.concat()).out, land(&[]));
    let given = [given[0], &["--vertical-velocity-mps=-1"], &BASELINE[4..]].concat();
    let said =
        ["--vertical-velocity-mps = -1: expected 0 ≤ value ≤ 10000 (in ft/s: this is -3.28084)"];
    bench.run(&given).refused(&said);
    let both = [&BASELINE[..], &["--vertical-velocity-mps=4"]].concat();
    bench
        .run(&both)
        .refused(&["--vertical-velocity", "cannot be used with"]);
}

#[test]
fn cases_come_out_in_si() {
    let bench = Bench::new();
    let scene = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
                 horizontal_velocity_fps = 3\ncross_slope_deg = 180\nslope_deg = 15\nfriction = 1\n";
    bench.write("us.toml", scene);
    bench.write("si.toml", &format!("units = \"SI\"\n{scene}"));
    let landed = ["us", "si"].map(|name| {
        let printed = run(
            &bench,
            &["land", &format!("{name}.toml"), "--out", "landed"],
        )
        .out;
        let tables = ["", "-1"].map(|end| bench.read(&format!("landed/{name}{end}.csv")));
        (printed, tables)
    });
    let [(us_printed, us), (si_printed, si)] = landed;
    assert!(
        us_printed.contains("clearance, ft  strut force, lb"),
        "{us_printed}"
    );
    assert!(
        si_printed.contains("clearance, m  strut force, N"),
        "{si_printed}"
    );
    for (us, si) in us.iter().zip(&si) {
        compare(us, si, &[], "");
    }
    run(
        &bench,
        &["land", "si.toml", "--out", "again", "--units", "US"],
    );
    assert_eq!(bench.read("again/si-1.csv"), us[1]);

    bench.write(
        "cases.csv",
        "vertical_velocity_mps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction\n4.2672,3,180,15,1\n",
    );
    let table = [
        "land",
        "--vehicle",
        "surveyor.toml",
        "--cases",
        "cases.csv",
        "--out",
    ];
    run(&bench, &[&table[..], &["one.csv"]].concat());
    run(
        &bench,
        &[&table[..], &["two.csv", "--units", "SI"]].concat(),
    );
    compare(&bench.read("one.csv"), &bench.read("two.csv"), &[], "");
}

#[test]
fn surfaces_come_out_in_si() {
    let bench = Bench::new();
    let told = |velocity: &str, more: &[&str]| {
        let given = [
            "surface",
            "--vehicle",
            "surveyor.toml",
            velocity,
            "--friction",
            "0.8",
        ];
        let times = ["--impact-times", "0,0.21,0.17"];
        run(&bench, &[&given[..], &times, more].concat()).out
    };
    let us: Value = serde_json::from_str(&told("--velocity=0,3,14", &["--json"])).unwrap();
    let si: Value = serde_json::from_str(&told(
        "--velocity-mps=0,0.9144,4.2672",
        &["--json", "--units", "SI"],
    ))
    .unwrap();
    assert_eq!(us["slope_deg"], si["slope_deg"]);
    let pair = |us: &Value, si: &Value, name: &str| {
        assert_is(&si.to_string(), &us.to_string(), FOOT, name);
    };
    pair(
        &us["horizontal_velocity_fps"],
        &si["horizontal_velocity_mps"],
        "velocity",
    );
    pair(
        &us["impact_points_ft"][1][2],
        &si["impact_points_m"][1][2],
        "point",
    );
    let text = told("--velocity=0,3,14", &["--units", "SI"]);
    assert!(
        text.contains("4.267200 m/s") && !text.contains("ft"),
        "{text}"
    );
    let given = [
        "surface",
        "--vehicle",
        "surveyor.toml",
        "--friction=1",
        "--impact-times=0,0.21,0.17",
    ];
    bench.run(&given).refused(&["--velocity"]);
    let wrong = [&given[..], &["--velocity-mps=0,0,-3.048"]].concat();
    bench
        .run(&wrong)
        .refused(&["--velocity-mps: expected", "(in ft/s: this is -10)"]);
}
