//! Table of the bands of a sweep.

use touchdown_input::documents::column::{Cell, Column, Heading, cells, headings};
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_search::boundary::{Band, Boundary};

/// A band and its number at a point, from 1.
#[derive(Debug)]
pub struct Numbered {
    number: u64,
    band: Band,
}

/// Columns of the table after the axes.
pub const COLUMNS: [Column<Numbered>; 10] = [
    Column::count(
        "band",
        |one| one.number,
        "number of the band at this point, from 1",
    ),
    Column::number("from_fps", |one| Some(one.band.from), "lower end"),
    Column::number("to_fps", |one| Some(one.band.to), "upper end"),
    Column::word(
        "outcome",
        |one| one.band.class.to_string(),
        "class of its landings: `stable`, `unstable`, `bottomed`, `failure`, `undecided`",
    ),
    Column::number(
        "bracket_width_fps",
        |one| one.band.bracket.map(|bracket| bracket.width),
        "width of the bracket at `to_fps`; empty at the end of the range",
    ),
    Column::word(
        "kind",
        |one| one.band.outcome.to_string(),
        "outcome of the landing nearest to the middle of the band, such as `stable-rockback`",
    ),
    Column::word(
        "certainty",
        |one| one.band.certainty.word().to_owned(),
        "of the transition at `to_fps`, as in [transitions](#transitions)",
    ),
    Column::number(
        "disputed_from_fps",
        |one| one.band.certainty.disputed()[0],
        "lower end of what is disputed",
    ),
    Column::number(
        "disputed_to_fps",
        |one| one.band.certainty.disputed()[1],
        "upper end of what is disputed",
    ),
    Column::power(
        "solver_tolerance",
        |one| one.band.bracket.map(|bracket| bracket.tolerance),
        "tolerance at which both ends of the bracket at `to_fps` were landed, as in [transitions](#transitions)",
    ),
];

/// Headings of the table of bands.
pub fn heading(sweep: &Sweep) -> Vec<Heading> {
    sweep.headings(headings(&COLUMNS, sweep.leg_count()))
}

/// Rows of a point: one for each band, lowest first.
pub fn rows(sweep: &Sweep, point: usize, boundary: &Boundary) -> impl Iterator<Item = Vec<Cell>> {
    let coordinates = sweep.cells_of_point(point);
    numbered(boundary).map(move |band| {
        let cells = cells(&COLUMNS, &band, sweep.leg_count());
        coordinates.iter().cloned().chain(cells).collect()
    })
}

/// The bands of a point with their numbers, lowest first.
pub fn numbered(boundary: &Boundary) -> impl Iterator<Item = Numbered> {
    (1..).zip(&boundary.bands).map(|(number, band)| Numbered {
        number,
        band: band.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::{figure_4_09, names, text};
    use touchdown_dynamics::outcome::{Class, Outcome};
    use touchdown_search::boundary::Bracket;
    use touchdown_search::certainty::Certainty;

    #[test]
    fn a_row_for_every_band() {
        let sweep = figure_4_09();
        let band = |from, to, class, outcome, bracket: Option<Bracket>| Band {
            from,
            to,
            class,
            outcome,
            bracket,
            certainty: match bracket {
                Some(_) => Certainty::Disputed([11.25, 12.0]),
                None => Certainty::Untested,
            },
        };
        let bands = vec![
            band(
                0.0,
                11.5,
                Class::Stable,
                Outcome::StableSubsided,
                Some(Bracket {
                    width: 0.25,
                    tolerance: 1e-7,
                }),
            ),
            band(11.5, 25.0, Class::Unstable, Outcome::UnstableYaw, None),
        ];
        let boundary = Boundary {
            bands,
            ..Boundary::default()
        };
        assert_eq!(
            names(heading(&sweep)),
            "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps,kind,certainty,\
             disputed_from_fps,disputed_to_fps,solver_tolerance"
        );
        let rows = rows(&sweep, 0, &boundary).map(text);
        assert_eq!(
            rows.collect::<Vec<_>>(),
            [
                "-60,1,0,11.5,stable,0.25,stable-subsided,disputed,11.25,12,1e-7",
                "-60,2,11.5,25,unstable,,unstable-yaw,,,,"
            ]
        );
    }
}
