//! Ctrl-C and termination: the first asks the run to stop between landings, the second stops at
//! once.
//!
//! A landing can take longer than anyone who asks a program to stop will wait. What is finished is
//! in the journal by then, so after a while the program ends in the middle of a landing.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use crate::failure::{Failure, INTERRUPTED};

/// Longest time from an interruption to the end of the program.
const PATIENCE: Duration = Duration::from_millis(1700);

/// A flag that becomes true when the user interrupts.
pub fn flag() -> Result<Arc<AtomicBool>, Failure> {
    let cancel = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&cancel);
    ctrlc::set_handler(move || {
        if raised.swap(true, Ordering::Relaxed) {
            std::process::exit(INTERRUPTED.into());
        }
        thread::spawn(|| {
            thread::sleep(PATIENCE);
            eprintln!(
                "touchdown: interrupted in the middle of a landing; what is finished is kept"
            );
            std::process::exit(INTERRUPTED.into());
        });
    })
    .map_err(Failure::running)?;
    Ok(cancel)
}
