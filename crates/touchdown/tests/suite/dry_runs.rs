//! What `sweep --dry-run` tells before anything is computed.

use serde_json::Value;

use crate::common::{Bench, SWEEP};

fn told(bench: &Bench, arguments: &[&str]) -> String {
    let done = bench.run(&[&["sweep", "--dry-run"], arguments].concat());
    assert_eq!(done.code, Some(0), "{}", done.err);
    done.out
}

#[test]
fn it_lists_axes_checks_points_and_writes_nothing() {
    let bench = Bench::new();
    let trade = SWEEP.replace(
        "[axes]",
        "[axes]\nvehicle.strut.compression_damping = [45, 54, 60]\n\
         vehicle.center_of_gravity_height_ft = { from = 1.2, to = 1.6, count = 81 }",
    ) + "[solver]\ntime_limit_s = 0.01\n";
    bench.write("trade.toml", &trade);
    let told = told(&bench, &["trade.toml", "--shard", "1/3"]);
    for fragment in [
        "  243 points\n",
        "vehicle.strut.compression_damping: 45, 54, 60\n",
        "vehicle.center_of_gravity_height_ft: 1.2, 1.205, 1.21, …, 1.6 (81 values)\n",
        "roll_deg: -10, 0, 10\n",
        "the input of all points was checked",
        "landings",
        "of journal",
    ] {
        assert!(told.contains(fragment), "{fragment}: {told}");
    }
    assert_eq!(bench.list("results"), Vec::<String>::new());
}

#[test]
fn what_it_foretells_of_a_small_sweep_is_what_is_taken() {
    let bench = Bench::new();
    let small =
        SWEEP.replace("from_fps = 10\n", "from_fps = 11.25\n") + "[solver]\ntime_limit_s = 0.5\n";
    bench.write("small.toml", &small);
    bench.write("other.toml", &small.replace("step = 10", "step = 20"));
    let told = told(&bench, &["small.toml", "other.toml"]);
    let mut sum = 0;
    for name in ["small", "other"] {
        let done = bench.run(&["sweep", &format!("{name}.toml")]);
        assert_eq!(done.code, Some(0), "{}", done.err);
        let record: Value =
            serde_json::from_str(&bench.read(&format!("results/{name}.json"))).unwrap();
        let landings = record["counts"]["landings"].as_u64().unwrap();
        let expected = format!("from all points, computed for this: {landings} landings");
        assert!(told.contains(&expected), "{expected}: {told}");
        sum += landings;
    }
    assert!(
        told.contains(&format!("2 sweeps together\n  {sum} landings")),
        "{told}"
    );
}

/// Every point takes thousands of landings, and each of these many steps.
#[test]
fn it_ends_before_a_point_does() {
    let bench = Bench::new();
    let endless = SWEEP
        .replace(
            "to_fps = 12.5\nscan_step_fps = 1.25",
            "to_fps = 1000\nscan_step_fps = 0.01",
        )
        .replace(
            "tolerance_fps = 0.1",
            "tolerance_fps = 0.001\nbands = \"all\"",
        )
        + "[solver]\ntolerance = 1e-12\n";
    bench.write("endless.toml", &endless);
    let told = told(&bench, &["endless.toml", "--threads", "1"]);
    assert!(told.contains("no estimate: "), "{told}");
    assert!(told.contains("and no point was finished"), "{told}");
}

#[test]
fn a_finished_shard_leaves_nothing() {
    let bench = Bench::new();
    let done = bench.run(&["sweep", "sweep.toml", "--shard", "2/3"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let told = told(&bench, &["sweep.toml", "--shard", "2/3"]);
    assert!(
        told.contains("results/sweep.2-of-3.journal holds 1 point: 0 left"),
        "{told}"
    );
    assert!(told.contains("nothing is left to be computed"), "{told}");
}
