//! Files that cannot grow any further, as on a full disk: a clear error, exit code 1, and a journal
//! from which a later run goes on.

#![allow(missing_docs, reason = "tests are not an interface")]
#![cfg(unix)]

use std::fs::{self, File};
use std::path::Path;
use std::process::Command;

use crate::common::{Bench, Done, SWEEP};

const RESULTS: [&str; 3] = ["sweep.csv", "sweep.svg", "sweep.png"];
const JOURNAL: &str = "results/sweep.journal";
const STAYS_GOOD: &str = "what it holds stays good, run again to go on";

/// Forty-one points, so that the journal outgrows its head.
fn sweep() -> String {
    SWEEP
        .replace("step = 10", "step = 0.5")
        .replace("from_fps = 10", "from_fps = 11.25")
}

/// Runs a sweep that can write no file longer than so many bytes: the write that would is refused, as
/// it is on a full disk.
fn limited(bench: &Bench, bytes: u64) -> Done {
    let program = env!("CARGO_BIN_EXE_touchdown");
    // Blocks of `ulimit` are half a kilobyte.
    let script = format!("ulimit -f {}; exec {program} sweep sweep.toml", bytes / 512);
    let mut command = Command::new("sh");
    command.args(["-c", &script]).current_dir(bench.path("."));
    Done::from(command.output().unwrap())
}

fn length(path: &Path) -> u64 {
    fs::metadata(path).map_or(0, |file| file.len())
}

#[test]
fn a_journal_that_cannot_grow_stays_good() {
    let whole = Bench::new();
    whole.write("sweep.toml", &sweep());
    assert_eq!(whole.run(&["sweep", "sweep.toml"]).code, Some(0));

    let bench = Bench::new();
    bench.write("sweep.toml", &sweep());
    // Not even the head, the head and little more, and a few points.
    let head = 512 * (head_length() / 512 + 1);
    let mut earlier = 0;
    for room in [512, head, head + 512, head + 1024] {
        let done = limited(&bench, room);
        assert_eq!(done.code, Some(1), "{}", done.err);
        for fragment in ["sweep.journal: ", STAYS_GOOD] {
            assert!(done.err.contains(fragment), "{fragment}: {}", done.err);
        }
        assert!(!done.err.contains("panicked"), "{}", done.err);
        assert_eq!(bench.list("results"), ["sweep.journal"]);
        // Whole records only, as many as there is room for, and none lost.
        let now = length(&bench.path(JOURNAL));
        assert!(now <= room && now >= earlier, "{earlier} {now} {room}");
        earlier = now;
    }
    assert!(earlier > head);
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.err.contains("of 41 points are in"), "{}", done.err);
    assert!(!done.err.contains("damaged"), "{}", done.err);
    for name in RESULTS {
        let read = |bench: &Bench| fs::read(bench.path("results").join(name)).unwrap();
        assert!(read(&bench) == read(&whole), "{name}");
    }
}

/// Length of the head of the sweep's journal, bytes: that of a shard, which stays, is as long.
fn head_length() -> u64 {
    let bench = Bench::new();
    bench.write("sweep.toml", &sweep());
    let done = bench.run(&["sweep", "sweep.toml", "--shard", "9/9"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let bytes = fs::read(bench.path("results/sweep.9-of-9.journal")).unwrap();
    let payload: [u8; 4] = bytes[4..8].try_into().unwrap();
    12 + u64::from(u32::from_le_bytes(payload))
}

#[test]
fn results_that_cannot_be_written_leave_the_journal_and_nothing_else() {
    let bench = Bench::new();
    bench.write("sweep.toml", &sweep());
    // Room for the journal, but for nothing that is made of it.
    let done = limited(&bench, 20 << 10);
    assert_eq!(done.code, Some(1), "{}", done.err);
    assert!(done.err.contains(STAYS_GOOD), "{}", done.err);
    assert_eq!(bench.list("results"), ["sweep.journal"]);
    // Nothing is computed again.
    let done = bench.run(&["sweep", "sweep.toml"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.err.contains("41 of 41 points are in"), "{}", done.err);
    assert!(bench.path("results/sweep.png").exists());
    assert!(!bench.path(JOURNAL).exists());
}

/// `/dev/full` takes nothing.
#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_printed_is_told() {
    let bench = Bench::new();
    for arguments in [&crate::common::BASELINE[..], &["sweep", "sweep.toml"]] {
        let full = File::options().write(true).open("/dev/full").unwrap();
        let done = Done::from(bench.command(arguments).stdout(full).output().unwrap());
        assert_eq!(done.code, Some(1), "{}", done.err);
        let said = "standard output cannot be written: No space left on device";
        assert!(done.err.contains(said), "{}", done.err);
    }
    // The results stand all the same.
    assert!(bench.path("results/sweep.csv").exists());
}
