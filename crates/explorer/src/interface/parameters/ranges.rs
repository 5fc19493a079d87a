//! Allowed values of parameters, and sensible ranges of sliders.

use serde::Serialize;
use touchdown_dynamics::quantity::{Quantity, Range, Usual};

/// A range of allowed values.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Allowed {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// True if the lower end is excluded.
    pub is_lower_open: bool,
    /// True if the upper end is excluded.
    pub is_upper_open: bool,
    /// The range in words, in program units.
    pub text: String,
}

impl Allowed {
    /// Values of a number, regardless of others; of a word, any.
    pub fn of(quantity: Option<&Quantity>) -> Self {
        let range = quantity.map_or(Range::ANY, |quantity| quantity.range);
        Self {
            lower: range.lower,
            upper: range.upper,
            is_lower_open: range.is_lower_open,
            is_upper_open: range.is_upper_open,
            text: range.to_string(),
        }
    }

    /// The same range in another unit.
    pub fn in_unit(&self, convert: impl Fn(f64) -> f64) -> Self {
        Self {
            lower: convert(self.lower),
            upper: convert(self.upper),
            ..self.clone()
        }
    }
}

/// Ends of the slider of a number with a value, in program units.
pub fn shown(quantity: &Quantity, value: f64) -> [f64; 2] {
    match quantity.usual {
        Usual::Between(from, to) => [from, to],
        Usual::Times(..) if value == 0.0 => [0.0, 1.0],
        Usual::Times(least, most) => [least * value, most * value],
        Usual::Around(least) => {
            let reach = value.abs().max(least);
            [value - reach, value + reach]
        }
        Usual::Beside(reach) => [value - reach, value + reach],
    }
}

#[cfg(test)]
mod tests {
    use touchdown_input::points::parameter::Parameter;

    use super::*;

    #[test]
    fn sliders_reach_as_far_from_the_value_as_is_usual() {
        let quantity = |range| Quantity::new("reach_ft", Range::ANY, "").usually(range);
        assert_eq!(shown(&quantity(Usual::Around(2.0)), 0.5), [-1.5, 2.5]);
        assert_eq!(shown(&quantity(Usual::Around(2.0)), -5.0), [-10.0, 0.0]);
        assert_eq!(shown(&quantity(Usual::Beside(2.0)), 5.0), [3.0, 7.0]);
        assert_eq!(shown(&quantity(Usual::Times(0.5, 4.0)), 3.0), [1.5, 12.0]);
    }

    #[test]
    fn both_ends_of_what_is_allowed_change_their_unit() {
        let slope = Parameter::named("slope_deg", 3).unwrap();
        let allowed = Allowed::of(slope.quantity());
        let turns = allowed.in_unit(|deg| deg / 360.0);
        assert_eq!((allowed.lower, allowed.upper), (-90.0, 90.0));
        assert_eq!((turns.lower, turns.upper), (-0.25, 0.25));
        assert!(turns.is_lower_open && turns.is_upper_open);
    }
}
