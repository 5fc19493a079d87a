//! A sweep that is killed at random moments and started again, until it was killed often enough.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use tempfile::TempDir;
use touchdown_input::sweeps::sweep_file::Sweep;

use super::killed_run::{KilledRun, RunState, journaled, results};
use super::{Bench, SURVEYOR, SURVEYOR_FILE};
use touchdown::terminal::Failure;

const SWEEP: &str = include_str!("../../../../sweeps/stress/killed.toml");
/// Name of the sweep, and of its results.
const STEM: &str = "killed";
/// Threads of the undisturbed run, and of most others.
const UNDISTURBED_THREADS: u32 = 2;
const MOST_THREADS: u32 = 3;
/// Longest time from start to kill, over the time of the undisturbed run.
const LONGEST: f64 = 0.6;
/// Every so-manieth run is killed when its results begin to appear, so long after that at most.
const LATE: u32 = 4;
const LATE_WITHIN: Duration = Duration::from_millis(4);
/// Files that appear together when results are written; a run that begins tries one.
const RESULTS: usize = 2;
/// Time between lines of progress.
const LINES: Duration = Duration::from_secs(5);

/// Kills and compares; in words. The folder stays where something is wrong.
pub fn run(bench: &Bench) -> Result<String, Failure> {
    let home = TempDir::with_prefix_in("kills-", &bench.options.out).map_err(Failure::running)?;
    match kill_in(home.path(), bench) {
        Err(Failure::Running(what)) => {
            let kept = home.keep();
            let what = format!("{}; {}", what.trim_end(), kept.display());
            Err(Failure::running(format!("after kills: {what} is kept")))
        }
        done => done,
    }
}

fn kill_in(home: &Path, bench: &Bench) -> Result<String, Failure> {
    let file = home.join("sweeps").join(format!("{STEM}.toml"));
    for (path, text) in [(&file, SWEEP), (&home.join(SURVEYOR_FILE), SURVEYOR)] {
        fs::create_dir_all(path.parent().unwrap_or(home)).map_err(Failure::running)?;
        fs::write(path, text).map_err(Failure::running)?;
    }
    let sweep = Sweep::read(&file)?;
    let [undisturbed, killed] = ["undisturbed", "killed"].map(|name| home.join(name));
    let mut run = KilledRun::start(&file, &undisturbed, UNDISTURBED_THREADS)?;
    run.watch(bench.cancel, |_, _| false)?;
    let whole = run.end()?;
    let mut trial = Trial {
        bench,
        sweep: &file,
        points: sweep.design.count(),
        whole,
        expected: results(STEM, &undisturbed)?,
        out: &killed,
        chance: Pcg64::seed_from_u64(bench.options.seed.into()),
        kills: 0,
        late: 0,
        resumed: 0,
        compared: 0,
    };
    let start = Instant::now();
    let mut reported = start;
    while trial.kills < bench.options.kills {
        trial.round()?;
        if !bench.options.quiet && reported.elapsed() > LINES {
            reported = Instant::now();
            let left = bench.options.kills - trial.kills;
            let pace = start.elapsed().as_secs_f64() / f64::from(trial.kills.max(1));
            eprintln!(
                "{}; about {:.0} s left",
                trial.summary(),
                pace * f64::from(left)
            );
        }
    }
    // The run after the last kill must come to the same results.
    trial.finish()?;
    Ok(format!(
        "{}: nothing lost, no differences\n",
        trial.summary()
    ))
}

/// Runs that are killed.
struct Trial<'t> {
    bench: &'t Bench<'t>,
    sweep: &'t Path,
    points: usize,
    /// Duration of the undisturbed run, and its results by name.
    whole: Duration,
    expected: BTreeMap<String, Vec<u8>>,
    out: &'t Path,
    chance: Pcg64,
    kills: u32,
    /// Those of them while results were written.
    late: u32,
    resumed: u32,
    compared: u32,
}

impl Trial<'_> {
    /// One run: killed, or compared at its end.
    fn round(&mut self) -> Result<(), Failure> {
        let journal = self.out.join(format!("{STEM}.journal"));
        let before = journaled(&journal, self.points)?;
        self.resumed += u32::from(before > 0);
        let threads = self.chance.random_range(1..=MOST_THREADS);
        let mut run = KilledRun::start(self.sweep, self.out, threads)?;
        let is_late = self.kills % LATE == LATE - 1;
        let state = if is_late {
            let within = LATE_WITHIN.mul_f64(self.chance.random());
            let state = run.watch(self.bench.cancel, |fresh, _| fresh >= RESULTS)?;
            thread::sleep(within);
            state
        } else {
            let until = self.whole.mul_f64(LONGEST * self.chance.random::<f64>());
            run.watch(self.bench.cancel, |_, age| age >= until)?
        };
        if state == RunState::Ended {
            run.end()?;
            return self.compare();
        }
        if run.kill()? {
            self.kills += 1;
            self.late += u32::from(is_late);
        }
        let results_stand = self.out.join(format!("{STEM}.csv")).exists();
        if !journal.exists() && (before > 0 || results_stand) {
            // The journal is removed only when all results are in place.
            return self.compare();
        }
        let after = journaled(&journal, self.points)?;
        if after < before {
            let lost = format!("{} points of the journal are lost", before - after);
            return Err(Failure::running(lost));
        }
        Ok(())
    }

    /// Lets a run go to its end, and compares.
    fn finish(&mut self) -> Result<(), Failure> {
        let mut run = KilledRun::start(self.sweep, self.out, UNDISTURBED_THREADS)?;
        run.watch(self.bench.cancel, |_, _| false)?;
        run.end()?;
        self.compare()
    }

    /// Compares results with those of the undisturbed run, and removes them.
    fn compare(&mut self) -> Result<(), Failure> {
        let found = results(STEM, self.out)?;
        for (name, expected) in &self.expected {
            if found.get(name) != Some(expected) {
                let complaint = format!("{name} differs from that of the undisturbed run");
                return Err(Failure::running(complaint));
            }
        }
        fs::remove_dir_all(self.out).map_err(Failure::running)?;
        self.compared += 1;
        Ok(())
    }

    fn summary(&self) -> String {
        let Self {
            kills,
            late,
            resumed,
            compared,
            ..
        } = self;
        format!(
            "{kills} of {} kills, {late} of them while results were written; {resumed} times resumed from \
             a journal, {compared} times at the end and compared",
            self.bench.options.kills
        )
    }
}
