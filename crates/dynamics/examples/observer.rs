//! An observer of its own: the loads that a payload on top of the lander feels.
//!
//! ```text
//! cargo run --release -p touchdown-dynamics --example observer
//! ```

mod lander;

use nalgebra::Vector3;
use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::record::Instant;
use touchdown_dynamics::scene::Settings;

/// Place of the payload: above the CG, in vehicle axes, of which z points down, ft.
const PAYLOAD: [f64; 3] = [0.0, 0.0, -3.0];
/// Time between two instants, s.
const INTERVAL: f64 = 0.005;
/// Standard gravity, ft/s².
const G: f64 = 32.174;

/// The greatest acceleration of the payload so far, and when.
#[derive(Default)]
struct Accelerometer {
    before: Option<(f64, Vector3<f64>)>,
    greatest: f64,
    at: f64,
}

impl Accelerometer {
    /// Takes the mean acceleration since the last instant.
    fn observe(&mut self, instant: &Instant) {
        let turning = instant.angular_velocity.cross(&Vector3::from(PAYLOAD));
        let velocity = instant.velocity + instant.attitude.matrix() * turning;
        if let Some((time, before)) = self.before {
            let load = (velocity - before).norm() / (instant.time - time) / G;
            if load > self.greatest {
                (self.greatest, self.at) = (load, instant.time);
            }
        }
        self.before = Some((instant.time, velocity));
    }
}

fn main() -> Result<(), Invalid> {
    let vehicle = lander::four_legs()?;
    for horizontal_velocity in [0.0, 2.0, 4.0, 6.0, 8.0] {
        let mut accelerometer = Accelerometer::default();
        let landing = land_observed(
            &vehicle,
            &lander::downhill(horizontal_velocity)?,
            &Settings::default(),
            INTERVAL,
            &mut |instant| accelerometer.observe(instant),
        );
        println!(
            "V_H {horizontal_velocity} ft/s: {:.2} g at {:.2} s, {}",
            accelerometer.greatest, accelerometer.at, landing.outcome,
        );
    }
    Ok(())
}
