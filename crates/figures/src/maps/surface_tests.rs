use super::*;
use crate::map_table::MapTable;
use crate::picture::{self, Choices, Source};

/// Three by four points, one without transition, one across a jump.
pub(crate) const TABLE: &str = "\
cross_slope_deg,roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps
80,-30,unstable,12,12,12
80,-10,unstable,13,13,13
80,10,unstable,14,14,14
80,30,none,,,
130,-30,unstable,12,12,12
130,-10,unstable,11,11,11
130,10,unstable,13,13,13
130,30,unstable,20,20,20
180,-30,unstable,13,13,13
180,-10,unstable,12,12,12
180,10,unstable,11.5,11.5,11.5
180,30,unstable,20.5,20.5,20.5
";

pub(crate) fn example() -> Surface {
    Surface::of(&BoundaryTable::parse(TABLE).unwrap(), |_| true).unwrap()
}

/// A square grid of `size` by `size` points whose transition is `height(row, column)`.
pub(crate) fn grid(size: usize, height: impl Fn(usize, usize) -> Option<f64>) -> Surface {
    let speeds: Vec<Vec<Option<f64>>> = (0..size)
        .map(|row| (0..size).map(|column| height(row, column)).collect())
        .collect();
    let values: Vec<f64> = (0..size).map(|index| index as f64).collect();
    Surface {
        axes: ["slope_deg", "friction"].map(str::to_owned),
        slow: values.clone(),
        fast: values,
        doubtful: Vec::new(),
        jump: jump(&speeds),
        speeds,
    }
}

#[test]
fn a_jump_is_far_more_than_what_neighbours_mostly_differ_by() {
    // A coarse map from 7 to 11 ft/s without jumps.
    let slope = grid(5, |row, column| {
        Some(7.0 + 0.6 * row as f64 + 0.4 * column as f64)
    });
    assert!(slope.jump_edges().is_empty(), "{}", slope.jump);
    // A fine map with a cliff.
    let cliff = grid(20, |row, column| {
        Some(11.0 + 0.05 * row as f64 + if column > 9 { 3.0 } else { 0.0 })
    });
    assert_eq!((cliff.jump_edges().len(), cliff.jump), (20, 0.5));
    assert!(grid(3, |_, _| None).jump > 0.0);
    assert!(grid(3, |_, _| Some(12.0)).jump_edges().is_empty());
}

#[test]
fn transitions_that_are_no_boundary_are_marked() {
    let table = TABLE
        .replace("80,-30,unstable,12,12,12", "80,-30,unstable,12,,12")
        .replace("180,10,unstable", "180,10,undecided");
    let surface = Surface::of(&BoundaryTable::parse(&table).unwrap(), |_| true).unwrap();
    assert_eq!(
        surface.doubtful,
        [
            ([80.0, -30.0], Mark::AtOrBelow(Kind::Unstable)),
            ([180.0, 10.0], Mark::Transition(Kind::Undecided))
        ]
    );
}

#[test]
fn gaps_and_jumps_are_told_apart() {
    let surface = example();
    assert_eq!(surface.cell(0, 0), Cell::Whole([12.0, 13.0, 11.0, 12.0]));
    assert_eq!(surface.cell(0, 2), Cell::Open);
    assert_eq!(surface.cell(1, 2), Cell::Jump);
    assert_eq!(surface.cells().count(), 6);
    assert_eq!(surface.range(), Some((11.0, 20.5)));
}

#[test]
fn jumps_are_bars_between_their_points() {
    let bars = example().jump_bars();
    assert_eq!(bars.len(), 2);
    assert_eq!(bars[0], [[105.0, 20.0], [155.0, 20.0]]);
    assert_eq!(bars[1], [[155.0, 20.0], [180.0, 20.0]]);
}

#[test]
fn the_valley_is_the_lowest_of_each_row() {
    let lowest = [[80.0, -30.0], [130.0, -10.0], [180.0, 10.0]];
    assert_eq!(example().lowest_in_rows(), lowest);
}

#[test]
fn what_fills_no_grid_is_no_surface() {
    let cut = TABLE.rsplit_once("180,30").unwrap().0;
    let table = BoundaryTable::parse(cut).unwrap();
    assert_eq!(Surface::of(&table, |_| true), None);
    assert_eq!(Surface::of(&table, |slow| slow < 100.0), None);
    assert!(Surface::of(&table, |slow| slow < 150.0).is_some());
}

const TRIANGLE: &str = "\
cross_slope_deg,roll_deg,triangle,first_transition_fps
80,-30,1,12
80,30,1,12
180,30,1,14
";

#[test]
fn a_map_is_hatched_where_it_falls_short_of_the_error_asked_for() {
    // Unknown in the first row; larger than asked only in the middle of the others.
    let grid = "\
cross_slope_deg,roll_deg,first_transition_fps,estimated_error_fps
80,-30,12,
80,0,12,
80,30,12,
130,-30,12,0.1
130,0,12,0.3
130,30,12,0.2
180,-30,12,0.1
180,0,12,0.3
180,30,12,0.2
";
    let hatched = |error: &str| {
        let pictures = picture::draw(
            &Source {
                table: TRIANGLE,
                grid: Some(grid),
                record: Some(&format!(
                    "{{\"input\": {{\"map\": {{\"error_fps\": {error}}}}}}}"
                )),
                ..Source::default()
            },
            &Choices::default(),
        );
        let contours = pictures.unwrap().remove(0).svg;
        let lines = contours.matches("stroke=\"#F07D96\"").count();
        (
            lines,
            contours.contains(&format!(">estimated error above {error} ft/s<")),
        )
    };
    // A line on each diagonal with a marked place, and three in the legend.
    assert_eq!(hatched("0.2"), (3 + 4, true));
    assert_eq!(hatched("0.4"), (3 + 3, true));
    assert_eq!(hatched("0"), (0, false));
    let ragged = grid.trim_end().rsplit_once('\n').unwrap().0;
    let complaint = MapTable::parse(TRIANGLE, None, None, Some(ragged));
    let complaint = complaint.unwrap_err().to_string();
    assert!(complaint.contains("regular table"), "{complaint}");
}

#[test]
fn patchy_transitions_are_marked() {
    let mut table = String::new();
    for row in TABLE.lines() {
        let cell = match row {
            row if row.starts_with("cross") => "patchy_to_fps",
            row if row.starts_with("130,10") => "13.5",
            _ => "",
        };
        table += &format!("{row},{cell}\n");
    }
    let surface = Surface::of(&BoundaryTable::parse(&table).unwrap(), |_| true).unwrap();
    let ring = Mark::Ring(palette::PATCHY);
    assert_eq!(surface.doubtful, [([130.0, 10.0], ring)]);
    let map = MapTable::parse(TRIANGLE, None, Some(&table), None);
    assert_eq!(map.unwrap().patchy, [[130.0, 10.0]]);
}

#[test]
fn a_jump_grows_with_the_heights() {
    let jump = |step: f64| grid(20, |row, column| Some(step * (row + column) as f64)).jump;
    for step in [0.001, 0.01, 0.1] {
        let ratio = jump(10.0 * step) / jump(step);
        assert!((ratio - 10.0).abs() < 1e-9, "{step}: {ratio}");
    }
}
