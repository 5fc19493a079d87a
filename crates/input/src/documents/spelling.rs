//! Spellings of a key: with the program's unit, or with an SI unit.
//!
//! Keys are known by the names with the program's units. `mass_kg` is another spelling of `mass_slug`; its numbers are
//! converted when read.

use std::cmp::Reverse;

use crate::documents::unit::{UNITS, Unit, program_unit};

/// Conversion from the unit of a spelling to that of the program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Conversion {
    /// Number of units of the spelling in one of the program.
    factor: f64,
    /// Unit of the program, in words.
    words: &'static str,
}

impl Conversion {
    /// Conversion of a key in the program's own unit.
    pub(crate) const NONE: Self = Self {
        factor: 1.0,
        words: "",
    };

    /// True if the two units differ.
    pub(crate) fn converts(self) -> bool {
        self != Self::NONE
    }

    /// This conversion, or `above` if this key has no unit of its own.
    pub(crate) fn or(self, above: Self) -> Self {
        if self.converts() { self } else { above }
    }

    /// Converts a number to the program's unit.
    pub(crate) fn to_program(self, number: f64) -> f64 {
        match self.converts() {
            true => decimal_within_rounding(number / self.factor),
            false => number,
        }
    }

    /// Converts a number of the program to the unit of the spelling.
    pub(crate) fn in_own_unit(self, number: f64) -> f64 {
        match self.converts() {
            true => decimal_within_rounding(number * self.factor),
            false => number,
        }
    }

    /// Text of the allowed values in the program's unit, for a number in that of the spelling.
    pub(crate) fn explain(self, allowed: &str, number: f64) -> String {
        match self.converts() {
            true => {
                let (value, words) = (rounded(self.to_program(number), 6), self.words);
                format!("{allowed} (in {words}: this is {value})")
            }
            false => allowed.to_owned(),
        }
    }

    /// A number of the program, followed by its unit if the spelling has another.
    pub(crate) fn with_unit(self, number: f64) -> String {
        format!("{number} {}", self.words).trim_end().to_owned()
    }
}

/// Rounds a converted number to fifteen digits if that changes it by no more than rounding errors. 19.05 mm are 0.75
/// inch, though neither 19.05 nor 25.4 is a binary fraction.
fn decimal_within_rounding(converted: f64) -> f64 {
    // The number, the factor, their quotient and the decimal are rounded by half an epsilon each.
    const ROUNDING: f64 = 2.0 * f64::EPSILON;
    let decimal = rounded(converted, 15);
    match (decimal - converted).abs() <= ROUNDING * converted.abs() {
        true => decimal,
        false => converted,
    }
}

fn rounded(number: f64, digits: usize) -> f64 {
    let decimal = format!("{number:.*e}", digits - 1);
    decimal.parse().unwrap_or(number)
}

/// Conversion of a spelling, if it is one of `key`.
pub(crate) fn conversion(spelling: &str, key: &str) -> Option<Conversion> {
    if spelling == key {
        return Some(Conversion::NONE);
    }
    // Spellings differ at their ends only. This tells most pairs of keys apart, of which there are very many.
    if spelling.as_bytes().first() != key.as_bytes().first() {
        return None;
    }
    let (bare, unit) = program_unit(key)?;
    let ending = spelling.strip_prefix(bare)?;
    let si = unit.si.iter().find(|si| si.ending == ending)?;
    Some(Conversion {
        factor: si.factor,
        words: unit.words,
    })
}

/// The same for dotted keys; at most one step has a unit other than the program's.
pub(crate) fn dotted_conversion(spelling: &str, key: &str) -> Option<Conversion> {
    let (mut spelled, mut known) = (spelling.split('.'), key.split('.'));
    let mut whole = Conversion::NONE;
    loop {
        whole = match (spelled.next(), known.next()) {
            (Some(spelled), Some(known)) => conversion(spelled, known)?.or(whole),
            (None, None) => return Some(whole),
            _ => return None,
        };
    }
}

/// All spellings of a key, that of the program first.
pub(crate) fn spellings(key: &str) -> Vec<String> {
    let mut all = vec![key.to_owned()];
    if let Some((bare, unit)) = program_unit(key) {
        all.extend(unit.si.iter().map(|si| format!("{bare}{}", si.ending)));
    }
    all
}

/// Spelling of a name, possibly dotted, in SI results: with the first SI unit, but with degrees for angles and rates of
/// turn.
pub(crate) fn spelling_for_results(name: &str) -> String {
    let step = |key: &str| match program_unit(key) {
        Some((
            bare,
            Unit {
                ending,
                si: [si, ..],
                ..
            },
        )) if !["_deg", "_dps"].contains(ending) => {
            format!("{bare}{}", si.ending)
        }
        _ => key.to_owned(),
    };
    name.split('.').map(step).collect::<Vec<_>>().join(".")
}

/// Spelling with the unit of the program of a name, possibly dotted, with an SI unit: of feet and inches with feet.
pub(crate) fn program_spelling(name: &str) -> String {
    let step = |key: &str| {
        let units = UNITS.iter().rev();
        let endings = units.flat_map(|unit| unit.si.iter().map(move |si| (si.ending, unit.ending)));
        let bare = endings.filter_map(|(si, program)| Some((key.strip_suffix(si)?, program)));
        match bare.max_by_key(|(bare, _)| Reverse(bare.len())) {
            Some((bare, program)) => format!("{bare}{program}"),
            None => key.to_owned(),
        }
    };
    name.split('.').map(step).collect::<Vec<_>>().join(".")
}

