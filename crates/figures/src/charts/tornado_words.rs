//! Words for the rows and the axis of a tornado chart.

use crate::axis_title::parameter_words;
use crate::sensitivity_table::{Point, Slope};
use crate::unit::{SpeedUnit, printed_unit, unit_of};
use crate::words::label;
use libm::{exp10, log10};

/// Name, value and change of a parameter.
pub fn name(slope: &Slope) -> String {
    let mut name = parameter_words(&slope.parameter);
    let unit = printed_unit(&slope.unit);
    if let Some(value) = slope.value {
        name += &format!("  {} {unit}", label(value));
    }
    match slope.change {
        // Angles change by a degree, all else by a tenth.
        Some(change)
            if ["deg", "rad"]
                .iter()
                .any(|unit| slope.unit.starts_with(unit)) =>
        {
            format!("{} ± {} {unit}", name.trim_end(), label(change.span))
        }
        Some(_) => format!("{} ± 10 %", name.trim_end()),
        None => name,
    }
}

/// Reason why a parameter has no bar.
pub fn reason(slope: &Slope) -> String {
    let within = |words: &str| match slope.step {
        Some(step) => {
            let digits = exp10(2.0 - log10(step.abs()).ceil());
            let step = label((step * digits).round() / digits);
            format!("{words} within ± {step} {}", printed_unit(&slope.unit))
        }
        None => words.to_owned(),
    };
    match slope.dependence.as_str() {
        "jumps" => within("V_H jumps"),
        "kinked" => within("V_H has a kink"),
        "vanishes" => within("no transition any more"),
        "not-allowed" => within("not allowed"),
        "no-step" => "0: no step follows".to_owned(),
        other => other.to_owned(),
    }
}

/// Title of the axis: a change from the transition of a point.
pub fn title(lowest: &Point, speed_unit: SpeedUnit) -> String {
    let place = lowest.place.iter();
    let place = place.map(|(name, value)| {
        let unit = unit_of(name);
        let value = value.replace('-', "\u{2212}");
        format!("{} {value} {unit}", parameter_words(name))
            .trim_end()
            .to_owned()
    });
    let place = place.collect::<Vec<_>>().join(", ");
    let speed = lowest
        .speed
        .map_or(0.0, |speed| (speed * 1e3).round() / 1e3);
    let speed = label(speed);
    format!("Change of V_H, {speed_unit}, from {speed} {speed_unit} at {place}")
}
