//! The vehicle at rest, in its own axes from the CG.

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::motion::Motion;
use touchdown_dynamics::vehicle::{Leg, StrutElement, Vehicle};

use super::{Triple, rounded, triple};

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
struct LegShape {
    azimuth_deg: f64,
    /// Direction from the centreline to the leg.
    outboard: Triple,
    lower_hardpoint: Triple,
    upper_hardpoint: Triple,
    link_length: f64,
    strut: StrutShape,
    footpad: PadShape,
    block: Option<BlockShape>,
}

#[derive(Debug, Serialize)]
struct StrutShape {
    extended_length: f64,
    minimum_length: f64,
    kind: &'static str,
}

#[derive(Debug, Serialize)]
struct PadShape {
    diameter: f64,
    height: f64,
}

#[derive(Debug, Serialize)]
struct BlockShape {
    /// Centre of its uncrushed face.
    face: Triple,
    diameter: f64,
    /// Height of the face below the plane of the lower hardpoints.
    height: f64,
}

impl Shape {
    /// Shape of a vehicle.
    pub fn of(vehicle: &Vehicle, motion: &Motion<f64>) -> Self {
        let [x, y] = vehicle.center_of_gravity_offset();
        let center = Vector3::new(-x, -y, 0.0);
        let legs = vehicle.hinged_legs().iter().enumerate();
        let legs: Vec<LegShape> = legs
            .map(|(index, leg)| leg_shape(motion, index, leg, &center))
            .collect();
        let heights = |of: fn(&LegShape) -> &Triple| legs.iter().map(move |leg| of(leg)[2]);
        let radii =
            (vehicle.hinged_legs().iter()).map(|leg| leg.design().linkage.lower_hardpoint_radius);
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

fn leg_shape(motion: &Motion<f64>, index: usize, leg: &Leg, center: &Vector3<f64>) -> LegShape {
    let (design, geometry) = (leg.design(), motion.geometry(index));
    let (sine, cosine) = design.azimuth.sin_cos();
    let outboard = Vector3::new(sine, cosine, 0.0);
    let lower = center + geometry.lower_hardpoint();
    // Chosen to satisfy (11): outboard by l_A sin β, up by l_A cos β.
    let linkage = &design.linkage;
    let (sin_beta, cos_beta) = linkage.hardpoint_angle.sin_cos();
    let between = outboard * sin_beta - Vector3::z() * cos_beta;
    LegShape {
        azimuth_deg: design.azimuth.to_degrees(),
        outboard: triple(&outboard),
        upper_hardpoint: triple(&(lower + between * linkage.hardpoint_distance)),
        lower_hardpoint: triple(&lower),
        link_length: linkage.lower_link_length,
        strut: StrutShape {
            extended_length: design.strut.extended_length,
            minimum_length: design.strut.minimum_length,
            kind: match design.strut.element {
                StrutElement::Damper(_) => "damper",
                StrutElement::Honeycomb(_) => "honeycomb",
            },
        },
        footpad: PadShape {
            diameter: design.footpad.diameter,
            height: design.footpad.height,
        },
        block: design.block.as_ref().map(|block| BlockShape {
            face: triple(&(center + geometry.block_face())),
            diameter: block.diameter,
            height: block.height,
        }),
    }
}
