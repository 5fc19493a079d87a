//! A number of the input: its key, its range, its default and what it means, said once.
//!
//! Checks, readers of input files, sliders and the reference of keys all come from these entries. Those of a lander and of
//! a touchdown stand in [`crate::quantities`].

use std::fmt;

use crate::invalid::Invalid;

/// Greatest magnitude of any number of a lander, whatever its unit, so that results of such numbers stay finite.
const GREATEST: f64 = 1e9;

/// Allowed values of a number, in the unit of its key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// True if the lower end is not allowed itself.
    pub is_lower_open: bool,
    /// True if the upper end is not allowed itself.
    pub is_upper_open: bool,
}

impl Range {
    /// Greater than zero.
    pub const POSITIVE: Self = Self::closed(0.0, GREATEST).above_lower();
    /// Zero or greater.
    pub const NOT_NEGATIVE: Self = Self::closed(0.0, GREATEST);
    /// Positive or negative.
    pub const ANY: Self = Self::closed(-GREATEST, GREATEST);

    /// Both ends and what lies between them.
    pub const fn closed(lower: f64, upper: f64) -> Self {
        Self {
            lower,
            upper,
            is_lower_open: false,
            is_upper_open: false,
        }
    }

    /// This range without its lower end.
    pub const fn above_lower(self) -> Self {
        Self {
            is_lower_open: true,
            ..self
        }
    }

    /// This range without its upper end.
    pub const fn below_upper(self) -> Self {
        Self {
            is_upper_open: true,
            ..self
        }
    }

    /// Returns whether a value is allowed. NaN never is.
    pub fn contains(&self, value: f64) -> bool {
        let is_above = match self.is_lower_open {
            true => value > self.lower,
            false => value >= self.lower,
        };
        let is_below = match self.is_upper_open {
            true => value < self.upper,
            false => value <= self.upper,
        };
        is_above && is_below
    }
}

/// Writes the range as complaints and the reference of keys say it: `0 < value ≤ 1e9`.
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = |is_open: bool| if is_open { "<" } else { "≤" };
        let (lower, upper) = (End(self.lower), End(self.upper));
        let (from, to) = (sign(self.is_lower_open), sign(self.is_upper_open));
        write!(f, "{lower} {from} value {to} {upper}")
    }
}

/// An end of a range, with a power of ten where it has many zeros.
struct End(f64);

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.abs() {
            0.0 | 0.1..1e6 => write!(f, "{}", self.0),
            _ => write!(f, "{:e}", self.0),
        }
    }
}

/// Value of a number that the input leaves out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IfMissing {
    /// It has to be given.
    Required,
    /// This value, in the unit of the key.
    Number(f64),
    /// A value that depends on others, in words.
    Words(&'static str),
}

/// Values of a number among which one usually looks, from its present value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Usual {
    /// From one value to another.
    Between(f64, f64),
    /// From one multiple of the value to another; from 0 to 1 if it is 0.
    Times(f64, f64),
    /// As far as the value is from zero, or this far, on both sides.
    Around(f64),
    /// This far on both sides.
    Beside(f64),
}

/// A number of the input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// Key within its table; its ending is the unit.
    pub key: &'static str,
    /// Allowed values, whatever other numbers are.
    pub range: Range,
    /// Demand of other numbers, in words; empty if there is none.
    pub relation: &'static str,
    /// Value if it is left out.
    pub if_missing: IfMissing,
    /// Meaning, with the symbol of the model.
    pub meaning: &'static str,
    /// Title of its axis in pictures, with the symbol but without the unit; none if the words of the key say it.
    pub title: Option<&'static str>,
    /// Values among which one usually looks.
    pub usual: Usual,
    /// Group in lists of numbers; none if its table is the group.
    pub group: Option<&'static str>,
}

impl Quantity {
    /// A number that has to be given.
    pub const fn new(key: &'static str, range: Range, meaning: &'static str) -> Self {
        Self {
            key,
            range,
            relation: "",
            if_missing: IfMissing::Required,
            meaning,
            title: None,
            usual: Usual::Times(0.25, 2.0),
            group: None,
        }
    }

    /// Gives its axis a title.
    pub const fn titled(self, title: &'static str) -> Self {
        Self {
            title: Some(title),
            ..self
        }
    }

    /// Puts it into a group of its table.
    pub const fn of(self, group: &'static str) -> Self {
        Self {
            group: Some(group),
            ..self
        }
    }

    /// Adds a demand of other numbers.
    pub const fn also(self, relation: &'static str) -> Self {
        Self { relation, ..self }
    }

    /// Gives it a default.
    pub const fn default(self, default: f64) -> Self {
        Self {
            if_missing: IfMissing::Number(default),
            ..self
        }
    }

    /// Gives it a default that depends on others, in words.
    pub const fn by_default(self, words: &'static str) -> Self {
        Self {
            if_missing: IfMissing::Words(words),
            ..self
        }
    }

