//! Pictures of result tables, drawn anew.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::Bench;

const HEADING: &str = "cross_slope_deg,roll_deg,first_transition_to,first_transition_fps,\
                       bracket_low_fps,bracket_high_fps\n";

/// A grid of two by two points, and the profile in its first row.
fn grid() -> String {
    let rows = [(90, -10, 14), (90, 10, 15), (180, -10, 12), (180, 10, 13)];
    let rows = rows
        .map(|(slope, roll, speed)| format!("{slope},{roll},unstable,{speed},{speed},{speed}\n"));
    format!("{HEADING}{}", rows.concat())
}

#[test]
fn a_sweep_is_drawn_again_as_it_was() {
    let bench = Bench::new();
    assert_eq!(
        bench.run(&["sweep", "sweep.toml", "--bands", "all"]).code,
        Some(0)
    );
    let drawn = |name: &str| std::fs::read(bench.path(name)).unwrap();
    let before = (drawn("results/sweep.svg"), drawn("results/sweep.png"));
    std::fs::remove_file(bench.path("results/sweep.svg")).unwrap();
    let done = bench.run(&["plot", "results/sweep.csv"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(done.out, "results/sweep.svg\nresults/sweep.png\n");
    assert_eq!(
        before,
        (drawn("results/sweep.svg"), drawn("results/sweep.png"))
    );
}

#[test]
fn a_table_alone_is_enough_and_two_axes_have_two_pictures() {
    let bench = Bench::new();
    bench.write("grid.csv", &grid());
    let done = bench.run(&["plot", "grid.csv", "--out", "new/map.svg"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert_eq!(
        bench.list("new"),
        ["map-contours.svg", "map-perspective.svg"]
    );
    let done = bench.run(&["plot", "grid.csv", "--out", "map.png"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let png = std::fs::read(bench.path("map-contours.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
    // Width and height stand in the first chunk: twice 900 by 860.
    assert_eq!(png[16..24], [0, 0, 7, 8, 0, 0, 6, 184]);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let bench = Bench::new();
    bench.write("grid.csv", &grid());
    let plot = |arguments: &[&str]| bench.run(&[&["plot"], arguments].concat());
    plot(&["none.csv"]).refused(&["none.csv: cannot be read"]);
    plot(&["sweep.toml"]).refused(&["sweep.toml: result table:"]);
    plot(&["grid.csv", "--out", "map.pdf"]).refused(&["map.pdf", "ends in .svg or .png"]);
    plot(&["grid.csv", "grid.csv", "--out", "map.svg"])
        .refused(&["map.svg", "one table or several histories"]);
    plot(&["grid.csv", "--levels", "12,11"]).refused(&["--levels", "1 to 30 velocities"]);
    plot(&["grid.csv", "--worst-by", "friction"]).refused(&[
        "grid.csv: ",
        "friction is no axis",
        "cross_slope_deg, roll_deg",
    ]);
    plot(&["grid.csv", "--columns", "pitch_deg"])
        .refused(&["columns cannot be chosen for a sweep"]);
    bench.write("grid.csv", &grid().replace(",13,13,13", ",fast,13,13"));
    plot(&["grid.csv"]).refused(&["grid.csv: result table: row 4: first_transition_fps = fast"]);
    bench.write("grid.csv", &grid().replace("180,10", "170,10"));
    plot(&["grid.csv"]).refused(&["grid.csv: has no picture", "a grid of at least 2 by 2"]);
    bench.write("grid.csv", &grid());
    bench.write("grid.json", "{");
    plot(&["grid.csv"]).refused(&["grid.csv: result table: record:"]);
    assert_eq!(bench.list(".").len(), 4);
}

/// One damaged number must not keep the program busy: it is refused with its row.
#[test]
fn absurd_numbers_are_refused() {
    let bench = Bench::new();
    for absurd in ["1e9", "1e16", "1e308"] {
        bench.write(
            "grid.csv",
            &grid().replace(",13,13,13", &format!(",{absurd},13,13")),
        );
        bench.run(&["plot", "grid.csv"]).refused(&[
            "grid.csv: result table: row 4: first_transition_fps = ",
            absurd,
        ]);
        bench.write("grid.csv", &grid().replace("180,", &format!("{absurd},")));
        let done = bench.run(&["plot", "grid.csv"]);
        if absurd == "1e9" {
            assert_eq!(done.code, Some(0), "{}", done.err);
        } else {
            done.refused(&["row 3: cross_slope_deg = ", absurd]);
        }
    }
}

/// Levels come from the data, or from the command line.
#[test]
fn maps_of_other_vehicles_have_levels_of_their_own() {
    let bench = Bench::new();
    let rows: String = (0..6)
        .flat_map(|slope| (0..6).map(move |friction| (slope, friction)))
        .map(|(slope, friction)| {
            let speed = 6.9 + 0.5 * f64::from(slope) + 0.38 * f64::from(friction);
            format!("{slope},{friction},unstable,{speed},{speed},{speed}\n")
        })
        .collect();
    let heading = HEADING.replace("cross_slope_deg,roll_deg", "slope_deg,friction");
    bench.write("map.csv", &format!("{heading}{rows}"));
    let labels = |arguments: &[&str]| -> Vec<String> {
        let done = bench.run(&[&["plot", "map.csv", "--out", "map.svg"], arguments].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        let picture = bench.read("map-contours.svg");
        let map = picture.split(">ft/s</text>").next().unwrap().to_owned();
        let texts = map
            .split("</text>")
            .filter(|text| text.contains("font-size=\"11\""));
        texts
            .map(|text| text.rsplit('>').next().unwrap().to_owned())
            .collect()
    };
    assert_eq!(
        labels(&[]),
        ["7.5", "8", "8.5", "9", "9.5", "10", "10.5", "11"]
    );
    assert_eq!(labels(&["--levels", "7.3,8.9"]), ["7.3", "8.9"]);
    let picture = bench.read("map-contours.svg");
    assert!(picture.contains("Slope θ, deg") && picture.contains("Friction coefficient μ"));
    assert!(!picture.contains("jumps") && !picture.contains("1966"));
}

/// A sweep over more than two axes has pictures of the worst case, and says how to get others; over three it has one for each
/// value of the third.
#[test]
fn sweeps_over_many_axes_are_drawn_at_worst_over_all_but_two() {
    let bench = Bench::new();
    let axes = "[axes]\ncross_slope_deg = [170, 180]\nfriction = [0.9, 1.0]\n";
    let sweep = crate::common::SWEEP
        .replace("cross_slope_deg = 180\n", "")
        .replace("friction = 1.0\n", "")
        .replace("[axes]\n", axes);
    bench.write("many.toml", &sweep);
    let done = bench.run(&["sweep", "many.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let command = "`touchdown plot results/many.csv --worst-by friction,roll_deg`";
    assert!(done.out.contains(command), "{}", done.out);
    let map = bench.read("results/many-contours.svg");
    assert!(
        map.contains("at worst over friction coefficient μ"),
        "{map}"
    );
    for friction in ["0.9", "1"] {
        let name = format!("results/many-contours-friction={friction}.svg");
        assert!(done.out.contains(&name), "{}", done.out);
        let of_one = bench.read(&name);
        assert!(
            of_one.contains(&format!(", friction {friction}</text>")),
            "{of_one}"
        );
        assert!(!of_one.contains("at worst over"), "{of_one}");
    }
    // The old word for the option still works.
    for option in ["--worst-by", "--least-over"] {
        let axes = "friction,roll_deg";
        let out = format!("{option}.svg");
        let done = bench.run(&[
            "plot",
            "results/many.csv",
            option,
            axes,
            &format!("--out=new/{out}"),
        ]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let [new, old] = ["--worst-by", "--least-over"].map(|option| {
        let map = bench.read(&format!("new/{option}-contours.svg"));
        assert!(map.contains("at worst over cross-slope angle λ"), "{map}");
        map
    });
    assert_eq!(new, old);
}

/// Pictures of short axes have the spacing of the sweep file, whatever ratio their values have, and results are asked
/// over logarithmic axes as over others.
#[test]
fn axes_have_the_scale_of_their_spacing() {
    let bench = Bench::new();
    let drawn = |values: &str| {
        let axis = format!("[axes]\nroll_deg = {values}\n");
        let (before, after) = crate::common::SWEEP.split_once("[axes]\n").unwrap();
        let (_, after) = after.split_once('\n').unwrap();
        bench.write("spaced.toml", &format!("{before}{axis}{after}"));
        let done = bench.run(&["sweep", "spaced.toml", "--overwrite"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        bench.read("results/spaced.svg")
    };
    let counted = drawn("{ from = 2.5, to = 10, count = 3, spacing = \"log\" }");
    let record: serde_json::Value =
        serde_json::from_str(&bench.read("results/spaced.json")).unwrap();
    assert_eq!(record["spacing"]["roll_deg"], "log");
    for file in ["results/spaced.csv", "results/spaced.json"] {
        let done = bench.run(&["ask", file, "--at", "roll_deg=5"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    let listed = drawn("[2.5, 5, 10]");
    assert_ne!(counted, listed);
}

/// A history is titled with vehicle and conditions where the report of its landing stands beside it.
#[test]
fn pictures_of_a_history_tell_vehicle_and_conditions() {
    let bench = Bench::new();
    let landing = [
        &crate::common::BASELINE[..],
        &["--history", "landing.csv", "--json"],
    ];
    let done = bench.run(&landing.concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    let conditions = ">Surveyor, Table 4-1 · ";
    for is_told in [false, true] {
        if is_told {
            bench.write("landing.json", &done.out);
        }
        let done = bench.run(&["plot", "landing.csv", "--out", "page.svg"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let page = bench.read("page.svg");
        assert!(page.contains(">landing</text>"), "{page}");
        assert_eq!(page.contains(conditions), is_told, "{page}");
        assert_eq!(
            page.contains("11.25 ft/s · cross-slope 180 deg"),
            is_told,
            "{page}"
        );
    }
}

/// A landing has a page of few panels; columns can be chosen, and landings drawn over each other.
#[test]
fn histories_are_drawn_on_a_page() {
    let bench = Bench::new();
    for (name, speed) in [("slow.csv", "10"), ("fast.csv", "11.25")] {
        let mut arguments = crate::common::BASELINE.to_vec();
        arguments[5] = speed;
        arguments.extend(["--history", name, "--interval", "0.02"]);
        assert_eq!(bench.run(&arguments).code, Some(0));
    }
    let plot = |arguments: &[&str]| {
        let done = bench.run(&[&["plot"], arguments].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
    };
    plot(&["slow.csv", "--out", "page.svg"]);
    let page = bench.read("page.svg");
    for title in [
        "Velocity, ft/s",
        "Attitude, deg",
        "Stability angle σ, deg",
        "Strut force, lb",
        "Footpad load, lb",
        "Energy, ft lb",
    ] {
        assert!(page.contains(&format!(">{title}</text>")), "{title}");
    }
    assert!(page.contains(">leg 3</text>"));
    plot(&[
        "slow.csv",
        "--columns",
        "stroke_#_ft,sigma_deg",
        "--out",
        "strokes.svg",
    ]);
    let strokes = bench.read("strokes.svg");
    assert!(strokes.contains(">stroke, leg 3</text>") && !strokes.contains("Velocity"));
    plot(&["slow.csv", "fast.csv", "--out", "both.svg"]);
    let both = bench.read("both.svg");
    assert!(both.contains(">slow</text>") && both.contains(">fast</text>"));
    bench
        .run(&[
            "plot",
            "slow.csv",
            "--columns",
            "strok_1_ft",
            "--out",
            "no.svg",
        ])
        .refused(&["slow.csv: ", "no column strok_1_ft", "stroke_#_ft"]);
    assert!(!bench.path("no.svg").exists());
}
