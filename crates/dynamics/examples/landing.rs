//! One landing with its history.
//!
//! ```text
//! cargo run --release -p touchdown-dynamics --example landing
//! ```

mod lander;

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::land::land_observed;
use touchdown_dynamics::scene::Settings;

/// Time between two lines of the history, s.
const INTERVAL: f64 = 0.25;

fn main() -> Result<(), Invalid> {
    let vehicle = lander::four_legs()?;
    let scene = lander::downhill(4.0)?;

    println!("time s,height ft,speed ft/s,stability angle deg,greatest strut force lb");
    let landing = land_observed(
        &vehicle,
        &scene,
        &Settings::default(),
        INTERVAL,
        &mut |instant| {
            let forces = instant.legs.iter().map(|leg| leg.strut_force);
            println!(
                "{:.2},{:.3},{:.3},{:.2},{:.0}",
                instant.time,
                // Z points down.
                -instant.position.z,
                instant.velocity.norm(),
                instant.stability_angle.to_degrees(),
                forces.fold(0.0, f64::max),
            );
        },
    );

    println!();
    println!("{} after {:.2} s", landing.outcome, landing.end_time);
    for (leg, share) in landing.max_stroke_share.iter().enumerate() {
        println!("leg {}: {:.0} % of its stroke", leg + 1, 100.0 * share);
    }
    let energies = &landing.energies;
    println!(
        "{:.0} ft lb taken up, {:.1e} unexplained",
        energies.dissipated(),
        energies.closure(),
    );
    Ok(())
}
