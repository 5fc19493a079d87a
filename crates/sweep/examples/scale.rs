//! What a sweep of many points costs besides its landings: journal, index, tables.
//!
//! ```text
//! cargo run --release -p touchdown-sweep --example scale -- 10000000 16
//! ```
//!
//! makes up results for so many points in so many shards, journals them slightly out of order, as
//! threads do, and writes the table from the journals. Prints rates, sizes, and the most memory
//! that was ever in use, where the system tells.

use std::error::Error;
use std::fs;
use std::time::Instant;

use touchdown_dynamics::outcome::Class;
use touchdown_sweep::input::sweeps::sweep_file::Sweep;
use touchdown_sweep::journal::header::Header;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::journal::{InOrder, Journal};
use touchdown_sweep::output::file_writer::{Draft, Folder};
use touchdown_sweep::output::tables::Tables;
use touchdown_sweep::search::boundary::{Boundary, Transition};
use touchdown_sweep::search::certainty::Certainty;
use touchdown_sweep::summary::findings::Finding;

const SWEEP: &str = include_str!("../../../sweeps/figure-4-09.toml");
const SURVEYOR: &str = include_str!("../../../sweeps/vehicles/surveyor-table-4-1.toml");
/// Points that change places, as if so many threads were at work.
const DISORDER: usize = 16;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut number = |default: usize| match arguments.next() {
        Some(text) => text.parse::<usize>(),
        None => Ok(default),
    };
    let (points, shards) = (number(100_000)?, number(1)?);
    let home = tempfile::tempdir()?;
    fs::create_dir(home.path().join("vehicles"))?;
    fs::write(
        home.path().join("vehicles/surveyor-table-4-1.toml"),
        SURVEYOR,
    )?;
    let file = home.path().join("scale.toml");
    let axis = format!("roll_deg = {{ from = -60, to = 60, count = {points} }}");
    fs::write(
        &file,
        SWEEP.replace("roll_deg = { from = -60, to = 60, step = 5 }", &axis),
    )?;
    let sweep: Sweep = Sweep::read(&file)?;

    let start = Instant::now();
    let mut journals = Vec::new();
    let mut bytes = 0;
    for number in 1..=shards {
        let shard = Shard::new(number, shards).ok_or("no such shard")?;
        let header = Header::new(&sweep, "0", shard).map_err(|fault| fault.to_string())?;
        let path = home.path().join(format!("{number}.journal"));
        let mut journal = Journal::open(&path, &header)?.journal;
        let count = shard.len(points);
        for begin in (0..count).step_by(DISORDER) {
            for index in (begin..count.min(begin + DISORDER)).rev() {
                let point = shard.point(index);
                journal.add(point, &made_up(point).encode())?;
                journal.tick()?;
            }
        }
        journals.push(journal.into_records()?);
        bytes += fs::metadata(&path)?.len();
    }
    told("journal", points, start);
    println!("journal: {:.1} bytes a point", bytes as f64 / points as f64);

    let start = Instant::now();
    let mut results = InOrder::new(journals, points, home.path())?;
    told("index", points, start);
    let start = Instant::now();
    let folder = Folder::open(home.path())?;
    let tables = Tables::write(&sweep, &mut results, &folder, false)?;
    told("tables", points, start);
    let files = Draft::put_in_place(vec![tables.points])?;
    let table = fs::metadata(&files[0])?.len();
    println!("table: {:.1} bytes a point", table as f64 / points as f64);
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    if let Some(peak) = status.lines().find(|line| line.starts_with("VmHWM")) {
        println!("{peak}");
    }
    Ok(())
}

fn told(what: &str, points: usize, start: Instant) {
    let rate = points as f64 / start.elapsed().as_secs_f64();
    println!("{what}: {rate:.0} points/s");
}

/// A result like that of any point.
fn made_up(point: usize) -> Finding {
    let low = 11.0 + (point % 997) as f64 / 1024.0;
    Finding::Boundary(Boundary {
        transition: Some(Transition {
            to: Class::Unstable,
            low: Some(low),
            high: low + 1.0 / 1024.0,
            tolerance: 3e-5,
            certainty: Certainty::Certain,
        }),
        landings: 54,
        evaluations: 300_000 + point as u64 % 1000,
        ..Boundary::default()
    })
}
