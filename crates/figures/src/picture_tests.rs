use super::*;
use crate::surface::tests::TABLE;

fn pictures(table: &str) -> Result<Vec<Picture>, FigureError> {
    let source = Source {
        table,
        ..Source::default()
    };
    draw(&source, &Choices::default())
}

fn suffixes(table: &str) -> Vec<String> {
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
    assert_eq!(suffixes(&both).last().unwrap(), "-contours-negative");
}

#[test]
fn single_rows_have_a_profile() {
    let row: String = TABLE.split_inclusive('\n').take(5).collect();
    let pictures = pictures(&row).unwrap();
    assert_eq!((pictures.len(), &*pictures[0].suffix), (1, ""));
    assert!(pictures[0].svg.contains("Roll angle") && !pictures[0].svg.contains("at worst"));
}

#[test]
fn more_axes_are_drawn_at_worst_over_all_but_two() {
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

/// Rows of a table without its heading, each with a cell before it.
fn with(value: &str, table: &str) -> String {
    let rows = table.lines().skip(1);
    rows.map(|row| format!("{value},{row}\n")).collect()
}

/// Colours of the bar beside a map, and the numbers between them, from above.
fn bar(svg: &str) -> Vec<&str> {
    let parts = svg
        .lines()
        .filter_map(|line| match line.split('"').nth(1)? {
            "816" => line
                .split_once("fill=\"")?
                .1
                .split('"')
                .next()
                .filter(|_| line.starts_with("<rect")),
            "842" => line.strip_suffix("</text>")?.rsplit('>').next(),
            _ => None,
        });
    parts.collect()
}

#[test]
fn three_axes_have_a_map_for_each_value_of_the_third_with_the_same_levels_and_colours() {
    let heading = TABLE.lines().next().unwrap();
    let lower = TABLE.replace("unstable,13,13,13", "bottomed,5,5,5");
    let table = format!(
        "friction,{heading}\n{}{}",
        with("0.5", TABLE),
        with("1", &lower)
    );
    let kinds = [
        "-contours",
        "-perspective",
        "-contours-friction=0.5",
        "-contours-friction=1",
    ];
    assert_eq!(suffixes(&table), kinds);
    let drawn = pictures(&table).unwrap();
    let family = [&drawn[2].svg, &drawn[3].svg];
    for (svg, friction) in family.into_iter().zip(["0.5", "1"]) {
        assert!(
            svg.contains(&format!(">, friction {friction}</text>")),
            "{svg}"
        );
        assert!(!svg.contains("at worst"));
    }
    assert_eq!(bar(family[0]), bar(family[1]));
    assert!(bar(family[0]).contains(&"6"), "{:?}", bar(family[0]));
    // What was chosen is drawn alone.
    let source = Source {
        table: &table,
        ..Source::default()
    };
    let worst_by = ["friction", "roll_deg"].map(str::to_owned).to_vec();
    let choices = Choices {
        worst_by,
        ..Choices::default()
    };
    assert_eq!(draw(&source, &choices).unwrap().len(), 2);
}

/// A plane over two axes as triangles, from the first V_H at a slow coordinate of 0 to the second at 10.
fn plane(friction: &str, from: f64, to: f64) -> String {
    let at = |slow, fast, speed: f64| format!("{slow},{friction},{fast},1,{speed}\n");
    let [a, b] = [0, 10].map(|fast| at(0, fast, from));
    let [c, d] = [0, 10].map(|fast| at(10, fast, to));
    [&a, &b, &c, &b, &d, &c].map(String::as_str).concat()
}

#[test]
fn refined_maps_over_three_axes_have_a_map_for_each_value_of_the_other_with_lines_at_the_same_levels()
 {
    let surface = format!(
        "slope_deg,friction,tip_deg,triangle,first_transition_fps\n{}{}",
        plane("0.5", 10.0, 20.0),
        plane("1", 14.0, 24.0)
    );
    // Nothing topples at the last friction.
    let corners = [(0, 0), (0, 10), (10, 0), (10, 10)];
    let grid = ["0.5", "1", "2"].map(|friction| {
        let row = |(slow, fast)| format!("{slow},{friction},{fast},15,0.1\n");
        corners.map(row).concat()
    });
    let grid = format!(
        "slope_deg,friction,tip_deg,first_transition_fps,estimated_error_fps\n{}",
        grid.concat()
    );
    let source = Source {
        name: "map",
        table: &surface,
        grid: Some(&grid),
        ..Source::default()
    };
    let levels = Levels::listed(&[12.0, 16.0, 22.0]).unwrap();
    let choices = Choices {
        levels: Some(levels),
        ..Choices::default()
    };
    let drawn = draw(&source, &choices).unwrap();
    let suffixes: Vec<&str> = drawn.iter().map(|picture| &*picture.suffix).collect();
    let frictions = ["0.5", "1", "2"];
    assert_eq!(
        suffixes,
        frictions.map(|value| format!("-contours-friction={value}"))
    );
    // Lines run across the map, at the slopes at which the planes have the levels.
    let lines = |svg: &str| -> Vec<String> {
        let lines = svg
            .lines()
            .filter(|line| line.contains("stroke-width=\"1.3\""));
        let height = |line: &str| {
            let place = line.split_once("points=\"")?.1.split_once(' ')?.0;
            Some(place.split_once(',')?.1.to_owned())
        };
        lines.map(|line| height(line).unwrap()).collect()
    };
    // Ticks from 0 to 10 deg of slope.
    let ticks = |svg: &str| -> Vec<String> {
        let ticks = svg
            .lines()
            .filter_map(|line| line.strip_prefix("<polyline points=\"70,"));
        ticks
            .map(|rest| rest.split(' ').next().unwrap().to_owned())
            .collect()
    };
    const BAR: [&str; 7] = ["#FAE88C", "22", "#9D9677", "16", "#596173", "12", "#203460"];
    let slopes: [&[usize]; 3] = [&[2, 6], &[2, 8], &[]];
    for ((picture, friction), slopes) in drawn.iter().zip(frictions).zip(slopes) {
        let svg = &picture.svg;
        let expected: Vec<String> = slopes
            .iter()
            .map(|slope| ticks(svg)[*slope].clone())
            .collect();
        assert_eq!(lines(svg), expected, "{svg}");
        assert_eq!(bar(svg), BAR, "{svg}");
        assert!(
            svg.contains(&format!(">map, friction {friction}</text>")),
            "{svg}"
        );
    }
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
    let history = "t_s,pitch_deg\n0,1\n1,2\n";
    let said = complaint(history, &by(&["pitch_deg"]));
    assert!(
        said.contains("axes cannot be chosen for histories"),
        "{said}"
    );
    let columns = Choices {
        columns: vec!["pitch_deg".to_owned()],
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

/// A sweep over friction from 0.1 to 10 and roll, with its record.
fn over_friction(rolls: &[i32]) -> (String, String) {
    let heading = "friction,roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,\
                   landings,derivative_evaluations\n";
    let mut table = heading.to_owned();
    for (friction, speed) in [("0.1", 11), ("1", 12), ("10", 14)] {
        for roll in rolls {
            table += &format!("{friction},{roll},unstable,{speed},{speed},{speed},9,100\n");
        }
    }
    let record = r#"{"title": "friction", "spacing": {"friction": "log"}}"#;
    (table, record.to_owned())
}

/// Places of a number of an axis, across and down.
fn places(svg: &str, number: &str) -> Vec<[f64; 2]> {
    let texts = svg
        .lines()
        .filter(|line| line.contains(&format!(">{number}</text>")));
    let attribute = |line: &str, name: &str| -> f64 {
        let (_, after) = line.split_once(&format!("{name}=\"")).unwrap();
        after.split('"').next().unwrap().parse().unwrap()
    };
    texts
        .map(|line| ["x", "y"].map(|name| attribute(line, name)))
        .collect()
}

#[test]
fn logarithmic_axes_have_logarithmic_scales_with_round_numbers() {
    let drawn = |table: &str, record: &str| {
        let source = Source {
            table,
            record: Some(record),
            ..Source::default()
        };
        draw(&source, &Choices::default()).unwrap()
    };
    let is_middle = |[a, b, c]: [f64; 3]| (b - 0.5 * (a + c)).abs() < 0.1 && (a - c).abs() > 80.0;
    // One axis: the profile. Two axes: the slow one of the map runs upward, and along the floor of the perspective.
    let (table, record) = over_friction(&[0]);
    let profile = &drawn(
        &table
            .replace(",0,unstable", ",unstable")
            .replace("roll_deg,", ""),
        &record,
    )[0]
    .svg;
    let (table, record) = over_friction(&[30, 40]);
    let map = drawn(&table, &record);
    let outcomes = table.replace("first_transition_to", "outcome");
    let outcomes = &drawn(&outcomes.replace("unstable", "sliding"), &record)[0].svg;
    let refined = "friction,roll_deg,triangle,first_transition_fps\n\
                   0.1,30,1,11\n10,30,1,14\n0.1,40,1,11\n10,30,2,14\n0.1,40,2,11\n10,40,2,14\n";
    let refined = drawn(refined, &record);
    for (svg, axis) in [
        (&refined[0].svg, 1),
        (&refined[1].svg, 0),
        (profile, 0),
        (&map[0].svg, 1),
        (&map[1].svg, 0),
        (outcomes, 1),
    ] {
        let at = |number| places(svg, number)[0][axis];
        assert!(is_middle([at("0.1"), at("1"), at("10")]), "{svg}");
        assert!(is_middle([at("0.2"), at("1"), at("5")]), "{svg}");
    }
    // Without a record scales are even.
    let even = pictures(&table).unwrap();
    assert!(places(&even[0].svg, "0.2").is_empty());
}

#[test]
fn probabilities_over_a_logarithmic_axis_have_its_scale() {
    let columns = "probability,low_95,high_95";
    let heading = ["topple", "bottom", "not_stable"].map(|name| {
        let columns = columns.split(',').map(|end| format!("{name}_{end}"));
        columns.collect::<Vec<_>>().join(",")
    });
    let row = |ends: &str| format!("friction,{ends},10,0.1,0,0.2,0,0,0.1,0.1,0,0.2\n");
    let bins = ["0.1,1", "1,10", "10,100"].map(row).concat();
    let table = format!("axis,from,to,landings,{}\n{bins}", heading.join(","));
    let record = r#"{"spacing": {"friction": "log"}}"#;
    let source = Source {
        table: &table,
        record: Some(record),
        ..Source::default()
    };
    let svg = &draw(&source, &Choices::default()).unwrap()[0].svg;
    let at = |number| places(svg, number)[0][0];
    assert!(
        (at("2") - at("1") - at("20") + at("10")).abs() < 0.1,
        "{svg}"
    );
}
