//! What a careful user once found to be plausible and wrong: each of these is told now.

use crate::common::{BASELINE, Bench, SWEEP};

/// The small sweep of the bench over friction so low, on a slope so steep, that the lander slides to the time limit.
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
    assert!(bands.contains(",0,2,undecided,,time-expired,"), "{bands}");
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
        told.contains("not stable, all of these together 20: 100.00 %"),
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
    assert!(row.ends_with(",at-or-below,,"), "{row}");
    let picture = bench.read("results/above.svg");
    assert!(picture.contains("at or below the lowest speed searched"));

    let below = SWEEP.replace("from_fps = 10\nto_fps = 12.5", "from_fps = 0\nto_fps = 2");
    bench.write("below.toml", &below);
    ran(&bench, &["sweep", "below.toml"]);
    let table = bench.read("results/below.csv");
    assert!(table.contains("\n0,none,,2,,"), "{table}");
    assert!(table.contains(",above,,\n"), "{table}");
}

/// A run leaves nothing of the one before, and pictures are not drawn from tables of two runs.
#[test]
fn results_of_two_runs_never_stand_side_by_side() {
    let bench = Bench::new();
    let all = format!("{SWEEP}bands = \"all\"\n");
    bench.write("sweep.toml", &all);
    ran(&bench, &["sweep", "sweep.toml", "--format", "parquet"]);
    let bands = bench.read("results/sweep-bands.csv");
    bench.write(
        "sweep.toml",
        &SWEEP.replace("friction = 1.0", "friction = 0.9"),
    );
    ran(&bench, &["sweep", "sweep.toml"]);
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
    let land = [
        "land",
        "--vehicle",
        "surveyor.toml",
        "--cases",
        "cases.csv",
        "--out",
    ];
    let land = |out: &str| bench.run(&[&land[..], &[out]].concat());
    land("cases.csv").refused(&["cases.csv", kept]);
    land("history.csv").refused(&["history.csv", foreign]);
    for _ in 0..2 {
        assert_eq!(land("out.csv").code, Some(0));
    }

    bench.write(
        "mine.txt",
        include_str!("../../../sweep/src/input/deck/sample_deck.txt"),
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
    ran(&bench, &["sweep", "sweep.toml", "--overwrite"]);
    ran(&bench, &["sweep", "sweep.toml"]);
    assert_eq!(bench.read("surveyor.toml"), surveyor);
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
        bench.run(&arguments).refused(&[name, "allowed is"]);
    }
}
