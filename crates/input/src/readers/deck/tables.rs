//! The tables of a deck (3.4.4.1): footpads, blocks and shock absorbers, for one leg or each.

use crate::documents::input_error::{InputError, Place};

use super::{LEGS, number};

/// Fields of a table card, and columns of each.
const FIELDS: usize = 8;
const COLUMNS: usize = 10;
/// Most numbers of a table, including identification and length.
const LONGEST: usize = 100;

/// One table: abscissas, inches, and one or two lists of ordinates.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Table {
    pub(super) abscissas: Vec<f64>,
    pub(super) ordinates: Vec<Vec<f64>>,
}

/// Tables by kind (footpads, blocks, shock absorbers) and leg.
pub(super) type Tables = [[Option<Table>; LEGS]; 3];

/// Reads all tables up to a blank card. Tables of a kind given for leg 1 alone apply to every leg.
pub(super) fn tables<'t>(
    place: &Place,
    cards: &mut impl Iterator<Item = (usize, &'t str)>,
) -> Result<Tables, InputError> {
    let mut tables: Tables = Default::default();
    while let Some((line, card)) = cards.next() {
        if card.trim().is_empty() {
            break;
        }
        let here = place.line(line);
        let (kind, leg, table) = table(place, &here, card, cards)?;
        tables[kind][leg] = Some(table);
    }
    for (kind, name) in ["footpad", "block", "shock absorber"].iter().enumerate() {
        let [first, others @ ..] = &mut tables[kind];
        let Some(first) = first else {
            let complaint = format!("has no {name} table of leg 1");
            return Err(InputError::other(complaint).at(place.clone()));
        };
        let alone = others.iter().all(Option::is_none);
        for (leg, other) in (2..).zip(others) {
            if alone {
                *other = Some(first.clone());
            } else if other.is_none() {
                let complaint = format!("has no {name} table of leg {leg}");
                return Err(InputError::other(complaint).at(place.clone()));
            }
        }
    }
    Ok(tables)
}

fn table<'t>(
    place: &Place,
    here: &Place,
    card: &str,
    cards: &mut impl Iterator<Item = (usize, &'t str)>,
) -> Result<(usize, usize, Table), InputError> {
    let refuse = |name: &str, value: f64, allowed: &str| {
        Err(InputError::value(name, value, allowed).at(here.clone()))
    };
    let identification = number(here, card, 0, COLUMNS)?;
    let (kind, leg) = ((identification / 10.0).floor(), identification % 10.0);
    if ![1.0, 2.0, 3.0].contains(&kind) || ![1.0, 2.0, 3.0].contains(&leg) {
        return refuse(
            "table identification",
            identification,
            "two digits of 1 to 3",
        );
    }
    let count = number(here, card, COLUMNS, COLUMNS)?;
    let lists = if kind == 3.0 { 3 } else { 2 };
    let most = (LONGEST - 2) / lists;
    if count.fract() != 0.0 || !(2.0..=most as f64).contains(&count) {
        return refuse("points of the table", count, &format!("2 to {most}"));
    }
    let count = count as usize;
    let mut values = Vec::new();
    let mut present = (here.clone(), card.to_owned());
    let mut field = 2;
    while values.len() < lists * count {
        if field == FIELDS {
            let Some((line, card)) = cards.next() else {
                let complaint = format!("the table needs {} numbers", lists * count);
                return Err(InputError::other(complaint).at(here.clone()));
            };
            present = (place.line(line), card.to_owned());
            field = 0;
        }
        let (place, card) = &present;
        values.push(number(place, card, field * COLUMNS, COLUMNS)?);
        field += 1;
    }
    let mut lists = values.chunks(count).map(<[f64]>::to_vec);
    let table = Table {
        abscissas: lists.next().unwrap_or_default(),
        ordinates: lists.collect(),
    };
    Ok((kind as usize - 1, leg as usize - 1, table))
}