    /// Gives it the values among which one usually looks.
    pub const fn usually(self, usual: Usual) -> Self {
        Self { usual, ..self }
    }

    /// Its default, if that is a number.
    pub const fn default_number(&self) -> Option<f64> {
        match self.if_missing {
            IfMissing::Number(number) => Some(number),
            IfMissing::Required | IfMissing::Words(_) => None,
        }
    }

    /// Returns whether it is an angle or a rate of turn, which the program has in radians.
    pub fn is_angular(&self) -> bool {
        self.key.ends_with("_deg") || self.key.ends_with("_dps")
    }

    /// Returns `Ok` if a value, in the unit of the key, is within the range.
    ///
    /// # Errors
    /// Names the number by the path of its table and its key.
    pub fn check(&self, table: &str, value: f64) -> Result<(), Invalid> {
        match self.range.contains(value) {
            true => Ok(()),
            false => {
                let dot = if table.is_empty() { "" } else { "." };
                let quantity = format!("{table}{dot}{}", self.key);
                Err(Invalid::new(quantity, value, self.range.to_string()))
            }
        }
    }

    /// Checks an angle or rate in radians. The ends of the range hold but for rounding.
    ///
    /// # Errors
    /// As [`Quantity::check`].
    pub fn check_radians(&self, table: &str, value: f64) -> Result<(), Invalid> {
        self.check(table, self.in_degrees(value))
    }

    /// An angle in degrees, with the end of the range that it differs from by rounding alone.
    fn in_degrees(&self, radians: f64) -> f64 {
        const ROUNDING: f64 = 2.0 * f64::EPSILON;
        let degrees = radians.to_degrees();
        let ends = [self.range.lower, self.range.upper];
        let is_end = |end: &f64| (degrees - end).abs() <= ROUNDING * end.abs();
        ends.into_iter().find(is_end).unwrap_or(degrees)
    }
}

/// A number of a part of a lander.
pub struct Field<T: 'static> {
    /// The number.
    pub quantity: Quantity,
    pub(crate) read: fn(&T) -> f64,
    pub(crate) write: fn(&mut T, f64),
}

impl<T> Field<T> {
    /// Its value, in the unit of its key.
    pub fn get(&self, part: &T) -> f64 {
        let value = (self.read)(part);
        match self.quantity.is_angular() {
            true => self.quantity.in_degrees(value),
            false => value,
        }
    }

    /// Sets it to a value in the unit of its key.
    pub fn set(&self, part: &mut T, value: f64) {
        let value = match self.quantity.is_angular() {
            true => value.to_radians(),
            false => value,
        };
        (self.write)(part, value);
    }
}

/// Checks that the numbers of a part are within their ranges.
///
/// # Errors
/// Names the first that is not, by the path of its table and its key.
pub(crate) fn check<T>(table: &str, fields: &[Field<T>], part: &T) -> Result<(), Invalid> {
    fields
        .iter()
        .try_for_each(|field| field.quantity.check(table, field.get(part)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_say_what_they_contain() {
        for (range, text, inside, outside) in [
            (Range::POSITIVE, "0 < value ≤ 1e9", 1e9, 0.0),
            (Range::NOT_NEGATIVE, "0 ≤ value ≤ 1e9", 0.0, -1e-300),
            (Range::ANY, "-1e9 ≤ value ≤ 1e9", -1e9, 1.1e9),
            (
                Range::closed(30.0, 84.0).below_upper(),
                "30 ≤ value < 84",
                30.0,
                84.0,
            ),
            (
                Range::closed(1e-12, 1e-2),
                "1e-12 ≤ value ≤ 1e-2",
                1e-12,
                0.011,
            ),
            (
                Range::closed(-36e3, 36e3),
                "-36000 ≤ value ≤ 36000",
                -36e3,
                36001.0,
            ),
        ] {
            assert_eq!(range.to_string(), text);
            assert!(range.contains(inside) && !range.contains(outside));
            assert!(!range.contains(f64::NAN));
        }
    }

    #[test]
    fn whole_degrees_at_the_ends_survive_the_way_to_radians_and_back() {
        let closed = Quantity::new("angle_deg", Range::closed(-84.0, 84.0), "an angle");
        let open = Quantity::new(
            "angle_deg",
            Range::closed(30.0, 84.0).above_lower().below_upper(),
            "an angle",
        );
        for degrees in 30..=84_i32 {
            let end = f64::from(degrees);
            let closed = Quantity {
                range: Range::closed(-end, end),
                ..closed
            };
            for angle in [end, -end] {
                assert_eq!(closed.check_radians("", angle.to_radians()), Ok(()));
            }
            let inside = degrees > 30 && degrees < 84;
            assert_eq!(open.check_radians("", end.to_radians()).is_ok(), inside);
        }
        let far = closed.check_radians("pad", 85f64.to_radians()).unwrap_err();
        assert_eq!(far.quantity, "pad.angle_deg");
    }
}
