use touchdown_dynamics::vehicle::StrutElement;

use super::*;

const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");

fn read(text: &str) -> Result<VehicleFile, InputError> {
    VehicleFile::from_document(Document::parse(Path::new("v.toml"), text)?)
}

/// The Surveyor of Table 4-1.
pub(crate) fn surveyor() -> VehicleFile {
    read(SURVEYOR).unwrap()
}

#[test]
fn the_surveyor_is_read_in_feet_and_radians() {
    let file = read(SURVEYOR).unwrap();
    assert_eq!(file.name, "Surveyor, Table 4-1");
    assert_eq!(file.vehicle.mass(), 20.0);
    assert_eq!(file.vehicle.inertia()[(0, 1)], -6.81);
    let leg = &file.vehicle.hinged_legs()[1];
    assert_eq!(leg.design().azimuth, 120f64.to_radians());
    assert_eq!(
        leg.design().strut.damper().unwrap().spring_profile.knots()[19],
        [6.5 / 12.0, 1.447]
    );
    assert!((leg.extended_angle().to_degrees() - 17.9978).abs() < 1e-4);
}

#[test]
fn a_leg_may_differ_in_anything_its_tables_included() {
    let text = format!(
        "{SURVEYOR}[legs.strut]\ncompression_damping = 60\n\
         [legs.footpad.profile]\ninterference_in = [0, 1]\nrelative_pressure = [0, 2]\n"
    );
    let vehicle = read(&text).unwrap().vehicle;
    let [first, _, last] = vehicle.hinged_legs() else {
        panic!("three legs");
    };
    assert_eq!(
        first.design().strut.damper().unwrap().compression_damping,
        54.0
    );
    assert_eq!(
        last.design().strut.damper().unwrap().compression_damping,
        60.0
    );
    assert_eq!(last.design().strut.damper().unwrap().rebound_damping, 864.0);
    assert_eq!(
        last.design().footpad.profile.knots(),
        [[0.0, 0.0], [1.0 / 12.0, 2.0]]
    );
    assert_eq!(first.design().footpad.profile.knots().len(), 14);
}

#[test]
fn a_scale_multiplies_the_ordinates_of_a_table_for_all_legs_or_one() {
    let scaled = |text: &str| SURVEYOR.replace("[footpad.profile]", text);
    let vehicle = read(&scaled("[footpad.profile]\nscale = 2"))
        .unwrap()
        .vehicle;
    let knots = vehicle.hinged_legs()[0].design().footpad.profile.knots();
    assert_eq!(knots[1], [0.1 / 12.0, 0.936]);
    let own = format!("{SURVEYOR}[legs.footpad.profile]\nscale = 3\n");
    let vehicle = read(&own).unwrap().vehicle;
    let pressure = |leg: usize| vehicle.hinged_legs()[leg].design().footpad.profile.knots()[9][1];
    assert_eq!((pressure(0), pressure(2)), (1.0, 3.0));
    let complaint = read(&scaled("[footpad.profile]\nscale = 0")).unwrap_err();
    assert!(
        complaint
            .to_string()
            .contains("footpad.profile.scale = 0: expected 0 < value")
    );
}

#[test]
fn the_center_of_gravity_is_on_the_centreline_unless_the_file_says_otherwise() {
    let offset = |text: &str| read(text).unwrap().vehicle.center_of_gravity_offset();
    assert_eq!(offset(SURVEYOR), [0.0, 0.0]);
    let key = "center_of_gravity_offset_y_ft";
    let aside = SURVEYOR.replace(
        "[inertia_slug_ft2]",
        &format!("{key} = -0.25\n[inertia_slug_ft2]"),
    );
    assert_eq!(offset(&aside), [0.0, -0.25]);
    let value = |text: &str| {
        let document = Document::parse(Path::new("v.toml"), text).unwrap();
        number(&document, &KeyPath::parse(key).unwrap())
    };
    assert_eq!((value(SURVEYOR), value(&aside)), (Some(0.0), Some(-0.25)));
}

