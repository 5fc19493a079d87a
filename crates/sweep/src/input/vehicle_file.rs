//! Vehicle files: mass properties, and legs given once for all or one by one.

use std::path::Path;

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::parts::PadEdge;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::vehicle::{
    Block, Damper, Footpad, Honeycomb, Inertia, LEAST_LEGS, Leg, LegDesign, Linkage, Strut,
    StrutElement, Vehicle,
};

use crate::choice::chosen_by;
use crate::document::{Document, Value};
use crate::input_error::InputError;
use crate::key_path::KeyPath;
use crate::library::Library;
use crate::section::Section;
use crate::settings_input::RULES;
use crate::vehicle_tables::{LOAD, MULTIPLIER, PRESSURE, SCALE, crush_load, profile};

pub(crate) const VEHICLE: [&str; 13] = [
    "name",
    "rules",
    "mass_slug",
    "gravity_fps2",
    "center_of_gravity_height_ft",
    "center_of_gravity_offset_x_ft",
    "center_of_gravity_offset_y_ft",
    "inertia_slug_ft2",
    "linkage",
    "strut",
    "footpad",
    "block",
    "legs",
];
pub(crate) const INERTIA: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];
pub(crate) const LEG: [&str; 5] = ["azimuth_deg", "linkage", "strut", "footpad", "block"];
pub(crate) const LINKAGE: [&str; 5] = [
    "lower_hardpoint_radius_ft",
    "lower_link_length_ft",
    "hardpoint_distance_ft",
    "hardpoint_angle_deg",
    "inertia_slug_ft2",
];
/// Keys of struts of every kind.
const STRUT: [&str; 4] = [
    "kind",
    "extended_length_ft",
    "minimum_length_ft",
    "friction_fraction",
];
/// Kinds of struts, each with the keys that only it has. The first is the default.
pub(crate) const STRUT_KINDS: [(&str, &[&str]); 2] =
    [("damper", &DAMPER), ("honeycomb", &HONEYCOMB)];
const DAMPER: [&str; 8] = [
    "structural_stiffness_lb_per_ft",
    "preload_lb",
    "spring_constant_lb_per_ft",
    "compression_damping",
    "rebound_damping",
    "rebound_growth_per_ft",
    "spring_profile",
    "damping_profile",
];
const HONEYCOMB: [&str; 2] = ["unloading_stiffness_lb_per_ft", "crush_load"];
pub(crate) const FOOTPAD: [&str; 10] = [
    "diameter_ft",
    "height_ft",
    "crush_pressure_psf",
    "inertia_slug_ft2",
    "hinge_damping_ftlb_s",
    "minimum_angle_deg",
    "maximum_angle_deg",
    "profile",
    EDGE[0],
    EDGE[1],
];
/// Load capacity of a footpad that has turned over; both keys or none.
const EDGE: [&str; 2] = ["edge_angle_deg", "edge_load_lb"];
pub(crate) const BLOCK: [&str; 5] = [
    "radius_ft",
    "height_ft",
    "diameter_ft",
    "crush_pressure_psf",
    "profile",
];
/// The keys of all tables.
pub(crate) const KEYS: [&[&str]; 12] = [
    &VEHICLE,
    &INERTIA,
    &LEG,
    &LINKAGE,
    &STRUT,
    &DAMPER,
    &HONEYCOMB,
    &FOOTPAD,
    &BLOCK,
    &MULTIPLIER,
    &PRESSURE,
    &LOAD,
];
/// Offset of the CG from the centreline; 0 if missing.
const OFFSET: [&str; 2] = [
    "center_of_gravity_offset_x_ft",
    "center_of_gravity_offset_y_ft",
];
/// Tables of a strut, footpad or block.
const TABLES: [&str; 4] = ["spring_profile", "damping_profile", "profile", "crush_load"];
/// Word in place of a table `[block]` for a leg without a block.
const NO_BLOCK: &str = "none";
/// Keys of a table [strut] of any kind.
pub(crate) fn strut_keys() -> Vec<&'static str> {
    [&STRUT[..], &DAMPER, &HONEYCOMB].concat()
}

/// Dotted names of all numbers of a vehicle file with `legs` legs; tables count by their scales.
pub(crate) fn numbers(legs: usize) -> Vec<String> {
    let parts: [(&str, &[&str]); 4] = [
        ("linkage", &LINKAGE),
        ("strut", &strut_keys()),
        ("footpad", &FOOTPAD),
        ("block", &BLOCK),
    ];
    let of_a_leg = parts.iter().flat_map(|(part, keys)| {
        let numbers = keys.iter().filter(|key| **key != "kind");
        numbers.map(move |key| match TABLES.contains(key) {
            true => format!("{part}.{key}.{SCALE}"),
            false => format!("{part}.{key}"),
        })
    });
    let of_a_leg: Vec<String> = of_a_leg.collect();
    let own = (1..=legs).flat_map(|leg| {
        std::iter::once("azimuth_deg")
            .chain(of_a_leg.iter().map(String::as_str))
            .map(move |key| format!("legs[{leg}].{key}"))
    });
    let body = ["mass_slug", "gravity_fps2", "center_of_gravity_height_ft"].into_iter();
    body.chain(OFFSET)
        .map(str::to_owned)
        .chain(INERTIA.map(|key| format!("inertia_slug_ft2.{key}")))
        .chain(of_a_leg.iter().cloned())
        .chain(own)
        .collect()
}

