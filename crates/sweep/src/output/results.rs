//! The result table of a sweep, and the record of its input and counts.

use serde_json::{Map, Value, json};
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_input::documents::column::{Cell, Column, Heading, cells, headings};
use touchdown_input::documents::fingerprint::fingerprint;
use touchdown_input::sweeps::sweep::Part;
use touchdown_input::sweeps::sweep_file::{Job, Sweep};
use touchdown_search::boundary::{Boundary, Transition};
use touchdown_search::certainty::Certainty;

use crate::output::landing_table;
use crate::summary::findings::Finding;
use crate::summary::probabilities::wilson;
use crate::summary::sweep_counts::SweepCounts;
use crate::summary::transition_statistics::{ABOVE, AT_OR_BELOW};

/// Columns of the table of a boundary sweep, after the axes.
pub const COLUMNS: [Column<Boundary>; 14] = [
    Column::word(
        "first_transition_to",
        transition_name,
        "class of the landings just above the first transition: `unstable`, `bottomed`, `failure` (not computed), \
         `undecided` (sliding, or still moving at the time limit); `none` where every landing of the scan was stable",
    ),
    Column::number(
        "first_transition_fps",
        |found| found.transition.map(|transition| transition.speed()),
        "transition velocity V_H: the middle of the bracket; `from_fps` where `certainty` is `at-or-below`",
    ),
    Column::number(
        "bracket_low_fps",
        bracket_low,
        "highest velocity below the transition that was landed and stable; of `none` the highest velocity searched; \
         empty where `certainty` is `at-or-below`",
    ),
    Column::number(
        "bracket_high_fps",
        |found| found.transition.map(|transition| transition.high),
        "lowest velocity above the transition that was landed",
    ),
    Column::count(
        "landings",
        |found| found.landings,
        "landings that the point took",
    ),
    Column::count(
        "derivative_evaluations",
        |found| found.evaluations,
        "evaluations of the equations of motion in them",
    ),
    Column::word(
        "certainty",
        certainty_word,
        "`certain`: small changes move the transition by less than its bracket; `disputed`: they move it further at \
         every tolerance down to 1e-9; `at-or-below`: the landing at `from_fps` is not stable already, so that V_H \
         lies at or below it; `above`: no transition up to `to_fps`; empty: not tested",
    ),
    Column::number(
        "disputed_from_fps",
        |found| certainty(found).disputed()[0],
        "lower end of what is disputed",
    ),
    Column::number(
        "disputed_to_fps",
        |found| certainty(found).disputed()[1],
        "upper end of what is disputed",
    ),
    Column::power(
        "solver_tolerance",
        |found| found.transition.map(|transition| transition.tolerance),
        "tolerance at which both ends of the bracket were landed: that of `[solver]`, or the tighter one that a \
         disputed transition took to become certain, or was given up at; empty where there is no transition",
    ),
    Column::count(
        "stable_landings_below",
        |found| found.stable_below,
        "landings below the transition, all stable; of `none` all landings",
    ),
    Column::number(
        "patchy_to_fps",
        |found| found.patchy.map(|patchy| patchy.to),
        "upper end of a *patchy* stretch, in which stable landings and others alternate from the transition on; \
         empty where the transition is sharp, as landings for a scan step above it are not stable",
    ),
    Column::count(
        "patchy_landings",
        |found| found.patchy.map_or(0, |patchy| patchy.landings),
        "landings at even parts of that stretch",
    ),
    Column::count(
        "patchy_not_stable",
        |found| found.patchy.map_or(0, |patchy| patchy.not_stable),
        "those of them that are not stable",
    ),
];

/// Name of the additional column for the points of a map.
pub const LEVEL: &str = "level";

/// Additional column for the points of a map, whose cells hold its level.
pub const OF_MAP_POINTS: [Column<usize>; 1] = [Column::count(
    LEVEL,
    |level| *level as u64,
    "how often a first-level cell is halved until the point is a corner, or an end over one axis; 0 on the first level",
)];

