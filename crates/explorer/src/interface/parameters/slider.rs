//! Sliders with round ends and steps.

use serde::Serialize;

use super::ranges::Allowed;

/// Approximate number of steps of a slider.
const STEPS: f64 = 200.0;

/// A slider.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Slider {
    from: f64,
    to: f64,
    step: f64,
}

impl Slider {
    /// Builds a slider over a range that is rounded outward, extended to the value and limited to what is allowed.
    pub fn over([from, to]: [f64; 2], value: f64, allowed: &Allowed) -> Self {
        let (from, to) = (from.min(value), to.max(value));
        let step = round_step((to - from) / STEPS);
        let inner = |end: f64, is_open: bool, toward: f64| {
            (end / step).round() + if is_open { toward } else { 0.0 }
        };
        let lowest = inner(allowed.lower, allowed.is_lower_open, 1.0);
        let highest = inner(allowed.upper, allowed.is_upper_open, -1.0);
        let low = (from / step).floor().max(lowest);
        let high = (to / step).ceil().min(highest);
        Self {
            from: multiple(low, step).min(value),
            to: multiple(high, step).max(value),
            step,
        }
    }
}

/// The next step of 1, 2 or 5 times a power of ten, at or above a number.
fn round_step(step: f64) -> f64 {
    let power = step.log10().floor();
    let digits = step / 10f64.powf(power);
    let round = [1.0, 2.0, 5.0].into_iter().find(|round| digits <= *round);
    decimal(round.unwrap_or(10.0), power as i32)
}

/// A multiple of a step, exact in decimals.
fn multiple(count: f64, step: f64) -> f64 {
    let power = step.log10().floor() as i32;
    let digits = (step / 10f64.powi(power)).round();
    decimal(count * digits, power)
}

/// The decimal digits · 10^power.
fn decimal(digits: f64, power: i32) -> f64 {
    format!("{digits}e{power}").parse().unwrap_or(digits)
}

#[cfg(test)]
mod tests {
    use touchdown_input::points::parameter::Parameter;

    use super::*;

    #[test]
    fn ends_and_steps_are_round_and_hold_the_value() {
        let slider = |name, range, value| {
            let parameter = Parameter::named(name, 3).unwrap();
            Slider::over(range, value, &Allowed::of(parameter.quantity()))
        };
        assert_eq!(
            slider("friction", [0.0, 2.0], 1.0),
            Slider {
                from: 0.0,
                to: 2.0,
                step: 0.01
            }
        );
        assert_eq!(
            slider("horizontal_velocity_fps", [0.0, 30.0], 31.5),
            Slider {
                from: 0.0,
                to: 31.6,
                step: 0.2
            }
        );
        assert_eq!(
            slider("vehicle.mass_slug", [0.0, 0.7], 0.3),
            Slider {
                from: 0.005,
                to: 0.7,
                step: 0.005
            }
        );
        assert_eq!(
            slider("vehicle.strut.friction_fraction", [0.0, 0.9], 0.05),
            Slider {
                from: 0.0,
                to: 0.9,
                step: 0.005
            }
        );
        assert_eq!(
            slider("slope_deg", [-30.0, 45.0], 15.0),
            Slider {
                from: -30.0,
                to: 45.0,
                step: 0.5
            }
        );
    }
}
