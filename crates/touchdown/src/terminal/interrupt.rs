//! Ctrl-C and termination: the first asks the run to stop between landings, the second stops at
//! once.
//!
//! A landing can take longer than anyone who asks a program to stop will wait. What is finished is
//! in the journal by then, so after a while the program ends in the middle of a landing.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag::{register, register_conditional_shutdown};

use crate::terminal::{Failure, INTERRUPTED};

/// Longest time from an interruption to the end of the program.
const PATIENCE: Duration = Duration::from_millis(1700);
/// Time between two looks at the flag.
const LOOK_INTERVAL: Duration = Duration::from_millis(50);

/// A flag that becomes true when the user interrupts.
pub fn flag() -> Result<Arc<AtomicBool>, Failure> {
    let cancel = Arc::new(AtomicBool::new(false));
    for signal in signals() {
        // In this order: the first signal finds the flag lowered.
        register_conditional_shutdown(signal, INTERRUPTED.into(), Arc::clone(&cancel))
            .and_then(|_| register(signal, Arc::clone(&cancel)))
            .map_err(Failure::running)?;
    }
    let raised = Arc::clone(&cancel);
    thread::spawn(move || {
        while !raised.load(Ordering::Relaxed) {
            thread::sleep(LOOK_INTERVAL);
        }
        thread::sleep(PATIENCE);
        eprintln!("touchdown: interrupted in the middle of a landing; what is finished is kept");
        std::process::exit(INTERRUPTED.into());
    });
    Ok(cancel)
}

/// Makes a write beyond the limit of a file's size (`ulimit -f`) an error like that of a full disk, instead of a signal
/// that ends the program in the middle of it.
pub fn report_file_limits() {
    #[cfg(unix)]
    {
        let unread = Arc::new(AtomicBool::new(false));
        // Should this fail, the signal ends the program as it would have without.
        let _ = register(signal_hook::consts::SIGXFSZ, unread);
    }
}

/// Signals that interrupt.
fn signals() -> impl Iterator<Item = i32> {
    [SIGINT, SIGTERM].into_iter().chain(hangup())
}

/// The signal of a terminal that is closed. `nohup` ignores it, and so does the program then.
#[cfg(unix)]
fn hangup() -> Option<i32> {
    Some(signal_hook::consts::SIGHUP).filter(|signal| !is_ignored(*signal))
}

#[cfg(not(unix))]
fn hangup() -> Option<i32> {
    None
}

/// Whether the program was started with a signal ignored; without `/proc`, where that cannot be known, it was not.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}
