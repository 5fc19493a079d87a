//! The report's card decks (3.4.4.1, 3.4.4.2): tables in eight columns of ten, then input constants
//! on 21 numbered cards of five columns of twelve; a blank card ends the tables and each run. Runs
//! stacked behind the first tell only the cards that change.

use touchdown_dynamics::attitude::{Attitude, Euler};

use crate::input_error::{InputError, Place};

/// Cards of input constants, and fields of each.
const CARDS: usize = 21;
const FIELDS: usize = 5;
/// Fields of a table's card, columns of a field of each kind, and where the constants begin.
const TABLE_FIELDS: usize = 8;
const TABLE_COLUMNS: usize = 10;
const CONSTANT_COLUMNS: usize = 12;
const NUMBER_COLUMNS: usize = 7;
const LEGS: usize = 3;
/// Most numbers of a table, identification and length included.
const LONGEST_TABLE: usize = 100;

/// A deck.
#[derive(Debug, Clone, PartialEq)]
pub struct Deck {
    tables: Tables,
    /// The runs, each complete.
    pub runs: Vec<Run>,
}

/// The constants of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    cards: [[f64; FIELDS]; CARDS],
}

/// One table: abscissas, inches, and one list of ordinates or two.
#[derive(Debug, Clone, PartialEq)]
struct Table {
    abscissas: Vec<f64>,
    ordinates: Vec<Vec<f64>>,
}

/// Tables by kind (footpads, blocks, shock absorbers) and leg.
type Tables = [[Option<Table>; LEGS]; 3];

/// Reads a deck.
///
/// # Errors
/// Names the card, by its line, and what is wrong with it.
pub fn parse(place: &Place, text: &str) -> Result<Deck, InputError> {
    let mut cards = text
        .lines()
        .enumerate()
        .map(|(index, card)| (index + 1, card));
    let tables = tables(place, &mut cards)?;
    let mut runs: Vec<Run> = Vec::new();
    let mut present = [[None; FIELDS]; CARDS];
    let mut is_changed = false;
    let mut last = 1;
    for (line, card) in cards {
        last = line;
        if !card.trim().is_empty() {
            let (number, fields) = constants(&place.line(line), card)?;
            present[number - 1] = fields.map(Some);
            is_changed = true;
        } else if is_changed {
            runs.push(run(&place.line(line), &present)?);
            is_changed = false;
        }
    }
    if is_changed {
        runs.push(run(&place.line(last), &present)?);
    }
    if runs.is_empty() {
        let complaint = "has no cards of input constants behind its tables and a blank card";
        return Err(InputError::other(complaint).at(place.clone()));
    }
    Ok(Deck { tables, runs })
}

fn run(place: &Place, present: &[[Option<f64>; FIELDS]; CARDS]) -> Result<Run, InputError> {
    let mut cards = [[0.0; FIELDS]; CARDS];
    for (index, (card, fields)) in cards.iter_mut().zip(present).enumerate() {
        for (value, field) in card.iter_mut().zip(fields) {
            let missing = || {
                let complaint = format!("card {} is missing before the first run", index + 1);
                InputError::other(complaint).at(place.clone())
            };
            *value = field.ok_or_else(missing)?;
        }
    }
    Ok(Run { cards })
}

/// The number in some columns of a card: blank is zero, and an exponent may stand without its
/// letter, as in .14222+03.
fn number(place: &Place, card: &str, from: usize, columns: usize) -> Result<f64, InputError> {
    let text: String = card.chars().skip(from).take(columns).collect();
    let text = text.trim();
    if text.is_empty() {
        return Ok(0.0);
    }
    let upper = text.to_ascii_uppercase().replace('D', "E");
    let sign = upper
        .char_indices()
        .skip(1)
        .find(|(index, letter)| matches!(letter, '+' | '-') && upper.as_bytes()[index - 1] != b'E');
    let written = match sign {
        Some((index, _)) => format!("{}E{}", &upper[..index], &upper[index..]),
        None => upper,
    };
    let parsed = written
        .parse::<f64>()
        .ok()
        .filter(|value| value.is_finite());
    parsed.ok_or_else(|| {
        let columns = format!("columns {} to {}", from + 1, from + columns);
        InputError::value(&columns, text, "a number").at(place.clone())
    })
}

