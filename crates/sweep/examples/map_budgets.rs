//! A map at several budgets, each beside the others, for docs/notes/maps.md.
//!
//!     cargo run --release -p touchdown-sweep --example map_budgets -- SWEEP.toml CACHE OUT BUDGET…
//!
//! CACHE keeps what points came to, so that another budget costs only the points that are new to it. A budget counts points
//! here. OUT-BUDGET-surface.csv, -edges.csv and .csv are written for each.

#![allow(missing_docs, reason = "a study")]

use std::collections::HashMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs::{self, OpenOptions};
use std::io::Write as _;
use std::path::Path;

use touchdown_sweep::design::Design;
use touchdown_sweep::height::Height;
use touchdown_sweep::rounds::Rounds;
use touchdown_sweep::run::Workers;
use touchdown_sweep::shard::Shard;
use touchdown_sweep::surface_pieces::MapSurface;
use touchdown_sweep::sweep_file::Sweep;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, cache, out, budgets @ ..] = arguments.as_slice() else {
        return Err("SWEEP.toml CACHE OUT BUDGET…".into());
    };
    let mut sweep: Sweep = Sweep::read(Path::new(file))?;
    let workers = Workers::start(None)?;
    let mut known: HashMap<usize, (Height, u64)> = HashMap::new();
    for line in fs::read_to_string(cache).unwrap_or_default().lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let speed = words[1].parse().ok();
        let height = Height { speed, bands: 0 };
        known.insert(words[0].parse()?, (height, words[2].parse()?));
    }
    let mut kept = OpenOptions::new().create(true).append(true).open(cache)?;
    for budget in budgets {
        let Design::Map(map) = &mut sweep.design else {
            return Err("no map".into());
        };
        map.rules.budget = Some(budget.parse()?);
        let sweep = sweep.clone();
        let map = sweep.map().ok_or("no map")?;
        let mut rounds = Rounds::new(map, Shard::WHOLE);
        let mut landings = 0;
        loop {
            let round = rounds.next_round();
            if round.is_empty() {
                break;
            }
            let new: Vec<usize> = (round.iter().copied())
                .filter(|point| !known.contains_key(point))
                .collect();
            for (point, finding) in new.iter().zip(workers.points(&sweep, &new)?) {
                let height = Height::of(&finding).ok_or("no boundary")?;
                let speed = height
                    .speed
                    .map_or("-".to_owned(), |speed| speed.to_string());
                writeln!(kept, "{point} {speed} {}", finding.landings())?;
                known.insert(*point, (height, finding.landings()));
            }
            for point in round {
                let (height, cost) = known[&point];
                landings += cost;
                rounds.learn_height(point, height, 1);
            }
        }
        let mut points = String::from("level,landings\n");
        for point in rounds.points() {
            writeln!(points, "{},{}", map.level(point), known[&point].1)?;
        }
        fs::write(format!("{out}-{budget}.csv"), points)?;
        let surfaces = MapSurface::all(&rounds);
        let mut text = String::from("cross_slope_deg,roll_deg,first_transition_fps\n");
        for (at, speed) in surfaces[0].triangles().flatten() {
            writeln!(text, "{},{},{speed}", at[0], at[1])?;
        }
        fs::write(format!("{out}-{budget}-surface.csv"), text)?;
        let mut text = String::from("edge,edge_kind,cross_slope_deg,roll_deg\n");
        for (index, line) in surfaces[0].edges().iter().enumerate() {
            for point in &line.points {
                let kind = line.kind.name();
                writeln!(text, "{index},{kind},{},{}", point.at[0], point.at[1])?;
            }
        }
        fs::write(format!("{out}-{budget}-edges.csv"), text)?;
        println!(
            "{budget}: {} points, {landings} landings",
            rounds.points().len()
        );
    }
    Ok(())
}
