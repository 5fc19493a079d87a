//! Legs that turn about one hinge.

use nalgebra::{Vector3, Vector4};
use touchdown_dynamics::kinematics::{BodyFrame, PointVelocity, SeenGround};
use touchdown_dynamics::landing::{HingedPosture, Instant, LegInstant};
use touchdown_dynamics::motion::Motion;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::stability::StabilityMonitor;
use touchdown_dynamics::state::{Body, LegState, State};
use touchdown_dynamics::touchdown::touchdown;
use touchdown_dynamics::vehicle::{Leg, Vehicle};

use super::shape::{BlockShape, PadShape, StrutShape};
use super::{LegKind, LegPlace, LegShape, Patch, triple};

/// The hinged legs of a vehicle in a scene.
pub struct HingedLegs<'a> {
    vehicle: &'a Vehicle,
    scene: &'a Scene,
    motion: Motion<f64>,
    monitor: StabilityMonitor,
}

impl<'a> HingedLegs<'a> {
    pub fn new(vehicle: &'a Vehicle, scene: &'a Scene, rules: Rules) -> Self {
        Self {
            vehicle,
            scene,
            motion: Motion::new(vehicle, scene),
            monitor: StabilityMonitor::new(rules, vehicle, scene),
        }
    }

    fn shape(&self, index: usize, leg: &Leg, center: &Vector3<f64>) -> LegShape {
        let (design, geometry) = (leg.design(), self.motion.geometry(index));
        let (sine, cosine) = design.azimuth.sin_cos();
        let outboard = Vector3::new(sine, cosine, 0.0);
        let lower = center + geometry.lower_hardpoint();
        // Chosen to satisfy (11): outboard by l_A sin β, up by l_A cos β.
        let linkage = &design.linkage;
        let (sin_beta, cos_beta) = linkage.hardpoint_angle.sin_cos();
        let between = outboard * sin_beta - Vector3::z() * cos_beta;
        let upper = triple(&(lower + between * linkage.hardpoint_distance));
        LegShape {
            azimuth_deg: design.azimuth.to_degrees(),
            outboard: triple(&outboard),
            upper_hardpoint: upper,
            lower_hardpoint: triple(&lower),
            link_length: Some(linkage.lower_link_length),
            struts: vec![StrutShape {
                from: upper,
                length: design.strut.extended_length,
                minimum_length: design.strut.minimum_length,
                maximum_length: design.strut.extended_length,
                collar: None,
            }],
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

    fn place(
        &self,
        index: usize,
        frame: &BodyFrame<f64>,
        leg: &LegInstant,
        posture: &HingedPosture,
    ) -> LegPlace {
        let geometry = self.motion.geometry(index);
        let [pad, block] = self.motion.ground(index, frame);
        let leg_frame = geometry.frame(frame, [&pad, &block]);
        let pose = geometry.pose(&leg_frame, posture.link_angle, posture.pad_angle);
        let in_ground_axes =
            |along_leg: &Vector3<f64>| frame.rotation * geometry.in_vehicle_axes(along_leg);
        let force = |seen: &SeenGround<f64>,
                     velocity: &PointVelocity<f64>,
                     [normal, friction]: [f64; 2]| {
            let speed = velocity.sliding_squared.sqrt();
            let against = match speed > 0.0 {
                true => in_ground_axes(&velocity.sliding) * (-friction / speed),
                false => Vector3::zeros(),
            };
            against - frame.rotation * seen.normal * normal
        };
        let swing = geometry.link_length() * posture.link_rate;
        let of_pivot = leg_frame.pivot_velocity(&pose, swing);
        let of_block = leg_frame.block_velocity(&pose);
        let pivot = geometry.off_leg_plane(&pose.pivot);
        LegPlace {
            pivot: frame.position + frame.seen_from_center_of_gravity(&pivot),
            pad_axis: in_ground_axes(&pose.pad_z.in_leg_axes()),
            pad_interference: pose.pad_interference,
            block_interference: pose.block_interference,
            strokes: vec![leg.stroke],
            strut_forces: vec![leg.strut_force],
            pad_force: force(&pad, &of_pivot, [leg.pad_normal, leg.pad_friction]),
            block_force: force(&block, &of_block, [leg.block_normal, leg.block_friction]),
        }
    }
}

impl LegKind for HingedLegs<'_> {
    fn shapes(&self, center: &Vector3<f64>) -> Vec<LegShape> {
        let legs = self.vehicle.hinged_legs().iter().enumerate();
        legs.map(|(index, leg)| self.shape(index, leg, center))
            .collect()
    }

    fn patches(&self) -> Vec<Patch> {
        let body = touchdown(self.vehicle, self.scene, &self.motion).body();
        let frame = self.motion.frame(&body);
        let mut patches = Vec::new();
        for (index, leg) in self.vehicle.hinged_legs().iter().enumerate() {
            let geometry = self.motion.geometry(index);
            let [pad, block] = self.motion.ground(index, &frame);
            let footing = self.scene.conditions().ground.leg(index);
            let mut add = |of, is_even, seen: &SeenGround<f64>, place: Vector3<f64>| {
                let inward = frame.rotation * seen.normal;
                let point = body.position + frame.seen_from_center_of_gravity(&place);
                let depth = seen.depth_of(&place);
                patches.push(Patch::new(index, of, is_even, point, &inward, depth));
            };
            let foot = geometry.pivot(leg.extended_angle());
            add("pad", footing.pad.is_even(), &pad, foot);
            if leg.design().block.is_some() {
                let face = geometry.block_face();
                add("block", footing.block.is_even(), &block, face);
            }
        }
        patches
    }

    fn critical_feet(&mut self, instant: &Instant) -> Option<[usize; 2]> {
        let state = state(instant);
        let chosen = self.monitor.choose_plane(&self.motion, &state);
        let footing = self.motion.footing(&state);
        chosen.ok().map(|_| self.monitor.critical_feet(&footing))
    }

    fn places(&self, instant: &Instant) -> Vec<LegPlace> {
        let frame = self.motion.frame(&body(instant));
        let legs = instant.legs.iter().enumerate();
        legs.filter_map(|(index, leg)| Some(self.place(index, &frame, leg, leg.hinged()?)))
            .collect()
    }
}

fn body(instant: &Instant) -> Body<f64> {
    let [w, x, y, z] = instant.attitude.quaternion();
    Body {
        position: instant.position,
        velocity: instant.velocity,
        quaternion: Vector4::new(w, x, y, z),
        rate: instant.angular_velocity,
    }
}

/// The part of the state that determines the positions of the feet.
fn state(instant: &Instant) -> State<f64> {
    let legs: Vec<LegState<f64>> = (instant.legs.iter().filter_map(LegInstant::hinged))
        .map(|posture| LegState {
            link_angle: posture.link_angle,
            link_rate: posture.link_rate,
            pad_turn: posture.pad_angle,
            pad_rate: posture.pad_rate,
            work: [0.0; 6],
        })
        .collect();
    State::new(&body(instant), &legs)
}
