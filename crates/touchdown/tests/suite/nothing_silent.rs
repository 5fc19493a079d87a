//! What a careful user once found to be plausible and wrong: each of these is told now.

use crate::common::{BASELINE, Bench, SWEEP};

/// The small sweep of the bench with friction so low, on a slope so steep, that the lander slides without end.
fn sliding() -> String {
    SWEEP
        .replace("slope_deg = 15", "slope_deg = 30")
        .replace("friction = 1.0", "friction = 0.3")
        .replace("from_fps = 10\nto_fps = 12.5", "from_fps = 0\nto_fps = 2")
        + "bands = \"all\"\n[solver]\ntime_limit_s = 5\n"
}

fn ran(bench: &Bench, arguments: &[&str]) -> String {
    let done = bench.run(arguments);
    assert_eq!(done.code, Some(0), "{}", done.err);
    done.out
}

#[test]
fn landings_out_of_time_are_undecided_and_not_stable() {
    let bench = Bench::new();
    bench.write("slide.toml", &sliding());
    let told = ran(&bench, &["sweep", "slide.toml"]);
    assert!(told.contains("first transition to: 3 undecided"), "{told}");
    assert!(
        told.contains("at 3 points some landings are undecided"),
        "{told}"
    );
    assert!(told.contains("time_limit_s = 5"), "{told}");
    let bands = bench.read("results/slide-bands.csv");
    assert!(bands.contains(",0,2,undecided,,sliding,"), "{bands}");
    let picture = bench.read("results/slide.svg");
    assert!(picture.contains("undecided") && !picture.contains(">stable</text>"));

    let sample = sliding()
        .replace("title", "job = \"outcome\"\ntitle")
        .replace(
            "[axes]\n",
            "[axes]\nhorizontal_velocity_fps = { from = 0, to = 2 }\n",
        )
        .replace(
            "{ from = -10, to = 10, step = 10 }",
            "{ from = -10, to = 10 }",
        );
    let (before, _) = sample.split_once("[search]").unwrap();
    let sample = format!(
        "{before}[sample]\ndesign = \"monte-carlo\"\ncount = 20\nseed = 1\n[solver]\ntime_limit_s = 5\n"
    );
    bench.write("sample.toml", &sample);
    let told = ran(&bench, &["sweep", "sample.toml"]);
    assert!(told.contains("undecided 20: 100.00 %"), "{told}");
    assert!(
        told.contains("not stable (all of these) 20: 100.00 %"),
        "{told}"
    );
    assert!(told.contains("warning: 20 landings undecided"), "{told}");
}

#[test]
fn a_transition_at_the_end_of_the_range_is_told_as_a_bound() {
    let bench = Bench::new();
    let above = SWEEP.replace("from_fps = 10\nto_fps = 12.5", "from_fps = 12\nto_fps = 14");
    bench.write("above.toml", &above);
    let told = ran(&bench, &["sweep", "above.toml"]);
    assert!(
        told.contains("lowest V_H at or below 12.0000 ft/s"),
        "{told}"
    );
    let table = bench.read("results/above.csv");
    let row = table.lines().find(|row| row.starts_with("0,")).unwrap();
    assert!(row.starts_with("0,unstable,12,,12,"), "{row}");
    assert!(row.ends_with(",at-or-below,,,3e-5,0,,0,0"), "{row}");
    let picture = bench.read("results/above.svg");
    assert!(picture.contains("at or below the lowest speed searched"));

    let below = SWEEP.replace("from_fps = 10\nto_fps = 12.5", "from_fps = 0\nto_fps = 2");
    bench.write("below.toml", &below);
    ran(&bench, &["sweep", "below.toml"]);
    let table = bench.read("results/below.csv");
    assert!(table.contains("\n0,none,,2,,"), "{table}");
    assert!(table.contains(",above,,,,4,,0,0\n"), "{table}");
}

