use super::*;
use crate::sensitivity_table::tests::TABLE;

/// Places of the plot in the picture, pixels: from the names to the margin on the right.
const LEFT: f64 = 344.0;
const RIGHT: f64 = 900.0 - 28.0;

fn drawn(csv: &str) -> String {
    draw(&SensitivityTable::parse(csv).unwrap(), &Caption::default()).unwrap()
}

fn attribute(element: &str, name: &str) -> f64 {
    let rest = element.split(&format!(" {name}=\"")).nth(1).unwrap_or("");
    let text = rest.split('"').next().unwrap_or("");
    text.parse().unwrap_or(f64::NAN)
}

/// Elements of the chart itself, without the legend's.
fn elements<'s>(svg: &'s str, begin: &str) -> Vec<&'s str> {
    let height = attribute(svg.lines().next().unwrap(), "height");
    let place = |line: &str| attribute(line, if begin == "<circle" { "cy" } else { "y" });
    svg.lines()
        .filter(|line| line.starts_with(begin) && place(line) < height - 34.0)
        .collect()
}

/// Bars of a colour: left and right end, pixels.
fn bars(svg: &str, colour: &str) -> Vec<[f64; 2]> {
    let bars = elements(svg, "<rect").into_iter();
    bars.filter(|line| line.contains(&format!("fill=\"{colour}\"")))
        .map(|line| {
            let left = attribute(line, "x");
            [left, left + attribute(line, "width")]
        })
        .collect()
}

/// Place of a change, pixels; the axis reaches 5 % beyond the widest mark of the table.
fn across(change: f64) -> f64 {
    let reach = 1.05 * (0.5 + 0.001);
    0.5 * (LEFT + RIGHT) + change / reach * 0.5 * (RIGHT - LEFT)
}

#[test]
fn bars_are_as_long_as_the_table_says_and_the_longest_is_on_top() {
    let svg = drawn(TABLE);
    let near = |found: [f64; 2], expected: [f64; 2]| {
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
        assert!(off.fold(0.0, f64::max) <= 0.02, "{found:?} {expected:?}");
    };
    // The slope does more than preload, which jumps: there is no transition left where it grows. Friction does least.
    let [grows, falls] = ["#005AA0", "#CEDFF0"].map(|colour| bars(&svg, colour));
    assert_eq!((grows.len(), falls.len()), (2, 3), "{svg}");
    near(grows[0], [across(-0.5), across(0.0)]);
    near(falls[0], [across(0.0), across(0.5)]);
    near(falls[1], [across(0.0), across(0.25)]);
    near(grows[1], [across(0.0), across(0.2)]);
    near(falls[2], [across(-0.2), across(0.0)]);
    let order = [
        "slope  15 deg ± 1 deg",
        "strut preload  185 lb ± 10 %",
        "friction  1 ± 10 %",
    ];
    let places = order.map(|name| svg.find(&format!(">{name}</text>")).expect(name));
    assert!(places.is_sorted());
    let reason = elements(&svg, "<text").into_iter();
    let reason: Vec<_> = reason
        .filter(|line| line.contains("jumps within ± 6 lb"))
        .collect();
    assert_eq!(reason.len(), 1, "{svg}");
    assert!(attribute(reason[0], "x") < across(0.0), "left of its bar");
    assert!(svg.contains("ft/s, from 11.25 ft/s at roll 5 deg"), "{svg}");
}

#[test]
fn rings_are_the_other_points() {
    let svg = drawn(TABLE);
    let mut rings: Vec<f64> = elements(&svg, "<circle")
        .into_iter()
        .filter(|line| line.contains("#E65A00"))
        .map(|line| attribute(line, "cx"))
        .collect();
    rings.sort_by(f64::total_cmp);
    let expected = [-0.3, -0.185, 0.4].map(across);
    assert_eq!(rings.len(), expected.len());
    for (ring, expected) in rings.iter().zip(expected) {
        assert!((ring - expected).abs() <= 0.02, "{ring} {expected}");
    }
    // One point has no others.
    let single: String = TABLE.split_inclusive('\n').take(4).collect();
    assert!(!drawn(&single).contains("other points"));
}

#[test]
fn where_nothing_has_a_derivative_there_is_no_chart() {
    let rows = ["friction", "slope_deg"].map(|name| format!("0,{name},1,1,none,,none,,,,,,,,\n"));
    let table = format!("{}\n{}", TABLE.lines().next().unwrap(), rows.concat());
    let complaint = draw(
        &SensitivityTable::parse(&table).unwrap(),
        &Caption::default(),
    );
    assert!(complaint.unwrap_err().to_string().contains("no point has"));
}