/// Circumstances of a run that its input does not determine.
#[derive(Debug, Clone, Copy)]
pub struct Circumstances<'a> {
    /// Version of the program.
    pub version: &'a str,
    /// Threads used, if there was a single run.
    pub threads: Option<usize>,
    /// Time from its first to its last landing, s.
    pub wall_time: Option<f64>,
}

/// The commit the program was built from, if given at build time in `TOUCHDOWN_COMMIT`.
pub const COMMIT: Option<&str> = option_env!("TOUCHDOWN_COMMIT");

/// The program in records: its version and that of the model, which fixes every bit of a landing.
pub fn program(version: &str) -> Value {
    json!({ "name": "touchdown", "version": version, "model": MODEL_VERSION })
}

/// Fingerprint of a sweep's full input with defaults; equal for equal results.
pub fn input_fingerprint(sweep: &Sweep) -> String {
    fingerprint(&sweep.resolved().to_string())
}

/// Word for the transition of a point.
pub fn transition_name(boundary: &Boundary) -> String {
    match boundary.transition {
        Some(transition) => transition.to.to_string(),
        None => "none".to_owned(),
    }
}

/// Headings of the table of a sweep.
pub fn heading(sweep: &Sweep) -> Vec<Heading> {
    let legs = sweep.leg_count();
    let mut all = match sweep.job {
        Job::Boundary(_) => sweep.headings(headings(&COLUMNS, legs)),
        Job::Outcome { .. } => sweep.headings(headings(&landing_table::COLUMNS, legs)),
    };
    if sweep.map().is_some() {
        all.extend(headings(&OF_MAP_POINTS, legs));
    }
    all
}

/// Row of a point in the table of a sweep.
pub fn row(sweep: &Sweep, point: usize, finding: &Finding) -> Vec<Cell> {
    let legs = sweep.leg_count();
    let mut row = sweep.cells_of_point(point);
    match finding {
        Finding::Boundary(boundary) | Finding::Sensitive { boundary, .. } => {
            row.extend(cells(&COLUMNS, boundary, legs));
        }
        Finding::Landing(landing) => {
            row.extend(cells(&landing_table::COLUMNS, &**landing, legs));
        }
    }
    if let Some(map) = sweep.map() {
        row.extend(cells(&OF_MAP_POINTS, &map.level(point), legs));
    }
    row
}

/// Highest velocity that was landed and stable below a transition, or the highest searched without one.
fn bracket_low(found: &Boundary) -> Option<f64> {
    match found.transition {
        Some(transition) => transition.low,
        None => Some(found.searched_to),
    }
}

/// Certainty of the first transition.
fn certainty(found: &Boundary) -> Certainty {
    found
        .transition
        .map_or(Certainty::Untested, |transition| transition.certainty)
}

fn certainty_word(found: &Boundary) -> String {
    let word = match found.transition {
        None => ABOVE,
        Some(Transition { low: None, .. }) => AT_OR_BELOW,
        Some(transition) => transition.certainty.word(),
    };
    word.to_owned()
}