#[test]
fn every_number_has_a_name() {
    let mut document = Document::parse(Path::new("v.toml"), SURVEYOR).unwrap();
    for (name, _) in numbers(3) {
        let path = KeyPath::parse(&name).unwrap();
        assert!(document.write(&path, Value::Number(0.5)), "{name}");
    }
    // Nothing was added that a vehicle file does not know.
    let complaint = VehicleFile::from_document(document).unwrap_err();
    assert!(
        !complaint.to_string().contains("unknown key"),
        "{complaint}"
    );
}

#[test]
fn the_surveyor_in_si_is_the_surveyor() {
    const SI: &str = include_str!("../../../../sweeps/vehicles/surveyor-si.toml");
    // Nothing in it has a unit of 1966.
    let document = Document::parse(Path::new("v.toml"), SI).unwrap();
    let numbers: Vec<String> = numbers(3).into_iter().map(|(name, _)| name).collect();
    for name in numbers.iter().filter(|name| !name.starts_with("legs[")) {
        let unit = crate::documents::unit::unit(&format!("vehicle.{name}"));
        let is_there = |step: &str| SI.contains(&format!("{step} = "));
        let key = name.rsplit('.').next().unwrap();
        assert!(unit == "1" || key.len() == 2 || !is_there(key), "{name}");
    }
    // Keys of honeycomb struts, of pads on their edges and of hinges with damping, which the Surveyor does not have.
    const OPTIONAL: [&str; 4] = [
        "hinge_damping_ftlb_s",
        "unloading_stiffness_lb_per_ft",
        "edge_angle_deg",
        "edge_load_lb",
    ];
    let of_three_struts: Vec<String> = three_struts::own_numbers().map(|(name, _)| name).collect();
    let optional = || {
        OPTIONAL
            .into_iter()
            .chain(of_three_struts.iter().map(String::as_str))
    };
    let si = VehicleFile::from_document(document).unwrap();
    let us = read(SURVEYOR).unwrap();
    assert_eq!(si.vehicle, us.vehicle);
    for name in numbers {
        let path = KeyPath::parse(&name).unwrap();
        let [si, us] = [&si, &us].map(|file| number(&file.document, &path));
        assert_eq!(si, us, "{name}");
        assert!(
            si.is_some() || optional().any(|key| name.ends_with(key)),
            "{name}"
        );
    }
}

#[test]
fn one_leg_may_have_other_units_than_the_rest() {
    let text = format!("{SURVEYOR}[legs.strut]\npreload_n = 444.82216152605\n");
    let vehicle = read(&text).unwrap().vehicle;
    let preload = |leg: usize| {
        vehicle.hinged_legs()[leg]
            .design()
            .strut
            .damper()
            .unwrap()
            .preload
    };
    assert_eq!((preload(0), preload(2)), (185.0, 100.0));
}

