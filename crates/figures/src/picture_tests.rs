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

#[test]
fn each_kind_of_transition_has_its_mark_region_and_word_at_its_place() {
    let row = |roll: u32, kind: &str, speed: u32| {
        format!("{roll},{kind},{speed},{speed},{speed},9,100,certain,,,3e-5\n")
    };
    let table = "roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,landings,\
                 derivative_evaluations,certainty,disputed_from_fps,disputed_to_fps,solver_tolerance\n"
        .to_owned()
        + &row(0, "unstable", 12)
        + &row(10, "bottomed", 14)
        + &row(20, "failure", 16)
        + &row(30, "undecided", 18)
        + "40,none,,20,,9,100,above,,,\n";
    let svg = &pictures(&table).unwrap()[0].svg;
    // Rolls of 0 to 40 deg are at 94.95 to 853.05, speeds of 8 to 20 ft/s at 454 to 34.
    for mark in [
        "<circle cx=\"94.95\" cy=\"314\" r=\"4\" fill=\"#005AA0\"/>",
        "<rect x=\"280.48\" y=\"240\" width=\"8\" height=\"8\" fill=\"#D55E00\"/>",
        "<polyline points=\"470,178 478,170\" fill=\"none\" stroke=\"#96286E\"",
        "<circle cx=\"663.52\" cy=\"104\" r=\"4\" fill=\"none\" stroke=\"#696969\"",
        "<polygon points=\"853.05,29 848.05,38 858.05,38\" fill=\"#FFFFFF\" stroke=\"#008264\"",
        // Above each transition, up to half of the way to the next.
        "<path d=\"M95 314L189.7 314L189.7 34L95 34Z\" fill=\"#CEDFF0\"/>",
        "284.5 244L379.2 244L379.2 34L284.5 34Z\" fill=\"#F8D6BA\"/>",
        "L568.8 34L474 34Z\" fill=\"#F0E0EC\"/>",
        "fill=\"#E2E2DA\"/>",
        "fill=\"#D55E00\" text-anchor=\"middle\">strut bottoms<",
        "fill=\"#96286E\" text-anchor=\"middle\">not computed<",
        "fill=\"#696969\" text-anchor=\"middle\">undecided<",
        "fill=\"#008264\" text-anchor=\"middle\">stable<",
    ] {
        assert!(svg.contains(mark), "{mark}: {svg}");
    }
}
