//! Tables of a vehicle file: multipliers and loads against stroke, crush pressure against interference.

use touchdown_dynamics::crush_load::CrushLoad;
use touchdown_dynamics::profile::Profile;
use touchdown_dynamics::quantities::TABLE_SCALE;

use crate::documents::input_error::InputError;
use crate::documents::section::{LocatedValue, Section};

const INCHES_PER_FOOT: f64 = 12.0;
/// Greatest number in a table, and least step of its abscissas, so that derived quantities stay finite.
const GREATEST: f64 = 1e9;
const LEAST_STEP: f64 = 1e-6;

pub(crate) const MULTIPLIER: [&str; 3] = ["stroke_in", "multiplier", SCALE];
pub(crate) const PRESSURE: [&str; 3] = ["interference_in", "relative_pressure", SCALE];
pub(crate) const LOAD: [&str; 3] = ["stroke_in", "load_lb", SCALE];
const SCALE: &str = TABLE_SCALE.key;

/// Reads a table of loads under which a strut gives for good. Strokes may repeat at a step of the load.
pub(crate) fn crush_load(section: &Section, key: &str) -> Result<CrushLoad, InputError> {
    let table = section.section(key, &LOAD)?;
    let scale = scale(&table)?;
    let [strokes, loads] = ["stroke_in", "load_lb"].map(|key| column(&table, key));
    let (strokes, loads) = (strokes?, loads?);
    let list = table.value("load_lb", "a list of numbers")?;
    if strokes.len() != loads.len() {
        return Err(list.complain_that(&format!(
            "{} numbers: expected as many as strokes, {}",
            loads.len(),
            strokes.len()
        )));
    }
    for (load, item) in loads.iter().zip(list.items("a list of numbers")?) {
        if !(0.0..=GREATEST).contains(&(scale * load)) {
            return Err(item.complain("0 ≤ value ≤ 1e9, the scale included"));
        }
    }
    let items = table.value("stroke_in", "a list of numbers")?;
    for (stroke, item) in strokes.iter().zip(items.items("a list of numbers")?) {
        if !(0.0..=GREATEST).contains(stroke) {
            return Err(item.complain("0 ≤ value ≤ 1e9"));
        }
    }
    let knots = strokes
        .iter()
        .zip(loads)
        .map(|(stroke, load)| [stroke / INCHES_PER_FOOT, scale * load]);
    CrushLoad::new(knots.collect()).map_err(|invalid| items.complain(&invalid.allowed))
}

/// Reads a table whose abscissas are in inches, as printed in the report.
pub(crate) fn profile(
    section: &Section,
    key: &str,
    columns: [&str; 3],
) -> Result<Profile, InputError> {
    let table = section.section(key, &columns)?;
    let [abscissas, ordinates, _] = columns;
    let scale = scale(&table)?;
    let x = column(&table, abscissas)?;
    let y = column(&table, ordinates)?;
    let list = table.value(ordinates, "a list of numbers")?;
    if x.len() != y.len() {
        return Err(list.complain_that(&format!(
            "{} numbers: expected as many as in {abscissas}, {}",
            y.len(),
            x.len()
        )));
    }
    if x.len() < 2 {
        let list = table.value(abscissas, "a list of numbers")?;
        return Err(list.complain("at least two knots"));
    }
    let items = table
        .value(abscissas, "a list of numbers")?
        .items("a list of numbers")?;
    for (index, pair) in x.windows(2).enumerate() {
        if pair[1] - pair[0] < LEAST_STEP || pair[1] > GREATEST {
            return Err(items[index + 1].complain(
                "a number ≤ 1e9, and 1e-6 or more above the one before: abscissas are in increasing order",
            ));
        }
    }
    if x[0] != 0.0 {
        return Err(items[0].complain("0 as the first abscissa"));
    }
    let items = list.items("a list of numbers")?;
    for (ordinate, item) in y.iter().zip(&items) {
        if !(0.0..=GREATEST).contains(&(scale * ordinate)) {
            return Err(item.complain("0 ≤ value ≤ 1e9, the scale included"));
        }
    }
    if ordinates == PRESSURE[1] {
        check_pressure(&x, &y, &items)?;
    }
    let knots = x
        .iter()
        .zip(y)
        .map(|(x, y)| [x / INCHES_PER_FOOT, scale * y]);
    Profile::new(knots.collect()).map_err(|invalid| list.complain(&invalid.allowed))
}

/// Checks that pressure starts at zero, and that no later segment falls or is steeper than the first, the elastic line:
/// otherwise crushing would heal.
fn check_pressure(x: &[f64], y: &[f64], items: &[LocatedValue]) -> Result<(), InputError> {
    if y[0] != 0.0 {
        return Err(items[0].complain("0, the pressure at no interference"));
    }
    if y[1] <= 0.0 {
        return Err(items[1].complain("a number > 0"));
    }
    let elastic = y[1] / x[1];
    for index in 2..y.len() {
        let least = y[index - 1];
        let most = least + elastic * (x[index] - x[index - 1]);
        if y[index] < least || y[index] - least > (most - least) * (1.0 + 1e-6) {
            return Err(items[index].complain(&format!(
                "{least} ≤ value ≤ {most:.6}: no segment falls, and none is steeper than the first"
            )));
        }
    }
    Ok(())
}

/// Reads the factor on the ordinates of a table.
fn scale(table: &Section) -> Result<f64, InputError> {
    match table.optional(SCALE) {
        None => Ok(const { TABLE_SCALE.default_number().unwrap() }),
        Some(found) => match found.number()? {
            scale if TABLE_SCALE.range.contains(scale) => Ok(scale),
            _ => Err(found.complain(&TABLE_SCALE.range.to_string())),
        },
    }
}

fn column(table: &Section, key: &str) -> Result<Vec<f64>, InputError> {
    table
        .value(key, "a list of numbers")?
        .items("a list of numbers")?
        .iter()
        .map(|item| item.number())
        .collect()
}