/// Number and fields of a card of constants.
fn constants(place: &Place, card: &str) -> Result<(usize, [f64; FIELDS]), InputError> {
    let index = number(place, card, 0, NUMBER_COLUMNS)?;
    if index.fract() != 0.0 || !(1.0..=CARDS as f64).contains(&index) {
        return Err(InputError::value("card number", index, "1 to 21").at(place.clone()));
    }
    let mut fields = [0.0; FIELDS];
    for (field, value) in fields.iter_mut().enumerate() {
        let from = CONSTANT_COLUMNS * (field + 1);
        *value = number(place, card, from, CONSTANT_COLUMNS)?;
    }
    Ok((index as usize, fields))
}

/// Reads all tables up to a blank card; those of a kind given for leg 1 alone serve every leg.
fn tables<'t>(
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
    let identification = number(here, card, 0, TABLE_COLUMNS)?;
    let (kind, leg) = ((identification / 10.0).floor(), identification % 10.0);
    if ![1.0, 2.0, 3.0].contains(&kind) || ![1.0, 2.0, 3.0].contains(&leg) {
        return refuse(
            "table identification",
            identification,
            "two digits of 1 to 3",
        );
    }
    let count = number(here, card, TABLE_COLUMNS, TABLE_COLUMNS)?;
    let lists = if kind == 3.0 { 3 } else { 2 };
    let most = (LONGEST_TABLE - 2) / lists;
    if count.fract() != 0.0 || !(2.0..=most as f64).contains(&count) {
        return refuse("points of the table", count, &format!("2 to {most}"));
    }
    let count = count as usize;
    let mut values = Vec::new();
    let mut present = (here.clone(), card.to_owned());
    let mut field = 2;
    while values.len() < lists * count {
        if field == TABLE_FIELDS {
            let Some((line, card)) = cards.next() else {
                let complaint = format!("the table needs {} numbers", lists * count);
                return Err(InputError::other(complaint).at(here.clone()));
            };
            present = (place.line(line), card.to_owned());
            field = 0;
        }
        let (place, card) = &present;
        values.push(number(place, card, field * TABLE_COLUMNS, TABLE_COLUMNS)?);
        field += 1;
    }
    let mut lists = values.chunks(count).map(<[f64]>::to_vec);
    let table = Table {
        abscissas: lists.next().unwrap_or_default(),
        ordinates: lists.collect(),
    };
    Ok((kind as usize - 1, leg as usize - 1, table))
}

impl Run {
    /// Field `field` of card `card`, both counted from 1 as in the report.
    fn at(&self, card: usize, field: usize) -> f64 {
        self.cards[card - 1][field - 1]
    }

    /// The scene as named numbers; velocities from whichever of the report's three ways the run
    /// chose.
    ///
    /// # Errors
    /// When the phase number is none of 1, 2 and 3.
    pub fn scene(&self) -> Result<Vec<(&'static str, f64)>, InputError> {
        let [pitch, yaw, roll] = [2, 3, 4].map(|field| self.at(9, field));
        let phase = self.at(11, 3);
        let [mut x, mut y, mut z] = [2, 3, 4].map(|field| self.at(6, field));
        let (vertical, horizontal, cross_slope) = if phase == 2.0 {
            (self.at(11, 5), self.at(11, 4), self.at(9, 5))
        } else if phase == 1.0 || phase == 3.0 {
            if phase == 3.0 {
                let [pitch, yaw, roll] = [pitch, yaw, roll].map(f64::to_radians);
                let attitude = Attitude::from_euler(Euler { pitch, yaw, roll });
                let b = attitude.matrix();
                let turned = |row: usize| b[(row, 0)] * x + b[(row, 1)] * y + b[(row, 2)] * z;
                [x, y, z] = [turned(0), turned(1), turned(2)];
            }
            (z, x.hypot(y), (-x).atan2(y).to_degrees())
        } else {
            return Err(InputError::value(
                "phase number (card 11)",
                phase,
                "1, 2 or 3",
            ));
        };
        Ok(vec![
            ("vertical_velocity_fps", vertical),
            ("horizontal_velocity_fps", horizontal),
            ("cross_slope_deg", cross_slope),
            ("slope_deg", self.at(9, 1)),
            ("friction", self.at(21, 1)),
            ("block_friction", self.at(21, 2)),
            ("pitch_deg", pitch),
            ("yaw_deg", yaw),
            ("roll_deg", roll),
            ("angular_velocity_x_dps", self.at(10, 1)),
            ("angular_velocity_y_dps", self.at(10, 2)),
            ("angular_velocity_z_dps", self.at(10, 3)),
        ])
    }