/// The record of a sweep: its full input with defaults, the version of the program, and counts. It contains neither
/// times nor threads, so it is the same for every run.
pub fn record(sweep: &Sweep, counts: &SweepCounts, version: &str) -> Value {
    let mut input = json!({
        "sweep_file": sweep.path.display().to_string(),
        "vehicle_file": sweep.vehicle.document.path().display().to_string(),
    });
    if let (Value::Object(input), Value::Object(resolved)) =
        (&mut input, sweep.resolved_in(sweep.units))
    {
        input.extend(resolved);
    }
    let mut record = json!({
        "title": sweep.title,
        "statement": sweep.statement,
        "program": program(version),
        "input_fingerprint": input_fingerprint(sweep),
        "input": input,
        "counts": {
            "points": counts.points,
            "first_transition_to": counts
                .kinds()
                .into_iter()
                .map(|(kind, count)| (kind, json!(count)))
                .collect::<Map<String, Value>>(),
            "scan_speeds_skipped": counts.skipped.left_out,
            "certainty_landings": counts.tests,
            "transitions_searched_again": counts.searched_again,
            "transitions_disputed": counts.disputed_in_all,
            "sensitivity_landings": counts.sensitivity_landings,
            "landings": counts.landings,
            "derivative_evaluations": counts.evaluations,
            "bands": counts.bands,
            "landings_closer_below_transitions": counts.checks.below.checks,
            "transitions_lowered_by_them": counts.checks.below.finds,
            "speeds_drawn_below_transitions": counts.checks.drawn.checks,
            "drawn_speeds_not_stable": counts.checks.drawn.finds,
            "patchy_transitions": counts.patchy,
            "looks_for_hidden_bands": counts.checks.all().checks,
            "hidden_bands_found": counts.checks.all().finds,
            "map_cells": counts.coarse_cells.cells,
            "map_cells_coarser_than_asked": counts.coarse_cells.coarse,
            "outcomes": outcomes(counts),
        },
    });
    let logarithmic = logarithmic_axes(sweep);
    if !logarithmic.is_empty() {
        record["spacing"] = Value::Object(logarithmic);
    }
    if let Some(Part { points, of }) = sweep.part {
        record["partial"] = json!({ "points": points, "of": of });
    }
    record
}

/// The axes given with `spacing = "log"`, each with that word: the input lists the values of short ones.
fn logarithmic_axes(sweep: &Sweep) -> Map<String, Value> {
    let axes = sweep.axes.iter().enumerate();
    axes.filter(|(index, _)| sweep.design.is_logarithmic(*index))
        .map(|(_, axis)| {
            let quantity = sweep.units.quantity(axis.name());
            (quantity.name().to_owned(), json!("log"))
        })
        .collect()
}

