use super::*;
use crate::surface::tests::TABLE;

fn pictures(table: &str) -> Result<Vec<Picture>, FigureError> {
    let source = Source {
        table,
        ..Source::default()
    };
    draw(&source, &Choices::default())
}

fn suffixes(table: &str) -> Vec<&'static str> {
    let pictures = pictures(table).unwrap().into_iter();
    pictures.map(|picture| picture.suffix).collect()
}

#[test]
fn two_axes_have_a_map_and_a_view_and_negative_cross_slopes_a_map_of_their_own() {
    assert_eq!(suffixes(TABLE), ["-contours", "-perspective"]);
    let (heading, rows) = TABLE.split_once('\n').unwrap();
    let negative: Vec<String> = rows
        .lines()
        .filter(|row| !row.starts_with("180"))
        .map(|row| format!("-{row}\n"))
        .collect();
    let both = format!("{heading}\n{rows}{}", negative.concat());
    assert_eq!(suffixes(&both).last(), Some(&"-contours-negative"));
}

#[test]
fn single_rows_have_a_profile() {
    let row: String = TABLE.split_inclusive('\n').take(5).collect();
    let pictures = pictures(&row).unwrap();
    assert_eq!((pictures.len(), pictures[0].suffix), (1, ""));
    assert!(pictures[0].svg.contains("Roll angle") && !pictures[0].svg.contains("at worst"));
}

#[test]
fn more_axes_are_drawn_at_worst_over_all_but_two() {
    let with = |value: &str, rows: &str| -> String {
        let rows = rows.lines().skip(1);
        rows.map(|row| format!("{value},{row}\n")).collect()
    };
    let heading = TABLE.lines().next().unwrap();
    let lower = TABLE.replace("unstable,13,13,13", "bottomed,5,5,5");
    let (first, second) = (with("15,soft", TABLE), with("20,stiff", &lower));
    let table = format!("slope_deg,vehicle,{heading}\n{first}{second}");
    assert_eq!(suffixes(&table), ["-contours", "-perspective"]);
    let pictures = pictures(&table).unwrap();
    let map = &pictures[0].svg;
    assert!(map.contains("at worst over slope θ and vehicle"), "{map}");
    assert!(map.contains("Cross-slope angle") && map.contains("Roll angle"));
    // What is drawn is the lower of the two: the walls of the perspective begin below it.
    assert!(pictures[1].svg.contains(">6</text>"));
}

#[test]
fn what_cannot_be_drawn_and_useless_choices_are_refused() {
    let complaint = |table: &str, choices: &Choices| {
        let source = Source {
            table,
            ..Source::default()
        };
        draw(&source, choices).unwrap_err().to_string()
    };
    let by = |axes: &[&str]| Choices {
        worst_by: axes.iter().map(|axis| (*axis).to_owned()).collect(),
        ..Choices::default()
    };
    let cut = TABLE.rsplit_once("180,30").unwrap().0;
    let said = complaint(cut, &Choices::default());
    assert!(said.contains("do not fill a grid"), "{said}");
    let said = complaint(TABLE, &by(&["friction"]));
    assert!(said.contains("friction is no axis"), "{said}");
    let history = "t_s,psi_deg\n0,1\n1,2\n";
    let said = complaint(history, &by(&["psi_deg"]));
    assert!(
        said.contains("axes cannot be chosen for histories"),
        "{said}"
    );
    let columns = Choices {
        columns: vec!["psi_deg".to_owned()],
        ..Choices::default()
    };
    let said = complaint(TABLE, &columns);
    assert!(
        said.contains("columns cannot be chosen for a sweep"),
        "{said}"
    );
}
