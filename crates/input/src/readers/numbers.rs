//! Numbers of the catalogue ([`touchdown_dynamics::quantities`]) as tables of input files have them.

use touchdown_dynamics::quantities::TABLE_SCALE;
use touchdown_dynamics::quantity::{Field, IfMissing, Quantity};

use crate::documents::document::dotted;
use crate::documents::input_error::InputError;
use crate::documents::section::Section;
use crate::documents::unit::unit;

/// Keys of the numbers of a part.
pub(crate) const fn keys<T, const N: usize>(fields: &[Field<T>; N]) -> [&'static str; N] {
    let mut keys = [""; N];
    let mut index = 0;
    while index < N {
        keys[index] = fields[index].quantity.key;
        index += 1;
    }
    keys
}

/// Keys of a list of numbers.
pub(crate) const fn keys_of<const N: usize>(quantities: &[Quantity]) -> [&'static str; N] {
    assert!(quantities.len() == N);
    let mut keys = [""; N];
    let mut index = 0;
    while index < N {
        keys[index] = quantities[index].key;
        index += 1;
    }
    keys
}

/// Several lists of keys as one.
pub(crate) const fn joined<const N: usize>(lists: &[&[&'static str]]) -> [&'static str; N] {
    let mut keys = [""; N];
    let (mut list, mut count) = (0, 0);
    while list < lists.len() {
        let mut index = 0;
        while index < lists[list].len() {
            keys[count] = lists[list][index];
            count += 1;
            index += 1;
        }
        list += 1;
    }
    assert!(count == N);
    keys
}

/// The numbers of a part.
pub(crate) fn quantities<T>(
    fields: &'static [Field<T>],
) -> impl Iterator<Item = &'static Quantity> {
    fields.iter().map(|field| &field.quantity)
}

/// The numbers of a part by their dotted names in a table.
pub(crate) fn named<T>(
    table: &'static str,
    fields: &'static [Field<T>],
) -> impl Iterator<Item = (String, &'static Quantity)> {
    quantities(fields).map(move |quantity| (dotted(table, quantity.key), quantity))
}

/// The factor on a table of knots by its dotted name.
pub(crate) fn scale(part: &str, table: &str) -> (String, &'static Quantity) {
    let quantity = const { &TABLE_SCALE };
    (format!("{part}.{table}.{}", quantity.key), quantity)
}

/// Reads the numbers of a part.
pub(crate) fn read<T: Default>(section: &Section, fields: &[Field<T>]) -> Result<T, InputError> {
    let mut part = T::default();
    fill(section, fields, &mut part)?;
    Ok(part)
}

/// Reads numbers of a part into it. Those that have a default in words and are left out stay as they are.
pub(crate) fn fill<T>(
    section: &Section,
    fields: &[Field<T>],
    part: &mut T,
) -> Result<(), InputError> {
    for field in fields {
        if let Some(value) = number(section, &field.quantity)? {
            field.set(part, value);
        }
    }
    Ok(())
}

/// Reads a number: the given one or its default; `None` if the default is in words.
pub(crate) fn number(section: &Section, quantity: &Quantity) -> Result<Option<f64>, InputError> {
    match (section.optional_number(quantity.key)?, quantity.if_missing) {
        (Some(given), _) => Ok(Some(given)),
        (None, IfMissing::Number(default)) => Ok(Some(default)),
        (None, IfMissing::Words(_)) => Ok(None),
        (None, IfMissing::Required) => Err(section.missing(quantity.key, &explanation(quantity))),
    }
}

/// Reads a number whose default, if any, is a number.
pub(crate) fn definite(section: &Section, quantity: &Quantity) -> Result<f64, InputError> {
    let missing = || section.missing(quantity.key, &explanation(quantity));
    number(section, quantity)?.ok_or_else(missing)
}

/// Explanation of a number that is missing: range, unit and meaning.
pub(crate) fn explanation(quantity: &Quantity) -> String {
    let unit = match unit(quantity.key) {
        "1" => String::new(),
        unit => format!(" {unit}"),
    };
    format!("{}{unit}, {}", quantity.range, quantity.meaning)
}
