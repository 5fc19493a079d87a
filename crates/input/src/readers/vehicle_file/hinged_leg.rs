//! Hinged legs in vehicle files: a lower link, a strut, a footpad and a body block.

use touchdown_dynamics::parts::PadEdge;
use touchdown_dynamics::quantities;
use touchdown_dynamics::quantity::Quantity;
use touchdown_dynamics::vehicle::{
    Block, Damper, Footpad, Honeycomb, Leg, LegDesign, Strut, StrutElement,
};

use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::readers::choice::{choice, refuse_keys_of_others, word};
use crate::readers::numbers::{self, fill, joined, keys, named, read, scale};
use crate::readers::vehicle_tables::{MULTIPLIER, PRESSURE, crush_load, profile};

pub(crate) const LINKAGE: [&str; 5] = keys(&quantities::LINKAGE);
/// Keys of struts of every kind.
pub(super) const STRUT: [&str; 4] = joined(&[&["kind"], &keys(&quantities::STRUT)]);
pub(super) const DAMPER: [&str; 8] = joined(&[&keys(&quantities::DAMPER), &DAMPER_TABLES]);
const DAMPER_TABLES: [&str; 2] = ["spring_profile", "damping_profile"];
pub(super) const HONEYCOMB: [&str; 2] = joined(&[&keys(&quantities::HONEYCOMB), &[CRUSH_LOAD]]);
const CRUSH_LOAD: &str = "crush_load";
pub(crate) const FOOTPAD: [&str; 10] = joined(&[
    &keys(&quantities::FOOTPAD),
    &[PROFILE],
    &keys(&quantities::EDGE),
]);
pub(crate) const BLOCK: [&str; 5] = joined(&[&keys(&quantities::BLOCK), &[PROFILE]]);
/// The table of a footpad or a block.
pub(super) const PROFILE: &str = "profile";
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

/// Keys that only struts of one kind have.
const KEYS_OF_KINDS: [(&str, &[&str]); 2] = [("damper", &DAMPER), ("honeycomb", &HONEYCOMB)];

/// Keys of a table [strut] of any kind.
pub(crate) fn strut_keys() -> Vec<&'static str> {
    let of_kinds = KEYS_OF_KINDS.iter().flat_map(|(_, keys)| *keys);
    STRUT.iter().chain(of_kinds).copied().collect()
}

/// The numbers of each table of a leg; a table of knots counts by its scale.
pub(super) fn numbers_of_a_leg() -> impl Iterator<Item = (String, &'static Quantity)> {
    let linkage = named("linkage", &quantities::LINKAGE);
    let strut = named("strut", &quantities::STRUT)
        .chain(named("strut", &quantities::DAMPER))
        .chain(DAMPER_TABLES.map(|table| scale("strut", table)))
        .chain(named("strut", &quantities::HONEYCOMB))
        .chain([scale("strut", CRUSH_LOAD)]);
    let footpad = named("footpad", &quantities::FOOTPAD)
        .chain([scale("footpad", PROFILE)])
        .chain(named("footpad", &quantities::EDGE));
    let block = named("block", &quantities::BLOCK).chain([scale("block", PROFILE)]);
    linkage.chain(strut).chain(footpad).chain(block)
}

/// Builds a leg from its own table, and from `entry`: its own table on top of the values for all legs.
pub(super) fn leg(own: &Section, entry: &Section, linkage: &Section) -> Result<Leg, InputError> {
    let mut design = LegDesign {
        azimuth: 0.0,
        linkage: read(linkage, &quantities::LINKAGE)?,
        strut: strut(&entry.section("strut", &strut_keys())?)?,
        footpad: footpad(&entry.section("footpad", &FOOTPAD)?)?,
        block: block(entry)?,
    };
    fill(own, &quantities::LEG, &mut design)?;
    Leg::new(design).map_err(|invalid| entry.complain(&invalid))
}

fn strut(section: &Section) -> Result<Strut, InputError> {
    let kind = choice(section, "kind", &STRUT_KINDS)?;
    refuse_keys_of_others(section, "strut", &KEYS_OF_KINDS, word(&STRUT_KINDS, kind))?;
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
        crush_load: crush_load(section, CRUSH_LOAD)?,
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