/// Replaced text of the Surveyor's file, its replacement, and text that the error must contain.
const WRONG: [(&str, &str, &[&str]); 28] = [
    (
        "mass_slug = 20",
        "mass_slug = -20",
        &["v.toml:4: mass_slug = -20", "0 < value ≤ 1e9"],
    ),
    (
        "mass_slug = 20",
        "mass_lb = 640",
        &[
            "v.toml:4: mass_lb = 640: unknown key",
            "did you mean mass_slug or mass_kg?",
        ],
    ),
    (
        "mass_slug = 20",
        "mass_slug = 20\nmass_kg = 292",
        &[
            "v.toml:5: mass_kg = 292: expected one spelling of a quantity, but line 4 says mass_slug",
        ],
    ),
    (
        "mass_slug = 20",
        "mass_kg = -292",
        &["v.toml:4: mass_kg = -292: expected 0 < value ≤ 1e9 (in slug: this is -20.0084)"],
    ),
    (
        "mass_slug = 20",
        "mass_kg = \"292\"",
        &["v.toml:4: mass_kg = \"292\": expected a number"],
    ),
    (
        "stroke_in = [0, 0.25, 0.5",
        "stroke_mm = [0, 12.7, 6.35",
        &[
            "v.toml:35: strut.spring_profile.stroke_mm[3] = 6.35",
            "increasing order (in inch: this is 0.25)",
        ],
    ),
    (
        "[strut]",
        "[strut]\nkind = \"foam\"",
        &["v.toml:24: strut.kind = \"foam\": expected \"damper\" or \"honeycomb\""],
    ),
    (
        "[strut]",
        "[strut]\nkind = \"honeycomb\"",
        &[
            "v.toml:27: strut.structural_stiffness_lb_per_ft",
            "only struts of kind \"damper\" have this, and this one is of kind \"honeycomb\"",
        ],
    ),
    (
        "[strut]",
        "[strut]\nunloading_stiffness_lb_per_ft = 1e5",
        &[
            "v.toml:24: strut.unloading_stiffness_lb_per_ft",
            "only struts of kind \"honeycomb\" have this, and this one is of kind \"damper\"",
        ],
    ),
    (
        "azimuth_deg = 120",
        "azimuth_deg = 120\nblock = \"no\"",
        &["legs[2].block = \"no\": expected a table [block], or \"none\""],
    ),
    ("mass_slug = 20", "", &["mass_slug is missing"]),
    (
        "mass_slug = 20",
        "mass_slug = \"20\"",
        &["v.toml:4: mass_slug = \"20\"", "a number"],
    ),
    (
        "xx = 138.12",
        "xx = 0.2",
        &["v.toml:8: inertia_slug_ft2 (least principal moment)"],
    ),
    (
        "[inertia_slug_ft2]",
        "center_of_gravity_offset_x_ft = 5\ncenter_of_gravity_offset_y_ft = 0.5\n[inertia_slug_ft2]",
        &[
            "v.toml:8: center_of_gravity_offset_x_ft = 5: expected -3.4048 < value < 3.4048",
            "over the polygon of the feet at center_of_gravity_offset_y_ft = 0.5",
        ],
    ),
    (
        "[inertia_slug_ft2]",
        "center_of_gravity_offset_x_ft = 4\ncenter_of_gravity_offset_y_ft = -3.6\n[inertia_slug_ft2]",
        &["v.toml:9: center_of_gravity_offset_y_ft = -3.6: expected -3.1987 < value < 6.3974"],
    ),
    (
        "[inertia_slug_ft2]",
        "center_of_gravity_offset_y_ft = -3.4\n[inertia_slug_ft2]",
        &["v.toml:8: center_of_gravity_offset_y_ft = -3.4: expected -3.1987 < value < 6.3974"],
    ),
    (
        "[inertia_slug_ft2]",
        "center_of_gravity_offset_x_in = 1\n[inertia_slug_ft2]",
        &[
            "v.toml:8: center_of_gravity_offset_x_in = 1",
            "did you mean center_of_gravity_offset_x_ft or center_of_gravity_offset_x_m or",
        ],
    ),
    (
        "preload_lb = 185",
        "preload_lb = 0",
        &["v.toml:27: strut.preload_lb = 0"],
    ),
    (
        "stroke_in = [0, 0.25, 0.5",
        "stroke_in = [0, 0.5, 0.25",
        &[
            "v.toml:35: strut.spring_profile.stroke_in[3] = 0.25",
            "increasing",
        ],
    ),
    (
        "interference_in = [0, 0.1, 5.75, 7.75]",
        "interference_in = [0, 0.1, 5.75]",
        &[
            "block.profile.relative_pressure",
            "as many as in interference_in, 3",
        ],
    ),
    (
        "relative_pressure = [0, 1, 1, 21]",
        "relative_pressure = [0, 1, -1, 21]",
        &["block.profile.relative_pressure[3] = -1"],
    ),
    (
        "relative_pressure = [0, 1, 1, 21]",
        "relative_pressure = [0, 1, 0.5, 21]",
        &[
            "v.toml:62: block.profile.relative_pressure[3] = 0.5: expected 1 ≤ value ≤ 57.5",
            "no segment falls",
        ],
    ),
    (
        "relative_pressure = [0, 1, 1, 21]",
        "relative_pressure = [0, 1, 1, 21.5]",
        &[
            "block.profile.relative_pressure[4] = 21.5: expected 1 ≤ value ≤ 21.0",
            "none is steeper than the first",
        ],
    ),
    (
        "relative_pressure = [0, 1, 1, 21]",
        "relative_pressure = [0.1, 1, 1, 21]",
        &["block.profile.relative_pressure[1] = 0.1: expected 0"],
    ),
    (
        "[block.profile]",
        "[block.profile]\nscale = 1e300",
        &["block.profile.scale = 1e300: expected 0 < value ≤ 1e9"],
    ),
    (
        "multiplier = [1, 1, 1",
        "multiplier = [1, 1, 1e200",
        &["strut.spring_profile.multiplier[3] = 1e200: expected 0 ≤ value ≤ 1e9"],
    ),
    (
        "[[legs]]\nazimuth_deg = 240",
        "",
        &["2 legs: expected", "three to eight tables [[legs]]"],
    ),
    (
        "azimuth_deg = 240",
        "azimuth_deg = 240\ncolour = 3",
        &["legs[3].colour = 3", "azimuth_deg"],
    ),
];

