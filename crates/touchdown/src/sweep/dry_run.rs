//! `touchdown sweep --dry-run`: what sweeps will take, before they begin.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

use touchdown_input::documents::output_units::OutputUnits;
use touchdown_input::points::refined_grid::{MapRules, RefinedGrid};
use touchdown_input::sweeps::sweep_file::{Job, Sweep};
use touchdown_sweep::journal::header::Header;
use touchdown_sweep::journal::point_set::PointSet;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::journal::{self, Records};
use touchdown_sweep::maps::rounds::Rounds;
use touchdown_sweep::output::results;
use touchdown_sweep::summary::findings::Finding;
use touchdown_sweep::threads::run::{Observer, RunError, Workers};

use super::Options;
use crate::axis_words;
use crate::estimate::{Estimate, Sample, Taken, evenly};
use crate::summary::number;
use crate::terminal::Failure;

/// Time that is spent on one sweep, and on all of them.
const TIME_FOR_ONE: Duration = Duration::from_secs(4);
const TIME_FOR_ALL: Duration = Duration::from_secs(20);
/// Most points computed as a sample, and most whose input is checked.
const MOST_SAMPLED: usize = 1024;
const MOST_CHECKED: usize = 10_000;
/// Points of a sample that are searched at a time for each thread: few are begun and not finished when the time is up.
const SEARCHES: usize = 4;

/// Estimates what sweeps, or a shard of each, will take with these options, one by one and in all; in words.
pub fn tell(sweeps: &[Sweep], shard: Shard, options: &Options) -> Result<String, Failure> {
    let time = TIME_FOR_ONE.min(TIME_FOR_ALL / sweeps.len().max(1) as u32);
    let mut text = String::new();
    let mut all = Estimate::default();
    let mut unknown = 0;
    let mut used = 1;
    for sweep in sweeps {
        let workers = Workers::start(options.threads)?;
        used = workers.threads();
        let held = Held {
            journal: options.out.join(shard.journal(&sweep.stem())),
            grows: !options.overwrite && sweep.design.is_nested(),
        };
        let looked = look(sweep, shard, workers, &held, Instant::now() + time)?;
        let estimate = looked.sample.estimate();
        text += &looked.text(sweep, &held.journal, estimate, used, time);
        match estimate {
            Some(estimate) => all += estimate,
            None => unknown += 1,
        }
    }
    if sweeps.len() > 1 {
        text += &format!(
            "{} together\n  {}",
            number(sweeps.len(), "sweep"),
            all.text(used)
        );
        text += &match unknown {
            0 => "\n".to_owned(),
            some => format!(
                ", without {} of which no point was finished\n",
                number(some, "sweep")
            ),
        };
    }
    Ok(text)
}

/// Journal in which a run would find points that are already computed.
#[derive(Clone)]
struct Held {
    journal: PathBuf,
    /// True if those of a smaller sample count.
    grows: bool,
}

/// The points that are known to be wanted before a run: all of a sweep, or of a shard; of a map, the first round.
struct Points {
    shard: Shard,
    count: usize,
    first_round: Option<Vec<usize>>,
}

impl Points {
    fn of(sweep: &Sweep, shard: Shard) -> Self {
        let round = |map| Rounds::new(map, shard).next_round();
        let first_round: Option<Vec<usize>> = sweep.map().map(round);
        let count = match &first_round {
            Some(round) => round.len(),
            None => shard.len(sweep.design.count()),
        };
        Self {
            shard,
            count,
            first_round,
        }
    }

    fn point(&self, index: usize) -> usize {
        match &self.first_round {
            Some(round) => round[index],
            None => self.shard.point(index),
        }
    }

    /// Which of them a journal holds.
    fn among(&self, done: PointSet) -> PointSet {
        let Some(round) = &self.first_round else {
            return done;
        };
        let mut among = PointSet::none(self.count);
        for (index, point) in round.iter().enumerate() {
            if done.contains(*point) {
                among.insert(index);
            }
        }
        among
    }
}

