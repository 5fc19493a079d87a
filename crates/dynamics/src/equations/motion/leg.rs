//! The equations of one leg: its action on the body and on itself.

use nalgebra::Vector3;

use super::pieces::Pressed;
use super::{LegLoads, LegPieces, LegSignals};
use crate::crush::elastic_slope;
use crate::kinematics::{
    BodyFrame, LegFrame, LegGeometry, LegGround, LegPose, PlanePoint, PointVelocity, SeenGround,
    turned,
};
use crate::lanes::per_lane;
use crate::profile::Profile;
use crate::scalar::Real;
use crate::scene::Scene;
use crate::signal::by_signal;
use crate::state::LegState;
use crate::vehicle::Leg;

/// Constants of the equations of one leg.
#[derive(Debug, Clone, Copy)]
pub(super) struct LegMotion<S> {
    pub(super) geometry: LegGeometry<S>,
    pub(super) ground: LegGround<S>,
    pub(super) link_inertia: S,
    inverse_link_inertia: S,
    pub(super) pad_inertia: S,
    inverse_pad_inertia: S,
    /// 1/(I_γ + I_α) − 1/I_γ, 1/(slug·ft²): for a pad that is one with its link.
    inverse_inertia_change: S,
    /// Damping of the pad's hinge, ft·lb·s/rad.
    pub(super) hinge_damping: S,
    /// Half of π d_f²/8 C_f: the attitude factor of (29) and (33) is then 1 + cos²ξ.
    pub(super) pad_strength: S,
    /// Half of π d_B²/4 C_B.
    block_strength: S,
    /// These over the slope E of the elastic line and, for the block, over 2: an element stores p²/2E per strength.
    pub(super) pad_leaning: S,
    pub(super) block_leaning: S,
    pub(super) pad_friction: S,
    pub(super) block_friction: S,
}

per_lane!(LegMotion {
    geometry,
    ground,
    link_inertia,
    inverse_link_inertia,
    pad_inertia,
    inverse_pad_inertia,
    inverse_inertia_change,
    hinge_damping,
    pad_strength,
    block_strength,
    pad_leaning,
    block_leaning,
    pad_friction,
    block_friction,
});

impl LegMotion<f64> {
    /// Constants of leg `index`, placed from the centre ([`LegGround::new`]).
    pub(super) fn new(
        index: usize,
        leg: &Leg,
        hardpoint_depth: f64,
        center: [f64; 2],
        scene: &Scene,
    ) -> Self {
        let geometry = LegGeometry::new(leg, hardpoint_depth);
        let design = leg.design();
        let pad = &design.footpad;
        let quarter_circle = std::f64::consts::FRAC_PI_4;
        let pad_strength = 0.25 * quarter_circle * pad.diameter * pad.diameter * pad.crush_pressure;
        let block_strength = design.block.as_ref().map_or(0.0, |block| {
            0.5 * quarter_circle * block.diameter * block.diameter * block.crush_pressure
        });
        let soil = &scene.conditions().soil_under(index);
        let elastic = |profile: &Profile, crush_pressure: f64| {
            elastic_slope(profile.first_slope(), soil, crush_pressure)
        };
        let link_inertia = design.linkage.inertia;
        Self {
            ground: LegGround::new(scene, index, &geometry, center, leg.extended_angle()),
            geometry,
            link_inertia,
            inverse_link_inertia: 1.0 / link_inertia,
            pad_inertia: pad.inertia,
            inverse_pad_inertia: 1.0 / pad.inertia,
            inverse_inertia_change: 1.0 / (link_inertia + pad.inertia) - 1.0 / link_inertia,
            hinge_damping: pad.hinge_damping,
            pad_strength,
            block_strength,
            pad_leaning: pad_strength / elastic(&pad.profile, pad.crush_pressure),
            block_leaning: design.block.as_ref().map_or(0.0, |block| {
                0.5 * block_strength / elastic(&block.profile, block.crush_pressure)
            }),
            pad_friction: scene.conditions().pad_friction,
            block_friction: scene.conditions().block_friction,
        }
    }
}

/// Action of one leg on the body and itself, its signals and its loads.
pub(super) struct LegAction<S> {
    /// Force on the body in vehicle axes, lb.
    pub(super) force: Vector3<S>,
    /// Torque on the body about the centre in vehicle axes, ft·lb.
    pub(super) torque: Vector3<S>,
    pub(super) derivative: LegState<S>,
    pub(super) signals: LegSignals<S>,
    pub(super) loads: LegLoads<S>,
}

