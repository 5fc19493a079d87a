//! Work that Ctrl-C ends: on a thread of its own, while the thread that called tells how far it is, or in place, where it asks
//! now and then whether to go on.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::prelude::*;
use touchdown_sweep::run::Observer;

use crate::errors::{Failure, guarded};

/// Time between two looks at signals.
const LOOK_INTERVAL: Duration = Duration::from_millis(50);
/// Longest wait for work that was told to stop, and so for its journal to be free again: a landing that takes longer is left to
/// end on its own.
const PATIENCE: Duration = Duration::from_secs(1);

/// Questions whether to go on for one look at the clock.
const QUESTIONS_PER_LOOK: u32 = 64;

const NO_RESULT: &str = "the engine gave no result";

/// How far work is, and whether it is to go on.
#[derive(Debug, Default)]
pub struct Work {
    /// Whether it is to stop.
    pub cancel: AtomicBool,
    wanted: AtomicU64,
    done: AtomicU64,
    landings: AtomicU64,
}

impl Work {
    /// So many points are done already.
    pub fn skip(&self, points: usize) {
        self.done.fetch_add(points as u64, Ordering::Relaxed);
    }

    fn counts(&self) -> [u64; 3] {
        [&self.done, &self.wanted, &self.landings].map(|count| count.load(Ordering::Relaxed))
    }
}

impl Observer for Work {
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

/// Does `work` without the interpreter. `watch` is called with the points done, the points wanted and the landings so far
/// whenever that has changed.
///
/// # Errors
/// What the work failed with, a signal, or what `watch` raised.
pub fn run<T: Send + 'static>(
    py: Python,
    watch: Option<&Bound<PyAny>>,
    work: impl FnOnce(&Work) -> Result<T, Failure> + Send + 'static,
) -> PyResult<T> {
    let shared = Arc::new(Work::default());
    let (sender, mut results) = channel();
    let own = Arc::clone(&shared);
    let thread = thread::spawn(move || {
        // Whoever waited for it may be gone.
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
            // What it comes to now is of no interest.
            let _ = wait(py, &mut results, PATIENCE);
            return Err(error);
        }
    }
}

/// Does `work` in place without the interpreter, for what takes no longer as a rule than a thread takes to start. It asks the
/// function that it is given whether to go on, and has no result where it is not to.
///
/// # Errors
/// A signal, or that the work panicked.
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