/// What is known beforehand of the refinement of a map whose first level is estimated.
fn refinement(map: &RefinedGrid, units: OutputUnits) -> String {
    let MapRules { error, budget, .. } = map.rules;
    let speed = units.quantity("error_fps");
    let below = format!("errors are below {} {}", speed.number(error), speed.unit());
    let until = match (budget, error > 0.0) {
        (Some(budget), true) => format!("until {below} or {budget} landings are spent"),
        (Some(budget), false) => format!("until {budget} landings are spent"),
        (None, _) => format!("until {below}, however many points that takes"),
    };
    format!("  these points are the first level of a map, which is refined {until}\n")
}

/// What was found out about a sweep.
struct Looked {
    points: usize,
    /// Points that the journal holds; `None` where there was no time to read it.
    done: Option<usize>,
    checked: usize,
    sample: Sample,
}

impl Looked {
    fn text(
        &self,
        sweep: &Sweep,
        journal: &Path,
        estimate: Option<Estimate>,
        threads: usize,
        time: Duration,
    ) -> String {
        let points = self.points;
        let mut text = format!("{}\n  {}\n", sweep.title, number(points, "point"));
        text += &axis_words::text(sweep);
        text += &(sweep.map())
            .map(|map| refinement(map, sweep.units))
            .unwrap_or_default();
        text += &match self.checked {
            all if all == points => "  the input of all points was checked\n".to_owned(),
            some => format!("  the input of {} was checked\n", number(some, "point")),
        };
        text += &match self.done {
            Some(0) => String::new(),
            Some(done) => {
                let kept = journal::kept(journal);
                let held_in = if journal.is_file() { journal } else { &kept };
                format!(
                    "  {} holds {}: {} left\n",
                    held_in.display(),
                    number(done, "point"),
                    points - done
                )
            }
            None => format!("  {} was not read in time\n", journal.display()),
        };
        let seconds = time.as_secs_f64();
        let computed = match self.sample.taken.len() {
            all if all == self.sample.points => "all points, computed for this".to_owned(),
            some => format!("{} computed as a sample", number(some, "point")),
        };
        let at_most = match sweep.job {
            Job::Outcome { enough: Some(_) } => ", fewer if enough is known before",
            _ => "",
        };
        text + &match estimate {
            Some(_) if self.sample.points == 0 => "  nothing is left to be computed\n".to_owned(),
            Some(estimate) => {
                format!("  from {computed}: {}{at_most}\n", estimate.text(threads))
            }
            None => format!(
                "  no estimate: {} took {seconds:.1} s, and no point was finished\n",
                number(self.sample.landings as usize, "landing")
            ),
        }
    }
}

/// Looks at a sweep until the time is up.
///
/// What may take longer, a single landing included, is done by a thread that is left behind then.
fn look(
    sweep: &Sweep,
    shard: Shard,
    workers: Workers,
    held: &Held,
    end: Instant,
) -> Result<Looked, Failure> {
    let points = Points::of(sweep, shard);
    let counter = Arc::new(Counter::default());
    let cancel = Arc::new(AtomicBool::new(false));
    let (sender, receiver) = mpsc::channel();
    let sampling = Sampling {
        sweep: sweep.clone(),
        shard,
        counter: Arc::clone(&counter),
        cancel: Arc::clone(&cancel),
        sender,
    };
    let held = held.clone();
    thread::spawn(move || sampling.run(&workers, &held));

    let mut checked = 0;
    for index in evenly(points.count, MOST_CHECKED) {
        let point = points.point(index);
        sweep.case(point).map_err(|fault| {
            Failure::running(format!("the point {}: {fault}", sweep.place(point)))
        })?;
        checked += 1;
        if Instant::now() > end {
            break;
        }
    }
    let heard = Heard::until(end, &receiver)?;
    cancel.store(true, Ordering::Relaxed);
    let done = heard.begun.as_ref().map(|(done, _)| *done);
    let seconds = match heard.begun {
        Some((_, begun)) => heard.ended.saturating_duration_since(begun).as_secs_f64(),
        None => 0.0,
    };
    let points = points.count;
    Ok(Looked {
        points,
        done,
        checked,
        sample: Sample {
            points: points - done.unwrap_or(0),
            taken: heard.taken,
            begun: counter.begun.load(Ordering::Relaxed),
            landings: counter.landings.load(Ordering::Relaxed),
            seconds,
        },
    })
}

/// What the thread that samples tells.
enum News {
    /// So many points are in the journal; it begins to sample.
    Begun(usize, Instant),
    /// What a point of the sample took.
    Taken(Taken),
    Failed(Failure),
}