/// Action of the surface on a footpad or block, in leg axes.
pub(super) struct Touch<S> {
    /// Velocity of the place where it acts.
    pub(super) velocity: PointVelocity<S>,
    /// Normal force N, lb.
    pub(super) normal: S,
    /// μ/S, s/ft.
    pub(super) drag: S,
    /// n + μ t̂: the surface pushes against it with N.
    pub(super) line: Vector3<S>,
    pub(super) force: Vector3<S>,
    pub(super) moment: Vector3<S>,
}

impl<S: Real> Touch<S> {
    #[inline(always)]
    pub(super) fn none() -> Self {
        let zero = S::zero();
        Self {
            velocity: PointVelocity {
                inward: zero,
                sliding: Vector3::from([zero; 3]),
                sliding_squared: zero,
            },
            normal: zero,
            drag: zero,
            line: Vector3::from([zero; 3]),
            force: Vector3::from([zero; 3]),
            moment: Vector3::from([zero; 3]),
        }
    }

    /// Normal force N and friction along the sliding velocity of `point` (39), on ground with this inward normal.
    #[inline(always)]
    fn new(
        inward: &Vector3<S>,
        point: &PlanePoint<S>,
        velocity: PointVelocity<S>,
        normal: S,
        drag: S,
    ) -> Self {
        let line = inward + velocity.sliding * drag;
        let force = line * -normal;
        S::keep_lanes_together(Self {
            moment: point.moment(&force),
            velocity,
            normal,
            drag,
            line,
            force,
        })
    }

    /// Friction force, lb.
    #[inline(always)]
    fn friction(&self) -> S {
        self.normal * self.drag * self.velocity.sliding_squared.sqrt()
    }
}

impl<S: Real> LegMotion<S> {
    /// The ground under footpad and block, seen from the body.
    #[inline(always)]
    pub(super) fn seen_ground(&self, body: &BodyFrame<S>) -> [SeenGround<S>; 2] {
        if self.ground.is_even() {
            [body.surface; 2]
        } else {
            self.ground.seen(body)
        }
    }

    /// The body's frame along this leg, over its ground.
    #[inline(always)]
    pub(super) fn frame(&self, body: &BodyFrame<S>) -> LegFrame<S> {
        let [pad, block] = self.seen_ground(body);
        self.geometry.frame(body, [&pad, &block])
    }

    /// Load on the edge of the footpad, lb: 0 on its face.
    #[inline(always)]
    pub(super) fn edge_load(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        pieces: &LegPieces<S>,
    ) -> S {
        pieces.edge.load.at(self.geometry.edge_depth(frame, pose))
    }

    /// Normal force (33) on the block per unit of relative pressure, lb.
    #[inline(always)]
    pub(super) fn block_force_per_pressure(&self, frame: &LegFrame<S>) -> S {
        let cos_block = frame.block.normal.z;
        self.block_strength * (S::one() + cos_block * cos_block)
    }

    /// Normal force (33) on the block, lb, with that of soil that it pushes aside if it `drags`.
    #[inline(always)]
    pub(super) fn block_normal(
        &self,
        frame: &LegFrame<S>,
        pose: &LegPose<S>,
        pieces: &LegPieces<S>,
        drags: bool,
    ) -> S {
        let mut pressure = pieces.block.at(pose.block_interference);
        if drags {
            let inward = frame.block_velocity(pose).inward;
            pressure += (pieces.block).drag_at(frame.block_interference_rate(inward));
        }
        self.block_force_per_pressure(frame) * pressure
    }