#[test]
fn complaints_name_line_key_value_and_what_is_allowed() {
    for (right, wrong, fragments) in WRONG {
        let text = SURVEYOR.replacen(right, wrong, 1);
        assert_ne!(text, SURVEYOR, "{right} is not in the file");
        let complaint = read(&text).unwrap_err().to_string();
        for fragment in fragments {
            assert!(complaint.contains(fragment), "{wrong}: {complaint}");
        }
    }
}

#[test]
fn too_short_a_table_is_refused() {
    let text = SURVEYOR
        .replace("[0, 0.1, 5.75, 7.75]", "[0]")
        .replace("[0, 1, 1, 21]", "[0]");
    let complaint = read(&text).unwrap_err().to_string();
    assert!(complaint.contains("block.profile.interference_in = [0]: expected at least two"));
}

/// The Surveyor with legs at these azimuths (deg), in this order.
fn with_legs(azimuths: [&str; 3]) -> Result<VehicleFile, InputError> {
    let (before, _) = SURVEYOR.split_once("[[legs]]").unwrap();
    let legs = azimuths.map(|azimuth| format!("[[legs]]\nazimuth_deg = {azimuth}\n"));
    read(&format!("{before}{}", legs.concat()))
}

#[test]
fn legs_keep_their_places_in_the_file() {
    let legs = |azimuths| {
        let vehicle = with_legs(azimuths).unwrap().vehicle;
        let azimuths = (vehicle.hinged_legs().iter())
            .map(|leg| leg.design().azimuth.to_degrees().round())
            .collect::<Vec<_>>();
        (azimuths, vehicle.ring().to_vec())
    };
    assert_eq!(
        legs(["0", "120", "240"]),
        (vec![0.0, 120.0, 240.0], vec![0, 1, 2])
    );
    assert_eq!(
        legs(["60", "-60", "180"]),
        (vec![60.0, -60.0, 180.0], vec![0, 2, 1])
    );
}

