//! Division of an axis: even, or by powers.

use crate::ticks;
use crate::words::label;
use libm::{exp10, log2, log10, pow};

/// Division of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Division {
    /// Even.
    Linear,
    /// By powers of ten, for values greater than zero.
    Decades,
    /// By powers of two, for values greater than zero within a decade or two.
    Doublings,
}

impl Division {
    /// Position of a value along the axis.
    pub fn place(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Decades => log10(value),
            Self::Doublings => log2(value),
        }
    }

    /// Positions between two others at which the axis of a condition is numbered, about `count` of them, and the
    /// numbers.
    pub fn ticks(self, condition: &str, from: f64, to: f64, count: usize) -> Vec<(f64, String)> {
        let values: Vec<(f64, f64)> = match self {
            Self::Linear => {
                let values = ticks::of_condition(condition, from, to, count).into_iter();
                return values.map(|value| (value, label(value))).collect();
            }
            Self::Decades if to - from < 1.0 => {
                let [low, high] = [from, to].map(exp10);
                let values = ticks::round_values(low, high, count).into_iter();
                values.map(|value| (log10(value), value)).collect()
            }
            Self::Decades if 3.0 * (to - from) <= count as f64 => {
                let powers = ticks::multiples(from.floor(), to.ceil(), 1.0).into_iter();
                let values = powers.flat_map(|power| [1.0, 2.0, 5.0].map(|m| m * exp10(power)));
                let places = values.map(|value| (log10(value), value));
                let is_between =
                    |(place, _): &(f64, f64)| (from - 1e-9..=to + 1e-9).contains(place);
                places.filter(is_between).collect()
            }
            Self::Decades => powers(from, to, count, 10.0),
            Self::Doublings => powers(from, to, count, 2.0),
        };
        let number = |(place, value)| (place, short(value));
        values.into_iter().map(number).collect()
    }
}

/// Powers of a base between two others, or only every second and so on if there are many: exponents and values.
fn powers(from: f64, to: f64, count: usize, base: f64) -> Vec<(f64, f64)> {
    let powers = ticks::round_values(from, to, count).into_iter();
    let powers = powers.filter(|power| power.fract() == 0.0);
    powers.map(|power| (power, pow(base, power))).collect()
}

/// A positive number with a power of ten if it is very small or great.
fn short(value: f64) -> String {
    let power = (log10(value) + 1e-9).floor();
    if (-4.0..6.0).contains(&power) {
        return label(value);
    }
    format!("{}e{}", label(value / exp10(power)), label(power))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(division: Division, from: f64, to: f64, count: usize) -> Vec<String> {
        let [from, to] = [from, to].map(|value| division.place(value));
        let ticks = division.ticks("friction", from, to, count).into_iter();
        ticks.map(|(_, number)| number).collect()
    }

    #[test]
    fn decades_have_round_numbers_however_many_there_are() {
        let decades = |from, to, count| numbers(Division::Decades, from, to, count).join(" ");
        assert_eq!(decades(0.09, 12.0, 13), "0.1 0.2 0.5 1 2 5 10");
        assert_eq!(decades(100.0, 310.0, 6), "100 150 200 250 300");
        assert_eq!(decades(1e-9, 1e9, 6), "1e\u{2212}5 1 100000");
        assert_eq!(
            decades(2e-8, 5e-8, 3),
            "2e\u{2212}8 3e\u{2212}8 4e\u{2212}8 5e\u{2212}8"
        );
    }

    #[test]
    fn doublings_are_numbered_by_powers_of_two() {
        assert_eq!(numbers(Division::Doublings, 1.9, 9.0, 12), ["2", "4", "8"]);
    }

    #[test]
    fn ticks_are_few_where_values_have_no_place() {
        for (from, to) in [(0.0, 1.0), (-1.0, 1.0), (1.0, f64::INFINITY)] {
            assert!(numbers(Division::Decades, from, to, 10).len() <= 60);
        }
    }
}