    /// Action of one leg on the body and itself, and its signals. Without `SIGNALS`, elements that are not `pressed`
    /// are not computed and their signals mean nothing. Without `FORCES`, only the signals have a meaning, except the
    /// link torque. Without `FULL`, the leg has to stand over the surface. The pad's turn has to be its angle
    /// (`stops`). With `FACE`, which needs `FULL`, the ground acts where it is touched.
    #[inline(always)]
    pub(super) fn action<
        const FORCES: bool,
        const SIGNALS: bool,
        const FULL: bool,
        const FACE: bool,
    >(
        &self,
        body: &BodyFrame<S>,
        leg: &LegState<S>,
        pieces: &LegPieces<S>,
        pressed: Pressed,
    ) -> LegAction<S> {
        let seen;
        let grounds = if !FULL || self.ground.is_even() {
            [&body.surface; 2]
        } else {
            seen = self.ground.seen(body);
            [&seen[0], &seen[1]]
        };
        let frame = self.geometry.frame(body, grounds);
        let pad_angle = leg.pad_turn;
        let pose = self.geometry.pose(&frame, leg.link_angle, pad_angle);
        let link_length = self.geometry.link_length();

        // Footpad: normal force (29), torque about its hinge (52).
        let cos_pad = pose.pad_inclination;
        let [outer, inner] = pose.pad_interference;
        let (pad, pad_torque, pad_leaning_power) = if !SIGNALS && !pressed.pads {
            (Touch::none(), S::zero(), S::zero())
        } else if FACE {
            self.face_touch(&frame, &pose, leg, pieces, pressed.drag)
        } else {
            let velocity = frame.pivot_velocity(&pose, link_length * leg.link_rate);
            let per_pressure = self.pad_force_per_pressure(&pose);
            let drags = FULL && pressed.drag;
            let pressure = self.pad_pressures(&frame, &pose, leg, pieces, drags);
            let on_face = per_pressure * (pressure[0] + pressure[1]);
            let edge_load = if FULL {
                self.edge_load(&frame, &pose, pieces)
            } else {
                S::zero()
            };
            let normal = if FULL { on_face + edge_load } else { on_face };
            let drag = self.pad_friction * pieces.pad_friction.per_speed(velocity.sliding_squared);
            let pad = Touch::new(&frame.pad.normal, &pose.pivot, velocity, normal, drag);
            let along_z = pose.pad_z.dot(&pad.line);
            let along_y = pose.pad_y.dot(&pad.line);
            let centroids = self.geometry.centroids();
            let height = self.geometry.pad_height();
            let lever =
                |k: usize| (height - pose.pad_interference[k]) * along_y - centroids[k] * along_z;
            let on_face = -per_pressure * (pressure[0] * lever(0) + pressure[1] * lever(1));
            let torque = if FULL {
                let lever = turned(&self.geometry.edge(&frame, &pose)).dot(&pad.line);
                on_face + edge_load * lever
            } else {
                on_face
            };
            (pad, torque, S::zero())
        };

        // Block: normal force (33).
        let (block, block_leaning_power) = if !SIGNALS && !pressed.blocks {
            (Touch::none(), S::zero())
        } else {
            let velocity = frame.block_velocity(&pose);
            let normal = self.block_normal(&frame, &pose, pieces, FULL && pressed.drag);
            let drag =
                self.block_friction * pieces.block_friction.per_speed(velocity.sliding_squared);
            let mut block = Touch::new(
                &frame.block.normal,
                &pose.block_center,
                velocity,
                normal,
                drag,
            );
            if FACE {
                let (moment, power) = self.block_leaning(&frame, &pose, pieces);
                block.moment += moment;
                (block, power)
            } else {
                (block, S::zero())
            }
        };

        // Lower link (49), (68).
        let strut_rate = pose.strut_lever * leg.link_rate;
        let strut = pieces
            .strut
            .force(pose.stroke, leg.link_rate, pose.strut_lever);
        let pivot_torque = link_length * pose.link_normal.dot(&pad.force);
        // A pad on a stop is one with its link; damping of its hinge drags the link along.
        let swings = pieces.hinge.swings();
        let damping = self.hinge_damping * (swings * leg.pad_rate);
        let surface_torque = if FACE {
            pivot_torque - (S::one() - swings) * pad_torque - damping
        } else {
            pivot_torque
        };
        let inverse_link_inertia = if FACE {
            self.inverse_link_inertia + (S::one() - swings) * self.inverse_inertia_change
        } else {
            self.inverse_link_inertia
        };
        let link_torque = surface_torque + strut * pose.strut_lever;
        let link_acceleration = pieces
            .link
            .acceleration(link_torque * inverse_link_inertia, leg.link_rate);

        // Footpad hinge (69).
        let unclipped = pieces.hinge.unclipped_speed(pad_angle, leg.pad_rate);
        let pad_speed = pieces.hinge.speed(unclipped);
        let (pad_acceleration, hinge_drive) = if FACE {
            let alone = (pad_torque - damping) * self.inverse_pad_inertia + link_acceleration;
            let drive = pad_torque + self.pad_inertia * link_acceleration;
            (swings * alone, drive)
        } else {
            (
                pad_torque * self.inverse_pad_inertia + link_acceleration,
                unclipped,
            )
        };
        // The stop, or the turning of the pad, takes the torque that does not accelerate the link.
        let stop_power = if FACE {
            let bare_torque = pivot_torque + strut * pose.strut_lever;
            (bare_torque - self.link_inertia * link_acceleration) * leg.link_rate
                - pad_torque * pieces.hinge.pad_turning(leg.link_rate, leg.pad_rate)
        } else {
            (link_torque - self.link_inertia * link_acceleration) * leg.link_rate
        };

        let derivative = LegState {
            link_angle: pieces.link.moving * leg.link_rate,
            link_rate: link_acceleration,
            pad_turn: pad_speed,
            pad_rate: pad_acceleration,
            work: [
                -strut * strut_rate,
                if FACE {
                    pad.normal * pad.velocity.inward + pad_leaning_power
                } else {
                    pad.normal * pad.velocity.inward
                },
                pad.normal * pad.drag * pad.velocity.sliding_squared,
                if FACE {
                    block.normal * block.velocity.inward + block_leaning_power
                } else {
                    block.normal * block.velocity.inward
                },
                block.normal * block.drag * block.velocity.sliding_squared,
                stop_power,
            ],
        };
        // The laws let the pivot swing with the rate state; a frozen link does not swing.
        let pivot_rate = if FACE {
            let swing = link_length * leg.link_rate;
            frame.pivot_velocity(&pose, swing).inward
        } else {
            pad.velocity.inward
        };
        let idle_swing = link_length * (leg.link_rate - derivative.link_angle);
        let pivot_inward = pivot_rate - idle_swing * pose.link_normal.dot(&frame.pad.normal);
        let rates = self.geometry.pad_interference_rates(
            &frame,
            &pose,
            pivot_inward,
            derivative.link_angle,
            pad_speed,
        );
        let (outer, outer_rate) = if FULL {
            // On the edge, its depth stands for the interference of the outboard section.
            let on_edge = pieces.edge.is_active;
            let turning = derivative.link_angle - pad_speed;
            let tilting = frame.inclination_rate(&pose, turning);
            let edge_rate = self.geometry.edge_rate(&pose, pivot_inward, tilting);
            (
                on_edge.where_zero(outer, self.geometry.edge_depth(&frame, &pose)),
                on_edge.where_zero(rates[0], edge_rate),
            )
        } else {
            (outer, rates[0])
        };
        let block_rate = if FACE {
            frame.held_block_interference_rate(block.velocity.inward, pose.block_interference)
        } else {
            frame.block_interference_rate(block.velocity.inward)
        };
        let foot = body.seen_from_center_of_gravity(&self.geometry.off_leg_plane(&pose.pivot));
        let signals = by_signal![
            OuterInterference: outer,
            InnerInterference: inner,
            BlockInterference: pose.block_interference,
            Stroke: pose.stroke,
            OuterRate: outer_rate,
            InnerRate: rates[1],
            BlockRate: block_rate,
            StrokeRate: -pose.strut_lever * derivative.link_angle,
            PivotRate: pivot_rate,
            BlockCentreRate: block.velocity.inward,
            PadSliding: pad.velocity.sliding_squared,
            BlockSliding: block.velocity.sliding_squared,
            LinkRate: leg.link_rate,
            LinkTorque: if FORCES { surface_torque } else { S::zero() },
            PadTurn: pad_angle,
            PadRate: leg.pad_rate,
            HingeDrive: hinge_drive,
            PadInclination: cos_pad,
            StrutForce: strut,
            StrutLever: pose.strut_lever,
            FootX: foot.x,
            FootY: foot.y,
            FootZ: foot.z,
            HardpointDepth: grounds[1].depth_of(&self.geometry.lower_hardpoint()),
        ];
        LegAction {
            force: self.geometry.in_vehicle_axes(&(pad.force + block.force)),
            torque: self.geometry.in_vehicle_axes(&(pad.moment + block.moment)),
            derivative,
            signals,
            loads: LegLoads {
                strut,
                pad_normal: pad.normal,
                pad_friction: pad.friction(),
                block_normal: block.normal,
                block_friction: block.friction(),
            },
        }
    }
}
