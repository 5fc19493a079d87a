//! A landing that the user may interrupt.

use std::sync::atomic::{AtomicBool, Ordering};

use touchdown_dynamics::land::land_with_summary;
use touchdown_dynamics::landing::{Instant, Landing, land_located_while};
use touchdown_dynamics::methods::{IntegrationSummary, Method};
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use crate::failure::Failure;

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
