//! Sliders with round ends and steps.

use serde::Serialize;

/// About so many steps a slider has.
const STEPS: f64 = 200.0;

/// A slider.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Slider {
    from: f64,
    to: f64,
    step: f64,
}

impl Slider {
    /// Over a range that is rounded outward and grown to hold the value.
    pub fn over([from, to]: [f64; 2], value: f64) -> Self {
        let (from, to) = (from.min(value), to.max(value));
        let step = round_step((to - from) / STEPS);
        Self {
            from: multiple((from / step).floor(), step).min(value),
            to: multiple((to / step).ceil(), step).max(value),
            step,
        }
    }
}

/// The step of 1, 2 or 5 times a power of ten next above a number.
fn round_step(step: f64) -> f64 {
    let power = step.log10().floor();
    let digits = step / 10f64.powf(power);
    let round = [1.0, 2.0, 5.0].into_iter().find(|round| digits <= *round);
    decimal(round.unwrap_or(10.0), power as i32)
}

/// A multiple of a step, without rounding of binary numbers.
fn multiple(count: f64, step: f64) -> f64 {
    let power = step.log10().floor() as i32;
    let digits = (step / 10f64.powi(power)).round();
    decimal(count * digits, power)
}

/// digits · 10^power as the decimal reads.
fn decimal(digits: f64, power: i32) -> f64 {
    format!("{digits}e{power}").parse().unwrap_or(digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_steps_are_round_and_hold_the_value() {
        assert_eq!(
            Slider::over([0.0, 2.0], 1.0),
            Slider {
                from: 0.0,
                to: 2.0,
                step: 0.01
            }
        );
        assert_eq!(
            Slider::over([0.0, 30.0], 31.5),
            Slider {
                from: 0.0,
                to: 31.6,
                step: 0.2
            }
        );
        assert_eq!(
            Slider::over([0.077, 0.6], 0.3),
            Slider {
                from: 0.075,
                to: 0.6,
                step: 0.005
            }
        );
        assert_eq!(
            Slider::over([0.0, 0.9], 0.05),
            Slider {
                from: 0.0,
                to: 0.9,
                step: 0.005
            }
        );
    }
}
