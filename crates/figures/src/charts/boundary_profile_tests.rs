use super::*;

const TABLE: &str = "\
roll_deg,first_transition_to,first_transition_fps,bracket_low_fps,bracket_high_fps,landings,derivative_evaluations
-20,none,,,,101,1
-10,unstable,12,11.9995,12.0005,57,1
0,unstable,11.5,11.4995,11.5005,55,1
10,bottomed,14,13.9995,14.0005,65,1
20,none,,,,101,1
";

fn draw(csv: &str, caption: &Caption) -> Result<String, FigureError> {
    super::draw(&BoundaryTable::parse(csv)?, None, caption)
}

fn caption() -> Caption {
    Caption {
        title: "V_H <versus> roll".to_owned(),
        conditions: "14 ft/s".to_owned(),
        statement: Some("1966: rises".to_owned()),
        searched_to: Some(25.0),
        ..Caption::default()
    }
}

#[test]
fn marks_stand_where_the_table_says() {
    let svg = draw(TABLE, &caption()).unwrap();
    assert!(svg.starts_with("<svg width=\"900\" height=\"560\""));
    let circles: Vec<&str> = svg
        .lines()
        .filter(|line| line.starts_with("<circle"))
        .collect();
    // The legend's, and two topple points.
    assert_eq!(circles.len(), 3, "{circles:?}");
    assert_eq!(svg.matches("first transition: ").count(), 2);
    assert!(svg.contains("stable up to 25 ft/s"));
    assert!(svg.contains("Roll angle Ξ, deg"));
    assert!(svg.contains("&lt;versus&gt;"));
    let across = |line: &str| -> f64 {
        let rest = line.split("cx=\"").nth(1).unwrap_or("");
        rest.split('"')
            .next()
            .unwrap_or("")
            .parse()
            .unwrap_or(f64::NAN)
    };
    // Roll 0 stands in the middle of the plot, which lies between 76 and 872 pixels.
    assert!((across(circles[2]) - 474.0).abs() <= 0.01, "{}", circles[2]);
}

#[test]
fn regions_come_from_the_bands_where_they_are_known() {
    let bands = "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps\n\
                 -10,1,0,12,stable,0.001\n-10,2,12,16,unstable,0.001\n-10,3,16,25,stable,\n\
                 0,1,0,11.5,stable,0.001\n0,2,11.5,16,unstable,0.001\n0,3,16,25,stable,\n";
    let table = BoundaryTable::parse(TABLE).unwrap();
    let bands = BandsTable::parse(bands).unwrap();
    let shaded = |svg: &str| -> Vec<String> {
        let colour = "fill=\"#CEDFF0\"";
        let mut lines = svg.lines().filter(|line| line.starts_with("<path"));
        let path = lines.find(|line| line.contains(colour)).unwrap();
        path.split('M').skip(1).map(str::to_owned).collect()
    };
    let with = super::draw(&table, Some(&bands), &caption()).unwrap();
    let without = draw(TABLE, &caption()).unwrap();
    assert!(with.contains("1966: rises"));
    assert_ne!(shaded(&with), shaded(&without));
    // From -10 to 0 one region, and halves toward the neighbours without bands.
    assert_eq!(shaded(&with).len(), 3, "{:?}", shaded(&with));
}

#[test]
fn a_region_too_narrow_for_its_word_is_in_the_legend() {
    let bands = "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps\n\
                 20,1,0,20,stable,0.001\n20,2,20,25,BAND,\n";
    let table = BoundaryTable::parse(TABLE).unwrap();
    let words = |band: &str| {
        let bands = BandsTable::parse(&bands.replace("BAND", band)).unwrap();
        let svg = super::draw(&table, Some(&bands), &caption()).unwrap();
        svg.matches("not computed").count()
    };
    assert_eq!((words("failure"), words("stable")), (1, 0));
}

#[test]
fn same_table_same_picture() {
    assert_eq!(draw(TABLE, &caption()), draw(TABLE, &caption()));
}

#[test]
fn single_points_and_points_without_any_transition_have_a_picture() {
    let (heading, rest) = TABLE.split_once('\n').unwrap();
    let first = rest.lines().next().unwrap();
    assert!(draw(&format!("{heading}\n{first}\n"), &Caption::default()).is_ok());
}

#[test]
fn two_axes_are_refused() {
    let table = TABLE
        .replace("roll_deg", "cross_slope_deg,roll_deg")
        .replace("\n-", "\n180,-");
    let table = table
        .replace("\n0,", "\n180,0,")
        .replace("\n10,", "\n180,10,");
    let table = table.replace("\n20,", "\n180,20,");
    let complaint = draw(&table, &caption()).unwrap_err().to_string();
    assert!(
        complaint.contains("not cross_slope_deg, roll_deg"),
        "{complaint}"
    );
}

#[test]
fn patchy_stretches_are_striped() {
    let mut rows = TABLE.lines().map(|row| match row {
        row if row.starts_with("roll") => format!("{row},patchy_to_fps\n"),
        row if row.starts_with("0,") => format!("{row},13\n"),
        row => format!("{row},\n"),
    });
    let table: String = rows.by_ref().collect();
    let (striped, sharp) = (
        draw(&table, &caption()).unwrap(),
        draw(TABLE, &caption()).unwrap(),
    );
    let stripes = |svg: &str| svg.matches("stroke=\"#008264\"").count();
    assert!(striped.contains(palette::PATCHY_WORDS) && !sharp.contains(palette::PATCHY_WORDS));
    // From half-way between -10 and 0 deg to half-way between 0 and 10 deg, of 42 deg over 796 pixels; four in the legend.
    let expected = 796.0 * 10.0 / 42.0 / palette::STRIPES_APART + 4.0;
    let more = stripes(&striped) - stripes(&sharp);
    assert!((more as f64 - expected).abs() < 1.5, "{more} {expected}");
}
