//! The bands of a sweep as a table.

use crate::boundary::Boundary;
use crate::sweep_file::Sweep;

/// Columns of the table after those of the axes.
pub const COLUMNS: [&str; 6] = [
    "band",
    "from_fps",
    "to_fps",
    "outcome",
    "bracket_width_fps",
    "kind",
];

/// All bands as CSV: one row per band, from below, points in grid order.
///
/// `outcome` is the class that the band's landings share, `kind` how the one nearest to its middle
/// ended; `bracket_width_fps` belongs to `to_fps` and is empty at the end of the range.
///
/// # Errors
/// None but those of memory.
pub fn table<const LEGS: usize>(
    sweep: &Sweep<LEGS>,
    boundaries: &[Boundary],
) -> Result<Vec<u8>, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let axes = sweep.axes.iter().map(|axis| axis.name());
    writer.write_record(axes.chain(COLUMNS))?;
    for (point, boundary) in boundaries.iter().enumerate() {
        let coordinates = sweep.coordinates_written(point);
        for (index, band) in boundary.bands.iter().enumerate() {
            let width = band.bracket_width;
            let cells = [
                (index + 1).to_string(),
                band.from.to_string(),
                band.to.to_string(),
                band.class.to_string(),
                width.map_or(String::new(), |width| width.to_string()),
                band.outcome.to_string(),
            ];
            writer.write_record(coordinates.iter().cloned().chain(cells))?;
        }
    }
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bands::Band;
    use std::path::Path;
    use touchdown_dynamics::outcome::{Class, Outcome};

    #[test]
    fn a_row_for_every_band() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-09.toml");
        let sweep: Sweep<3> = Sweep::read(Path::new(path)).unwrap();
        let band = |from, to, class, outcome, bracket_width| Band {
            from,
            to,
            class,
            outcome,
            bracket_width,
        };
        let bands = vec![
            band(
                0.0,
                11.5,
                Class::Stable,
                Outcome::StableSubsided,
                Some(0.25),
            ),
            band(11.5, 25.0, Class::Unstable, Outcome::UnstableYaw, None),
        ];
        let boundary = Boundary {
            bands,
            ..Boundary::default()
        };
        let text = String::from_utf8(table(&sweep, &[boundary]).unwrap()).unwrap();
        assert_eq!(
            text,
            "roll_deg,band,from_fps,to_fps,outcome,bracket_width_fps,kind\n\
             -60,1,0,11.5,stable,0.25,stable-subsided\n\
             -60,2,11.5,25,unstable,,unstable-yaw\n"
        );
    }
}
