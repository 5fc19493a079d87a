//! Sweeps that are interrupted, killed and gone on with.

#![allow(missing_docs, reason = "tests are not an interface")]
#![cfg(unix)]

use std::fs;
use std::process::{Child, Command, Stdio};
use std::sync::LazyLock;
use std::time::Duration;

use crate::common::{Bench, Done, LAND_CASES, SWEEP};
use touchdown_sweep::journal::{Access, InOrder, Records};

/// Points of [`sweep`].
const POINTS: usize = 48;

/// Forty-eight points over roll and the strut's damping, all bands: the first is in the journal long before the last is
/// computed.
fn sweep() -> String {
    SWEEP
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "vehicle.strut.compression_damping = [45, 54, 60]\n\
             roll_deg = { from = -15, to = 15, step = 2 }",
        )
        .replace(
            "tolerance_fps = 0.1",
            "tolerance_fps = 0.01\nbands = \"all\"",
        )
}

const RESULTS: [&str; 2] = ["results/sweep.csv", "results/sweep-bands.csv"];

/// The results of a run from beginning to end.
fn uninterrupted() -> &'static [String; 2] {
    static RESULTS_OF_ONE_RUN: LazyLock<[String; 2]> = LazyLock::new(|| {
        let bench = bench();
        bench.run(&["sweep", "sweep.toml", "--threads", "1"]);
        RESULTS.map(|name| bench.read(name))
    });
    &RESULTS_OF_ONE_RUN
}

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("sweep.toml", &sweep());
    bench
}

