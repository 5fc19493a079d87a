//! The reference histories at the default tolerance, up to the first second.

use crate::common::complaints::Complaints;
use crate::common::{level_scene, reference, sample_deck, scenes, settings, table_4_1};
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

/// Length of the compared stretch, s.
const STRETCH: f64 = 1.0;
const POSITION_LIMIT: f64 = 1e-5;
const ANGLE_LIMIT: f64 = 1e-4;

/// Position (ft) and angles (deg) by the names of their columns.
fn measured(instant: &Instant) -> Vec<(String, f64, f64)> {
    let euler = instant.attitude.euler();
    let position = instant.position;
    let mut all: Vec<(String, f64, f64)> =
        [("X", position.x), ("Y", position.y), ("Z", position.z)]
            .into_iter()
            .chain([("clear", instant.clearance)])
            .map(|(column, value)| (column.into(), value, POSITION_LIMIT))
            .collect();
    let mut angle = |column: String, radians: f64| {
        all.push((column, radians.to_degrees(), ANGLE_LIMIT));
    };
    angle("psi".into(), euler.pitch);
    angle("phi".into(), euler.yaw);
    angle("xi".into(), euler.roll);
    angle("sigma".into(), instant.stability_angle);
    for (index, leg) in instant.legs.iter().enumerate() {
        let posture = leg.hinged().unwrap();
        angle(format!("g{}", index + 1), posture.link_angle);
        angle(format!("a{}", index + 1), posture.pad_angle);
    }
    all
}

/// Plastic sets by the names of their columns, ft.
fn sets(instant: &Instant) -> impl Iterator<Item = (String, f64)> {
    instant.legs.iter().enumerate().flat_map(|(index, leg)| {
        let foot = index + 1;
        [
            (format!("psp{foot}1"), leg.pad_sets[0]),
            (format!("psp{foot}2"), leg.pad_sets[1]),
            (format!("psb{foot}"), leg.block_set),
        ]
    })
}

fn compare(file: &str, vehicle: &Vehicle, scene: &Scene) {
    let tolerance = settings(Settings::DEFAULT_TOLERANCE);
    let (_, instants) = scenes::history(vehicle, scene, &tolerance, 0.01);
    let rows = reference(file);
    let mut complaints = Complaints::default();
    let mut compared_sets = 0;
    for (k, instant) in instants.iter().enumerate() {
        let time = rows[k].number("t");
        if time > STRETCH + 1e-9 {
            break;
        }
        let name = format!("{file} at {time} s");
        complaints.near(&name, "t", instant.time, time, 1e-9);
        for (column, value, limit) in measured(instant) {
            complaints.near(&name, &column, value, rows[k].number(&column), limit);
        }
        // While an element is crushing, the reference's sets lag behind: compare them where they
        // stay for a while.
        for (column, value) in sets(instant) {
            let expected = rows[k].number(&column);
            let near = &rows[k.saturating_sub(2)..(k + 3).min(rows.len())];
            if near.iter().all(|row| row.number(&column) == expected) {
                complaints.near(&name, &column, value, expected, POSITION_LIMIT);
                compared_sets += usize::from(expected > 0.0);
            }
        }
    }
    assert!(instants.len() > 100, "{} instants", instants.len());
    assert!(compared_sets > 100, "{compared_sets} sets compared");
    complaints.settle();
}

#[test]
fn sample_deck_run() {
    compare(
        "history-sample-deck.csv",
        &sample_deck(),
        &scenes::sample_run(),
    );
}

#[test]
fn case_of_table_4_3() {
    compare("history-table-4-3.csv", &table_4_1(), &scenes::table_4_3());
}

#[test]
fn baseline_at_11_25() {
    let scene = level_scene(180.0, 0.0, 11.25);
    compare("history-baseline-11.25.csv", &table_4_1(), &scene);
}
