//! Every quantity of every input file in SI units: the same numbers, the same transitions, the same journal.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::f64::consts::PI;
use std::fmt::Debug;
use std::path::Path;

use touchdown_dynamics::scene::{CrushRule, Settings};
use touchdown_input::documents::column::Cell;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::documents::unit::unit;
use touchdown_input::points::set_value::SetValue;
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::input_keys::tables;
use touchdown_input::sweeps::overrides::Overrides;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_input::sweeps::{cases, scene_file};
use touchdown_search::boundary::Boundary;
use touchdown_sweep::journal::header::Header;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::sensitivity::Dependence;
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::Workers;

const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
const SURVEYOR_SI: &str = include_str!("../../../../sweeps/vehicles/surveyor-si.toml");

const HONEYCOMB: &str = "[strut]\nkind = \"honeycomb\"\nextended_length_ft = 3.1275\n\
     minimum_length_ft = 2.7525\nfriction_fraction = 0.05\nunloading_stiffness_lb_per_ft = 40000\n\
     [strut.crush_load]\nstroke_in = [0, 2, 2, 4]\nload_lb = [900, 900, 1500, 1700]\n";

/// The Surveyor with honeycomb struts.
fn honeycomb() -> String {
    let (before, rest) = SURVEYOR.split_once("[strut]").unwrap();
    let (_, after) = rest.split_once("[footpad]").unwrap();
    format!("{before}{HONEYCOMB}[footpad]{after}")
}

const CANTILEVER: &str = "[linkage]\nkind = \"cantilever\"\nfoot_radius_ft = 6\nfoot_depth_ft = 2\n\
     foot_mass_slug = 0.25\ncollar_ft = 2\n\
     bearing_friction = 0.1\nbearing_overhang_ft = 2.25\nbearing_overlap_ft = 0.7\n\
     [primary]\nhardpoint_radius_ft = 2.5\nhardpoint_height_ft = 2\nstiffness_lb_per_ft = 1e5\n\
     damping_lb_s_per_ft = 20\ncompression_stroke_ft = 1.5\ntension_stroke_ft = 0.125\n\
     [secondary]\nhardpoint_radius_ft = 2.25\nhardpoint_height_ft = 0.5\nhardpoint_spread_ft = 1.25\n\
     stiffness_lb_per_ft = 1e5\ndamping_lb_s_per_ft = 20\ncompression_stroke_ft = 0.5\n\
     tension_stroke_ft = 0.75\ntension_load = { stroke_in = [0], load_lb = [500] }\n\
     [footpad]\ndiameter_ft = 1\nheight_ft = 0.5\ncrush_pressure_psf = 1500\n";

/// The Surveyor on legs with a collar.
fn cantilever() -> String {
    let (before, rest) = SURVEYOR.split_once("[linkage]").unwrap();
    let (_, rest) = rest.split_once("[footpad.profile]").unwrap();
    let (profile, rest) = rest.split_once("[block]").unwrap();
    let (_, legs) = rest.split_once("[[legs]]").unwrap();
    let before = before.replace("rules = \"1966\"", "rules = \"physical\"");
    format!("{before}{CANTILEVER}[footpad.profile]{profile}[[legs]]{legs}")
}

const FOOT: f64 = 0.3048;
const POUND: f64 = 4.4482216152605;

/// The SI number of a value.
type ToSi = fn(f64) -> f64;