/// Counts points that were begun, and landings.
#[derive(Default)]
struct Counter {
    begun: AtomicUsize,
    landings: AtomicU64,
}

impl Observer for Counter {
    fn begin(&self, _point: usize) {
        self.begun.fetch_add(1, Ordering::Relaxed);
    }

    fn landing(&self) {
        self.landings.fetch_add(1, Ordering::Relaxed);
    }
}

/// A sample of the points of a sweep that are not in its journal.
struct Sampling {
    sweep: Sweep,
    shard: Shard,
    counter: Arc<Counter>,
    cancel: Arc<AtomicBool>,
    sender: Sender<News>,
}

impl Sampling {
    fn run(self, workers: &Workers, held: &Held) {
        if let Err(failure) = self.sample(workers, held) {
            self.send(News::Failed(failure));
        }
    }

    fn sample(&self, workers: &Workers, held: &Held) -> Result<(), Failure> {
        let sweep = &self.sweep;
        let all = Points::of(sweep, self.shard);
        let done = all.among(self.done(held)?);
        let left = all.count - done.len();
        let points: Vec<usize> = missing(&done, &evenly(left, MOST_SAMPLED))
            .into_iter()
            .map(|index| all.point(index))
            .collect();
        self.send(News::Begun(done.len(), Instant::now()));
        let mut keep = |place: usize, finding: Finding| {
            let row = results::row(sweep, points[place], &finding);
            let taken = Taken {
                landings: finding.landings(),
                journal: journal::record_length(finding.encode().len()),
                table: row.iter().map(|cell| cell.to_string().len() + 1).sum(),
            };
            self.send(News::Taken(taken));
        };
        let (counter, cancel) = (&*self.counter, &self.cancel);
        match workers.each_point(sweep, &points, SEARCHES, counter, cancel, &mut keep) {
            Err(RunError::Cancelled) => Ok(()),
            ended => Ok(ended?),
        }
    }

    /// The points that a run would find.
    fn done(&self, held: &Held) -> Result<PointSet, Failure> {
        let header = Header::new(&self.sweep, env!("CARGO_PKG_VERSION"), self.shard)
            .map_err(|fault| Failure::running(format!("the first point: {fault}")))?;
        Ok(Records::done(&held.journal, &header, held.grows)?)
    }

    fn send(&self, news: News) {
        // Nobody listens any more when the time is up.
        let _ = self.sender.send(news);
    }
}

/// The numbers of these ranks among those that are not done.
fn missing(done: &PointSet, ranks: &[usize]) -> Vec<usize> {
    if done.is_empty() {
        return ranks.to_vec();
    }
    let mut by_rank: BTreeMap<usize, usize> = ranks.iter().map(|rank| (*rank, 0)).collect();
    for (rank, number) in done.missing().enumerate() {
        if let Some(found) = by_rank.get_mut(&rank) {
            *found = number;
        }
    }
    ranks.iter().map(|rank| by_rank[rank]).collect()
}

/// What was heard of a sample.
struct Heard {
    begun: Option<(usize, Instant)>,
    ended: Instant,
    taken: Vec<Taken>,
}

impl Heard {
    /// Listens until the sample or the time is at its end.
    fn until(end: Instant, receiver: &Receiver<News>) -> Result<Self, Failure> {
        let mut heard = Self {
            begun: None,
            ended: end,
            taken: Vec::new(),
        };
        loop {
            let rest = end.saturating_duration_since(Instant::now());
            match receiver.recv_timeout(rest) {
                Ok(News::Begun(done, at)) => heard.begun = Some((done, at)),
                Ok(News::Taken(taken)) => {
                    heard.taken.push(taken);
                    heard.ended = Instant::now();
                }
                Ok(News::Failed(failure)) => return Err(failure),
                Err(RecvTimeoutError::Timeout) => {
                    heard.ended = end;
                    return Ok(heard);
                }
                Err(RecvTimeoutError::Disconnected) => return Ok(heard),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_is_counted_without_what_is_done() {
        let mut done = PointSet::none(6);
        assert_eq!(missing(&done, &[3, 0]), [3, 0]);
        done.insert(0);
        done.insert(3);
        assert_eq!(missing(&done, &[3, 0, 2]), [5, 1, 4]);
    }
}
