//! Positions at every instant, and the forces of the ground.

use nalgebra::{Vector3, Vector4};
use serde::Serialize;
use touchdown_dynamics::contact::Sinkages;
use touchdown_dynamics::kinematics::{BodyFrame, PointVelocity, SeenGround};
use touchdown_dynamics::landing::{Instant, LegInstant};
use touchdown_dynamics::motion::Motion;
use touchdown_dynamics::rules::Rules;
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::stability::StabilityMonitor;
use touchdown_dynamics::state::{Body, LegState, State};
use touchdown_dynamics::vehicle::Vehicle;

use super::{Triple, rounded, triple};

/// All instants, column by column.
#[derive(Debug, Default, Serialize)]
pub struct Instants {
    time_s: Vec<f64>,
    center_of_gravity: Vec<Triple>,
    /// The matrix B, vehicle to ground, row by row.
    rotation: Vec<[f64; 9]>,
    stability_angle_deg: Vec<f64>,
    /// Numbers of the two critical feet; `None` if all feet are on one side.
    critical_edge: Vec<Option<[usize; 2]>>,
    legs: Vec<LegColumns>,
}

#[derive(Debug, Default, Clone, Serialize)]
struct LegColumns {
    pivot: Vec<Triple>,
    /// From the pivot to the centre of the pad's face.
    pad_axis: Vec<Triple>,
    /// Depths of the uncrushed faces of the outboard and inboard halves in the ground, on soil in their prints.
    pad_interference: Vec<[f64; 2]>,
    /// Plastic sets of both halves.
    pad_crush: Vec<[f64; 2]>,
    block_interference: Vec<f64>,
    block_crush: Vec<f64>,
    stroke: Vec<f64>,
    strut_force: Vec<f64>,
    pad_force: Vec<Triple>,
    block_force: Vec<Triple>,
    is_down: Vec<bool>,
}

impl Instants {
    /// Columns of a landing.
    pub fn of(
        vehicle: &Vehicle,
        scene: &Scene,
        rules: Rules,
        motion: &Motion<f64>,
        instants: &[Instant],
    ) -> Self {
        let mut monitor = StabilityMonitor::new(rules, vehicle, scene);
        let mut columns = Self {
            legs: vec![LegColumns::default(); vehicle.leg_count()],
            ..Self::default()
        };
        for instant in instants {
            let body = body(instant);
            let frame = motion.frame(&body);
            let matrix = frame.rotation.transpose();
            let mut rotation = [0.0; 9];
            for (place, number) in rotation.iter_mut().zip(matrix.iter()) {
                *place = rounded(*number);
            }
            columns.time_s.push(instant.time);
            columns.center_of_gravity.push(triple(&instant.position));
            columns.rotation.push(rotation);
            let angle = instant.stability_angle.to_degrees();
            columns.stability_angle_deg.push(rounded(angle));
            let state = state(&body, instant);
            let chosen = monitor.choose_plane(motion, &state);
            columns.critical_edge.push(chosen.ok().map(|_| {
                let feet = monitor.critical_feet(&motion.footing(&state));
                feet.map(|foot| foot + 1)
            }));
            for (index, (leg, to)) in instant.legs.iter().zip(&mut columns.legs).enumerate() {
                to.add(motion, index, &frame, leg);
            }
        }
        columns
    }
}

impl LegColumns {
    fn add(
        &mut self,
        motion: &Motion<f64>,
        index: usize,
        frame: &BodyFrame<f64>,
        leg: &LegInstant,
    ) {
        let Some(posture) = leg.hinged() else {
            return;
        };
        let geometry = motion.geometry(index);
        let [pad, block] = motion.ground(index, frame);
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
            triple(&(against - frame.rotation * seen.normal * normal))
        };
        let swing = geometry.link_length() * posture.link_rate;
        let of_pivot = leg_frame.pivot_velocity(&pose, swing);
        let of_block = leg_frame.block_velocity(&pose);

        let pivot = geometry.off_leg_plane(&pose.pivot);
        let pivot = frame.position + frame.seen_from_center_of_gravity(&pivot);
        self.pivot.push(triple(&pivot));
        self.pad_axis
            .push(triple(&in_ground_axes(&pose.pad_z.in_leg_axes())));
        let sunk = leg.sinkages.unwrap_or(Sinkages::NONE);
        let [outer, inner] = pose.pad_interference;
        let in_print = [outer - sunk.pad[0], inner - sunk.pad[1]];
        self.pad_interference.push(in_print.map(above_zero));
        self.pad_crush.push(leg.pad_sets.map(rounded));
        self.block_interference
            .push(above_zero(pose.block_interference - sunk.block));
        self.block_crush.push(rounded(leg.block_set));
        self.stroke.push(rounded(leg.stroke));
        self.strut_force.push(rounded(leg.strut_force));
        self.pad_force
            .push(force(&pad, &of_pivot, [leg.pad_normal, leg.pad_friction]));
        self.block_force.push(force(
            &block,
            &of_block,
            [leg.block_normal, leg.block_friction],
        ));
        self.is_down.push(leg.pad_normal > 0.0);
    }
}

fn above_zero(depth: f64) -> f64 {
    rounded(depth.max(0.0))
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
fn state(body: &Body<f64>, instant: &Instant) -> State<f64> {
    let legs: Vec<LegState<f64>> = (instant.legs.iter().filter_map(LegInstant::hinged))
        .map(|posture| LegState {
            link_angle: posture.link_angle,
            link_rate: posture.link_rate,
            pad_turn: posture.pad_angle,
            pad_rate: posture.pad_rate,
            work: [0.0; 6],
        })
        .collect();
    State::new(body, &legs)
}
