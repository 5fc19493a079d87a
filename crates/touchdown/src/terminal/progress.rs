//! How far a run is: a bar on a terminal, a line every few seconds elsewhere, or nothing.

use std::fmt::Write;
use std::io::{IsTerminal, stderr};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use touchdown_sweep::threads::run::Observer;

/// Time between lines where there is no terminal, ms.
const LINE_INTERVAL: u64 = 5000;

/// Progress of a run over a number of points.
pub struct Progress {
    start: Instant,
    unit: &'static str,
    count: AtomicU64,
    done: AtomicU64,
    /// Done before this run began.
    earlier: AtomicU64,
    landings: Arc<AtomicU64>,
    last_line: AtomicU64,
    show: Show,
}

enum Show {
    Bar(ProgressBar),
    Lines,
    Nothing,
}

impl Progress {
    /// Starts to show a run over `count` points, or other units.
    pub fn start(unit: &'static str, count: usize, quiet: bool) -> Self {
        let landings = Arc::new(AtomicU64::new(0));
        let show = match (quiet, stderr().is_terminal()) {
            (true, _) => Show::Nothing,
            (false, true) => Show::Bar(bar(unit, count as u64, &landings)),
            (false, false) => Show::Lines,
        };
        Self {
            start: Instant::now(),
            unit,
            count: AtomicU64::new(count as u64),
            done: AtomicU64::new(0),
            earlier: AtomicU64::new(0),
            landings,
            last_line: AtomicU64::new(0),
            show,
        }
    }

    /// Takes the bar away; the time since the start.
    pub fn finish(&self) -> Duration {
        if let Show::Bar(bar) = &self.show {
            bar.finish_and_clear();
        }
        self.start.elapsed()
    }

    fn line(&self) {
        let elapsed = self.start.elapsed();
        let now = elapsed.as_millis() as u64;
        let last = self.last_line.load(Ordering::Relaxed);
        if now < last + LINE_INTERVAL {
            return;
        }
        // Whichever thread moves the time on writes the line, and no other.
        let mine = self
            .last_line
            .compare_exchange(last, now, Ordering::Relaxed, Ordering::Relaxed);
        if mine.is_err() {
            return;
        }
        let (done, count) = (
            self.done.load(Ordering::Relaxed),
            self.count.load(Ordering::Relaxed),
        );
        let landings = self.landings.load(Ordering::Relaxed);
        let rate = landings as f64 / elapsed.as_secs_f64();
        let landed = match landings {
            0 => String::new(),
            landings => format!(", {landings} landings, {rate:.0} landings/s"),
        };
        let now_done = done - self.earlier.load(Ordering::Relaxed).min(done);
        let left = match now_done {
            0 => String::new(),
            now_done => {
                let left =
                    elapsed.as_secs_f64() * count.saturating_sub(done) as f64 / now_done as f64;
                format!(", about {left:.0} s left")
            }
        };
        eprintln!("{done}/{count} {}{landed}{left}", self.unit);
    }
}

impl Observer for Progress {
    fn skip(&self, points: usize) {
        let points = points as u64;
        self.done.fetch_add(points, Ordering::Relaxed);
        self.earlier.fetch_add(points, Ordering::Relaxed);
        if let Show::Bar(bar) = &self.show {
            bar.inc(points);
            bar.reset_eta();
        }
    }

    fn landing(&self) {
        self.landings.fetch_add(1, Ordering::Relaxed);
        if matches!(self.show, Show::Lines) {
            self.line();
        }
    }

    fn more(&self, points: usize) {
        self.count.fetch_add(points as u64, Ordering::Relaxed);
        if let Show::Bar(bar) = &self.show {
            bar.inc_length(points as u64);
        }
    }

    fn point(&self, _point: usize) {
        self.done.fetch_add(1, Ordering::Relaxed);
        match &self.show {
            Show::Bar(bar) => bar.inc(1),
            Show::Lines => self.line(),
            Show::Nothing => {}
        }
    }
}

fn bar(unit: &str, count: u64, landings: &Arc<AtomicU64>) -> ProgressBar {
    let landings = Arc::clone(landings);
    let rate = move |state: &ProgressState, out: &mut dyn Write| {
        let seconds = state.elapsed().as_secs_f64().max(1e-3);
        let landings = landings.load(Ordering::Relaxed);
        if landings > 0 {
            let rate = landings as f64 / seconds;
            // A terminal that cannot be written to is no reason to stop a run.
            let _ = write!(out, "{rate:.0} landings/s  ");
        }
    };
    let template = format!("{{bar:32}} {{pos}}/{{len}} {unit}  {{rate}}{{elapsed}}, ETA {{eta}}");
    let bar = ProgressBar::new(count);
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style.with_key("rate", rate));
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
