//! Landings of one touchdown at many horizontal velocities.

use std::sync::Arc;

use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;

use super::IsOver;
use super::complaint::Complaint;

/// Lands at all these speeds (ft/s), in lanes, which changes no bit.
///
/// # Errors
/// If the answer is no longer wanted, or a speed is not allowed.
pub fn land_at(
    vehicle: &Arc<Vehicle>,
    scene: &Scene,
    settings: &Settings,
    speeds: &[f64],
    is_over: IsOver,
) -> Result<Vec<Landing>, Complaint> {
    let at = |speed: &f64| {
        let moved = scene.with_horizontal_velocity(*speed);
        moved.map_err(|invalid| Complaint::value("speed_fps", speed, &invalid.allowed))
    };
    let scenes = speeds.iter().map(at).collect::<Result<Vec<Scene>, _>>()?;
    let mut landings: Vec<Option<Landing>> = vec![None; speeds.len()];
    let mut next = 0;
    land_many(
        &mut || {
            let scene = *scenes.get(next).filter(|_| !is_over())?;
            next += 1;
            Some(Request {
                key: next - 1,
                vehicle: Arc::clone(vehicle),
                scene,
                settings: *settings,
            })
        },
        &mut |key, landing| landings[key] = Some(landing),
    );
    let all: Option<Vec<Landing>> = landings.into_iter().collect();
    all.ok_or_else(Complaint::over)
}
