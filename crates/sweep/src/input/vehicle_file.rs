//! Vehicle files: mass properties, and legs given once for all or one by one.

use std::path::Path;

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::parts::PadEdge;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantities;
use touchdown_dynamics::quantity::{Field, Quantity};
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::vehicle::{
    Block, Body, Damper, Footpad, Honeycomb, LEAST_LEGS, Leg, LegDesign, Strut, StrutElement,
    Vehicle,
};

use crate::choice::{self, choice, chosen_by};
use crate::document::{Document, Value, dotted};
use crate::input_error::InputError;
use crate::key_path::KeyPath;
use crate::library::Library;
use crate::numbers::{self, fill, joined, keys, read};
use crate::section::Section;
use crate::settings_input::RULES;
use crate::vehicle_tables::{LOAD, MULTIPLIER, PRESSURE, crush_load, profile};

pub(crate) const VEHICLE: [&str; 13] = joined(&[
    &["name", "rules"],
    &keys(&quantities::BODY),
    &keys(&quantities::OFFSET),
    &[
        INERTIA_TABLE,
        "linkage",
        "strut",
        "footpad",
        "block",
        "legs",
    ],
]);
const INERTIA_TABLE: &str = "inertia_slug_ft2";
pub(crate) const INERTIA: [&str; 6] = keys(&quantities::INERTIA);
pub(crate) const LEG: [&str; 5] = joined(&[
    &keys(&quantities::LEG),
    &["linkage", "strut", "footpad", "block"],
]);
pub(crate) const LINKAGE: [&str; 5] = keys(&quantities::LINKAGE);
/// Keys of struts of every kind.
const STRUT: [&str; 4] = joined(&[&["kind"], &keys(&quantities::STRUT)]);
const DAMPER: [&str; 8] = joined(&[&keys(&quantities::DAMPER), &DAMPER_TABLES]);
const DAMPER_TABLES: [&str; 2] = ["spring_profile", "damping_profile"];
const HONEYCOMB: [&str; 2] = joined(&[&keys(&quantities::HONEYCOMB), &[CRUSH_LOAD]]);
const CRUSH_LOAD: &str = "crush_load";
pub(crate) const FOOTPAD: [&str; 10] = joined(&[
    &keys(&quantities::FOOTPAD),
    &[PROFILE],
    &keys(&quantities::EDGE),
]);
pub(crate) const BLOCK: [&str; 5] = joined(&[&keys(&quantities::BLOCK), &[PROFILE]]);
/// The table of a footpad or a block.
const PROFILE: &str = "profile";
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
/// Word in place of a table `[block]` for a leg without a block.
const NO_BLOCK: &str = "none";

/// Kind of a strut, by what carries the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum StrutKind {
    /// The Surveyor's shock absorber.
    #[default]
    Damper,
    /// A crushable cartridge.
    Honeycomb,
}

/// Words of the kinds.
pub(crate) const STRUT_KINDS: [(&str, StrutKind); 2] = [
    ("damper", StrutKind::Damper),
    ("honeycomb", StrutKind::Honeycomb),
];

impl StrutKind {
    /// Keys that only struts of this kind have.
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Damper => &DAMPER,
            Self::Honeycomb => &HONEYCOMB,
        }
    }
}

/// Keys of a table [strut] of any kind.
pub(crate) fn strut_keys() -> Vec<&'static str> {
    let of_kinds = STRUT_KINDS.iter().flat_map(|(_, kind)| kind.keys());
    STRUT.iter().chain(of_kinds).copied().collect()
}

/// The numbers of each table of a leg; a table of knots counts by its scale.
fn numbers_of_a_leg() -> impl Iterator<Item = (String, &'static Quantity)> {
    let linkage = fields("linkage", &quantities::LINKAGE);
    let strut = fields("strut", &quantities::STRUT)
        .chain(fields("strut", &quantities::DAMPER))
        .chain(DAMPER_TABLES.map(|table| scale("strut", table)))
        .chain(fields("strut", &quantities::HONEYCOMB))
        .chain([scale("strut", CRUSH_LOAD)]);
    let footpad = fields("footpad", &quantities::FOOTPAD)
        .chain([scale("footpad", PROFILE)])
        .chain(fields("footpad", &quantities::EDGE));
    let block = fields("block", &quantities::BLOCK).chain([scale("block", PROFILE)]);
    linkage.chain(strut).chain(footpad).chain(block)
}

fn fields<T>(
    table: &'static str,
    fields: &'static [Field<T>],
) -> impl Iterator<Item = (String, &'static Quantity)> {
    numbers::quantities(fields).map(move |quantity| (dotted(table, quantity.key), quantity))
}

fn scale(part: &str, table: &str) -> (String, &'static Quantity) {
    let quantity = &quantities::TABLE_SCALE;
    (format!("{part}.{table}.{}", quantity.key), quantity)
}