/// Counts of outcomes for sweeps of single landings, with intervals of their probabilities for a sample.
fn outcomes(counts: &SweepCounts) -> Value {
    let Some(count) = counts.outcomes else {
        return Value::Null;
    };
    let mut outcomes = json!({
        "landings": count.landings,
        "toppled": count.toppled,
        "bottomed": count.bottomed,
        "undecided": count.undecided,
        "failed": count.failed,
        "stable": count.stable(),
    });
    if counts.probabilities.is_some() {
        for (name, hits) in [
            ("topple", count.toppled),
            ("bottom", count.bottomed),
            ("undecided", count.undecided),
            ("failure", count.failed),
            ("not_stable", count.landings - count.stable()),
        ] {
            outcomes[format!("{name}_probability_95")] = json!(wilson(hits, count.landings));
        }
    }
    outcomes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::{figure_4_09, names, sweep, text};
    use touchdown_dynamics::outcome::Class;

    fn example() -> (Sweep, Vec<Boundary>) {
        let sweep = figure_4_09();
        let at = |to, low, high| Boundary {
            transition: Some(Transition {
                to,
                low: Some(low),
                high,
                tolerance: 3e-5,
                certainty: Certainty::Certain,
            }),
            landings: 50,
            evaluations: 1000,
            ..Boundary::default()
        };
        let none = Boundary {
            searched_to: 25.0,
            landings: 101,
            evaluations: 2000,
            ..Boundary::default()
        };
        let boundaries = vec![
            at(Class::Unstable, 11.25, 11.5),
            none,
            at(Class::Bottomed, 0.1, 0.3),
            Boundary {
                transition: Some(Transition {
                    to: Class::Failure,
                    low: None,
                    high: 8.0,
                    tolerance: 3e-5,
                    certainty: Certainty::Untested,
                }),
                ..Boundary::default()
            },
        ];
        (sweep, boundaries)
    }

    #[test]
    fn rows_follow_the_grid() {
        let (sweep, boundaries) = example();
        assert_eq!(
            names(heading(&sweep)),
            "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,\
             landings,derivative_evaluations,certainty,disputed_from_fps,disputed_to_fps,solver_tolerance,\
             stable_landings_below,patchy_to_fps,patchy_landings,patchy_not_stable"
        );
        let rows = boundaries.iter().enumerate();
        let rows = rows.map(|(point, boundary)| {
            text(row(&sweep, point, &Finding::Boundary(boundary.clone())))
        });
        assert_eq!(
            rows.collect::<Vec<_>>(),
            [
                "-60,unstable,11.375,11.25,11.5,50,1000,certain,,,3e-5,0,,0,0",
                "-55,none,,25,,101,2000,above,,,,0,,0,0",
                "-50,bottomed,0.2,0.1,0.3,50,1000,certain,,,3e-5,0,,0,0",
                "-45,failure,8,,8,0,0,at-or-below,,,3e-5,0,,0,0"
            ]
        );
    }

    #[test]
    fn record_holds_the_resolved_input() {
        let (sweep, boundaries) = example();
        let mut counts = SweepCounts::default();
        for (point, boundary) in boundaries.iter().enumerate() {
            counts.add(&sweep, point, &Finding::Boundary(boundary.clone()));
        }
        let record = record(&sweep, &counts, "1.2.3");
        assert_eq!(record["program"]["version"], "1.2.3");
        assert_eq!(record["program"]["model"], MODEL_VERSION);
        assert_eq!(record["input_fingerprint"].as_str().map(str::len), Some(32));
        assert_eq!(record["input"]["scene"]["block_friction"], 1.0);
        assert_eq!(record["input"]["scene"].get("roll_deg"), None);
        assert_eq!(record["input"]["axes"]["roll_deg"][24], 60.0);
        assert_eq!(record["input"]["vehicle"]["legs"][2]["azimuth_deg"], 240.0);
        assert_eq!(record["counts"]["landings"], 201);
        assert_eq!(record["counts"]["first_transition_to"]["bottomed"], 1);
    }

    #[test]
    fn record_tells_the_axes_given_with_logarithmic_spacing() {
        let spacing = |text: &str| {
            let head = "title = \"T\"\nvehicle = \"vehicles/surveyor-table-4-1.toml\"\nunits = \"SI\"\n\
                        scene = { cross_slope_deg = 180, slope_deg = 15, vertical_velocity_fps = 14, friction = 1 }\n";
            let sweep = sweep(&format!("{head}{text}"));
            record(&sweep, &SweepCounts::default(), "1.2.3")["spacing"].clone()
        };
        let search =
            "[search]\nfrom_fps = 8\nto_fps = 16\nscan_step_fps = 1\ntolerance_fps = 0.1\n";
        let counted = "{ from = 5, to = 20, count = 3, spacing = \"log\" }";
        let grid = format!(
            "axes = {{ vehicle.strut.preload_lb = {counted}, roll_deg = [5, 10, 20] }}\n{search}"
        );
        assert_eq!(spacing(&grid), json!({"vehicle.strut.preload_n": "log"}));
        let map = "map = { edge_width = { roll_deg = 5, pitch_deg = 5 }, error_fps = 0.5 }\n";
        let map = format!("{map}axes = {{ roll_deg = {counted}, pitch_deg = [5, 20] }}\n{search}");
        assert_eq!(spacing(&map), json!({"roll_deg": "log"}));
        let drawn = "job = \"outcome\"\nsample = { design = \"monte-carlo\", count = 4, seed = 1 }\n\
                     axes = { roll_deg = { from = 5, to = 20, spacing = \"log\" }, \
                     horizontal_velocity_fps = { from = 8, to = 16 } }\n";
        assert_eq!(spacing(drawn), json!({"roll_deg": "log"}));
        let even = format!("axes.roll_deg = [5, 10, 20]\n{search}");
        assert_eq!(spacing(&even), Value::Null);
    }
}
