//! Samples that grow: the points of a smaller one are taken over.

use super::{RESULTS, SAMPLE, TRANSITIONS, bench, kill_runs, uninterrupted};
use crate::common::{Bench, Done};

const KEPT: &str = "results/sweep.journal.kept";

/// A sample of so many points.
fn swept(bench: &Bench, count: usize, options: &[&str]) -> Done {
    let count = format!("sample.count={count}");
    bench.run(&[&["sweep", "sweep.toml", "--set", &count], options].concat())
}

/// All results but the kept journal by name; what the program said of them but for the time.
fn all(bench: &Bench, done: &Done) -> (Vec<(String, Vec<u8>)>, String) {
    assert_eq!(done.code, Some(0), "{}", done.err);
    let mut files = bench.list("results");
    files.retain(|name| !KEPT.ends_with(name));
    let read = |name: String| {
        let bytes = std::fs::read(bench.path("results").join(&name)).unwrap();
        (name, bytes)
    };
    let lines = done.out.lines();
    let untimed = lines.filter(|line| !line.contains("evaluations"));
    (files.into_iter().map(read).collect(), untimed.collect())
}

/// A sample that has grown takes over the points of the smaller one and comes to the results of a run from the beginning.
#[test]
fn a_grown_sample_takes_over_the_points_of_the_smaller_one() {
    let si = ["--units", "SI", "--format", "parquet"];
    for (text, design, options) in [
        (SAMPLE, "monte-carlo", &[][..]),
        (SAMPLE, "sobol", &si),
        (SAMPLE, "latin-hypercube", &[]),
        (TRANSITIONS, "sobol", &si),
    ] {
        let [bench, scratch] = [Bench::new(), Bench::new()];
        let text = text
            .replace("monte-carlo", design)
            .replace("latin-hypercube", design);
        bench.write("sweep.toml", &text);
        scratch.write("sweep.toml", &text);
        let swept = |bench, count, more| swept(bench, count, &[options, more].concat());
        assert_eq!(swept(&bench, 16, &[]).code, Some(0));
        let beforehand = swept(&bench, 32, &["--dry-run"]);
        let grown = swept(&bench, 32, &["--threads", "1"]);
        let refused = ["results/sweep.csv: holds results of other input"];
        if design == "latin-hypercube" {
            assert!(!bench.path(KEPT).exists());
            grown.refused(&refused);
            continue;
        }
        let told = format!("took 16 of 32 points from {KEPT}");
        assert!(grown.err.contains(&told), "{}", grown.err);
        let left = format!("{KEPT} holds 16 points: 16 left");
        assert!(beforehand.out.contains(&left), "{}", beforehand.out);
        let whole = swept(&scratch, 32, &["--threads", "3"]);
        assert!(all(&bench, &grown) == all(&scratch, &whole), "{design}");
        swept(&bench, 16, &[]).refused(&refused);
        let beforehand = swept(&bench, 33, &["--overwrite", "--dry-run"]);
        assert!(!beforehand.out.contains("holds"), "{}", beforehand.out);
        let anew = swept(&bench, 33, &["--overwrite"]);
        assert_eq!(anew.code, Some(0), "{}", anew.err);
        assert!(!anew.err.contains("took"), "{}", anew.err);
        // What cannot grow leaves nothing for it.
        bench.write("sweep.toml", &text.replace(design, "latin-hypercube"));
        assert_eq!(swept(&bench, 16, &["--overwrite"]).code, Some(0));
        assert!(!bench.path(KEPT).exists());
    }
}

