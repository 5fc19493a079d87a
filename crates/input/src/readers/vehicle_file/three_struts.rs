//! Legs of three struts in vehicle files.

use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::quantities;
use touchdown_dynamics::quantity::Quantity;
use touchdown_dynamics::three_strut_leg::ThreeStrutLeg;
use touchdown_dynamics::three_struts::{Arrangement, BallFootpad, LegStrut, ThreeStrutDesign};

use super::hinged_leg::{FOOTPAD, PROFILE};
use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::readers::numbers::{definite, fill, joined, keys, named, read, scale};
use crate::readers::vehicle_tables::{PRESSURE, crush_load, profile};

/// Keys of linkages of any kind of three struts.
pub(super) const FOOT: [&str; 3] = keys(&quantities::FOOT);
pub(crate) const PRIMARY: [&str; 9] = joined(&[&keys(&quantities::LEG_STRUT), &LOADS]);
pub(crate) const SECONDARY: [&str; 10] = joined(&[&PRIMARY, &[quantities::SPREAD.key]]);
pub(super) const BALL_FOOTPAD: [&str; 4] = joined(&[&keys(&quantities::BALL_FOOTPAD), &[PROFILE]]);
/// Tables of a strut, both optional.
const LOADS: [&str; 2] = ["compression_load", "tension_load"];

/// The numbers of each table of a leg that hinged legs do not have.
pub(super) fn own_numbers() -> impl Iterator<Item = (String, &'static Quantity)> {
    let one =
        |table: &str, quantity: &'static Quantity| (format!("{table}.{}", quantity.key), quantity);
    let strut =
        |table| named(table, &quantities::LEG_STRUT).chain(LOADS.map(|load| scale(table, load)));
    named("linkage", &quantities::FOOT)
        .chain(named("linkage", &quantities::TELESCOPE))
        .chain(strut("primary"))
        .chain(strut("secondary"))
        .chain([one("secondary", const { &quantities::SPREAD })])
}

/// Builds a leg from its own table, and from `entry`: its own table on top of the values for all legs.
pub(super) fn leg(
    own: &Section,
    entry: &Section,
    linkage: &Section,
    arrangement: Arrangement,
) -> Result<ThreeStrutLeg, InputError> {
    let secondary = entry.section("secondary", &SECONDARY)?;
    let mut design = ThreeStrutDesign {
        azimuth: 0.0,
        arrangement,
        foot: read(linkage, &quantities::FOOT)?,
        primary: strut(&entry.section("primary", &PRIMARY)?)?,
        secondary: strut(&secondary)?,
        spread: definite(&secondary, &quantities::SPREAD)?,
        footpad: footpad(&entry.section("footpad", &FOOTPAD)?)?,
    };
    fill(own, &quantities::THREE_STRUT_LEG, &mut design)?;
    ThreeStrutLeg::new(design).map_err(|invalid| entry.complain(&invalid))
}

fn strut(section: &Section) -> Result<LegStrut, InputError> {
    let load = |key| -> Result<Option<CrushLoad>, InputError> {
        let given = section.optional(key);
        given.map(|_| crush_load(section, key)).transpose()
    };
    let [compression, tension] = LOADS;
    let mut strut: LegStrut = read(section, &quantities::LEG_STRUT)?;
    strut.compression_load = load(compression)?;
    strut.tension_load = load(tension)?;
    Ok(strut)
}

fn footpad(section: &Section) -> Result<BallFootpad, InputError> {
    let mut footpad: BallFootpad = read(section, &quantities::BALL_FOOTPAD)?;
    footpad.profile = profile(section, PROFILE, PRESSURE)?;
    Ok(footpad)
}

#[cfg(test)]
#[path = "three_struts_tests.rs"]
mod tests;
