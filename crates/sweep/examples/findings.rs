//! What the first points of a sweep come to, to the last bit: for comparing builds and machines.
//!
//! ```text
//! cargo run -p touchdown-sweep --example findings -- sweeps/stress/wild.toml 40
//! ```
//!
//! A build without optimization (`--profile dev`) prints the same lines as one with it (`--release`).

use std::error::Error;
use std::path::Path;

use touchdown_sweep::input::sweeps::sweep_file::Sweep;
use touchdown_sweep::threads::run::Workers;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, count] = arguments.as_slice() else {
        return Err("name a sweep file and a number of points".into());
    };
    let sweep: Sweep = Sweep::read(Path::new(file))?;
    let points: Vec<usize> = (0..sweep.design.count().min(count.parse()?)).collect();
    let found = Workers::start(None)?.points(&sweep, &points)?;
    for (point, finding) in points.iter().zip(&found) {
        // Numbers are written with all the digits that tell them from their neighbours.
        println!("{}: {finding:?}", sweep.place(*point));
    }
    Ok(())
}