fn start(bench: &Bench, arguments: &[&str]) -> Child {
    bench
        .command(&[&["sweep", "sweep.toml"], arguments].concat())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn signal(child: &Child, name: &str) {
    let kill = Command::new("kill")
        .args([name, &child.id().to_string()])
        .status()
        .unwrap();
    assert!(kill.success());
}

/// The journal of a sweep that is computed as a whole.
const JOURNAL: &str = "results/sweep.journal";

/// Whether a journal has more than its head, whose length its first bytes announce: the file grows while it is written.
fn has_points(bench: &Bench, journal: &str) -> bool {
    const OVERHEAD: usize = 12;
    let Ok(journal) = fs::read(bench.path(journal)) else {
        return false;
    };
    (journal.get(4..8)).is_some_and(|announced| {
        let announced = u32::from_le_bytes(announced.try_into().unwrap());
        journal.len() > OVERHEAD + announced as usize
    })
}

/// Waits until points are in a journal.
fn wait_for_points(bench: &Bench, journal: &str, child: &mut Child) {
    while !has_points(bench, journal) {
        assert!(child.try_wait().unwrap().is_none(), "ended at once");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Interrupted at first, then gone on with and terminated, then gone on with to the end.
#[test]
fn interrupted_and_terminated_it_ends_in_time_and_goes_on() {
    let expected = uninterrupted();
    let bench = bench();
    let length = || fs::metadata(bench.path(JOURNAL)).map_or(0, |file| file.len());
    let mut earlier = 0;
    for name in ["-INT", "-TERM"] {
        let before = length();
        let mut sweep = start(&bench, &["--threads", "1"]);
        // What was there before does not tell that the program heeds signals by now; that it has grown does.
        while length() <= before {
            assert!(sweep.try_wait().unwrap().is_none(), "ended at once");
            std::thread::sleep(Duration::from_millis(1));
        }
        wait_for_points(&bench, JOURNAL, &mut sweep);
        signal(&sweep, name);
        let done = Done::from(sweep.wait_with_output().unwrap());
        assert_eq!(done.code, Some(130), "{}", done.err);
        assert!(done.err.contains("run again to go on"), "{}", done.err);
        assert_eq!(bench.list("results"), ["sweep.journal"]);
        let journaled = journaled_points(&bench).unwrap();
        assert!(journaled > earlier, "{journaled} after {earlier}");
        earlier = journaled;
        let told = bench.run(&["sweep", "sweep.toml", "--dry-run"]);
        let expected_words = format!(
            "results/sweep.journal holds {journaled} point{}: {} left",
            if journaled == 1 { "" } else { "s" },
            POINTS - journaled
        );
        assert!(told.out.contains(&expected_words), "{}", told.out);
    }
    let resumed = bench.run(&["sweep", "sweep.toml", "--resume", "--threads", "2"]);
    assert_eq!(resumed.code, Some(0), "{}", resumed.err);
    assert!(
        (resumed.err).contains(&format!("{earlier} of {POINTS} points are in")),
        "{}",
        resumed.err
    );
    assert_eq!(RESULTS.map(|name| bench.read(name)), *expected);
    assert!(!bench.list("results").contains(&"sweep.journal".to_owned()));
}

/// Journals are in the units of the program, whatever those of the results.
#[test]
fn a_run_goes_on_in_other_units_than_it_was_begun_in() {
    let bench = bench();
    let mut sweep = start(&bench, &["--threads", "1"]);
    wait_for_points(&bench, JOURNAL, &mut sweep);
    signal(&sweep, "-INT");
    let done = Done::from(sweep.wait_with_output().unwrap());
    assert_eq!(done.code, Some(130), "{}", done.err);
    for more in [["--resume"].as_slice(), &["--out", "whole"]] {
        let in_si = ["sweep", "sweep.toml", "--units", "SI"];
        let done = bench.run(&[&in_si, more].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    for name in ["sweep.csv", "sweep-bands.csv", "sweep.json"] {
        let [resumed, whole] = ["results", "whole"].map(|folder| format!("{folder}/{name}"));
        assert_eq!(bench.read(&resumed), bench.read(&whole));
    }
    let table = bench.read("results/sweep.csv");
    assert!(table.contains("first_transition_mps"), "{table}");
}

/// As `nohup` starts a program: what closes the terminal does not end it. The tests may be run under it themselves.
#[cfg(target_os = "linux")]
#[test]
fn a_closed_terminal_interrupts_unless_hangups_are_ignored() {
    for (handling, code) in [("--default-signal=HUP", 130), ("--ignore-signal=HUP", 0)] {
        let bench = bench();
        let program = env!("CARGO_BIN_EXE_touchdown");
        let mut sweep = Command::new("env")
            .args([handling, program, "sweep", "sweep.toml", "--threads", "1"])
            .current_dir(bench.path("."))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_for_points(&bench, JOURNAL, &mut sweep);
        signal(&sweep, "-HUP");
        let done = Done::from(sweep.wait_with_output().unwrap());
        assert_eq!(done.code, Some(code), "{handling}: {}", done.err);
    }
}

/// A table of cases, each of which takes a while.
fn cases() -> String {
    let heading = "vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction,\
                   roll_deg,solver.tolerance\n";
    let row = |case: u32| {
        format!(
            "14,{},180,15,1,{},1e-9\n",
            8.0 + 0.01 * f64::from(case),
            case % 7
        )
    };
    heading.to_owned() + &(0..400).map(row).collect::<String>()
}

#[test]
fn tables_of_cases_go_on_after_interruptions_with_the_same_results() {
    const JOURNAL: &str = "out/cases.csv.journal";
    let bench = bench();
    bench.write("cases.csv", &cases());
    let land = |more: &[&str]| bench.command(&[&LAND_CASES[..], &["out/cases.csv"], more].concat());
    let run = |more: &[&str]| Done::from(land(more).output().unwrap());
    assert_eq!(run(&["--threads", "2"]).code, Some(0));
    let expected = bench.read("out/cases.csv");
    assert_eq!(bench.list("out"), ["cases.csv"]);
    fs::remove_file(bench.path("out/cases.csv")).unwrap();

    for (how, code) in [("-INT", Some(130)), ("-KILL", None)] {
        let mut command = land(&["--threads", "1"]);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut cases = command.spawn().unwrap();
        wait_for_points(&bench, JOURNAL, &mut cases);
        signal(&cases, how);
        let done = Done::from(cases.wait_with_output().unwrap());
        assert_eq!(done.code, code, "{}", done.err);
        assert_eq!(bench.list("out"), ["cases.csv.journal"]);
    }
    // Neither other cases nor another vehicle go on with it.
    bench.write("cases.csv", &cases().replace("14,8,", "14,8.5,"));
    run(&[]).refused(&["cannot be resumed", "table_of_cases: "]);
    bench.write("cases.csv", &cases());
    run(&["--crush-rule", "section"]).refused(&["solver.crush_rule: \"section\" here"]);
    // No sweep is merged from it.
    let merged = bench.run(&["merge", "out"]);
    merged.refused(&["no journals of sweeps"]);

    let resumed = run(&["--threads", "3"]);
    assert_eq!(resumed.code, Some(0), "{}", resumed.err);
    assert!(
        resumed.err.contains("of 400 cases are in"),
        "{}",
        resumed.err
    );
    assert_eq!(bench.read("out/cases.csv"), expected);
    assert_eq!(bench.list("out"), ["cases.csv"]);
}

#[test]
fn what_there_is_of_a_sweep_is_tabulated_and_marked_as_partial() {
    let bench = bench();
    let mut sweep = start(&bench, &["--threads", "1"]);
    wait_for_points(&bench, JOURNAL, &mut sweep);
    // Also while the sweep goes on.
    let looked = bench.run(&["merge", "results", "--partial", "--out", "look"]);
    assert_eq!(looked.code, Some(0), "{}", looked.err);
    signal(&sweep, "-INT");
    assert_eq!(
        Done::from(sweep.wait_with_output().unwrap()).code,
        Some(130)
    );
    let points = journaled_points(&bench).unwrap();

    let merged = bench.run(&["merge", "results", "--partial"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    let mark = format!("Partial, {points} of {POINTS} points: Roll at");
    assert!(merged.out.starts_with(&mark), "{}", merged.out);
    let record = bench.read("results/sweep-partial.json");
    let expected = format!("\"partial\": {{\n    \"points\": {points},\n    \"of\": {POINTS}\n");
    assert!(
        record.contains(&mark) && record.contains(&expected),
        "{record}"
    );
    assert!(!bench.path(RESULTS[0]).exists() && bench.path(JOURNAL).exists());
    let partial = bench.read("results/sweep-partial.csv");
    assert_eq!(partial.lines().count(), 1 + points);

    let resumed = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(resumed.code, Some(0), "{}", resumed.err);
    let whole = bench.read(RESULTS[0]);
    assert!(
        partial
            .lines()
            .all(|row| whole.lines().any(|known| known == row))
    );
    // What was partial is gone with it.
    let left = bench.list("results");
    assert!(
        left.iter().all(|name| !name.contains("partial")),
        "{left:?}"
    );
}

#[test]
fn a_partial_sweep_is_drawn_as_partial() {
    let bench = Bench::new();
    bench.write("sweep.toml", &SWEEP.replace("step = 10", "step = 5"));
    assert_eq!(
        bench.run(&["sweep", "sweep.toml", "--shard", "1/2"]).code,
        Some(0)
    );
    let merged = bench.run(&["merge", "results", "--partial"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    let picture = bench.read("results/sweep-partial.svg");
    assert!(picture.contains("Partial, 3 of 5 points"), "{picture}");

    let grid = SWEEP
        .replace("[axes]", "[axes]\nslope_deg = [10, 12, 15]")
        .replace("slope_deg = 15\nf", "f");
    bench.write("grid.toml", &grid);
    for shard in ["1/9", "2/9", "3/9", "4/9", "5/9", "6/9", "8/9"] {
        assert_eq!(
            bench.run(&["sweep", "grid.toml", "--shard", shard]).code,
            Some(0)
        );
    }
    let merged = bench.run(&["merge", "results", "--partial"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    assert!(bench.path("results/grid-partial-contours.svg").exists());
    assert_eq!(
        bench.read("results/grid-partial.csv").lines().count(),
        1 + 7
    );
}

/// How many points are in the journal, whole; `None` when it is gone.
fn journaled_points(bench: &Bench) -> Option<usize> {
    let journal = bench.path(JOURNAL);
    if !journal.exists() {
        return None;
    }
    // Before its head is whole it holds nothing.
    let Ok((records, _)) = Records::open(&journal, Access::Alone) else {
        return Some(0);
    };
    let found = InOrder::new(vec![records], POINTS, &bench.path("results")).unwrap();
    Some(POINTS - found.missing())
}

#[test]
fn killed_again_and_again_it_loses_nothing_and_changes_nothing() {
    let expected = uninterrupted();
    let bench = bench();
    let mut journaled = 0;
    let mut kills = 0;
    // Odd times, so that kills fall anywhere, and ever longer ones, so that a slow machine ends as well.
    for round in 0u64.. {
        let mut sweep = start(&bench, &["--threads", ["1", "2", "3"][round as usize % 3]]);
        std::thread::sleep(Duration::from_micros(20_000 + round * 37_123));
        sweep.kill().unwrap();
        let ended = sweep.wait().unwrap();
        kills += u32::from(!ended.success());
        match journaled_points(&bench) {
            Some(points) => {
                assert!(points >= journaled, "{points} of {journaled} points");
                journaled = points;
            }
            // Nothing was begun yet, or all results stand, where the kill may still find the program
            // about to end.
            None if journaled == 0 && !bench.path(RESULTS[0]).exists() => {}
            None => break,
        }
    }
    assert!(kills > 0);
    assert_eq!(RESULTS.map(|name| bench.read(name)), *expected);
}

#[test]
fn two_processes_cannot_write_one_journal() {
    let bench = bench();
    let mut first = start(&bench, &[]);
    wait_for_points(&bench, JOURNAL, &mut first);
    let second = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(second.code, Some(1), "{}", second.err);
    assert!(second.err.contains("another process"), "{}", second.err);
    assert_eq!(Done::from(first.wait_with_output().unwrap()).code, Some(0));
}

#[test]
fn another_input_is_refused_with_what_differs() {
    let bench = bench();
    let mut first = start(&bench, &[]);
    wait_for_points(&bench, JOURNAL, &mut first);
    first.kill().unwrap();
    first.wait().unwrap();
    bench.write(
        "sweep.toml",
        &sweep().replace("friction = 1.0", "friction = 0.9"),
    );
    bench
        .run(&["sweep", "sweep.toml"])
        .refused(&["cannot be resumed", "scene.friction: 0.9 here, 1.0 there"]);
    // What does not matter may change.
    bench.write("sweep.toml", &sweep().replace("Roll at", "Rolling at"));
    assert_eq!(bench.run(&["sweep", "sweep.toml"]).code, Some(0));
}

/// It would take hours if it were not noticed.
#[test]
fn a_folder_removed_while_running_is_told() {
    let bench = Bench::new();
    bench.write("sweep.toml", &SWEEP.replace("step = 10", "step = 0.0001"));
    let mut sweep = start(&bench, &[]);
    wait_for_points(&bench, JOURNAL, &mut sweep);
    fs::remove_dir_all(bench.path("results")).unwrap();
    let done = Done::from(sweep.wait_with_output().unwrap());
    assert_eq!(done.code, Some(1), "{}", done.err);
    assert!(done.err.contains("moved or removed"), "{}", done.err);
}

#[test]
fn shards_computed_anywhere_and_killed_make_the_same_results() {
    let expected = uninterrupted();
    let bench = bench();
    let shard = |number: &str| ["sweep", "sweep.toml", "--shard", number].map(str::to_owned);
    let run = |number: &str| {
        let arguments = shard(number);
        bench.run(&arguments.each_ref().map(String::as_str))
    };
    let mut killed = start(&bench, &["--shard", "2/3", "--threads", "1"]);
    wait_for_points(&bench, "results/sweep.2-of-3.journal", &mut killed);
    killed.kill().unwrap();
    killed.wait().unwrap();
    assert_eq!(run("1/3").code, Some(0));
    assert_eq!(run("3/3").code, Some(0));
    let early = bench.run(&["merge", "results"]);
    assert_eq!(early.code, Some(1), "{}", early.out);
    assert!(early.err.contains("are missing"), "{}", early.err);
    assert_eq!(run("2/3").code, Some(0));
    // All that is needed is in the journals.
    fs::remove_file(bench.path("sweep.toml")).unwrap();
    fs::remove_file(bench.path("surveyor.toml")).unwrap();
    let merged = bench.run(&["merge", "results"]);
    assert_eq!(merged.code, Some(0), "{}", merged.err);
    assert_eq!(RESULTS.map(|name| bench.read(name)), *expected);
}

#[test]
fn shards_of_different_sweeps_are_not_merged() {
    let bench = Bench::new();
    for (number, friction) in [("1/2", "1.0"), ("2/2", "0.9")] {
        let text = SWEEP.replace("friction = 1.0", &format!("friction = {friction}"));
        bench.write("sweep.toml", &text);
        let done = bench.run(&["sweep", "sweep.toml", "--shard", number]);
        assert_eq!(done.code, Some(0), "{}", done.err);
    }
    bench.run(&["merge", "results"]).refused(&[
        "2-of-2.journal: does not belong to",
        "scene.friction: 1.0 here, 0.9 there",
    ]);
    bench.run(&["merge", "nowhere"]).refused(&["nowhere"]);
}

#[test]
fn there_must_be_something_to_resume() {
    let bench = bench();
    let done = bench.run(&["sweep", "sweep.toml", "--resume"]);
    done.refused(&["sweep.journal: there is nothing to resume"]);
}
