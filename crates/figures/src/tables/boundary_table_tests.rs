use super::*;

const HEADING: &str = "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,\
                       bracket_high_fps,landings,derivative_evaluations\n";

#[test]
fn transitions_and_their_absence_are_read() {
    let rows = "-5,unstable,11.4,11.3,11.5,55,1\n0,none,,25,,101,2\n5,failure,8,,8,1,1\n";
    let text = format!("{HEADING}{rows}");
    let table = BoundaryTable::parse(&text).unwrap();
    assert_eq!(table.axes, ["roll_deg"]);
    assert_eq!(table.points[0].coordinates, [-5.0]);
    let found = table.points[0].transition.unwrap();
    assert_eq!(found.kind, Kind::Unstable);
    assert_eq!((found.low, found.high), (Some(11.3), 11.5));
    assert_eq!(table.points[1].transition, None);
    let open = table.points[2].transition.unwrap();
    assert_eq!((open.speed, open.low), (8.0, None));
}

#[test]
fn complaints_name_row_and_column() {
    let complaint = |text: &str| BoundaryTable::parse(text).unwrap_err().to_string();
    assert!(complaint("a,b\n1,2\n").contains("column first_transition_to is missing"));
    assert!(complaint(HEADING).contains("no rows"));
    let odd = format!("{HEADING}0,toppled,1,1,1,1,1\n");
    assert!(complaint(&odd).contains("row 1: first_transition_to = toppled"));
    let nan = format!("{HEADING}0,unstable,NaN,1,1,1,1\n");
    assert!(complaint(&nan).contains("row 1: first_transition_fps = NaN"));
}

#[test]
fn absurd_numbers_are_refused_with_their_row() {
    for absurd in ["1e9", "1e16", "1e308", "-1", "inf"] {
        for row in [
            format!("0,unstable,{absurd},1,1,1,1\n"),
            format!("0,unstable,1,1,{absurd},1,1\n"),
        ] {
            let text = format!("{HEADING}5,none,,25,,101,2\n{row}");
            let complaint = BoundaryTable::parse(&text).unwrap_err().to_string();
            assert!(complaint.contains("row 2: "), "{complaint}");
            assert!(complaint.contains(&format!(" = {absurd}: expected a number from 0")));
        }
    }
    let far = format!("{HEADING}1e200,none,,25,,101,2\n");
    let complaint = BoundaryTable::parse(&far).unwrap_err().to_string();
    assert!(complaint.contains("row 1: roll_deg = 1e200"), "{complaint}");
}

const MANY: &str = "\
a,roll_deg,vehicle,b,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps
1,0,x,5,unstable,12,11,13
1,0,y,6,none,,,
1,5,x,5,unstable,11,10,12
1,5,y,6,bottomed,9,8,10
2,0,x,5,none,,,
2,5,x,5,none,,,
2,5,x,6,none,,,
";

#[test]
fn the_lowest_of_the_rows_that_agree_remains() {
    let axes = BoundaryTable::axes(MANY).unwrap();
    let told: Vec<_> = axes
        .iter()
        .map(|axis| (axis.name.as_str(), axis.values, axis.is_numeric))
        .collect();
    assert_eq!(
        told,
        [
            ("a", 2, true),
            ("roll_deg", 2, true),
            ("vehicle", 2, false),
            ("b", 2, true)
        ]
    );
    let by = |axes: &[&str]| {
        let axes: Vec<String> = axes.iter().map(|axis| (*axis).to_owned()).collect();
        BoundaryTable::worst_by(MANY, &axes)
    };
    let table = by(&["b", "a"]).unwrap();
    assert_eq!(table.others, ["roll_deg", "vehicle"]);
    let found: Vec<_> = table
        .points
        .iter()
        .map(|point| (point.coordinates.as_slice(), point.velocity()))
        .collect();
    assert_eq!(
        found,
        [
            (&[5.0, 1.0][..], 11.0),
            (&[6.0, 1.0], 9.0),
            (&[5.0, 2.0], f64::INFINITY),
            (&[6.0, 2.0], f64::INFINITY)
        ]
    );
    for (axes, expected) in [
        (
            &["c"][..],
            "c is no axis of this table: expected a, roll_deg",
        ),
        (&["a", "a"], "a is named twice"),
        (&["vehicle"], "row 1: vehicle = x"),
    ] {
        let complaint = by(axes).unwrap_err().to_string();
        assert!(complaint.contains(expected), "{complaint}");
    }
}
