//! Several sweeps in short: one line for each.

use std::path::Path;
use std::time::Duration;

use touchdown_sweep::boundary::Boundary;
use touchdown_sweep::results::{Circumstances, count_by_kind};
use touchdown_sweep::sweep_file::Sweep;

use crate::LEGS;
use crate::summary;

const HEADING: [&str; 7] = [
    "sweep",
    "points",
    "first transition to",
    "lowest V_H, ft/s, at",
    "landings",
    "looks",
    "s",
];

/// What the overview says of a sweep.
pub struct Line {
    cells: [String; HEADING.len()],
    landings: u64,
}

impl Line {
    /// The line of a sweep that was run.
    pub fn of(sweep: &Sweep<LEGS>, boundaries: &[Boundary], circumstances: Circumstances) -> Self {
        let landings = boundaries.iter().map(|boundary| boundary.landings).sum();
        let looks: u64 = boundaries.iter().map(|boundary| boundary.looks).sum();
        let finds: u64 = boundaries.iter().map(|boundary| boundary.finds).sum();
        let lowest = match summary::lowest(sweep, boundaries) {
            Some((transition, place)) => format!("{:.3} ({place})", transition.speed()),
            None => "-".to_owned(),
        };
        Self {
            cells: [
                sweep.stem(),
                boundaries.len().to_string(),
                summary::counted(&count_by_kind(boundaries)),
                lowest,
                u64::to_string(&landings),
                format!("{finds}/{looks}"),
                format!("{:.1}", circumstances.wall_time),
            ],
            landings,
        }
    }
}

/// The table of all sweeps.
pub fn table(lines: &[Line], wall_time: Duration, out: &Path) -> String {
    let heading = HEADING.map(str::to_owned);
    let rows: Vec<&[String; HEADING.len()]> = std::iter::once(&heading)
        .chain(lines.iter().map(|line| &line.cells))
        .collect();
    let width = |column: usize| {
        let widths = rows.iter().map(|row| row[column].chars().count());
        widths.max().unwrap_or(0)
    };
    let mut text = String::new();
    for row in &rows {
        let cells = row.iter().enumerate().map(|(column, cell)| {
            let width = width(column);
            match column {
                1 | 4 | 6 => format!("{cell:>width$}"),
                _ => format!("{cell:<width$}"),
            }
        });
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text.push('\n');
    }
    let landings: u64 = lines.iter().map(|line| line.landings).sum();
    let seconds = wall_time.as_secs_f64();
    let rate = landings as f64 / seconds.max(1e-9);
    text += &format!(
        "{landings} landings in {seconds:.1} s: {rate:.0} landings/s. Looks for hidden bands are \
         given as found/looks. Results are in {}.\n",
        out.display()
    );
    text
}
