//! `touchdown-lab stress`, a little of it.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{Bench, rows};

/// The tolerance of sweeps, and of wild landings.
const TOLERANCE: &str = "3e-5";

#[test]
fn kills_and_wild_landings_are_told_and_land_again_as_they_did() {
    let bench = Bench::new();
    let arguments = ["stress", "--kills", "2", "--landings", "34", "--quiet"];
    let done = bench.run(&arguments);
    assert_eq!(done.code, Some(0), "{}", done.err);
    for fragment in [
        "2 of 2 kills",
        "nothing lost, no difference",
        "%  unstable-pitch",
        "%  unstable-toppled",
        "of the energy involved",
        "every value is a number, every energy account closes",
    ] {
        assert!(done.out.contains(fragment), "{fragment}: {}", done.out);
    }
    // Fewer of the last, as 34 cannot be shared out evenly.
    let vehicles = (3..=8).flat_map(|legs| ["1966", "physical"].map(|rules| (legs, rules)));
    let vehicles: Vec<(usize, &str)> = vehicles.collect();
    for (legs, rules) in &vehicles {
        let share = if *legs == 8 { 2 } else { 3 };
        let line = format!(
            "{share} wild landings of {legs} legs under {rules} rules, seed 1966, tolerance 3e-5"
        );
        assert!(done.out.contains(&line), "{line}: {}", done.out);
    }
    // Neither the journals nor the folder of the kills stay.
    let left = bench.list("stress");
    let names = (vehicles.iter()).map(|(legs, rules)| format!("stress-{legs}-legs-{rules}.toml"));
    let expected: Vec<String> = names.chain(["stress-cases.csv".to_owned()]).collect();
    assert_eq!(left, expected);
    let kept = rows(&bench.read("stress/stress-cases.csv"));
    for (legs, rules) in &vehicles {
        let name = format!("{legs}-legs-{rules}-");
        let own = kept.iter().filter(|case| case["case"].starts_with(&name));
        // One landing may be the worst in everything.
        assert!(own.count() >= 1, "{}", done.out);
    }
    let [vehicle, cases] = ["stress/stress-3-legs-1966.toml", "stress/stress-cases.csv"];
    for (kept, landed) in kept.iter().zip(bench.land_again(vehicle, cases, TOLERANCE)) {
        let why = &kept["note"];
        let is_beyond = landed["failure"].ends_with("inclined more than 65 deg");
        assert_eq!(why.contains("no law: "), is_beyond, "{why}: {landed:?}");
        let has_failed = landed["outcome"] == "failure" && !is_beyond;
        assert_eq!(why.contains("failure: "), has_failed, "{why}: {landed:?}");
        // To the last bit, or the greatest of all would not come out at the same.
        if let Some((_, number)) = why.split_once("most steps") {
            assert!(
                number.is_empty() && done.out.contains(&landed["steps"]),
                "{landed:?}"
            );
        }
    }
}

#[test]
fn the_seed_says_what_is_landed() {
    let landed = |seed: &str| {
        let bench = Bench::new();
        let count = ["stress", "--kills", "0", "--landings", "8"];
        let done = bench.run(&[&count[..], &["--seed", seed, "--quiet"]].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        bench.read("stress/stress-cases.csv")
    };
    let first = landed("4");
    assert_eq!(landed("4"), first);
    assert_ne!(landed("2"), first);
}

/// A folder that cannot be written, and more landings than there are numbers for.
#[test]
fn bad_input_is_refused_before_anything_is_killed() {
    let bench = Bench::new();
    bench.write("file", "");
    bench
        .run(&["stress", "--out", "file"])
        .refused(&["file: output folder cannot be written"]);
    bench
        .run(&["stress", "--landings", "2000000000000"])
        .refused(&["--landings", "2000000000000", "0..=10000000"]);
    bench
        .run(&["stress", "--tolerance", "0.5"])
        .refused(&["--tolerance = 0.5", "1e-2"]);
    assert!(!bench.path("stress").exists());
}
