//! Table of sensitivities: one row for each point and parameter.
//!
//! `vh_change_fps` is the change of V_H, by the derivative, for a change of the parameter by `span`: 10 % of it, 1 deg
//! (deg/s) for an angle (rate of turn), or the step for a parameter that is 0. Where there is no derivative, searches at
//! the ends of the span take its place. Cells about the parameter are in the units of results; those about V_H are in
//! program units until the table is written.

use touchdown_input::documents::column::{Cell, Column, Heading, cells, headings};
use touchdown_input::documents::output_units::Quantity;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::Boundary;

use crate::output::results::transition_name;
use crate::sensitivity::{Dependence, Sensitivity, Slope, span};

/// A parameter at a point, and how its transition depends on it.
#[derive(Debug)]
pub struct AtPoint {
    /// The parameter in the units of results.
    own: Quantity,
    /// Its value in program units.
    value: Option<f64>,
    transition_to: String,
    /// Transition velocity, ft/s.
    speed: Option<f64>,
    slope: Slope,
    /// Span of the parameter, if V_H changes with it in a way that is told.
    span: Option<f64>,
    smooth: Option<Smooth>,
}

/// A derivative with its error estimate, per program unit of the parameter, and changes of V_H over the span, ft/s.
#[derive(Debug)]
struct Smooth {
    derivative: f64,
    error: f64,
    change: f64,
    change_error: f64,
}

/// Columns of the table after the axes.
pub const COLUMNS: [Column<AtPoint>; 14] = [
    Column::word(
        "parameter",
        |at| at.own.name().to_owned(),
        "dotted name of the parameter p",
    ),
    Column::word("unit", |at| at.own.unit().to_owned(), "its unit"),
    Column::number(
        "value",
        |at: &AtPoint| at.value.map(|value| at.own.number(value)),
        "its value at this point",
    )
    .in_unit("of p"),
    Column::word(
        "first_transition_to",
        |at| at.transition_to.clone(),
        "as in [transitions](#transitions)",
    ),
    Column::number(
        "first_transition_fps",
        |at| at.speed,
        "V_H, narrowed down further than by the search",
    ),
    Column::word(
        "dependence",
        |at| at.slope.dependence.word().to_owned(),
        "`smooth` (0 ± 0 where a step changes nothing of the landing at V_H, to the last bit); `kinked`: \
         another slope to either side; `jumps`; `vanishes`: no transition within the step; `not-allowed`: the \
         step leads to forbidden input; `disputed`: the transition itself is; `none`: no transition; \
         `no-step`: p is 0, and neither an angle, a length nor a product of inertia",
    ),
    Column::number(
        "step",
        |at: &AtPoint| at.slope.step.map(|step| at.own.number(step)),
        "step h to either side",
    )
    .in_unit("of p"),
    Column::number(
        "dvh_dp_fps_per_unit",
        |at: &AtPoint| (at.smooth.as_ref()).map(|one| at.own.derivative(one.derivative)),
        "dV_H/dp; empty unless `smooth`",
    )
    .in_unit("ft/s per unit"),
    Column::number(
        "dvh_dp_error_fps_per_unit",
        |at: &AtPoint| (at.smooth.as_ref()).map(|one| at.own.derivative(one.error)),
        "estimate of its largest error",
    )
    .in_unit("ft/s per unit"),
    Column::number(
        "span",
        |at: &AtPoint| at.span.map(|span| at.own.number(span)),
        "10 % of p, or 1 deg (1 deg/s) of an angle (rate), or the step where p is 0",
    )
    .in_unit("of p"),
    Column::number(
        "vh_change_fps",
        |at| at.smooth.as_ref().map(|one| one.change),
        "change of V_H for a change of p by `span`, by the derivative; empty unless `smooth`",
    ),
    Column::number(
        "vh_change_error_fps",
        |at| at.smooth.as_ref().map(|one| one.change_error),
        "estimate of its largest error",
    ),
    Column::number(
        "vh_at_minus_span_fps",
        |at| at.slope.ends[0],
        "V_H at p − `span`, by a search, where the dependence is `kinked`, `jumps` or `vanishes`; empty if there is \
         no transition, or the input is not allowed",
    ),
    Column::number(
        "vh_at_plus_span_fps",
        |at| at.slope.ends[1],
        "the same at p + `span`",
    ),
];

/// Headings of the table.
pub fn heading(sweep: &Sweep) -> Vec<Heading> {
    sweep.headings(headings(&COLUMNS, sweep.leg_count()))
}

/// Rows of a point, one for each parameter, in the order of the sweep file.
pub fn rows(
    sweep: &Sweep,
    point: usize,
    boundary: &Boundary,
    sensitivity: &Sensitivity,
) -> impl Iterator<Item = Vec<Cell>> {
    let coordinates = sweep.cells_of_point(point);
    let slopes = sweep.sensitivity.iter().zip(&sensitivity.slopes);
    slopes.map(move |(parameter, slope)| {
        let value = sweep.value(point, parameter);
        let span = (value.zip(slope.step))
            .filter(|_| slope.dependence.has_span())
            .map(|(value, step)| span(parameter, value, step));
        let smooth = match (slope.dependence, span) {
            (Dependence::Smooth { derivative, error }, Some(span)) => Some(Smooth {
                derivative,
                error,
                change: derivative * span,
                change_error: error * span,
            }),
            _ => None,
        };
        let at = AtPoint {
            own: sweep.units.quantity(parameter.name()),
            value,
            transition_to: transition_name(boundary),
            speed: sensitivity.speed,
            slope: *slope,
            span,
            smooth,
        };
        let cells = cells(&COLUMNS, &at, sweep.leg_count());
        coordinates.iter().cloned().chain(cells).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::{figure_4_09, text};
    use touchdown_input::points::parameter::Parameter;

    #[test]
    fn numbers_stand_where_there_is_a_derivative_and_words_elsewhere() {
        let mut sweep = figure_4_09();
        let named = |name| Parameter::named(name, 3).unwrap();
        sweep.sensitivity = vec![
            named("vehicle.legs[2].strut.preload_lb"),
            named("roll_deg"),
            named("friction"),
            named("slope_deg"),
        ];
        let smooth = |derivative, error| Dependence::Smooth { derivative, error };
        let sensitivity = Sensitivity {
            speed: Some(11.25),
            slopes: vec![
                Slope::new(Some(6.5), smooth(-0.5, 0.25)),
                Slope::new(Some(1.0), smooth(0.125, 0.0)),
                Slope {
                    ends: [Some(10.5), None],
                    ..Slope::new(Some(0.03), Dependence::Jumps)
                },
                Slope::new(Some(0.03), Dependence::NotAllowed),
            ],
            ..Sensitivity::default()
        };
        let rows: Vec<_> = rows(&sweep, 3, &Boundary::default(), &sensitivity).collect();
        assert!(rows.iter().all(|row| row.len() == heading(&sweep).len()));
        assert_eq!(
            rows.into_iter().map(text).collect::<Vec<_>>(),
            [
                "-45,vehicle.legs[2].strut.preload_lb,lb,185,none,11.25,smooth,6.5,-0.5,0.25,\
                 18.5,-9.25,4.625,,",
                "-45,roll_deg,deg,-45,none,11.25,smooth,1,0.125,0,1,0.125,0,,",
                "-45,friction,1,1,none,11.25,jumps,0.03,,,0.1,,,10.5,",
                "-45,slope_deg,deg,15,none,11.25,not-allowed,0.03,,,,,,,",
            ]
        );
    }
}
