use super::*;
use crate::documents::document::Document;
use std::path::Path;

/// Name, values and group.
type Axis = (String, Vec<f64>, Option<String>);

/// Reads the axes of a file: names, values and groups, or the error.
fn read(axes: &str) -> Result<Vec<Axis>, String> {
    let document = Document::parse(Path::new("f.toml"), axes).unwrap();
    let root = Section::root(&document, &["axes"]).unwrap();
    let said = |error: InputError| error.to_string();
    entries(&root, 3)
        .map_err(said)?
        .iter()
        .map(|entry| {
            let (levels, group) = entry.levels().map_err(said)?;
            let name = entry.parameter.name().to_owned();
            Ok((name, levels.values().collect(), group))
        })
        .collect()
}

fn names(axes: &str) -> Vec<String> {
    let axes = read(axes).unwrap();
    axes.into_iter().map(|(name, ..)| name).collect()
}

#[test]
fn dotted_names_may_be_quoted_or_tables_and_keep_their_order() {
    let text = "[axes]\nvehicle.mass_slug = [20]\nroll_deg = [0]\n\
                vehicle.strut.preload_lb = { from = 1, to = 3, count = 2 }\n\
                \"vehicle.legs[2].azimuth_deg\" = [120]\nscene.slope_deg = [15]\n";
    assert_eq!(
        names(text),
        [
            "vehicle.mass_slug",
            "roll_deg",
            "vehicle.strut.preload_lb",
            "vehicle.legs[2].azimuth_deg",
            "slope_deg"
        ]
    );
}

#[test]
fn every_form_gives_its_values() {
    let values = |form: &str| {
        let axes = read(&format!("[axes]\nfriction = {form}\n")).unwrap();
        axes[0].1.clone()
    };
    assert_eq!(values("[0.4, 0.8]"), [0.4, 0.8]);
    assert_eq!(values("{ values = [0.4, 0.8] }"), [0.4, 0.8]);
    assert_eq!(values("{ from = 0, to = 1, step = 0.5 }"), [0.0, 0.5, 1.0]);
    assert_eq!(values("{ from = 0, to = 1, count = 3 }"), [0.0, 0.5, 1.0]);
    let log = "{ from = 0.01, to = 1, count = 3, spacing = \"log\" }";
    assert_eq!(values(log), [0.01, 0.1, 1.0]);
    let zipped = read("[axes]\nslope_deg = { values = [1], zip = \"a\" }\n").unwrap();
    assert_eq!(zipped[0].2.as_deref(), Some("a"));
    let rules = read("[axes]\nsolver.crush_rule = [\"section\", \"pivot-rate\"]\n").unwrap();
    assert_eq!(rules[0].1, [1.0, 0.0]);
}

/// The value of an axis, and text that the error must contain.
#[rustfmt::skip]
const WRONG: [(&str, &[&str]); 14] = [
    ("rol_deg = [0]", &["f.toml:2: axes.rol_deg = [0]", "did you mean roll_deg?"]),
    ("vehicle.strut.preload = [1]", &["axes.vehicle.strut.preload", "did you mean vehicle.strut.preload_lb"]),
    ("\"vehicle.legs[4].azimuth_deg\" = [1]", &["unknown parameter", "vehicle.legs[3].azimuth_deg"]),
    ("vehicle = 3", &["axes.vehicle = 3", "unknown parameter"]),
    ("slope_deg = 3", &["axes.slope_deg = 3", "a list"]),
    ("slope_deg = { from = 0, to = 1 }", &["axes.slope_deg.step is missing"]),
    ("slope_deg = { from = 0, to = 1, step = 1, count = 2 }", &["expected only one of them"]),
    ("slope_deg = { from = 0, to = 1, count = 2, spacing = \"log\" }", &["axes.slope_deg.from = 0", "> 0"]),
    ("slope_deg = { from = 1, to = 2, step = 1, spacing = \"log\" }", &["axes.slope_deg.count is missing"]),
    ("slope_deg = { from = 0, to = 16, step = 7 }", &["axes.slope_deg.step = 7", "pass over to = 16", "to = 14 or 21", "divides 16"]),
    ("slope_deg = { from = 3, to = -0.5, step = -0.1 }\nroll_deg = { from = 1, to = -0.55, step = -0.1 }", &["axes.roll_deg.step = -0.1", "to = -0.5 or -0.6"]),
    ("slope_deg = { values = [1], step = 1 }", &["axes.slope_deg.step = 1", "values, zip"]),
    ("solver.crush_rule = [\"soft\"]", &["axes.solver.crush_rule[1] = \"soft\"", "\"pivot-rate\", \"section\""]),
    ("slope_deg = [1]\nscene.slope_deg = [2]", &["axes.scene.slope_deg = [2]", "varies twice"]),
];

#[test]
fn wrong_axes_are_complained_about_where_they_stand() {
    for (axis, fragments) in WRONG {
        let said = read(&format!("[axes]\n{axis}\n")).unwrap_err();
        for fragment in fragments {
            assert!(said.contains(fragment), "{fragment} is not in: {said}");
        }
    }
}