/// A run leaves nothing of the one before, and pictures are not drawn from tables of two runs.
#[test]
fn results_of_two_runs_never_stand_side_by_side() {
    let bench = Bench::new();
    let all = format!("{SWEEP}bands = \"all\"\n");
    bench.write("sweep.toml", &all);
    ran(&bench, &["sweep", "sweep.toml", "--format", "parquet"]);
    let bands = bench.read("results/sweep-bands.csv");
    let parquet = std::fs::read(bench.path("results/sweep.parquet")).unwrap();
    let parquet = String::from_utf8_lossy(&parquet).into_owned();
    for known in [
        "input_fingerprint",
        "{\"name\":\"touchdown\",\"version\":",
        "\"model\":",
    ] {
        assert!(parquet.contains(known), "{known}");
    }
    bench.write(
        "sweep.toml",
        &SWEEP.replace("friction = 1.0", "friction = 0.9"),
    );
    bench.run(&["sweep", "sweep.toml"]).refused(&[
        "results/sweep.csv",
        "holds results of other input",
        "--overwrite",
    ]);
    assert_eq!(bench.read("results/sweep-bands.csv"), bands);
    let again = "results/sweep.csv: holds the results of this input, which are computed again";
    for (more, is_again) in [(&["--overwrite"][..], false), (&[], true)] {
        let done = bench.run(&[&["sweep", "sweep.toml"], more].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        assert_eq!(done.err.contains(again), is_again, "{}", done.err);
    }
    assert_eq!(
        bench.list("results"),
        ["sweep.csv", "sweep.json", "sweep.png", "sweep.svg"]
    );
    bench.write("results/sweep-bands.csv", &bands);
    let plotted = bench.run(&["plot", "results/sweep.csv"]);
    plotted.refused(&["results/sweep.csv", "they do not belong to this table"]);
}

#[test]
fn no_command_writes_over_what_it_reads_or_what_is_not_its_own() {
    let bench = Bench::new();
    let surveyor = bench.read("surveyor.toml");
    let kept = "is read by this command";
    let foreign = "is no earlier result of this command";
    let with = |more: &[&str]| bench.run(&[&BASELINE[..], more].concat());
    with(&["--history", "surveyor.toml"]).refused(&["surveyor.toml", kept]);
    with(&["--history", "./surveyor.toml", "--overwrite"]).refused(&[kept]);
    bench.write("notes.txt", "my notes");
    with(&["--history", "notes.txt"]).refused(&["notes.txt", foreign, "--overwrite"]);
    assert_eq!(bench.read("notes.txt"), "my notes");
    for _ in 0..2 {
        assert_eq!(with(&["--history", "history.csv"]).code, Some(0));
    }
    assert_eq!(
        with(&["--history", "notes.txt", "--overwrite"]).code,
        Some(0)
    );

    let cases = "vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction\n\
                 14,2,180,15,1\n";
    bench.write("cases.csv", cases);
    let land = |out: &str| bench.land_cases(&[out]);
    land("cases.csv").refused(&["cases.csv", kept]);
    land("history.csv").refused(&["history.csv", foreign]);
    for _ in 0..2 {
        assert_eq!(land("out.csv").code, Some(0));
    }

    bench.write(
        "mine.txt",
        include_str!("../../../input/src/readers/deck/sample_deck.txt"),
    );
    for _ in 0..2 {
        assert_eq!(bench.run(&["import-deck", "mine.txt"]).code, Some(0));
    }
    bench.write("mine.toml", "# my own\n");
    bench
        .run(&["import-deck", "mine.txt"])
        .refused(&["mine.toml", foreign]);
    assert_eq!(bench.read("mine.toml"), "# my own\n");

    bench.write("results.csv", "roll,speed\n1,2\n");
    std::fs::create_dir(bench.path("results")).unwrap();
    bench.write("results/sweep.csv", "roll,speed\n1,2\n");
    bench
        .run(&["sweep", "sweep.toml"])
        .refused(&["results/sweep.csv", foreign]);
    let again = "results/sweep.csv: holds the results of this input, which are computed again";
    for (more, is_again) in [(&["--overwrite"][..], false), (&[], true)] {
        let done = bench.run(&[&["sweep", "sweep.toml"], more].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        assert_eq!(done.err.contains(again), is_again, "{}", done.err);
    }
    assert_eq!(bench.read("surveyor.toml"), surveyor);
}

/// A command refused its input, could not compute its landing, or printed numbers.
fn printed_numbers(bench: &Bench, arguments: &[&str]) {
    let done = bench.run(arguments);
    assert!(
        matches!(done.code, Some(0..=2)),
        "{arguments:?}: {}",
        done.err
    );
    let is_no_number = |word: &str| {
        let word = word.trim_matches(|c: char| !c.is_ascii_alphanumeric());
        ["inf", "infinity", "nan"].contains(&word.to_ascii_lowercase().as_str())
    };
    for text in [&done.out, &done.err] {
        let found = text
            .split([' ', ',', '\n', '"'])
            .find(|word| is_no_number(word));
        assert_eq!(found, None, "{arguments:?}: {text}");
    }
}

const EXTREMES: [&str; 6] = ["1e300", "-1e300", "1e9", "-1e9", "1e-300", "36000"];

#[test]
fn extremes_of_any_option_give_numbers_or_a_refusal() {
    let bench = Bench::new();
    for option in [
        "vertical-velocity",
        "horizontal-velocity",
        "cross-slope",
        "slope",
        "friction",
        "block-friction",
        "pitch",
        "yaw",
        "roll",
        "tip",
        "time-limit",
        "tolerance",
    ] {
        for extreme in EXTREMES {
            let given = format!("--{option}={extreme}");
            let mut arguments: Vec<&str> = BASELINE.to_vec();
            if let Some(place) = arguments
                .iter()
                .position(|known| *known == format!("--{option}"))
            {
                arguments.drain(place..place + 2);
            }
            arguments.retain(|known| !known.starts_with(&format!("--{option}=")));
            arguments.extend([given.as_str(), "--json"]);
            if option == "tip" {
                arguments.push("--tip-azimuth=1e4");
            }
            if option != "time-limit" {
                arguments.push("--time-limit=0.05");
            }
            printed_numbers(&bench, &arguments);
        }
    }
    let surface = [
        "surface",
        "--vehicle=surveyor.toml",
        "--impact-times=0,0.21,0.17",
        "--json",
    ];
    for given in [
        ["--velocity=0,3,1e300", "--friction=0.8"],
        ["--velocity=1e-300,1e4,1e4", "--friction=0.8"],
        ["--velocity=0,3,14", "--friction=1e300"],
        ["--velocity=0,3,14", "--friction=1e-300"],
    ] {
        printed_numbers(&bench, &[&surface[..], &given].concat());
    }
    let good = ["--velocity=0,3,14", "--friction=0.8"];
    for given in [
        "--pitch=1e300",
        "--roll=-1e9",
        "--angular-velocity=1e300,0,0",
        "--timing-sigma=1e300",
    ] {
        let (option, _) = given.split_once('=').unwrap();
        bench
            .run(&[&surface[..], &good, &[given]].concat())
            .refused(&[option, "expected"]);
    }
}

#[test]
fn extremes_of_any_number_of_a_vehicle_give_numbers_or_a_refusal() {
    let bench = Bench::new();
    let surveyor = bench.read("surveyor.toml");
    let mut count = 0;
    for line in surveyor.lines() {
        let Some((key, value)) = line.split_once(" = ") else {
            continue;
        };
        if value
            .split_whitespace()
            .next()
            .unwrap()
            .parse::<f64>()
            .is_err()
        {
            continue;
        }
        // Blocks farther out than the last would take seconds.
        for extreme in [&EXTREMES[..5], &["3600"]].concat() {
            let text = surveyor.replacen(line, &format!("{key} = {extreme}"), 1);
            bench.write("extreme.toml", &text);
            let mut arguments = BASELINE.to_vec();
            arguments[2] = "extreme.toml";
            arguments.extend(["--json", "--time-limit=0.02", "--tolerance=1e-2"]);
            printed_numbers(&bench, &arguments);
            count += 1;
        }
    }
    assert!(count > 150, "{count}");
}

#[test]
fn extremes_of_sweeps_are_refused_where_they_stand() {
    let bench = Bench::new();
    let roll = "roll_deg = { from = -10, to = 10, step = 10 }";
    for (right, wrong, place, allowed) in [
        (
            "to_fps = 12.5",
            "to_fps = 20000",
            ":12: search.to_fps = 20000",
            "≤ 10000",
        ),
        (
            "friction = 1.0",
            "friction = 1e300",
            ":7: scene.friction = 1e300",
            "≤ 1000",
        ),
        (roll, "roll_deg = [1e300]", ":9: axes.roll_deg", "≤ 36000"),
        (
            roll,
            "roll_deg = { from = 1, to = 1e300, count = 2, spacing = \"log\" }",
            ":9: axes.roll_deg",
            "≤ 36000",
        ),
        (
            roll,
            "vehicle.mass_slug = [1e300]",
            ":9: axes.vehicle.mass_slug = [1e300]",
            "≤ 1e9",
        ),
    ] {
        assert!(SWEEP.contains(right), "{right}");
        bench.write("sweep.toml", &SWEEP.replace(right, wrong));
        bench
            .run(&["sweep", "sweep.toml"])
            .refused(&[place, allowed]);
    }
    assert_eq!(bench.list("results"), Vec::<String>::new());
}

#[test]
fn elements_that_give_back_more_than_they_took_are_told() {
    let bench = Bench::new();
    let done = bench.run(&BASELINE);
    assert_eq!((done.code, done.err.as_str()), (Some(0), ""));
    let (soft, stiff) = ("crush_pressure_psf = 1578.8", "crush_pressure_psf = 1e5");
    let surveyor = bench.read("surveyor.toml").replace(soft, stiff);
    bench.write("surveyor.toml", &surveyor);
    // At 5 ft/s the pads turn so fast that their faces slide against their pivots.
    let slower = BASELINE.map(|argument| argument.replace("11.25", "5"));
    let done = bench.run(&slower.each_ref().map(String::as_str));
    assert_eq!(done.code, Some(0), "{}", done.err);
    let warning = "warning: crushing footpads or blocks added ";
    assert!(done.err.contains(warning), "{}", done.err);

    // The same in a table of cases, once for all rows that are concerned.
    let cases = "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction,\
                 vehicle.footpad.crush_pressure_psf\nsoft,14,5,180,15,1,1578.8\nstiff,14,5,180,15,1,\nless stiff,14,5,180,15,1,5e4\n";
    bench.write("cases.csv", cases);
    let done = bench.land_cases(&["out.csv"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let told: Vec<&str> = (done.err.lines())
        .filter(|line| line.contains("crushing"))
        .collect();
    assert_eq!(told.len(), 1, "{}", done.err);
    assert!(
        told[0].contains(
            "warning: in 2 cases, most in case stiff: crushing footpads or blocks added "
        ),
        "{}",
        told[0]
    );

    // And in a sweep of single landings, of the points that are concerned.
    let outcomes = SWEEP
        .replace(
            "[scene]",
            "job = \"outcome\"\n[scene]\nhorizontal_velocity_fps = 5",
        )
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "vehicle.footpad.crush_pressure_psf = [1578.8, 1e5]",
        );
    bench.write("sweep.toml", outcomes.split("[search]").next().unwrap());
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let warning = "warning: at 1 point, most at vehicle.footpad.crush_pressure_psf = 100000: \
                   crushing footpads or blocks added ";
    assert!(done.out.contains(warning), "{}", done.out);

    // And in a search, of the landings that it computes.
    let searches = SWEEP.replace(
        "roll_deg = { from = -10, to = 10, step = 10 }",
        "vehicle.footpad.crush_pressure_psf = [1578.8, 1e5]",
    );
    let search = "[search]\nfrom_fps = 5\nto_fps = 6\nscan_step_fps = 1\ntolerance_fps = 0.1\nbands = \"first\"\n";
    let searches = searches.split("[search]").next().unwrap().to_owned() + search;
    bench.write("sweep.toml", &searches);
    let done = bench.run(&["sweep", "sweep.toml", "--overwrite"]);
    assert!(done.out.contains(warning), "{}", done.out);
}

#[test]
fn inputs_beyond_any_lander_are_refused() {
    let bench = Bench::new();
    for (option, name) in [
        ("--horizontal-velocity=1e300", "--horizontal-velocity"),
        ("--friction=1e9", "--friction"),
        ("--angular-velocity=0,0,1e99", "angular-velocity"),
    ] {
        let mut arguments: Vec<&str> = BASELINE.to_vec();
        let key = option.split('=').next().unwrap();
        if let Some(place) = arguments.iter().position(|known| *known == key) {
            arguments.drain(place..place + 2);
        }
        arguments.push(option);
        bench.run(&arguments).refused(&[name, "expected"]);
    }
}