/// A unit of 1966 by the ending of keys, and the endings of its SI units with their numbers of a value.
type Unit = (&'static str, &'static [(&'static str, ToSi)]);

/// The longer ending of two that fit comes first.
const UNITS: [Unit; 16] = [
    ("_ftlb_s", &[("_nm_s", |x| x * POUND * FOOT)]),
    ("_lb_per_ft", &[("_n_per_m", |x| x * POUND / FOOT)]),
    ("_lb_s_per_ft", &[("_n_s_per_m", |x| x * POUND / FOOT)]),
    ("_per_ft", &[("_per_m", |x| x / FOOT)]),
    ("_slug_ft2", &[("_kg_m2", |x| x * POUND * FOOT)]),
    (
        "_slug_ft3",
        &[("_kg_m3", |x| x * POUND / FOOT / FOOT / FOOT / FOOT)],
    ),
    ("_slug", &[("_kg", |x| x * POUND / FOOT)]),
    ("_lb", &[("_n", |x| x * POUND)]),
    (
        "_psf",
        &[
            ("_pa", |x| x * POUND / (FOOT * FOOT)),
            ("_kpa", |x| x * POUND / (FOOT * FOOT) / 1000.0),
        ],
    ),
    ("_fps2", &[("_mps2", |x| x * FOOT)]),
    ("_fps", &[("_mps", |x| x * FOOT)]),
    (
        "_ft",
        &[
            ("_m", |x| x * FOOT),
            ("_cm", |x| x * 30.48),
            ("_mm", |x| x * 304.8),
        ],
    ),
    (
        "_in",
        &[
            ("_m", |x| x * 0.0254),
            ("_cm", |x| x * 2.54),
            ("_mm", |x| x * 25.4),
        ],
    ),
    ("_deg", &[("_rad", |x| x * PI / 180.0)]),
    ("_dps", &[("_rad_per_s", |x| x * PI / 180.0)]),
    (
        "_damping",
        &[("_damping_n_s2_per_m2", |x| x * POUND / (FOOT * FOOT))],
    ),
];

/// Spellings of a key in SI, each with its number of a value of the key.
fn in_si(key: &str) -> Vec<(String, ToSi)> {
    let Some((ending, si)) = UNITS.iter().find(|(ending, _)| key.ends_with(ending)) else {
        return Vec::new();
    };
    let bare = key.strip_suffix(ending).unwrap();
    si.iter()
        .map(|(si, number)| (format!("{bare}{si}"), *number))
        .collect()
}

#[test]
fn the_reference_lists_all_units() {
    const REFERENCE: &str = include_str!("../../../../docs/reference.md");
    let table = REFERENCE.split_once("<!-- units -->\n").unwrap().1;
    let rows = table.lines().skip(2).take_while(|row| row.starts_with('|'));
    let mut listed: Vec<(String, String)> = rows
        .map(|row| {
            let cells: Vec<&str> = row.split('|').map(str::trim).collect();
            (cells[1].to_owned(), cells[2].to_owned())
        })
        .collect();
    let quoted = |ending: &str| format!("`{ending}`");
    let mut known: Vec<(String, String)> = UNITS
        .iter()
        .map(|(ending, si)| {
            let si: Vec<String> = si.iter().map(|(si, _)| quoted(si)).collect();
            (quoted(ending), si.join(", "))
        })
        .collect();
    listed.sort();
    known.sort();
    assert_eq!(listed, known);
}

/// The lines of a text from the header of a table, or from the start, up to the next one.
fn table_lines(lines: &[String], header: &str) -> std::ops::Range<usize> {
    let begin = match header {
        "" => 0,
        header => {
            1 + lines
                .iter()
                .position(|line| line.starts_with(header))
                .unwrap()
        }
    };
    let next = lines[begin..].iter().position(|line| line.starts_with('['));
    begin..next.map_or(lines.len(), |next| begin + next)
}

/// A line `key = number or list` in another spelling.
fn respelled(line: &str, spelling: &str, convert: ToSi) -> String {
    let value = line.split_once('=').unwrap().1;
    let value = value.split('#').next().unwrap().trim();
    let number = |text: &str| convert(text.trim().parse().unwrap());
    match value.strip_prefix('[') {
        Some(list) => {
            let numbers = list.trim_end_matches(']').split(',').map(number);
            format!("{spelling} = {:?}", numbers.collect::<Vec<_>>())
        }
        None => format!("{spelling} = {:?}", number(value)),
    }
}

/// Reads a text with every spelling of every one of these keys of a table: always the same comes out, and two spellings at once
/// are refused.
fn check<T: Debug>(
    text: &str,
    header: &str,
    keys: &[&'static str],
    read: &dyn Fn(&str) -> Result<T, String>,
) -> usize {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut checked = 0;
    for key in keys {
        let spellings = in_si(key);
        let is_of = |line: &String| line.split('=').next().unwrap().trim() == *key;
        let is_table =
            |line: &String| *line == format!("[{key}]") || line.starts_with(&format!("[{key}] "));
        let range = table_lines(&lines, header);
        let found = lines[range.clone()].iter().position(is_of);
        let table = lines.iter().position(is_table);
        let at = match (found, table) {
            (Some(index), _) => range.start + index,
            (None, Some(table)) => table,
            (None, None) if spellings.is_empty() => continue,
            (None, None) => {
                lines.insert(range.start, format!("{key} = 0.25"));
                range.start
            }
        };
        let expected = format!("{:?}", read(&lines.join("\n")).unwrap());
        for (spelling, convert) in spellings {
            assert_ne!(unit(key), unit(&spelling), "{spelling}");
            let mut other = lines.clone();
            match found.is_none() && table.is_some() {
                true => {
                    other[at] = format!("[{spelling}]");
                    for index in table_lines(&other, &other[at].clone()) {
                        if let Some((key, _)) = other[index].clone().split_once(" =") {
                            other[index] = respelled(&other[index], key, convert);
                        }
                    }
                }
                false => other[at] = respelled(&lines[at], &spelling, convert),
            }
            let read_si = format!("{:?}", read(&other.join("\n")).unwrap());
            assert!(read_si == expected, "{header} {spelling}");
            if table.is_none() {
                other.insert(at, lines[at].clone());
                let said = read(&other.join("\n")).unwrap_err();
                assert!(said.contains(&spelling), "{said}");
                assert!(
                    said.contains("one spelling of a quantity, but line"),
                    "{said}"
                );
            }
            checked += 1;
        }
    }
    checked
}

fn source(path: &str, text: &str) -> Source {
    Source {
        path: path.into(),
        text: text.to_owned(),
    }
}

fn read_sweep(text: &str, vehicle: &str) -> Result<Sweep, String> {
    let sources = [source("s.toml", text), source("v.toml", vehicle)];
    let sweep = Sweep::read_from(Path::new("s.toml"), Library::Copies(&sources));
    sweep.map_err(|error| error.to_string())
}

const SCENE: &str = "vehicle = \"v.toml\"\n[scene]\nvertical_velocity_fps = 14\nhorizontal_velocity_fps = 11\n\
     cross_slope_deg = 170\nslope_deg = 15\nfriction = 1\n";
const EULER: &str = "pitch_deg = 2\nyaw_deg = -3\nroll_deg = 5\nangular_velocity_x_dps = 1\n\
     angular_velocity_y_dps = 2\nangular_velocity_z_dps = -3\n";
const TIP: &str = "tip_deg = 9\ntip_azimuth_deg = 30\nnominal_roll_deg = 4\n";
const LIMITS: &str = "[solver]\nmethod = \"report\"\n[solver.error_per_second]\n";
const MAP: &str = "title = \"Map\"\nvehicle = \"v.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
     cross_slope_deg = 180\nslope_deg = 15\n[axes]\nroll_deg = [0, 10, 20]\nfriction = [0.5, 1]\n\
     [map]\nedge_width = { roll_deg = 1, friction = 0.1 }\nerror_fps = 0.1\njump_fps = 0.5\n\
     [search]\nfrom_fps = 1\nto_fps = 20\nscan_step_fps = 0.25\ntolerance_fps = 0.001\n";

#[test]
fn every_key_with_a_unit_is_read_in_si() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("v.toml"), SURVEYOR).unwrap();
    let surveyor = VehicleFile::read(&path("v.toml")).unwrap();
    let settings = Settings::new(1e-5, 20.0, CrushRule::default()).unwrap();
    let vehicle = |text: &str| {
        std::fs::write(path("w.toml"), text).unwrap();
        let file = VehicleFile::read(&path("w.toml")).map_err(|error| error.to_string())?;
        Ok(file.vehicle)
    };
    let scene = |text: &str| {
        std::fs::write(path("s.toml"), text).unwrap();
        let file = scene_file::read(&path("s.toml")).map_err(|error| error.to_string())?;
        Ok((file.cases[0].scene, file.cases[0].settings))
    };
    let map = |text: &str| {
        let sweep = read_sweep(text, SURVEYOR)?;
        let rules = sweep.map().map(|map| map.rules);
        Ok((*sweep.search().unwrap(), rules))
    };
    let row = |text: &str| {
        // Lines of keys and values turned into a table.
        let cells = text.lines().map(|line| line.split_once(" = ").unwrap());
        let (heading, row): (Vec<&str>, Vec<&str>) = cells.unzip();
        let table = format!("{}\n{}\n", heading.join(","), row.join(","));
        std::fs::write(path("c.csv"), table).unwrap();
        let read = cases::read(&path("c.csv"), &surveyor, &settings);
        let said = |error: String| {
            error.replace(
                "expected one spelling of a quantity",
                "one spelling of a quantity, but line",
            )
        };
        let table = read.map_err(|error| said(error.to_string()))?;
        Ok(table.case(0).unwrap().scene)
    };
    let mut checked = 0;
    for table in tables() {
        let keys = |wanted: &dyn Fn(&str) -> bool| -> Vec<&'static str> {
            let keys = table.keys.iter().copied();
            keys.filter(|key| wanted(key)).collect()
        };
        let all = &table.keys[..];
        let is_tip = |key: &str| key.contains("tip_") || key.contains("nominal_");
        checked += match table.name {
            "vehicle" => check(SURVEYOR, "", all, &vehicle),
            "vehicle.linkage" => {
                let foot = keys(&|key| CANTILEVER.contains(&format!("\n{key} = ")));
                let hinged = keys(&|key| !foot.contains(&key));
                check(SURVEYOR, "[linkage]", &hinged, &vehicle)
                    + check(&cantilever(), "[linkage]", &foot, &vehicle)
            }
            "vehicle.secondary" => {
                let of_primary = keys(&|key| key != "hardpoint_spread_ft");
                check(&cantilever(), "[primary]", &of_primary, &vehicle)
                    + check(&cantilever(), "[secondary]", all, &vehicle)
            }
            "vehicle.strut" => {
                let cartridge = keys(&|key| HONEYCOMB.contains(&format!("\n{key} = ")));
                let damper = keys(&|key| !key.starts_with("unloading"));
                check(SURVEYOR, "[strut]", &damper, &vehicle)
                    + check(&honeycomb(), "[strut]", &cartridge, &vehicle)
            }
            "vehicle.strut.crush_load" => check(&honeycomb(), "[strut.crush_load]", all, &vehicle),
            "vehicle.strut.profile" => check(SURVEYOR, "[strut.damping_profile]", all, &vehicle),
            "vehicle.footpad" => {
                let edge = "[footpad]\nedge_angle_deg = 65\nedge_load_lb = 187\n";
                let text = SURVEYOR.replacen("[footpad]\n", edge, 1);
                check(&text, "[footpad]", all, &vehicle)
            }
            "vehicle.block" => check(SURVEYOR, "[block]", all, &vehicle),
            "vehicle.profile" => check(SURVEYOR, "[footpad.profile]", all, &vehicle),
            "vehicle.legs" => check(SURVEYOR, "[[legs]]", all, &vehicle),
            "scene" => {
                let euler = keys(&|key| !is_tip(key));
                check(&format!("{SCENE}{EULER}"), "[scene]", &euler, &scene)
                    + check(&format!("{SCENE}{TIP}"), "[scene]", &keys(&is_tip), &scene)
            }
            "scene.thrust" => {
                let text = format!(
                    "{SCENE}[scene.thrust]\ntime_s = [0, 0.5]\nforce_lb = [80, 0]\nscale = 0.5\n"
                );
                check(&text, "[scene.thrust]", all, &scene)
            }
            "scene.soil" => {
                let text = format!(
                    "{SCENE}[scene.soil]\nbearing_strength_psf = 800\nbearing_depth_ft = 0.15\nrebound = 0.01\n"
                );
                check(&text, "[scene.soil]", all, &scene)
            }
            "scene.footing" => {
                let text = format!("{SCENE}[[scene.footing]]\n");
                check(&text, "[[scene.footing]]", all, &scene)
            }
            "map" => check(MAP, "[map]", all, &map),
            "search" => check(MAP, "[search]", all, &map),
            "solver.error_per_second" => {
                let header = "[solver.error_per_second]";
                check(&format!("{SCENE}{LIMITS}"), header, all, &scene)
            }
            "table of cases" => {
                let lines = SCENE.split_once("[scene]\n").unwrap().1;
                check(lines, "", all, &row)
            }
            other => {
                let units: Vec<&str> = all.iter().map(|key| unit(key)).collect();
                let is_unitless = |unit: &&str| ["1", "s"].contains(unit);
                assert!(units.iter().all(is_unitless), "{other} is not checked");
                0
            }
        };
    }
    assert!(checked > 80, "{checked}");
}

const US: &str = "title = \"Downhill\"\nvehicle = \"v.toml\"\n[scene]\nvertical_velocity_fps = 14\n\
     cross_slope_deg = 180\nslope_deg = 15\nfriction = 1\n[axes]\nroll_deg = [-30, 0, 30]\n\
     [search]\nfrom_fps = 10\nto_fps = 14\nscan_step_fps = 0.25\ntolerance_fps = 0.001\n";
const SI: &str = "title = \"Downhill\"\nvehicle = \"v.toml\"\n[scene]\nvertical_velocity_mps = 4.2672\n\
     cross_slope_rad = 3.141592653589793\nslope_rad = 0.2617993877991494\nfriction = 1\n[axes]\n\
     roll_rad = [-0.5235987755982988, 0, 0.5235987755982988]\n\
     [search]\nfrom_mps = 3.048\nto_mps = 4.2672\nscan_step_mps = 0.0762\ntolerance_mps = 0.0003048\n";

fn boundaries(sweep: &Sweep) -> Vec<Boundary> {
    let points: Vec<usize> = (0..sweep.design.count()).collect();
    let found = Workers::start(None)
        .unwrap()
        .points(sweep, &points)
        .unwrap();
    let boundary = |finding: Finding| match finding {
        Finding::Boundary(boundary) => boundary,
        other => panic!("{other:?}"),
    };
    found.into_iter().map(boundary).collect()
}

#[test]
fn a_sweep_in_si_finds_the_same_transitions() {
    let us = boundaries(&read_sweep(US, SURVEYOR).unwrap());
    let si = read_sweep(SI, SURVEYOR_SI).unwrap();
    for (us, si) in us.iter().zip(boundaries(&si)) {
        let speed = |boundary: &Boundary| boundary.transition.unwrap().speed();
        let (us, si) = (speed(us), speed(&si));
        assert!((us - si).abs() <= 1e-9 * us, "{us} {si}");
    }
    // Axes are told as they were asked for.
    assert_eq!(si.headings([])[0].name, "roll_rad");
    assert_eq!(si.cells_of_point(2), [Cell::Number(0.5235987755982988)]);
}

#[test]
fn records_tell_the_vehicle_in_the_units_of_the_program() {
    let [us, si] = [(US, SURVEYOR), (SI, SURVEYOR_SI)].map(|(text, vehicle)| {
        let mut input = read_sweep(text, vehicle).unwrap().resolved();
        input["vehicle"]["name"].take();
        input["axes"].take();
        input
    });
    assert_eq!(us, si);
}

#[test]
fn derivatives_are_told_in_the_unit_of_their_parameter() {
    let slopes = |parameters: [&str; 2]| {
        let overrides = Overrides {
            sensitivity: parameters.map(str::to_owned).to_vec(),
            ..Overrides::default()
        };
        let text = US.replace("[-30, 0, 30]", "[5]");
        let sweep = read_sweep(&text, SURVEYOR)
            .unwrap()
            .with(&overrides)
            .unwrap();
        let values = [0, 1].map(|index| sweep.value(0, &sweep.sensitivity[index]).unwrap());
        let found = Workers::start(None).unwrap().points(&sweep, &[0]).unwrap();
        let Finding::Sensitive { sensitivity, .. } = &found[0] else {
            panic!("{found:?}");
        };
        let derivative = |index: usize| match sensitivity.slopes[index].dependence {
            Dependence::Smooth { derivative, .. } => derivative,
            other => panic!("{other:?}"),
        };
        (values, [derivative(0), derivative(1)])
    };
    let (values, us) = slopes(["vehicle.strut.preload_lb", "roll_deg"]);
    let (values_si, si) = slopes(["vehicle.strut.preload_n", "roll_rad"]);
    assert_eq!(values, [185.0, 5.0]);
    let near = |one: f64, other: f64, part: f64| (one - other).abs() <= part * other.abs();
    for (index, per_unit) in [POUND, PI / 180.0].into_iter().enumerate() {
        assert!(near(values_si[index], values[index] * per_unit, 1e-15));
        assert!(near(si[index], us[index] / per_unit, 1e-6), "{us:?} {si:?}");
    }
}

#[test]
fn a_sweep_in_si_goes_on_from_its_journal() {
    let overrides = Overrides {
        set: vec![SetValue::parse("vehicle.strut.preload_n=890").unwrap()],
        ..Overrides::default()
    };
    let sweep = read_sweep(SI, SURVEYOR_SI)
        .unwrap()
        .with(&overrides)
        .unwrap();
    let preload = |sweep: &Sweep| {
        sweep.case(0).unwrap().vehicle.hinged_legs()[0]
            .design()
            .strut
            .damper()
            .unwrap()
            .preload
    };
    assert!((preload(&sweep) - 890.0 / POUND).abs() < 1e-12);
    let header = Header::new(&sweep, "test", Shard::WHOLE).unwrap();
    let again = header.sweep().unwrap().unwrap();
    assert_eq!(preload(&again), preload(&sweep));
    let of_again = Header::new(&again, "test", Shard::WHOLE).unwrap();
    assert_eq!(header.differences(&of_again), Vec::<String>::new());
}

#[test]
fn samples_in_si_are_drawn_in_si_and_landed_in_feet() {
    let (scene, _) = US.split_once("[axes]").unwrap();
    let text = format!(
        "{}[axes]\nhorizontal_velocity_mps = {{ from = 1, to = 2 }}\n\
         vehicle.mass_kg = {{ mean = 300, sd = 10 }}\n[sample]\ndesign = \"sobol\"\ncount = 8\nseed = 1\n",
        scene.replace("[scene]", "job = \"outcome\"\n[scene]")
    );
    let sweep = read_sweep(&text, SURVEYOR).unwrap();
    for point in 0..8 {
        let [speed, mass] = sweep.design.coordinates(point)[..] else {
            panic!("two axes");
        };
        assert!((1.0..=2.0).contains(&speed) && (200.0..400.0).contains(&mass));
        let case = sweep.case(point).unwrap();
        let landed = case.scene.conditions().horizontal_velocity;
        assert!((landed * FOOT / speed - 1.0).abs() < 1e-15);
        assert!((case.vehicle.mass() * POUND / FOOT / mass - 1.0).abs() < 1e-15);
    }
}

#[test]
fn complaints_about_axes_have_their_unit() {
    let said = |from: &str, to: &str| read_sweep(&SI.replace(from, to), SURVEYOR).unwrap_err();
    let both = said("friction = 1\n", "friction = 1\nroll_deg = 3\n");
    assert!(
        both.contains("axes.roll_rad") && both.contains("also in [scene]"),
        "{both}"
    );
    let twice = said("[axes]\n", "[axes]\nroll_deg = [1]\n");
    assert!(
        twice.contains("axes.roll_rad") && twice.contains("varies twice"),
        "{twice}"
    );
    let steep = said("slope_rad = 0.2617993877991494", "").replace("s.toml", "");
    assert!(steep.contains("slope_deg is missing"), "{steep}");
    let steep = said(
        "roll_rad = [-0.5235987755982988, 0, 0.5235987755982988]",
        "pitch_rad = [1000]",
    );
    assert!(
        steep.contains("includes 1000: expected -36000 ≤ value ≤ 36000 (in deg: this is 57295.8)"),
        "{steep}"
    );
    let light = said("[axes]\n", "[axes]\nvehicle.mass_kg = [-5]\n");
    assert!(
        light.contains("at vehicle.mass_kg = -5: v.toml:4: mass_slug = -0.34"),
        "{light}"
    );
}
