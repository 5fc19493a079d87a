//! Legs of three struts.

use nalgebra::Vector3;
use touchdown_dynamics::kinematics::LocalPlane;
use touchdown_dynamics::landing::{Instant, LegInstant, ThreeStrutPosture};
use touchdown_dynamics::scene::Scene;
use touchdown_dynamics::stability::critical_feet_of_hull;
use touchdown_dynamics::three_strut_leg::ThreeStrutLeg;
use touchdown_dynamics::three_struts::{Arrangement, ThreeStrutDesign};
use touchdown_dynamics::vehicle::Vehicle;

use super::shape::{PadShape, StrutShape};
use super::{LegKind, LegPlace, LegShape, Patch, triple};

/// The legs of three struts of a vehicle in a scene.
pub struct ThreeStrutLegs<'a> {
    legs: &'a [ThreeStrutLeg],
    /// Depth of the plane of the lower hardpoints below the CG, ft.
    depth: f64,
    grounds: Vec<Footing>,
}

/// The ground under a footpad.
struct Footing {
    is_even: bool,
    /// The foot at first contact, ground axes from the CG.
    foot: Vector3<f64>,
    plane: LocalPlane<f64>,
}

impl<'a> ThreeStrutLegs<'a> {
    pub fn new(vehicle: &Vehicle, legs: &'a [ThreeStrutLeg], scene: &Scene) -> Self {
        let conditions = scene.conditions();
        let depth = vehicle.center_of_gravity_height();
        let [x, y] = vehicle.center_of_gravity_offset();
        let footing = |(index, leg): (usize, &ThreeStrutLeg)| {
            let (foot, _) = leg.design().places();
            let foot = Vector3::new(-x, -y, depth) + in_vehicle_axes(leg.design(), &foot);
            let foot = conditions.attitude.matrix() * foot;
            let pad = &conditions.ground.leg(index).pad;
            Footing {
                is_even: pad.is_even(),
                foot,
                plane: LocalPlane::new(pad, conditions.slope, foot),
            }
        };
        Self {
            legs,
            depth,
            grounds: legs.iter().enumerate().map(footing).collect(),
        }
    }

    fn shape(&self, leg: &ThreeStrutLeg, center: &Vector3<f64>) -> LegShape {
        let design = leg.design();
        let (_, hardpoints) = design.places();
        let origin = center + Vector3::z() * self.depth;
        let hardpoints = hardpoints.map(|place| origin + in_vehicle_axes(design, &place));
        let [primary, left, right] = hardpoints;
        let secondary = (left + right) / 2.0;
        let (upper, lower) = match primary.z <= secondary.z {
            true => (primary, secondary),
            false => (secondary, primary),
        };
        let (struts, lengths) = (design.struts(), design.rest_lengths());
        let strut = |k: usize| StrutShape {
            from: triple(&hardpoints[k]),
            length: lengths[k],
            minimum_length: lengths[k] - struts[k].compression_stroke,
            maximum_length: lengths[k] + struts[k].tension_stroke,
            collar: match design.arrangement {
                Arrangement::Cantilever(telescope) if k > 0 => Some(telescope.collar),
                _ => None,
            },
        };
        LegShape {
            azimuth_deg: design.azimuth.to_degrees(),
            outboard: triple(&in_vehicle_axes(design, &Vector3::x())),
            upper_hardpoint: triple(&upper),
            lower_hardpoint: triple(&lower),
            link_length: None,
            struts: (0..struts.len()).map(strut).collect(),
            footpad: PadShape {
                diameter: design.footpad.diameter,
                height: design.footpad.height,
            },
            block: None,
        }
    }

    fn place(&self, index: usize, instant: &Instant) -> Option<LegPlace> {
        let leg = &instant.legs[index];
        let posture = leg.three_strut()?;
        let pivot = instant.position + instant.attitude.matrix() * posture.foot;
        let plane = &self.grounds[index].plane;
        let inward = plane.normal();
        let sliding = posture.velocity - inward * inward.dot(&posture.velocity);
        let direction = sliding.try_normalize(0.0).unwrap_or_default();
        let interference = plane.depth_of(&pivot) + self.legs[index].design().footpad.height;
        let of_struts = |primary, [left, right]: [f64; 2]| vec![primary, left, right];
        Some(LegPlace {
            pivot,
            pad_axis: *inward,
            pad_interference: [interference; 2],
            block_interference: 0.0,
            strokes: of_struts(leg.stroke, posture.secondary_strokes),
            strut_forces: of_struts(leg.strut_force, posture.secondary_forces),
            pad_force: -(inward * leg.pad_normal + direction * leg.pad_friction),
            block_force: Vector3::zeros(),
        })
    }
}

impl LegKind for ThreeStrutLegs<'_> {
    fn shapes(&self, center: &Vector3<f64>) -> Vec<LegShape> {
        let legs = self.legs.iter();
        legs.map(|leg| self.shape(leg, center)).collect()
    }

    fn patches(&self) -> Vec<Patch> {
        let patch = |(index, footing): (usize, &Footing)| {
            let Footing {
                is_even,
                foot,
                plane,
            } = footing;
            let depth = plane.depth_of(foot);
            Patch::new(index, "pad", *is_even, *foot, plane.normal(), depth)
        };
        self.grounds.iter().enumerate().map(patch).collect()
    }

    fn critical_feet(&mut self, instant: &Instant) -> Option<[usize; 2]> {
        let attitude = instant.attitude.matrix();
        let feet: Vec<Vector3<f64>> = (instant.legs.iter().filter_map(LegInstant::three_strut))
            .map(|ThreeStrutPosture { foot, .. }| attitude * foot)
            .collect();
        Some(critical_feet_of_hull(&feet))
    }

    fn places(&self, instant: &Instant) -> Vec<LegPlace> {
        (0..self.legs.len())
            .filter_map(|index| self.place(index, instant))
            .collect()
    }
}

/// A vector in the axes of a leg (outboard, across, down) in those of its vehicle.
fn in_vehicle_axes(design: &ThreeStrutDesign, along_leg: &Vector3<f64>) -> Vector3<f64> {
    let (sine, cosine) = design.azimuth.sin_cos();
    let outboard = Vector3::new(sine, cosine, 0.0);
    let across = Vector3::new(cosine, -sine, 0.0);
    outboard * along_leg.x + across * along_leg.y + Vector3::z() * along_leg.z
}