/// Finds the number of a vehicle file under a dotted key: a leg's own, else that for all legs. If missing, the scale of
/// a table is 1 and the offset of the CG 0.
pub fn number(document: &Document, path: &KeyPath) -> Option<f64> {
    let of_all = || document.number(&path.of_all_legs()?);
    let by_default = || match path.steps.last()?.key.as_str() {
        SCALE => Some(1.0),
        key if OFFSET.contains(&key) => Some(0.0),
        _ => None,
    };
    document.number(path).or_else(of_all).or_else(by_default)
}

/// Number of legs in the document of a vehicle, clamped to the possible range.
pub(crate) fn leg_count(document: &Document) -> usize {
    let legs = document.root().iter().find(|entry| entry.key == "legs");
    let count = legs.map_or(0, |entry| match &entry.node.value {
        Value::List(legs) => legs.len(),
        _ => 0,
    });
    count.clamp(LEAST_LEGS, MOST_LEGS)
}

/// Writes the value of a parameter `name` into the document of a vehicle.
///
/// # Errors
/// If the vehicle has no such leg.
pub(crate) fn write(
    document: &mut Document,
    name: &str,
    path: &KeyPath,
    value: Value,
) -> Result<(), InputError> {
    match document.write(path, value) {
        true => Ok(()),
        false => Err(InputError::other(format!(
            "{name}: the vehicle has {} legs",
            leg_count(document)
        ))),
    }
}

/// A vehicle and its file.
#[derive(Debug, Clone)]
pub struct VehicleFile {
    /// The file as read.
    pub document: Document,
    /// Name of the vehicle in the file.
    pub name: String,
    /// The vehicle.
    pub vehicle: Vehicle,
}

impl VehicleFile {
    /// Reads a vehicle.
    ///
    /// # Errors
    /// Names file, line, key and value of the first fault, and the allowed values.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::read_from(path, Library::Disk)
    }

    /// Reads a vehicle from a library.
    ///
    /// # Errors
    /// As [`VehicleFile::read`].
    pub fn read_from(path: &Path, library: Library) -> Result<Self, InputError> {
        Self::from_document(library.document(path)?)
    }

    /// Builds the vehicle of a document.
    ///
    /// # Errors
    /// As [`VehicleFile::read`].
    pub fn from_document(document: Document) -> Result<Self, InputError> {
        let root = Section::root(&document, &VEHICLE)?;
        let name = root.text("name")?.to_owned();
        let entries = root.sections("legs", &LEG)?;
        let legs: Vec<Leg> = entries
            .iter()
            .map(|entry| leg(entry, &entry.over(&root)))
            .collect::<Result<_, _>>()?;
        if !(LEAST_LEGS..=MOST_LEGS).contains(&legs.len()) {
            let allowed = "three to eight tables [[legs]], one for each leg";
            return Err(match root.optional("legs") {
                Some(found) => {
                    found.complain_that(&format!("{} legs: expected {allowed}", legs.len()))
                }
                None => root.missing("legs", allowed),
            });
        }
        let rules = (root.optional("rules"))
            .map_or(Ok(Rules::PHYSICAL), |word| chosen_by(&word, &RULES))?;
        let [x, y] = OFFSET.map(|key| root.optional_number(key));
        let offset = [x?.unwrap_or(0.0), y?.unwrap_or(0.0)];
        let vehicle = Vehicle::new(
            root.number("mass_slug")?,
            root.number("gravity_fps2")?,
            root.number("center_of_gravity_height_ft")?,
            inertia(&root.section("inertia_slug_ft2", &INERTIA)?)?,
            legs,
        )
        .and_then(|vehicle| vehicle.with_center_of_gravity_offset(offset))
        .map(|vehicle| vehicle.with_rules(rules))
        .map_err(|invalid| match of_a_leg(&invalid) {
            Some((leg, invalid)) if leg < entries.len() => entries[leg].complain(&invalid),
            _ => root.complain(&invalid),
        })?;
        Ok(Self {
            document,
            name,
            vehicle,
        })
    }
}

/// Index of the leg that an error is about, from 0, and the error in terms of its table.
fn of_a_leg(invalid: &Invalid) -> Option<(usize, Invalid)> {
    let (number, key) = invalid.quantity.strip_prefix("legs[")?.split_once("].")?;
    let leg = number.parse::<usize>().ok()?.checked_sub(1)?;
    Some((leg, Invalid::new(key, invalid.value, &*invalid.allowed)))
}

