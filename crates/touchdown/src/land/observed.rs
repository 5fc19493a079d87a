//! A landing observed for its history, which the user may interrupt: how long the history may be, and its file.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use touchdown_dynamics::land::land_with_summary;
use touchdown_dynamics::landing::{Instant, Landing, land_located_while};
use touchdown_dynamics::methods::{IntegrationSummary, Method};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::documents::input_error::InputError;
use touchdown_sweep::output::file_writer::{Draft, WriteError};
use touchdown_sweep::output::history::History;

use crate::terminal::Failure;

/// Most instants in a history: a hundred times what the longest landing needs at 0.01 s.
const LONGEST_HISTORY: f64 = 1e7;

/// Checks the time between the rows of a history, s.
pub fn interval(seconds: f64, time_limit: f64) -> Result<f64, InputError> {
    let least = time_limit / LONGEST_HISTORY;
    if seconds >= least && seconds > 0.0 {
        Ok(seconds)
    } else {
        let allowed = format!("at least {least:e} s, a ten-millionth of the time limit");
        Err(InputError::value("--interval", seconds, &allowed))
    }
}

/// Returns whether a file that begins with this line is a history.
pub fn is_history(line: &str) -> bool {
    line.starts_with("t_s,")
}

/// The file of a finished history.
///
/// # Errors
/// Names the file that could not be written.
pub fn ended(history: History<Draft>, path: PathBuf) -> Result<Draft, WriteError> {
    history.end().map_err(|error| WriteError { path, error })
}

/// A touchdown to be observed: every `interval` seconds and at its end.
pub struct Observed<'o> {
    pub vehicle: &'o Vehicle,
    pub scene: &'o Scene,
    pub settings: &'o Settings,
    pub interval: f64,
}

impl Observed<'_> {
    /// Computes the landing. The methods of 1966 are not interrupted.
    ///
    /// # Errors
    /// If it is interrupted.
    pub fn land(
        &self,
        observe: &mut dyn FnMut(&Instant),
        cancel: &AtomicBool,
    ) -> Result<(Landing, IntegrationSummary), Failure> {
        let (vehicle, scene, settings) = (self.vehicle, self.scene, self.settings);
        if settings.method() != Method::Located {
            return Ok(land_with_summary(
                vehicle,
                scene,
                settings,
                self.interval,
                observe,
            ));
        }
        let goes_on = || !cancel.load(Ordering::Relaxed);
        land_located_while(vehicle, scene, settings, self.interval, observe, goes_on)
            .map(|landing| (landing, IntegrationSummary::default()))
            .ok_or_else(|| {
                Failure::Interrupted("no history of an unfinished landing was written".to_owned())
            })
    }
}
