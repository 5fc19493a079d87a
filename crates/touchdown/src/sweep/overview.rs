//! A table with one line for each of several sweeps.

use std::path::Path;
use std::time::Duration;

use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::output::results::Circumstances;
use touchdown_sweep::summary::sweep_counts::SweepCounts;

use crate::summary;

/// A speed of the table.
const SPEED: &str = "speed_fps";
const HEADING: [&str; 7] = [
    "sweep",
    "points",
    "first transition to",
    "lowest V_H, UNIT, at",
    "landings",
    "checks",
    "s",
];

/// The line of a sweep.
pub struct Line {
    cells: [String; HEADING.len()],
    landings: u64,
}

impl Line {
    /// The line of a sweep that was run, with speeds in the units of the table.
    pub fn of(
        sweep: &Sweep,
        counts: &SweepCounts,
        circumstances: Circumstances,
        units: OutputUnits,
    ) -> Self {
        let lowest = match counts.lowest {
            Some((point, transition)) => {
                let number = units.quantity(SPEED).number(transition.speed());
                format!("{number:.3} ({})", sweep.place(point))
            }
            None => "-".to_owned(),
        };
        let looks = counts.checks.all();
        Self {
            cells: [
                sweep.stem(),
                counts.points.to_string(),
                summary::counted(&counts.kinds()),
                lowest,
                counts.landings.to_string(),
                format!("{}/{}", looks.finds, looks.checks),
                match circumstances.wall_time {
                    Some(seconds) => format!("{seconds:.1}"),
                    None => "-".to_owned(),
                },
            ],
            landings: counts.landings,
        }
    }
}

/// The table of all sweeps.
pub fn table(lines: &[Line], wall_time: Duration, out: &Path, units: OutputUnits) -> String {
    let unit = units.quantity(SPEED).unit();
    let heading = HEADING.map(|name| name.replace("UNIT", unit));
    let mut rows = vec![heading];
    rows.extend(lines.iter().map(|line| line.cells.clone()));
    let mut text = summary::columns(&rows, &[1, 4, 6]);
    let landings: u64 = lines.iter().map(|line| line.landings).sum();
    let seconds = wall_time.as_secs_f64();
    let rate = landings as f64 / seconds.max(1e-9);
    text += &format!(
        "{landings} landings in {seconds:.1} s: {rate:.0} landings/s. The column checks has the hidden bands found and the \
         checks made. Results are in {}.\n",
        out.display()
    );
    text
}