/// Guesses the meaning of an unknown key: all spellings of a known key if only the unit is wrong, else the most similar
/// spelling.
pub(crate) fn meant(unknown: &str, known: &[&str]) -> Vec<String> {
    if let Some(key) = known.iter().find(|key| differ_in_unit(unknown, key)) {
        return spellings(key);
    }
    let all: Vec<String> = (known.iter())
        .map(|key| with_unit_of(unknown, key))
        .collect();
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    let nearest = nearest(unknown, &all);
    nearest.map(str::to_owned).into_iter().collect()
}

/// Asks whether one of these was meant; empty without names.
pub(crate) fn did_you_mean(names: &[String]) -> String {
    match names {
        [] => String::new(),
        names => format!("did you mean {}? ", names.join(" or ")),
    }
}

/// Spelling of a key with the unit that a name ends with; else the program's.
pub(crate) fn with_unit_of(name: &str, key: &str) -> String {
    let spelled = program_unit(key).and_then(|(bare, unit)| {
        let fits = unit.si.iter().filter(|si| name.ends_with(si.ending));
        let si = fits.max_by_key(|si| si.ending.len())?;
        Some(format!("{bare}{}", si.ending))
    });
    spelled.unwrap_or_else(|| key.to_owned())
}

/// True if an unknown key differs from a known one only in its unit.
pub(crate) fn differ_in_unit(unknown: &str, key: &str) -> bool {
    let rest = program_unit(key).and_then(|(bare, _)| unknown.strip_prefix(bare));
    rest.is_some_and(is_unit)
}

/// The known name most similar to `name`, if similar enough.
fn nearest<'n>(name: &str, known: &[&'n str]) -> Option<&'n str> {
    let likeness = |candidate: &&str| strsim::jaro_winkler(name, candidate);
    known
        .iter()
        .copied()
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
        .filter(|candidate| likeness(candidate) > 0.7)
}

/// True if the ending of a key is that of a known unit, or a single word that may be meant as one.
fn is_unit(ending: &str) -> bool {
    let known = |unit: &Unit| unit.ending == ending || unit.si.iter().any(|si| si.ending == ending);
    let is_word = ending.starts_with('_') && ending.matches('_').count() == 1;
    is_word || UNITS.iter().any(known)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn converted(spelling: &str, key: &str, number: f64) -> Option<f64> {
        dotted_conversion(spelling, key).map(|conversion| conversion.to_program(number))
    }

    #[test]
    fn decimals_of_the_program_come_back_from_any_unit() {
        for unit in &UNITS {
            for si in unit.si {
                let (spelling, key) = (format!("x{}", si.ending), format!("x{}", unit.ending));
                let conversion = conversion(&spelling, &key).unwrap();
                for index in 1..20_000 {
                    let number = f64::from(index * 7) / 1000.0;
                    let there = number * si.factor;
                    assert_eq!(conversion.to_program(there), number, "{spelling} = {there}");
                    // What is no decimal stays what it is.
                    let between = there * (1.0 + 1e-15 * std::f64::consts::PI);
                    let error = conversion.to_program(between) * si.factor / between - 1.0;
                    assert!(error.abs() < 4.0 * f64::EPSILON, "{spelling} = {between}");
                }
            }
        }
    }

    #[test]
    fn numbers_that_are_exact_in_both_units_are_met() {
        for (spelling, key, number, expected) in [
            ("height_m", "height_ft", 0.3048, 1.0),
            ("height_mm", "height_ft", 1524.0, 5.0),
            ("stroke_mm", "stroke_in", 6.35, 0.25),
            ("stroke_mm", "stroke_in", 19.05, 0.75),
            ("preload_n", "preload_lb", 444.82216152605, 100.0),
            ("velocity_mps", "velocity_fps", 4.2672, 14.0),
            (
                "inertia_kg_m2.xx",
                "inertia_slug_ft2.xx",
                13.558179483314004,
                10.0,
            ),
            ("slope_rad", "slope_deg", std::f64::consts::PI, 180.0),
            ("friction", "friction", 0.8, 0.8),
        ] {
            assert_eq!(
                converted(spelling, key, number),
                Some(expected),
                "{spelling}"
            );
        }
    }

    #[test]
    fn other_quantities_and_other_units_are_no_spellings() {
        for (spelling, key) in [
            ("mass_n", "mass_slug"),
            ("mass", "mass_slug"),
            ("height_m", "diameter_ft"),
            ("height_ft", "stroke_in"),
            ("friction_m", "friction"),
            ("strut.preload_n", "preload_lb"),
            ("time_limit_ms", "time_limit_s"),
        ] {
            assert_eq!(dotted_conversion(spelling, key), None, "{spelling}");
        }
    }

    #[test]
    fn a_wrong_unit_brings_all_allowed_ones_to_mind() {
        let known = ["name", "mass_slug", "height_ft", "friction"];
        assert_eq!(meant("mass_lb", &known), ["mass_slug", "mass_kg"]);
        assert_eq!(meant("mass_tons", &known), ["mass_slug", "mass_kg"]);
        assert_eq!(meant("hight_mm", &known), ["height_mm"]);
        assert_eq!(meant("frictoin", &known), ["friction"]);
        assert!(meant("colour", &["mass_slug"]).is_empty());
    }
}