#[test]
fn vehicles_that_cannot_be_are_refused_where_they_say_so() {
    let said = |file: Result<VehicleFile, InputError>| file.unwrap_err().to_string();
    let twice = said(with_legs(["0", "120", "120"]));
    assert!(
        twice.contains("legs[3].azimuth_deg = 120: expected 1 deg or more"),
        "{twice}"
    );
    let turned = said(with_legs(["0", "120", "-240"]));
    assert!(
        turned.contains("legs[3].azimuth_deg = -240: expected 1 deg"),
        "{turned}"
    );
    let aside = said(with_legs(["0", "10", "20"]));
    assert!(
        aside.contains("less than 180 deg from the leg before it"),
        "{aside}"
    );
    // Two opposite ones and a third stand on a line.
    assert!(with_legs(["0", "90", "180"]).is_err());

    let slab = SURVEYOR.replace("xx = 138.12", "xx = 500");
    let slab = said(read(&slab));
    assert!(slab.contains("greatest principal moment) = 500"), "{slab}");
    assert!(slab.contains("at most the sum of the other two"), "{slab}");

    let (before, _) = SURVEYOR.rsplit_once("azimuth_deg").unwrap();
    let nowhere = said(read(before));
    let line = before.lines().count();
    assert!(
        nowhere.contains(&format!("v.toml:{line}: legs[3].azimuth_deg is missing")),
        "{nowhere}"
    );
}

/// The Surveyor with honeycomb struts that have this table.
fn with_cartridge(table: &str) -> Result<VehicleFile, InputError> {
    let (before, rest) = SURVEYOR.split_once("[strut]").unwrap();
    let (_, after) = rest.split_once("[footpad]").unwrap();
    read(&format!(
        "{before}[strut]\nkind = \"honeycomb\"\nextended_length_ft = 3.1275\n\
         minimum_length_ft = 2.7525\nfriction_fraction = 0.05\n\
         unloading_stiffness_n_per_m = 583756.11\n[strut.crush_load]\n{table}\n[footpad]{after}"
    ))
}

#[test]
fn struts_may_be_honeycomb_and_legs_may_have_no_block() {
    let table = "stroke_in = [0, 3, 3, 6]\nload_lb = [100, 100, 200, 220]\nscale = 2";
    let vehicle = with_cartridge(table).unwrap().vehicle;
    let StrutElement::Honeycomb(honeycomb) = &vehicle.hinged_legs()[2].design().strut.element
    else {
        panic!("a cartridge");
    };
    assert!((honeycomb.unloading_stiffness - 4e4).abs() < 1e-2);
    assert_eq!(
        honeycomb.crush_load.knots(),
        [[0.0, 200.0], [0.25, 200.0], [0.25, 400.0], [0.5, 440.0]]
    );
    let bare = format!("{SURVEYOR}block = \"none\"\n");
    let legs = read(&bare).unwrap().vehicle;
    let has_block: Vec<bool> = (legs.hinged_legs().iter())
        .map(|leg| leg.design().block.is_some())
        .collect();
    assert_eq!(has_block, [true, true, false]);
}

#[test]
fn tables_of_cartridges_that_mean_nothing_are_refused() {
    for (table, complaint) in [
        (
            "stroke_in = [0, 3]\nload_lb = [100, -1]",
            "load_lb[2] = -1: expected 0 ≤ value ≤ 1e9",
        ),
        (
            "stroke_in = [0, 3]\nload_lb = [0, 100]",
            "a load > 0 at stroke 0",
        ),
        (
            "stroke_in = [0, 3, 2]\nload_lb = [1, 1, 1]",
            "strokes that do not decrease",
        ),
        (
            "stroke_in = [0, 3, 3, 3]\nload_lb = [1, 1, 1, 1]",
            "at most two knots at one stroke",
        ),
        (
            "stroke_in = [0, 3]\nload_lb = [1]",
            "1 numbers: expected as many as strokes, 2",
        ),
        ("stroke_in = [1, 3]\nload_lb = [1, 1]", "first stroke 0"),
        ("load_lb = [1, 1]", "strut.crush_load.stroke_in is missing"),
    ] {
        let said = with_cartridge(table).unwrap_err().to_string();
        assert!(said.contains(complaint), "{said}");
    }
}
