//! Vehicle files: mass properties, and legs given once for all or one by one.

mod hinged_leg;
mod three_struts;

use std::path::Path;

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantities;
use touchdown_dynamics::quantity::Quantity;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::three_struts::Arrangement;
use touchdown_dynamics::vehicle::{Body, LEAST_LEGS, Legs, Vehicle};

use crate::documents::document::{Document, Value};
use crate::documents::input_error::InputError;
use crate::documents::key_path::KeyPath;
use crate::documents::library::Library;
use crate::documents::section::Section;
use crate::readers::choice::{choice, chosen_by, refuse_keys_of_others, word};
use crate::readers::numbers::{self, joined, keys, named, read};
use crate::readers::settings_input::RULES;
use crate::readers::vehicle_tables::{LOAD, MULTIPLIER, PRESSURE};

pub(crate) use hinged_leg::{BLOCK, FOOTPAD, LINKAGE, STRUT_KINDS, strut_keys};
use hinged_leg::{DAMPER, HONEYCOMB, STRUT, numbers_of_a_leg};
use three_struts::{BALL_FOOTPAD, FOOT};
pub(crate) use three_struts::{PRIMARY, SECONDARY};

pub(crate) const VEHICLE: [&str; 15] = joined(&[
    &["name", "rules"],
    &keys(&quantities::BODY),
    &keys(&quantities::OFFSET),
    &[INERTIA_TABLE],
    &LEG_TABLES,
    &["legs"],
]);
const INERTIA_TABLE: &str = "inertia_slug_ft2";
pub(crate) const INERTIA: [&str; 6] = keys(&quantities::INERTIA);
pub(crate) const LEG: [&str; 7] = joined(&[&keys(&quantities::LEG), &LEG_TABLES]);
/// Tables of a leg of any kind.
const LEG_TABLES: [&str; 6] = [
    "linkage",
    "strut",
    "primary",
    "secondary",
    "footpad",
    "block",
];
/// The keys of all tables.
pub(crate) const KEYS: [&[&str]; 15] = [
    &VEHICLE,
    &INERTIA,
    &LEG,
    &LINKAGE,
    &CANTILEVER,
    &STRUT,
    &DAMPER,
    &HONEYCOMB,
    &PRIMARY,
    &SECONDARY,
    &FOOTPAD,
    &BLOCK,
    &MULTIPLIER,
    &PRESSURE,
    &LOAD,
];

/// Kind of the legs of a vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum LegKind {
    /// Legs that turn about one hinge.
    #[default]
    Hinged,
    /// Legs of three struts that end at the foot.
    Tripod,
    /// Legs of three struts, two of which end at a collar of the third.
    Cantilever,
}

/// Words of the kinds.
pub(crate) const LEG_KINDS: [(&str, LegKind); 3] = [
    ("hinged", LegKind::Hinged),
    ("tripod", LegKind::Tripod),
    ("cantilever", LegKind::Cantilever),
];

/// Keys of linkages of kind `"cantilever"`.
const CANTILEVER: [&str; 7] = joined(&[&FOOT, &keys(&quantities::TELESCOPE)]);
/// Keys of a table [linkage] of any kind.
pub(crate) const ANY_LINKAGE: [&str; 13] = joined(&[&["kind"], &LINKAGE, &CANTILEVER]);

/// Tables of a leg, keys of its linkage and keys of its footpad that only legs of some kinds have.
const TABLES_OF_KINDS: [(&str, &[&str]); 3] = [
    ("hinged", &["strut", "block"]),
    ("tripod", &["primary", "secondary"]),
    ("cantilever", &["primary", "secondary"]),
];
const LINKAGES_OF_KINDS: [(&str, &[&str]); 3] = [
    ("hinged", &LINKAGE),
    ("tripod", &FOOT),
    ("cantilever", &CANTILEVER),
];
const FOOTPADS_OF_KINDS: [(&str, &[&str]); 3] = [
    ("hinged", &FOOTPAD),
    ("tripod", &BALL_FOOTPAD),
    ("cantilever", &BALL_FOOTPAD),
];

/// The numbers of a leg of any kind; those of footpads on ball joints are among those of all.
fn numbers_of_any_leg() -> impl Iterator<Item = (String, &'static Quantity)> {
    numbers_of_a_leg().chain(three_struts::own_numbers())
}

