//! Sweeps that are interrupted, killed and gone on with.

#![allow(missing_docs, reason = "tests are not an interface")]
#![cfg(unix)]

#[allow(dead_code, reason = "every test file uses its own part")]
use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use crate::common::{Bench, Done, SWEEP};
use touchdown_sweep::journal::{InOrder, Records};

/// Points of [`sweep`].
const POINTS: usize = 93;

/// Ninety-three points over roll and the strut's damping, all bands: the first is in the journal long before the last is
/// computed.
fn sweep() -> String {
    SWEEP
        .replace(
            "roll_deg = { from = -10, to = 10, step = 10 }",
            "vehicle.strut.compression_damping = [45, 54, 60]\n\
             roll_deg = { from = -15, to = 15, step = 1 }",
        )
        .replace(
            "tolerance_fps = 0.1",
            "tolerance_fps = 0.01\nbands = \"all\"",
        )
}

const RESULTS: [&str; 2] = ["results/sweep.csv", "results/sweep-bands.csv"];

/// The results of a run from beginning to end.
fn uninterrupted() -> [String; 2] {
    let bench = bench();
    bench.run(&["sweep", "sweep.toml", "--threads", "1"]);
    RESULTS.map(|name| bench.read(name))
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

#[test]
fn interrupted_and_terminated_it_ends_in_time_and_goes_on() {
    let expected = uninterrupted();
    for name in ["-INT", "-TERM"] {
        let bench = bench();
        let mut sweep = start(&bench, &["--threads", "1"]);
        wait_for_points(&bench, JOURNAL, &mut sweep);
        signal(&sweep, name);
        let done = Done::from(sweep.wait_with_output().unwrap());
        assert_eq!(done.code, Some(130), "{}", done.err);
        assert!(done.err.contains("run again to go on"), "{}", done.err);
        assert_eq!(bench.list("results"), ["sweep.journal"]);

        let resumed = bench.run(&["sweep", "sweep.toml", "--resume", "--threads", "2"]);
        assert_eq!(resumed.code, Some(0), "{}", resumed.err);
        assert!(
            resumed.err.contains(&format!("of {POINTS} points are in")),
            "{}",
            resumed.err
        );
        assert_eq!(RESULTS.map(|name| bench.read(name)), expected);
        assert!(!bench.list("results").contains(&"sweep.journal".to_owned()));
    }
}

/// As `nohup` starts a program: what closes the terminal does not end it.
#[test]
fn a_closed_terminal_interrupts_unless_hangups_are_ignored() {
    for (trap, code) in [("", 130), ("trap '' HUP;", 0)] {
        let bench = bench();
        let program = env!("CARGO_BIN_EXE_touchdown");
        let mut sweep = Command::new("sh")
            .args([
                "-c",
                &format!("{trap} exec {program} sweep sweep.toml --threads 1"),
            ])
            .current_dir(bench.path("."))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait_for_points(&bench, JOURNAL, &mut sweep);
        signal(&sweep, "-HUP");
        let done = Done::from(sweep.wait_with_output().unwrap());
        assert_eq!(done.code, Some(code), "{trap:?}: {}", done.err);
    }
}

/// How many points are in the journal, whole; `None` when it is gone.
fn journaled_points(bench: &Bench) -> Option<usize> {
    let journal = bench.path(JOURNAL);
    if !journal.exists() {
        return None;
    }
    // Before its head is whole it holds nothing.
    let Ok((records, _)) = Records::open(&journal) else {
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
    // Odd times, so that kills fall anywhere; each round gets a little further.
    for round in 0u64.. {
        let mut sweep = start(&bench, &["--threads", ["1", "2", "3"][round as usize % 3]]);
        std::thread::sleep(Duration::from_micros(20_000 + round * 37_123 % 300_000));
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
    assert_eq!(RESULTS.map(|name| bench.read(name)), expected);
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
    assert_eq!(RESULTS.map(|name| bench.read(name)), expected);
}

#[test]
fn shards_of_different_sweeps_are_not_merged() {
    let bench = bench();
    for (number, friction) in [("1/2", "1.0"), ("2/2", "0.9")] {
        let text = sweep().replace("friction = 1.0", &format!("friction = {friction}"));
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
