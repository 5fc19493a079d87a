//! The values at which an axis is numbered: few, whatever the axis spans.

use libm::{exp10, log10};
/// Azimuths are numbered every eighth of a turn, deg, or every quarter or half where there is less room.
const EIGHTH: f64 = 45.0;
/// Most ticks of an axis.
const MOST: usize = 60;

/// The least of 1, 2 and 5 times a power of ten that is not below `rough`; 1 if there is none.
pub fn round_step(rough: f64) -> f64 {
    let power = exp10(log10(rough).floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let found = steps.into_iter().find(|step| *step >= rough * 0.999);
    found.filter(|step| step.is_normal()).unwrap_or(1.0)
}

/// Round values between two ends, at most about `count` of them, including the ends if they are round.
pub fn round_values(from: f64, to: f64, count: usize) -> Vec<f64> {
    multiples(from, to, round_step((to - from) / count.max(1) as f64))
}

/// Values at which the axis of a condition is numbered between two ends, about `count` of them.
pub fn of_condition(condition: &str, from: f64, to: f64, count: usize) -> Vec<f64> {
    if condition.ends_with("azimuth_deg") && (4.0..32.0).contains(&((to - from) / EIGHTH)) {
        let steps = [EIGHTH, 2.0 * EIGHTH];
        let fits = |step: &f64| (to - from) / step <= count as f64;
        return multiples(
            from,
            to,
            steps.into_iter().find(fits).unwrap_or(4.0 * EIGHTH),
        );
    }
    round_values(from, to, count)
}

/// Multiples of a step between two ends.
pub fn multiples(from: f64, to: f64, step: f64) -> Vec<f64> {
    let first = (from / step - 1e-9).ceil();
    let values = (0..MOST).map(|index| (first + index as f64) * step);
    values
        .take_while(|value| *value <= to + 1e-9 * step)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_values_lie_between_the_ends() {
        assert_eq!(
            round_values(80.0, 180.0, 6),
            [80.0, 100.0, 120.0, 140.0, 160.0, 180.0]
        );
        assert_eq!(round_values(-60.0, 60.0, 6).len(), 7);
        assert_eq!(round_step(0.37), 0.5);
        assert_eq!(round_step(800.0), 1000.0);
    }

    #[test]
    fn ticks_are_few_whatever_the_ends_are() {
        for (from, to) in [
            (0.0, 0.0),
            (1e9, 1e9),
            (1e300, 1.0000001e300),
            (-1e308, 1e308),
            (0.0, 5e-324),
            (1e16, 1e16 + 2.0),
            (0.0, f64::INFINITY),
        ] {
            let values = round_values(from, to, 10);
            assert!(values.len() <= MOST, "{from} {to}: {}", values.len());
        }
    }

    #[test]
    fn azimuths_go_by_eighths_of_a_turn() {
        let azimuths = of_condition("tip_azimuth_deg", -189.0, 189.0, 13);
        assert_eq!((azimuths[0], azimuths.len()), (-180.0, 9));
        let few = of_condition("tip_azimuth_deg", -189.0, 189.0, 5);
        assert_eq!(few, [-180.0, -90.0, 0.0, 90.0, 180.0]);
        let rolls = of_condition("roll_deg", -63.0, 63.0, 13);
        assert_eq!((rolls[0], rolls.len()), (-60.0, 13));
        assert!(of_condition("tip_azimuth_deg", 0.0, 1e9, 13).len() < 20);
    }
}
