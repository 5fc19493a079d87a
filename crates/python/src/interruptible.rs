//! Work that Ctrl-C interrupts: on its own thread, while the calling thread reports progress, or in place, where it
//! checks now and then whether to continue.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use touchdown_sweep::threads::run::Observer;

use crate::errors::{Failure, guarded};

/// Interval between checks for signals.
const LOOK_INTERVAL: Duration = Duration::from_millis(50);
/// Longest wait for stopped work to end and release its journal; a landing that takes longer is left to end by itself.
const PATIENCE: Duration = Duration::from_secs(1);

/// Checks for continuation per look at the clock.
const QUESTIONS_PER_LOOK: u32 = 64;

const NO_RESULT: &str = "the engine gave no result";

/// Progress of work, and its stop flag.
#[derive(Debug, Default)]
pub struct Work {
    /// True once it should stop.
    pub cancel: AtomicBool,
    wanted: AtomicU64,
    done: AtomicU64,
    landings: AtomicU64,
}

impl Work {
    fn counts(&self) -> [u64; 3] {
        [&self.done, &self.wanted, &self.landings].map(|count| count.load(Ordering::Relaxed))
    }
}

impl Observer for Work {
    fn skip(&self, points: usize) {
        self.done.fetch_add(points as u64, Ordering::Relaxed);
    }

    fn more(&self, points: usize) {
        self.wanted.fetch_add(points as u64, Ordering::Relaxed);
    }

    fn landing(&self) {
        self.landings.fetch_add(1, Ordering::Relaxed);
    }

    fn point(&self, _point: usize) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
}

/// Runs `work` without the interpreter. Calls `watch` with the points done, the points wanted and the landings so far
/// whenever these change.
///
/// # Errors
/// An error of the work, a signal, or an exception of `watch`.
pub fn run<T: Send + 'static>(
    py: Python,
    watch: Option<&Bound<PyAny>>,
    work: impl FnOnce(&Work) -> Result<T, Failure> + Send + 'static,
) -> PyResult<T> {
    let shared = Arc::new(Work::default());
    let (sender, mut results) = channel();
    let own = Arc::clone(&shared);
    let thread = thread::spawn(move || {
        // The receiver may be gone.
        let _ = sender.send(work(&own));
    });
    let mut told = [0; 3];
    loop {
        let arrived = wait(py, &mut results, LOOK_INTERVAL);
        let counts = shared.counts();
        let mut looked = py.check_signals();
        if let (Some(watch), true, true) = (watch, looked.is_ok(), counts != told) {
            looked = watch.call1((counts[0], counts[1], counts[2])).map(drop);
            told = counts;
        }
        match arrived {
            Ok(result) => return looked.and_then(|()| result.map_err(PyErr::from)),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                let panic = py.detach(|| thread.join());
                let failure = match panic {
                    Err(panic) => Failure::of_panic(&*panic),
                    Ok(()) => Failure::Engine(NO_RESULT.to_owned()),
                };
                return Err(failure.into());
            }
        }
        if let Err(error) = looked {
            shared.cancel.store(true, Ordering::Relaxed);
            // Its result is no longer of interest.
            let _ = wait(py, &mut results, PATIENCE);
            return Err(error);
        }
    }
}

/// Runs `work` in place without the interpreter, if it is usually shorter than starting a thread. The work calls the
/// function it is given to ask whether to continue; if not, it returns no result.
///
/// # Errors
/// A signal, or a panic of the work.
pub fn in_place<T: Send>(
    py: Python,
    work: impl FnOnce(&mut dyn FnMut() -> bool) -> Option<T> + Send,
) -> PyResult<T> {
    let mut signal = None;
    let done = py.detach(|| {
        let mut looked = Instant::now();
        let mut questions = 0;
        let mut goes_on = || {
            questions += 1;
            if questions % QUESTIONS_PER_LOOK == 0 && looked.elapsed() >= LOOK_INTERVAL {
                signal = Python::attach(|py| py.check_signals()).err();
                looked = Instant::now();
            }
            signal.is_none()
        };
        let no_result = || Failure::Engine(NO_RESULT.to_owned());
        guarded(|| work(&mut goes_on).ok_or_else(no_result))
    });
    match signal {
        Some(signal) => Err(signal),
        None => Ok(done?),
    }
}

fn wait<T: Send>(
    py: Python,
    results: &mut Receiver<T>,
    time: Duration,
) -> Result<T, RecvTimeoutError> {
    py.detach(move || results.recv_timeout(time))
}
