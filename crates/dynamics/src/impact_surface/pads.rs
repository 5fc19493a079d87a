//! Positions of the footpads' sections.

use libm::sincos;
use nalgebra::Vector3;

use crate::invalid::Invalid;
use crate::land::land_observed;
use crate::landing::Instant;
use crate::scene::{CrushRule, Scene, Settings};
use crate::vehicle::Vehicle;

/// Centroids of the uncrushed outboard and inboard sections of a pad (14)(15), vehicle axes from
/// the CG, ft.
pub(super) fn centroids(
    vehicle: &Vehicle,
    leg: usize,
    link_angle: f64,
    pad_angle: f64,
) -> [Vector3<f64>; 2] {
    let design = vehicle.hinged_legs()[leg].design();
    let (linkage, footpad) = (&design.linkage, &design.footpad);
    let (sine, cosine) = sincos(design.azimuth);
    let in_plane =
        |outboard: f64, down: f64| Vector3::new(outboard * sine, outboard * cosine, down);
    let (sin_link, cos_link) = sincos(link_angle);
    let [cg_x, cg_y] = vehicle.center_of_gravity_offset();
    let pivot = in_plane(
        linkage.lower_hardpoint_radius + linkage.lower_link_length * cos_link,
        vehicle.center_of_gravity_height() + linkage.lower_link_length * sin_link,
    ) - Vector3::new(cg_x, cg_y, 0.0);
    let (sin_pad, cos_pad) = sincos(link_angle - pad_angle);
    let offset = 2.0 * footpad.diameter / (3.0 * std::f64::consts::PI);
    let middle = pivot + in_plane(-sin_pad, cos_pad) * footpad.height;
    let aside = in_plane(cos_pad, sin_pad) * offset;
    [middle + aside, middle - aside]
}

/// The CG at first contact and the section of pad `leg` that touches at `contact` (s after first
/// contact), in the ground axes of a scene, ft.
pub(super) fn at_contact(
    vehicle: &Vehicle,
    scene: &Scene,
    leg: usize,
    contact: f64,
) -> Result<(Vector3<f64>, Vector3<f64>), Invalid> {
    // The landing ends at the contact, and its last instant is there.
    let limit = contact.max(1e-9);
    let settings = Settings::new(super::TOLERANCE, limit, CrushRule::default())?;
    let mut instants: Vec<Instant> = Vec::new();
    land_observed(
        vehicle,
        scene,
        &settings,
        limit,
        &mut |instant: &Instant| {
            instants.push(instant.clone());
        },
    );
    let (Some(first), Some(last)) = (instants.first(), instants.last()) else {
        return Ok((Vector3::zeros(), Vector3::zeros()));
    };
    let Some(angles) = last.legs[leg].hinged() else {
        return Ok((Vector3::zeros(), Vector3::zeros()));
    };
    let sections = centroids(vehicle, leg, angles.link_angle, angles.pad_angle);
    let matrix = last.attitude.matrix();
    let (sine, cosine) = sincos(scene.conditions().slope);
    let depth = |point: &Vector3<f64>| sine * point.y + cosine * point.z;
    let [outboard, inboard] = sections.map(|section| last.position + matrix * section);
    let deeper = if depth(&outboard) >= depth(&inboard) {
        outboard
    } else {
        inboard
    };
    Ok((first.position, deeper))
}
