use super::*;
use crate::surface::tests::{example, grid};

fn map() -> String {
    let surface = example();
    let levels = Levels::listed(&[12.0, 12.5, 13.0]).unwrap();
    draw(
        &surface,
        &View::of(&surface, &Caption::default()),
        &Heights::of_surfaces([&surface], Some(&levels)),
        &Caption::default(),
    )
}

#[test]
fn lines_carry_their_level_and_gaps_their_marks() {
    let svg = map();
    assert!(svg.starts_with("<svg width=\"900\" height=\"860\""));
    for level in ["12", "12.5", "13"] {
        assert!(svg.contains(&format!(">{level}</text>")), "{level}");
    }
    // One point without a transition, and the legend's mark: white triangles.
    let triangles = svg
        .lines()
        .filter(|line| line.starts_with("<polygon") && line.contains("#FFFFFF"));
    assert_eq!(triangles.count(), 2);
    // Two bars where the boundary jumps, and the legend's.
    assert_eq!(svg.matches("stroke=\"#BE1E64\"").count(), 3);
    assert_eq!(svg, map());
}

#[test]
fn the_valley_is_marked_where_the_table_has_it() {
    let svg = map();
    let discs: Vec<&str> = svg
        .lines()
        .filter(|line| line.contains("fill=\"#E65A00\""))
        .collect();
    assert_eq!(discs.len(), 4);
    let number = |line: &str, key: &str| -> f64 {
        let rest = line.split(key).nth(1).unwrap_or("");
        rest.split('"')
            .next()
            .unwrap_or("")
            .parse()
            .unwrap_or(f64::NAN)
    };
    // Rolls run from 30 on the left to -30 on the right: 80 deg at -30 lies far right and on top.
    // The legend's comes first.
    let [first, last] = [discs[1], discs[3]];
    assert!(number(first, "cx=\"") > number(last, "cx=\"") + 300.0);
    assert!(number(first, "cy=\"") < number(last, "cy=\"") - 300.0);
}

#[test]
fn every_point_with_a_transition_is_seen_and_every_mark_explained() {
    let drawn = |surface: &Surface| {
        draw(
            surface,
            &View::of(surface, &Caption::default()),
            &Heights::of_surfaces([surface], None),
            &Caption::default(),
        )
    };
    // Transitions in the last of three rows, a jump among them.
    let row = grid(3, |row, column| {
        let speeds = [11.0, 11.1, 13.0];
        (row == 2).then_some(speeds[column])
    });
    let svg = drawn(&row);
    // The three points and the legend's mark.
    let discs = |svg: &str| {
        let is_lone =
            |line: &&str| line.starts_with("<circle") && line.contains("stroke=\"#262626\"");
        svg.lines().filter(is_lone).count()
    };
    assert_eq!(discs(&svg), 4);
    assert!(svg.contains("of a point beside gaps"));
    assert_eq!(svg.contains("#BE1E64"), svg.contains("jumps by more than"));
    // A whole surface has no such points, and one without transitions no lowest one.
    let whole = grid(3, |row, column| Some(11.0 + 0.1 * (row + column) as f64));
    assert_eq!(discs(&drawn(&whole)), 0);
    let none = grid(3, |_, _| None);
    assert!(!drawn(&none).contains("lowest"));
}

#[test]
fn labels_stand_within_the_map() {
    let area = Area {
        left: 0.0,
        top: 0.0,
        right: 400.0,
        bottom: 400.0,
    };
    let is_labelled = |line: &dyn Fn(f64) -> Point| {
        let line = (0..=40).map(|step| line(10.0 * f64::from(step))).collect();
        let mut canvas = Canvas::new((400.0, 400.0));
        draw_lines(&mut canvas, &area, &[], [(12.5, vec![line])].into_iter());
        canvas.into_svg().contains(">12.5</text>")
    };
    for (across, expected) in [(2.0, false), (200.0, true), (398.0, false)] {
        assert_eq!(is_labelled(&|along| (across, along)), expected);
        assert_eq!(is_labelled(&|along| (along, across)), expected);
    }
}
