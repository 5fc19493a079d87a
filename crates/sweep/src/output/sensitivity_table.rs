//! Table of sensitivities: one row for each point and parameter.
//!
//! `vh_change_fps` is the change of V_H, by the derivative, for a change of the parameter by `span`: 10 % of it, 1 deg
//! (deg/s) for an angle (rate of turn), or the step for a parameter that is 0. The numbers are empty unless the
//! dependence is `smooth`. Cells about the parameter are in the units of results; those about V_H are in program units
//! until the table is written.

use crate::boundary::Boundary;
use crate::parameter::Parameter;
use crate::results::{optional, transition_name};
use crate::sensitivity::{Dependence, Sensitivity, Slope};
use crate::sweep_file::Sweep;

/// Columns of the table after the axes.
pub const COLUMNS: [&str; 12] = [
    "parameter",
    "unit",
    "value",
    "first_transition_to",
    "first_transition_fps",
    "dependence",
    "step",
    "dvh_dp_fps_per_unit",
    "dvh_dp_error_fps_per_unit",
    "span",
    "vh_change_fps",
    "vh_change_error_fps",
];

/// Span: the change of a parameter for which the change of V_H is listed, as a fraction of the parameter.
const SPAN: f64 = 0.1;
/// Span of angles and rates of turn, deg and deg/s.
const ANGULAR_SPAN: f64 = 1.0;

/// Heading of the table.
pub fn heading(sweep: &Sweep) -> Vec<String> {
    sweep.heading(COLUMNS)
}

/// Rows of a point, one for each parameter, in the order of the sweep file.
pub fn rows(
    sweep: &Sweep,
    point: usize,
    boundary: &Boundary,
    sensitivity: &Sensitivity,
) -> Vec<Vec<String>> {
    let coordinates = sweep.coordinates_written(point);
    let slopes = sweep.sensitivity.iter().zip(&sensitivity.slopes);
    let row = |(parameter, slope): (&Parameter, &Slope)| {
        let value = sweep.value(point, parameter);
        let own = sweep.units.quantity(parameter.name());
        let cells = [
            own.name().to_owned(),
            own.unit().to_owned(),
            optional(value.map(|value| own.number(value))),
            transition_name(boundary),
            optional(sensitivity.speed),
            slope.dependence.word().to_owned(),
            optional(slope.step.map(|step| own.number(step))),
        ];
        let numbers = match (slope.dependence, value.zip(slope.step)) {
            (Dependence::Smooth { derivative, error }, Some((value, step))) => {
                let span = span(parameter, value, step);
                let per_unit = [derivative, error].map(|slope| Some(own.derivative(slope)));
                let changes = [derivative * span, error * span].map(Some);
                [
                    per_unit[0],
                    per_unit[1],
                    Some(own.number(span)),
                    changes[0],
                    changes[1],
                ]
            }
            _ => [None; 5],
        };
        let cells = cells.into_iter().chain(numbers.map(optional));
        coordinates.iter().cloned().chain(cells).collect()
    };
    slopes.map(row).collect()
}

fn span(parameter: &Parameter, value: f64, step: f64) -> f64 {
    if parameter.is_angular() {
        parameter.in_own_unit(ANGULAR_SPAN)
    } else if value == 0.0 {
        step
    } else {
        SPAN * value.abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep_file::tests::figure_4_09;

    #[test]
    fn numbers_stand_where_there_is_a_derivative_and_words_elsewhere() {
        let mut sweep = figure_4_09();
        let named = |name| Parameter::named(name, 3).unwrap();
        sweep.sensitivity = vec![
            named("vehicle.legs[2].strut.preload_lb"),
            named("roll_deg"),
            named("friction"),
        ];
        let slope = |step, dependence| Slope { step, dependence };
        let smooth = |derivative, error| Dependence::Smooth { derivative, error };
        let sensitivity = Sensitivity {
            speed: Some(11.25),
            slopes: vec![
                slope(Some(6.5), smooth(-0.5, 0.25)),
                slope(Some(1.0), smooth(0.125, 0.0)),
                slope(None, Dependence::Jumps),
            ],
            ..Sensitivity::default()
        };
        let rows = rows(&sweep, 3, &Boundary::default(), &sensitivity);
        assert!(rows.iter().all(|row| row.len() == heading(&sweep).len()));
        let rows: Vec<String> = rows.iter().map(|row| row.join(",")).collect();
        assert_eq!(
            rows,
            [
                "-45,vehicle.legs[2].strut.preload_lb,lb,185,none,11.25,smooth,6.5,-0.5,0.25,\
                 18.5,-9.25,4.625",
                "-45,roll_deg,deg,-45,none,11.25,smooth,1,0.125,0,1,0.125,0",
                "-45,friction,1,1,none,11.25,jumps,,,,,,",
            ]
        );
    }
}