/// Dotted names of all numbers of a vehicle file with `legs` legs, with what they are.
pub(crate) fn numbers(legs: usize) -> Vec<(String, &'static Quantity)> {
    let own = (1..=legs).flat_map(|leg| {
        let numbers = named("", &quantities::LEG).chain(numbers_of_any_leg());
        numbers.map(move |(name, quantity)| (format!("legs[{leg}].{name}"), quantity))
    });
    named("", &quantities::BODY)
        .chain(named("", &quantities::OFFSET))
        .chain(named(INERTIA_TABLE, &quantities::INERTIA))
        .chain(numbers_of_any_leg())
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
        Self::from_document(Document::read_from(path, library)?)
    }

    /// Builds the vehicle of a document.
    ///
    /// # Errors
    /// As [`VehicleFile::read`].
    pub fn from_document(document: Document) -> Result<Self, InputError> {
        let root = Section::root(&document, &VEHICLE)?;
        let name = root.text("name")?.to_owned();
        let entries = root.sections("legs", &LEG)?;
        let legs = legs(&entries, &root)?;
        if !(LEAST_LEGS..=MOST_LEGS).contains(&entries.len()) {
            let allowed = "three to eight tables [[legs]], one for each leg";
            return Err(match root.optional("legs") {
                Some(found) => {
                    found.complain_that(&format!("{} legs: expected {allowed}", entries.len()))
                }
                None => root.missing("legs", allowed),
            });
        }
        let rules = rules(&root, &legs)?;
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

/// The legs of a vehicle, all of one kind.
fn legs(own: &[Section], root: &Section) -> Result<Legs, InputError> {
    let entries: Vec<Section> = own.iter().map(|own| own.over(root)).collect();
    let linkages: Vec<Section> = (entries.iter())
        .map(|entry| entry.section("linkage", &ANY_LINKAGE))
        .collect::<Result<_, _>>()?;
    let kind = kind(&linkages)?;
    for (entry, linkage) in entries.iter().zip(&linkages) {
        let own = word(&LEG_KINDS, kind);
        refuse_keys_of_others(entry, "leg", &TABLES_OF_KINDS, own)?;
        refuse_keys_of_others(linkage, "leg", &LINKAGES_OF_KINDS, own)?;
        let footpad = entry.section("footpad", &FOOTPAD)?;
        refuse_keys_of_others(&footpad, "leg", &FOOTPADS_OF_KINDS, own)?;
    }
    let legs = own.iter().zip(&entries).zip(&linkages);
    if kind == LegKind::Hinged {
        let legs = legs.map(|((own, entry), linkage)| hinged_leg::leg(own, entry, linkage));
        return legs.collect::<Result<_, _>>().map(Legs::Hinged);
    }
    let legs = legs.map(|((own, entry), linkage)| {
        let arrangement = match kind {
            LegKind::Cantilever => Arrangement::Cantilever(read(linkage, &quantities::TELESCOPE)?),
            _ => Arrangement::Tripod,
        };
        three_struts::leg(own, entry, linkage, arrangement)
    });
    legs.collect::<Result<_, _>>().map(Legs::ThreeStrut)
}

/// The kind of all legs.
fn kind(linkages: &[Section]) -> Result<LegKind, InputError> {
    let kinds: Vec<LegKind> = (linkages.iter())
        .map(|linkage| choice(linkage, "kind", &LEG_KINDS))
        .collect::<Result<_, _>>()?;
    let first = kinds.first().copied().unwrap_or_default();
    let Some(other) = kinds.iter().position(|kind| *kind != first) else {
        return Ok(first);
    };
    let given = [other, 0].map(|leg| linkages[leg].optional("kind"));
    let words = [0, other].map(|leg| word(&LEG_KINDS, kinds[leg]));
    let complaint = format!(
        "leg 1 is of kind \"{}\" and leg {} of kind \"{}\": expected one kind for all legs",
        words[0],
        other + 1,
        words[1]
    );
    Err(match given.into_iter().flatten().next() {
        Some(found) => found.complain_that(&complaint),
        None => InputError::other(complaint),
    })
}

/// The rules of the vehicle.
fn rules(root: &Section, legs: &Legs) -> Result<Rules, InputError> {
    let Some(found) = root.optional("rules") else {
        return Ok(Rules::PHYSICAL);
    };
    match (chosen_by(&found, &RULES)?, legs) {
        (rules, Legs::ThreeStrut(_)) if rules != Rules::PHYSICAL => {
            Err(found.complain("\"physical\": legs of three struts land by no other rules"))
        }
        (rules, _) => Ok(rules),
    }
}

/// Index of the leg that an error is about, from 0, and the error in terms of its table.
fn of_a_leg(invalid: &Invalid) -> Option<(usize, Invalid)> {
    let (number, key) = invalid.quantity.strip_prefix("legs[")?.split_once("].")?;
    let leg = number.parse::<usize>().ok()?.checked_sub(1)?;
    Some((leg, Invalid::new(key, invalid.value, &*invalid.allowed)))
}

#[cfg(test)]
#[path = "vehicle_file_tests.rs"]
pub(crate) mod tests;
