//! Table of the bands of a sweep.

use crate::bands::Band;
use crate::boundary::Boundary;
use crate::certainty::tolerance_cell;
use crate::results::optional;
use crate::sweep_file::Sweep;

/// Columns of the table after the axes.
pub const COLUMNS: [&str; 10] = [
    "band",
    "from_fps",
    "to_fps",
    "outcome",
    "bracket_width_fps",
    "kind",
    "certainty",
    "disputed_from_fps",
    "disputed_to_fps",
    "solver_tolerance",
];

/// Heading of the table of bands.
pub fn heading(sweep: &Sweep) -> Vec<String> {
    sweep.heading(COLUMNS)
}

/// Rows of a point: one for each band, lowest first.
///
/// `outcome` is the class of the band's landings, `kind` the outcome of the one nearest to its middle.
/// `bracket_width_fps`, `certainty` and the following columns refer to `to_fps`; they are empty at the end of the
/// range. If `certainty` is `disputed`, small changes decide between the two speeds that follow.
pub fn rows(sweep: &Sweep, point: usize, boundary: &Boundary) -> Vec<Vec<String>> {
    let coordinates = sweep.coordinates_written(point);
    let row = |(index, band): (usize, &Band)| {
        let width = band.bracket.map(|bracket| bracket.width);
        let tolerance = band.bracket.map(|bracket| bracket.tolerance);
        let cells = [
            (index + 1).to_string(),
            band.from.to_string(),
            band.to.to_string(),
            band.class.to_string(),
            optional(width),
            band.outcome.to_string(),
        ];
        let cells = cells.into_iter().chain(band.certainty.cells());
        let cells = cells.chain([tolerance_cell(tolerance)]);
        coordinates.iter().cloned().chain(cells).collect()
    };
    boundary.bands.iter().enumerate().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::Bracket;
    use crate::certainty::Certainty;
    use crate::sweep_file::tests::figure_4_09;
    use touchdown_dynamics::outcome::{Class, Outcome};

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
            heading(&sweep).join(","),
            "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps,kind,certainty,\
             disputed_from_fps,disputed_to_fps,solver_tolerance"
        );
        let rows = rows(&sweep, 0, &boundary).into_iter();
        assert_eq!(
            rows.map(|row| row.join(",")).collect::<Vec<_>>(),
            [
                "-60,1,0,11.5,stable,0.25,stable-subsided,disputed,11.25,12,1e-7",
                "-60,2,11.5,25,unstable,,unstable-yaw,,,,"
            ]
        );
    }
}
