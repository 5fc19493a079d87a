//! Calls of the interface, each computed on a thread for as long as the client waits.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use hyper::StatusCode;
use hyper::body::Bytes;
use tokio::task::spawn_blocking;
use tokio::time::{sleep, timeout_at};

use super::compressed;
use super::limits::{ANSWER_TIME, Limits, PAUSE};
use super::reply::{self, Reply};
use crate::interface::{self, Complaint};
use crate::named::Named;

/// Tells the computing thread that the client no longer waits, also when a closed connection drops the waiting task.
struct Wanted(Arc<AtomicBool>);

impl Drop for Wanted {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Answers a request of the interface when its turn comes.
pub async fn answer(
    named: &Arc<Named>,
    limits: &Limits,
    name: &str,
    request: String,
    compresses: bool,
) -> Reply {
    let deadline = Instant::now() + ANSWER_TIME;
    let Ok(waiting) = limits.waiting().try_acquire() else {
        return reply::refusal(StatusCode::TOO_MANY_REQUESTS, "too many requests wait");
    };
    let turn = limits.turns(name).acquire_owned();
    let Ok(Ok(turn)) = timeout_at(deadline.into(), turn).await else {
        return reply::complaint(&Complaint::over());
    };
    drop(waiting);
    // Clients read, or their time is over.
    while limits.is_full() {
        if Instant::now() > deadline {
            let said = "too many answers have not been read";
            return reply::refusal(StatusCode::TOO_MANY_REQUESTS, said);
        }
        sleep(PAUSE).await;
    }
    let over = Arc::new(AtomicBool::new(false));
    let _wanted = Wanted(Arc::clone(&over));
    let (named, name) = (Arc::clone(named), name.to_owned());
    let answered = spawn_blocking(move || {
        // Keeps its turn until it has noticed that nobody waits.
        let _turn = turn;
        let is_over = || over.load(Ordering::Relaxed) || Instant::now() > deadline;
        let json = interface::answer(&named, &name, &request, &is_over)?;
        let packed = compresses.then(|| compressed::answer(&json)).flatten();
        let is_gzip = packed.is_some();
        let answer = packed.unwrap_or_else(|| json.into_bytes());
        Ok::<_, Complaint>((answer, is_gzip))
    });
    match answered.await {
        Ok(Ok((answer, is_gzip))) => {
            reply::answer(Bytes::from_owner(limits.count(answer)), is_gzip)
        }
        Ok(Err(complaint)) => reply::complaint(&complaint),
        Err(error) => reply::complaint(&Complaint::engine(error)),
    }
}
