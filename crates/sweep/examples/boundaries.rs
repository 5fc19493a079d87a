//! Boundaries over a batch of designs: how the preload of the struts and the height of the center of gravity move V_H.
//!
//! ```text
//! cargo run --release -p touchdown-sweep --example boundaries
//! ```

use std::error::Error;
use std::fs;
use std::path::Path;

use touchdown_sweep::input::documents::library::{Library, Source};
use touchdown_sweep::input::sweeps::sweep_file::Sweep;
use touchdown_sweep::threads::run::Workers;

const VEHICLE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../sweeps/vehicles/surveyor-table-4-1.toml"
);

/// The sweep: straight downhill, searched up to the first transition.
const SWEEP: &str = r#"
vehicle = "surveyor.toml"

[scene]
vertical_velocity_fps = 14
cross_slope_deg = 180
slope_deg = 15
friction = 1.0

[axes]
vehicle.strut.preload_lb = [100, 185, 300]
vehicle.center_of_gravity_height_ft = [1.2, 1.445, 1.7]

[search]
from_fps = 5
to_fps = 20
scan_step_fps = 0.25
tolerance_fps = 0.001
"#;

fn main() -> Result<(), Box<dyn Error>> {
    // Files need not lie on the disk.
    let file = |path: &str, text: String| Source {
        path: path.into(),
        text,
    };
    let files = [
        file("designs.toml", SWEEP.to_owned()),
        file("surveyor.toml", fs::read_to_string(VEHICLE)?),
    ];
    let sweep = Sweep::read_from(Path::new("designs.toml"), Library::Copies(&files))?;

    // All cores share the landings of all searches.
    let points: Vec<usize> = (0..sweep.design.count()).collect();
    let findings = Workers::start(None)?.points(&sweep, &points)?;

    for (point, finding) in points.iter().zip(&findings) {
        let Some(boundary) = finding.boundary() else {
            continue;
        };
        let place = sweep.place(*point);
        match &boundary.transition {
            Some(transition) => println!(
                "{place}: {:.3} ft/s, then {}; {} landings",
                transition.speed(),
                transition.to,
                boundary.landings,
            ),
            None => println!("{place}: stable up to {} ft/s", boundary.searched_to),
        }
    }
    Ok(())
}
