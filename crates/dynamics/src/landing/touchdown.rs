//! First contact: the state at which a landing begins.

use libm::sincos;
use nalgebra::{Vector3, Vector4};

use crate::extremes::greatest;
use crate::motion::Motion;
use crate::per_leg::PerLeg;
use crate::scene::{Conditions, Scene};
use crate::state::{Body, LegState, State};
use crate::vehicle::Vehicle;

/// Legs at rest: struts extended, pads level with the vehicle.
pub fn extended_legs(vehicle: &Vehicle) -> PerLeg<LegState<f64>> {
    let legs = vehicle.hinged_legs();
    PerLeg::from_fn(legs.len(), |j| {
        let angle = legs[j].extended_angle();
        LegState {
            link_angle: angle,
            link_rate: 0.0,
            pad_turn: angle,
            pad_rate: 0.0,
            work: [0.0; 6],
        }
    })
}

/// The body at first contact, with its CG at the origin.
pub(super) fn body_at_touchdown(conditions: &Conditions) -> Body<f64> {
    let [w, x, y, z] = conditions.attitude.quaternion();
    let (sin_cross, cos_cross) = sincos(conditions.cross_slope);
    let speed = conditions.horizontal_velocity;
    Body {
        position: Vector3::zeros(),
        velocity: Vector3::new(
            -speed * sin_cross,
            speed * cos_cross,
            conditions.vertical_velocity,
        ),
        quaternion: Vector4::new(w, x, y, z),
        rate: Vector3::from(conditions.angular_velocity),
    }
}

/// State at first contact: CG above the origin, the lowest pad section centroid on the surface.
pub fn touchdown(vehicle: &Vehicle, scene: &Scene, motion: &Motion<f64>) -> State<f64> {
    let conditions = scene.conditions();
    let legs = extended_legs(vehicle);
    let mut body = body_at_touchdown(conditions);
    let frame = motion.frame(&body);
    let rises = (0..legs.len()).flat_map(|j| {
        let geometry = motion.geometry(j);
        let [pad, block] = motion.ground(j, &frame);
        let leg_frame = geometry.frame(&frame, [&pad, &block]);
        let pose = geometry.pose(&leg_frame, legs[j].link_angle, legs[j].pad_turn);
        geometry
            .section_depths(&pose)
            .map(|depth| motion.rise(j, depth))
    });
    body.position.z = -greatest(rises);
    State::new(&body, &legs)
}