fn inertia(section: &Section) -> Result<Inertia, InputError> {
    Ok(Inertia {
        xx: section.number("xx")?,
        yy: section.number("yy")?,
        zz: section.number("zz")?,
        xy: section.number("xy")?,
        xz: section.number("xz")?,
        yz: section.number("yz")?,
    })
}

/// Builds a leg from its own table, and from `entry`: its own table on top of the values for all legs.
fn leg(own: &Section, entry: &Section) -> Result<Leg, InputError> {
    let design = LegDesign {
        azimuth: own.number("azimuth_deg")?.to_radians(),
        linkage: linkage(&entry.section("linkage", &LINKAGE)?)?,
        strut: strut(&entry.section("strut", &strut_keys())?)?,
        footpad: footpad(&entry.section("footpad", &FOOTPAD)?)?,
        block: block(entry)?,
    };
    Leg::new(design).map_err(|invalid| entry.complain(&invalid))
}

fn linkage(section: &Section) -> Result<Linkage, InputError> {
    Ok(Linkage {
        lower_hardpoint_radius: section.number("lower_hardpoint_radius_ft")?,
        lower_link_length: section.number("lower_link_length_ft")?,
        hardpoint_distance: section.number("hardpoint_distance_ft")?,
        hardpoint_angle: section.number("hardpoint_angle_deg")?.to_radians(),
        inertia: section.number("inertia_slug_ft2")?,
    })
}

fn strut(section: &Section) -> Result<Strut, InputError> {
    let kind = match section.optional("kind") {
        None => STRUT_KINDS[0].0,
        Some(found) => chosen_by(&found, &STRUT_KINDS.map(|(kind, _)| (kind, kind)))?,
    };
    for (other, keys) in STRUT_KINDS.iter().filter(|(other, _)| *other != kind) {
        if let Some(found) = keys.iter().find_map(|key| section.optional(key)) {
            return Err(found.complain_that(&format!(
                "only struts of kind \"{other}\" have this, and this one is of kind \"{kind}\""
            )));
        }
    }
    Ok(Strut {
        extended_length: section.number("extended_length_ft")?,
        minimum_length: section.number("minimum_length_ft")?,
        friction_fraction: section.number("friction_fraction")?,
        element: match kind {
            "honeycomb" => StrutElement::Honeycomb(Honeycomb {
                unloading_stiffness: section.number("unloading_stiffness_lb_per_ft")?,
                crush_load: crush_load(section)?,
            }),
            _ => StrutElement::Damper(damper(section)?),
        },
    })
}

fn damper(section: &Section) -> Result<Damper, InputError> {
    Ok(Damper {
        structural_stiffness: section.number("structural_stiffness_lb_per_ft")?,
        preload: section.number("preload_lb")?,
        spring_constant: section.number("spring_constant_lb_per_ft")?,
        compression_damping: section.number("compression_damping")?,
        rebound_damping: section.number("rebound_damping")?,
        rebound_growth: section.number("rebound_growth_per_ft")?,
        spring_profile: profile(section, "spring_profile", MULTIPLIER)?,
        damping_profile: profile(section, "damping_profile", MULTIPLIER)?,
    })
}

fn footpad(section: &Section) -> Result<Footpad, InputError> {
    Ok(Footpad {
        diameter: section.number("diameter_ft")?,
        height: section.number("height_ft")?,
        crush_pressure: section.number("crush_pressure_psf")?,
        inertia: section.number("inertia_slug_ft2")?,
        hinge_damping: (section.optional_number("hinge_damping_ftlb_s")?).unwrap_or(0.0),
        minimum_angle: section.number("minimum_angle_deg")?.to_radians(),
        maximum_angle: section.number("maximum_angle_deg")?.to_radians(),
        profile: profile(section, "profile", PRESSURE)?,
        edge: edge(section)?,
    })
}

fn edge(section: &Section) -> Result<Option<PadEdge>, InputError> {
    if EDGE.iter().all(|key| section.optional(key).is_none()) {
        return Ok(None);
    }
    let [angle, load] = EDGE.map(|key| section.number(key));
    Ok(Some(PadEdge {
        angle: angle?.to_radians(),
        load: load?,
    }))
}

fn block(entry: &Section) -> Result<Option<Block>, InputError> {
    if let Some(found) = entry.optional("block")
        && let Ok(word) = found.text()
    {
        return match word {
            NO_BLOCK => Ok(None),
            _ => Err(found.complain("a table [block], or \"none\"")),
        };
    }
    let section = entry.section("block", &BLOCK)?;
    Ok(Some(Block {
        radius: section.number("radius_ft")?,
        height: section.number("height_ft")?,
        diameter: section.number("diameter_ft")?,
        crush_pressure: section.number("crush_pressure_psf")?,
        profile: profile(&section, "profile", PRESSURE)?,
    }))
}

#[cfg(test)]
#[path = "vehicle_file_tests.rs"]
pub(crate) mod tests;