/// Shards of a sample grow as the whole of it does.
#[test]
fn shards_of_a_grown_sample_take_over_the_points_of_their_smaller_ones() {
    let [bench, scratch] = [bench(), bench()];
    let shards = ["1/3", "2/3", "3/3"];
    let merged = |bench: &Bench| {
        let done = bench.run(&["merge", "results"]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        std::fs::read(bench.path("results/sweep.csv")).unwrap()
    };
    for shard in shards {
        assert_eq!(swept(&bench, 16, &["--shard", shard]).code, Some(0));
        assert_eq!(swept(&scratch, 32, &["--shard", shard]).code, Some(0));
    }
    merged(&bench);
    for (shard, [held, all]) in shards.into_iter().zip([[6, 11], [5, 11], [5, 10]]) {
        let journal = format!("results/sweep.{}.journal", shard.replace('/', "-of-"));
        let beforehand = swept(&bench, 32, &["--shard", shard, "--dry-run"]);
        let told = format!("{journal} holds {held} points: {} left", all - held);
        assert!(beforehand.out.contains(&told), "{}", beforehand.out);
        let other = swept(&bench, 32, &["--shard", shard, "--set", "sample.seed=2"]);
        other.refused(&["other input"]);
        let grown = swept(&bench, 32, &["--shard", shard]);
        let told = format!("took {held} of {all} points from {journal}.kept");
        assert!(grown.err.contains(&told), "{}", grown.err);
        assert!(!bench.path(&format!("{journal}.kept")).exists());
    }
    assert!(merged(&bench) == merged(&scratch));
}

/// A run that was interrupted grows, too. Beside a finished smaller sample it would take that one's place: it is refused then,
/// and nothing is lost.
#[test]
fn an_interrupted_sample_grows() {
    const JOURNAL: &str = "results/sweep.journal";
    let [scratch, other, bench] = [bench(), bench(), bench()];
    assert_eq!(swept(&scratch, 32, &[]).code, Some(0));
    // As if it had been interrupted at its last point.
    assert_eq!(swept(&other, 24, &[]).code, Some(0));
    let interrupted = std::fs::read(other.path(KEPT)).unwrap();
    assert_eq!(swept(&bench, 16, &[]).code, Some(0));
    std::fs::write(bench.path(JOURNAL), &interrupted).unwrap();
    for options in [&["--dry-run"][..], &[]] {
        swept(&bench, 32, options).refused(&["a journal of other input", "24 there"]);
        assert!(std::fs::read(bench.path(JOURNAL)).unwrap() == interrupted);
        assert!(bench.path(KEPT).exists());
    }
    std::fs::remove_file(bench.path(KEPT)).unwrap();
    let grown = swept(&bench, 32, &[]);
    assert!(grown.err.contains("took 24 of 32 points"), "{}", grown.err);
    let table = |bench: &Bench| std::fs::read(bench.path("results/sweep.csv")).unwrap();
    assert!(table(&bench) == table(&scratch));
}

#[test]
fn a_kept_journal_that_was_changed_is_told_and_not_trusted() {
    let scratch = bench();
    let whole = swept(&scratch, 32, &[]);
    let other = bench();
    assert_eq!(swept(&other, 16, &["--set", "sample.seed=7"]).code, Some(0));
    let other = std::fs::read(other.path(KEPT)).unwrap();
    let flip = |mut bytes: Vec<u8>, place: usize| {
        bytes[place] ^= 1;
        bytes
    };
    for (change, told) in [
        (
            &(|bytes| flip(bytes, 100)) as &dyn Fn(Vec<u8>) -> Vec<u8>,
            ["not used, as its head is damaged"; 2],
        ),
        (
            &|bytes| {
                let place = bytes.len() - 700;
                flip(bytes, place)
            },
            ["are damaged", "took 15 of 32"],
        ),
        (
            &|bytes| bytes[..bytes.len() - 9].to_vec(),
            ["were cut off", "took 15 of 32"],
        ),
        (
            &|_| other.clone(),
            ["not used, as it differs", "sample.seed: 1966 here, 7 there"],
        ),
    ] {
        let bench = bench();
        assert_eq!(swept(&bench, 16, &[]).code, Some(0));
        let bytes = std::fs::read(bench.path(KEPT)).unwrap();
        std::fs::write(bench.path(KEPT), change(bytes)).unwrap();
        let grown = swept(&bench, 32, &[]);
        assert!(
            told.iter().all(|told| grown.err.contains(told)),
            "{told:?}: {}",
            grown.err
        );
        assert!(all(&bench, &grown) == all(&scratch, &whole), "{told:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_sample_that_is_killed_while_it_grows_loses_nothing_and_ends_as_early() {
    let bench = bench();
    assert_eq!(swept(&bench, 100, &[]).code, Some(0));
    kill_runs(&bench);
    for count in [5000, 6000] {
        let done = swept(&bench, count, &[]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        assert_eq!(RESULTS.map(|name| bench.read(name)), *uninterrupted());
        let takes_over = done.err.contains("points from");
        assert!(takes_over || count == 5000, "{}", done.err);
    }
}