    /// Serial number (card 11).
    pub fn serial_number(&self) -> f64 {
        self.at(11, 2)
    }
}

impl Deck {
    /// The vehicle of a run as a vehicle file of this program.
    pub fn vehicle(&self, run: &Run, name: &str) -> String {
        let at = |card, field| run.at(card, field);
        let [pads, blocks, struts] = &self.tables;
        let mut text = format!(
            "# Converted from a card deck of the 1966 program.\nname = {name:?}\n\
             mass_slug = {}\ngravity_fps2 = {}\ncenter_of_gravity_height_ft = {}\n\n\
             [inertia_slug_ft2]\nxx = {}\nyy = {}\nzz = {}\nxy = {}\nxz = {}\nyz = {}\n\n\
             [linkage]\nlower_hardpoint_radius_ft = {}\nlower_link_length_ft = {}\n\
             hardpoint_distance_ft = {}\nhardpoint_angle_deg = {}\ninertia_slug_ft2 = {}\n\n",
            at(1, 1),
            at(3, 4),
            at(2, 5),
            at(1, 2),
            at(1, 3),
            at(1, 4),
            at(1, 5),
            at(2, 1),
            at(2, 2),
            at(3, 1),
            at(3, 2),
            at(3, 3),
            at(4, 4),
            at(5, 3),
        );
        text += &format!(
            "[strut]\nextended_length_ft = {}\nminimum_length_ft = {}\n\
             structural_stiffness_lb_per_ft = {}\nfriction_fraction = {}\n\n\
             [footpad]\ndiameter_ft = {}\nheight_ft = {}\ninertia_slug_ft2 = {}\n\
             minimum_angle_deg = {}\nmaximum_angle_deg = {}\n\n\
             [block]\nradius_ft = {}\nheight_ft = {}\ndiameter_ft = {}\n",
            at(2, 4),
            at(7, 2),
            at(7, 3),
            at(7, 1),
            at(6, 1),
            at(5, 4),
            at(5, 2),
            at(3, 5),
            at(4, 1),
            at(4, 5),
            at(5, 1),
            at(5, 5),
        );
        // Everything that the deck has leg by leg.
        let per_leg = |cards: [(usize, usize); LEGS], leg: usize| at(cards[leg].0, cards[leg].1);
        for leg in 0..LEGS {
            let value = |cards| per_leg(cards, leg);
            text += &format!(
                "\n[[legs]]\nazimuth_deg = {}\n\n[legs.strut]\npreload_lb = {}\n\
                 spring_constant_lb_per_ft = {}\ncompression_damping = {}\nrebound_damping = {}\n\
                 rebound_growth_per_ft = {}\n",
                at(8, leg + 1),
                value([(18, 1), (18, 2), (18, 3)]),
                value([(17, 3), (17, 4), (17, 5)]),
                value([(16, 5), (17, 1), (17, 2)]),
                value([(18, 4), (18, 5), (19, 1)]),
                value([(19, 2), (19, 3), (19, 4)]),
            );
            if let Some(table) = &struts[leg] {
                for (profile, ordinates) in ["spring_profile", "damping_profile"]
                    .iter()
                    .zip(&table.ordinates)
                {
                    text += &format!(
                        "\n[legs.strut.{profile}]\nstroke_in = {:?}\nmultiplier = {ordinates:?}\n",
                        table.abscissas
                    );
                }
            }
            for (element, tables, cards) in [
                ("footpad", pads, [(20, 3), (20, 4), (20, 5)]),
                ("block", blocks, [(19, 5), (20, 1), (20, 2)]),
            ] {
                text += &format!(
                    "\n[legs.{element}]\ncrush_pressure_psf = {}\n",
                    value(cards)
                );
                if let Some(table) = &tables[leg] {
                    text += &format!(
                        "\n[legs.{element}.profile]\ninterference_in = {:?}\n\
                         relative_pressure = {:?}\n",
                        table.abscissas, table.ordinates[0]
                    );
                }
            }
        }
        text
    }
}

#[cfg(test)]
#[path = "deck_tests.rs"]
mod tests;