/// Dotted names of all numbers of a vehicle file with `legs` legs, with what they are.
pub(crate) fn numbers(legs: usize) -> Vec<(String, &'static Quantity)> {
    let own = (1..=legs).flat_map(|leg| {
        let azimuth = fields("", &quantities::LEG);
        let numbers = azimuth.chain(numbers_of_a_leg());
        numbers.map(move |(name, quantity)| (format!("legs[{leg}].{name}"), quantity))
    });
    fields("", &quantities::BODY)
        .chain(fields("", &quantities::OFFSET))
        .chain(fields(INERTIA_TABLE, &quantities::INERTIA))
        .chain(numbers_of_a_leg())
        .chain(own)
        .collect()
}

/// Finds the number of a vehicle file under a dotted key: a leg's own, else that for all legs. If missing, the scale of
/// a table is 1 and the offset of the CG 0.
pub fn number(document: &Document, path: &KeyPath) -> Option<f64> {
    let of_all = || document.number(&path.of_all_legs()?);
    let by_default = || {
        let offset = numbers::quantities(&quantities::OFFSET);
        let key = &path.steps.last()?.key;
        let optional = offset.chain([&quantities::TABLE_SCALE]);
        let found = optional.into_iter().find(|quantity| quantity.key == key);
        found.and_then(Quantity::default_number)
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
        let offset = read(&root, &quantities::OFFSET)?;
        let body: Body = read(&root, &quantities::BODY)?;
        let inertia = read(
            &root.section(INERTIA_TABLE, &INERTIA)?,
            &quantities::INERTIA,
        )?;
        let vehicle = Vehicle::new(
            body.mass,
            body.gravity,
            body.center_of_gravity_height,
            inertia,
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

/// Builds a leg from its own table, and from `entry`: its own table on top of the values for all legs.
fn leg(own: &Section, entry: &Section) -> Result<Leg, InputError> {
    let mut design = LegDesign {
        azimuth: 0.0,
        linkage: read(&entry.section("linkage", &LINKAGE)?, &quantities::LINKAGE)?,
        strut: strut(&entry.section("strut", &strut_keys())?)?,
        footpad: footpad(&entry.section("footpad", &FOOTPAD)?)?,
        block: block(entry)?,
    };
    fill(own, &quantities::LEG, &mut design)?;
    Leg::new(design).map_err(|invalid| entry.complain(&invalid))
}

fn strut(section: &Section) -> Result<Strut, InputError> {
    let kind = choice(section, "kind", &STRUT_KINDS)?;
    for (word, other) in STRUT_KINDS.iter().filter(|(_, other)| *other != kind) {
        if let Some(found) = other.keys().iter().find_map(|key| section.optional(key)) {
            return Err(found.complain_that(&format!(
                "only struts of kind \"{word}\" have this, and this one is of kind \"{}\"",
                choice::word(&STRUT_KINDS, kind)
            )));
        }
    }
    let mut strut = Strut::default();
    fill(section, &quantities::STRUT, &mut strut)?;
    strut.element = match kind {
        StrutKind::Damper => StrutElement::Damper(damper(section)?),
        StrutKind::Honeycomb => StrutElement::Honeycomb(honeycomb(section)?),
    };
    Ok(strut)
}

fn damper(section: &Section) -> Result<Damper, InputError> {
    let [spring, damping] = DAMPER_TABLES;
    let mut damper: Damper = read(section, &quantities::DAMPER)?;
    damper.spring_profile = profile(section, spring, MULTIPLIER)?;
    damper.damping_profile = profile(section, damping, MULTIPLIER)?;
    Ok(damper)
}

fn honeycomb(section: &Section) -> Result<Honeycomb, InputError> {
    let mut honeycomb = Honeycomb {
        unloading_stiffness: 0.0,
        crush_load: crush_load(section)?,
    };
    fill(section, &quantities::HONEYCOMB, &mut honeycomb)?;
    Ok(honeycomb)
}

fn footpad(section: &Section) -> Result<Footpad, InputError> {
    let mut footpad: Footpad = read(section, &quantities::FOOTPAD)?;
    footpad.profile = profile(section, PROFILE, PRESSURE)?;
    footpad.edge = edge(section)?;
    Ok(footpad)
}

/// Load capacity of a footpad that has turned over; both keys or none.
fn edge(section: &Section) -> Result<Option<PadEdge>, InputError> {
    let both = || numbers::quantities(&quantities::EDGE);
    if both().all(|quantity| section.optional(quantity.key).is_none()) {
        return Ok(None);
    }
    for quantity in both() {
        section.value(quantity.key, &numbers::explanation(quantity))?;
    }
    read(section, &quantities::EDGE).map(Some)
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
    let mut block: Block = read(&section, &quantities::BLOCK)?;
    block.profile = profile(&section, PROFILE, PRESSURE)?;
    Ok(Some(block))
}

#[cfg(test)]
#[path = "vehicle_file_tests.rs"]
pub(crate) mod tests;
