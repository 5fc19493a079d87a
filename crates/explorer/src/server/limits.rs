//! Limits on the resources of clients.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use tokio::sync::Semaphore;

/// Simultaneous connections, below the limit of open files of a program.
pub const CONNECTIONS: usize = 512;
/// Time for the head of a request, and for its body.
pub const HEADER_TIME: Duration = Duration::from_secs(5);
pub const BODY_TIME: Duration = Duration::from_secs(10);
/// Time for a client to read an answer.
pub const WRITE_TIME: Duration = Duration::from_secs(10);
/// Headers of a request, and their total bytes.
pub const HEADERS: usize = 64;
pub const HEADER_BYTES: usize = 32 * 1024;
/// Bytes of the body of a request.
pub const BODY_BYTES: usize = 256 * 1024;
/// Time for an answer, including waiting.
pub const ANSWER_TIME: Duration = Duration::from_secs(30);
/// Requests waiting for their turn.
const WAITING: usize = 64;
/// Bytes of answers that clients have not read, beyond which nothing more is computed, and how often that is looked at.
const UNREAD: usize = 64 * 1024 * 1024;
pub const PAUSE: Duration = Duration::from_millis(20);
/// Requests per second on average, and in a burst.
const RATE: f64 = 500.0;
const BURST: f64 = 1000.0;

/// Turns at computing. Long answers have their own turns, so that they never delay a landing.
#[derive(Debug)]
pub struct Limits {
    quick: Arc<Semaphore>,
    long: Arc<Semaphore>,
    waiting: Semaphore,
    counts: [usize; 2],
    unread: Arc<AtomicUsize>,
    /// Requests of those who may ask.
    pub admitted: Rate,
    /// Requests of those who may not, which take nothing from the others.
    pub strangers: Rate,
}

/// A limit on how often something is asked.
#[derive(Debug)]
pub struct Rate(Mutex<Allowance>);

/// An answer that counts as unread until the client has it, or is gone.
#[derive(Debug)]
pub struct Unread {
    answer: Vec<u8>,
    unread: Arc<AtomicUsize>,
}

impl AsRef<[u8]> for Unread {
    fn as_ref(&self) -> &[u8] {
        &self.answer
    }
}

impl Drop for Unread {
    fn drop(&mut self) {
        self.unread.fetch_sub(self.answer.len(), Ordering::Relaxed);
    }
}

#[derive(Debug)]
struct Allowance {
    requests: f64,
    since: Instant,
}

impl Limits {
    /// Half of the cores for long answers and a quarter for quick ones; the rest is left to other programs.
    pub fn of_this_machine() -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let counts = [cores.div_ceil(4), cores.div_ceil(2)];
        Self {
            quick: Arc::new(Semaphore::new(counts[0])),
            long: Arc::new(Semaphore::new(counts[1])),
            waiting: Semaphore::new(WAITING),
            counts,
            unread: Arc::default(),
            admitted: Rate::full(),
            strangers: Rate::full(),
        }
    }

    /// Number of computing threads.
    pub fn threads(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Turns for a kind of request.
    pub fn turns(&self, name: &str) -> Arc<Semaphore> {
        Arc::clone(match name {
            "strip" | "bands" | "boundary" => &self.long,
            _ => &self.quick,
        })
    }

    /// Waiting places.
    pub fn waiting(&self) -> &Semaphore {
        &self.waiting
    }

    /// True if clients have left too many answers unread.
    pub fn is_full(&self) -> bool {
        self.unread.load(Ordering::Relaxed) > UNREAD
    }

    /// Counts an answer until it is read.
    pub fn count(&self, answer: Vec<u8>) -> Unread {
        self.unread.fetch_add(answer.len(), Ordering::Relaxed);
        Unread {
            answer,
            unread: Arc::clone(&self.unread),
        }
    }
}

impl Rate {
    fn full() -> Self {
        Self(Mutex::new(Allowance {
            requests: BURST,
            since: Instant::now(),
        }))
    }

    /// Counts a request; returns whether it is within the rate.
    pub fn allow(&self) -> bool {
        let Ok(mut allowance) = self.0.lock() else {
            return false;
        };
        let now = Instant::now();
        let gained = RATE * (now - allowance.since).as_secs_f64();
        allowance.requests = (allowance.requests + gained).min(BURST);
        allowance.since = now;
        let is_within = allowance.requests >= 1.0;
        if is_within {
            allowance.requests -= 1.0;
        }
        is_within
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_burst_uses_the_allowance_up() {
        let limits = Limits::of_this_machine();
        let allowed = (0..10_000).filter(|_| limits.strangers.allow()).count();
        assert!((1000..9000).contains(&allowed), "{allowed}");
        assert!(limits.admitted.allow());
    }
}
