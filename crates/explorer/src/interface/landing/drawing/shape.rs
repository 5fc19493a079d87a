//! The vehicle at rest, in its own axes from the CG.

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::vehicle::Vehicle;

use super::{LegKind, Triple, rounded, triple};

/// A vehicle.
#[derive(Debug, Serialize)]
pub struct Shape {
    /// Point of the centreline level with the CG.
    center: Triple,
    body: Drum,
    /// Leg numbers by azimuth: the order of the corners of the polygon of the feet.
    ring: Vec<usize>,
    legs: Vec<LegShape>,
}

/// A drum around the centreline through the hardpoints, for drawing only.
#[derive(Debug, Serialize)]
struct Drum {
    top: f64,
    bottom: f64,
    radius: f64,
}

#[derive(Debug, Serialize)]
pub struct LegShape {
    pub azimuth_deg: f64,
    /// Direction from the centreline to the leg.
    pub outboard: Triple,
    pub lower_hardpoint: Triple,
    pub upper_hardpoint: Triple,
    /// Length of the link from the lower hardpoint to the footpad.
    pub link_length: Option<f64>,
    pub struts: Vec<StrutShape>,
    pub footpad: PadShape,
    pub block: Option<BlockShape>,
}

#[derive(Debug, Serialize)]
pub struct StrutShape {
    /// Its hardpoint.
    pub from: Triple,
    /// Length without stroke.
    pub length: f64,
    pub minimum_length: f64,
    pub maximum_length: f64,
    /// Distance from the hardpoint of the first strut to the place on that strut where this one ends; at the footpad
    /// without it.
    pub collar: Option<f64>,
}

#[derive(Debug, Serialize)]
pub struct PadShape {
    pub diameter: f64,
    pub height: f64,
}

#[derive(Debug, Serialize)]
pub struct BlockShape {
    /// Centre of its uncrushed face.
    pub face: Triple,
    pub diameter: f64,
    /// Height of the face below the plane of the lower hardpoints.
    pub height: f64,
}

impl Shape {
    /// Shape of a vehicle.
    pub fn of(vehicle: &Vehicle, legs: &impl LegKind) -> Self {
        let [x, y] = vehicle.center_of_gravity_offset();
        let center = Vector3::new(-x, -y, 0.0);
        let legs = legs.shapes(&center);
        let heights = |of: fn(&LegShape) -> &Triple| legs.iter().map(move |leg| of(leg)[2]);
        let radii = legs.iter().map(
            |LegShape {
                 lower_hardpoint: [to_x, to_y, _],
                 ..
             }| { (to_x - center.x).hypot(to_y - center.y) },
        );
        Self {
            center: triple(&center),
            body: Drum {
                top: heights(|leg| &leg.upper_hardpoint).fold(f64::INFINITY, f64::min),
                bottom: heights(|leg| &leg.lower_hardpoint).fold(f64::NEG_INFINITY, f64::max),
                radius: rounded(radii.fold(f64::INFINITY, f64::min)),
            },
            ring: vehicle.ring().iter().map(|leg| leg + 1).collect(),
            legs,
        }
    }
}
