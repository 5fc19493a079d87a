//! Many searches at a time on one thread, each of which waits for a landing.

use std::cell::RefCell;
use std::pin::Pin;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use touchdown_dynamics::landing::Landing;

use crate::exchange::{Asker, Exchange};

/// Longest time without a landing after which `keep` is called.
const LONGEST_SILENCE: Duration = Duration::from_millis(100);

/// Landings by the searches that asked for them, where threads put them.
pub(crate) type Landed<const LEGS: usize> = Receiver<(usize, Landing<LEGS>)>;

/// Searches all points with `search`, `at_a_time` of them at a time, and gives what each came to to `keep` as it
/// becomes known. `keep` is also called, with nothing, after each landing and when there is none for a while.
///
/// # Errors
/// The first that a search or `keep` gave up with. Where no thread lands any more it ends early, without.
pub(crate) fn search_all<T, E, V, const LEGS: usize>(
    mut points: impl Iterator<Item = usize>,
    at_a_time: usize,
    (exchange, landed): (&Exchange<V>, &Landed<LEGS>),
    search: impl for<'e> AsyncFn(usize, Asker<'e, V, LEGS>) -> Result<T, E>,
    mut keep: impl FnMut(Option<(usize, T)>) -> Result<(), E>,
) -> Result<(), E> {
    let answers: Vec<_> = (0..at_a_time).map(|_| RefCell::new(None)).collect();
    let mut begin = |key: usize| {
        let point = points.next()?;
        let answer = &answers[key];
        let course = search(
            point,
            Asker {
                exchange,
                key,
                answer,
            },
        );
        Some(UnderWay {
            point,
            course: Box::pin(course),
        })
    };
    let mut searches: Vec<_> = (0..at_a_time).map(|_| None).collect();
    let mut ready: Vec<usize> = (0..at_a_time).rev().collect();
    loop {
        while let Some(key) = ready.pop() {
            if searches[key].is_none() {
                searches[key] = begin(key);
            }
            let Some(search) = &mut searches[key] else {
                continue;
            };
            if let Some(result) = search.go_on() {
                let finished = (search.point, result?);
                searches[key] = None;
                ready.push(key);
                keep(Some(finished))?;
            }
        }
        if searches.iter().all(Option::is_none) {
            return Ok(());
        }
        match landed.recv_timeout(LONGEST_SILENCE) {
            Ok((key, landing)) => {
                answers[key].replace(Some(landing));
                ready.push(key);
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => return Ok(()),
        }
        keep(None)?;
    }
}

/// The search of a point, which waits for a landing.
struct UnderWay<F> {
    point: usize,
    course: Pin<Box<F>>,
}

impl<F: Future> UnderWay<F> {
    /// Goes on to the next landing that it asks for; what it came to, if to none.
    fn go_on(&mut self) -> Option<F::Output> {
        // Nobody has to be woken: who waits for an answer is gone on with once it is there.
        match self
            .course
            .as_mut()
            .poll(&mut Context::from_waker(Waker::noop()))
        {
            Poll::Ready(result) => Some(result),
            Poll::Pending => None,
        }
    }
}
