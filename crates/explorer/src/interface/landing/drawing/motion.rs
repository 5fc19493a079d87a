//! Positions at every instant, and the forces of the ground.

use nalgebra::Vector3;
use serde::Serialize;
use touchdown_dynamics::contact::Sinkages;
use touchdown_dynamics::landing::{Instant, LegInstant};
use touchdown_dynamics::vehicle::Vehicle;

use super::{LegKind, Triple, rounded, triple};

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
    /// Of each strut.
    strokes: Vec<Vec<f64>>,
    strut_forces: Vec<Vec<f64>>,
    pad_force: Vec<Triple>,
    block_force: Vec<Triple>,
    is_down: Vec<bool>,
}

/// A leg at one instant, in ground axes.
pub struct LegPlace {
    pub pivot: Vector3<f64>,
    /// From the pivot to the centre of the pad's face.
    pub pad_axis: Vector3<f64>,
    /// Depths of the uncrushed faces of the outboard and inboard halves in the ground.
    pub pad_interference: [f64; 2],
    pub block_interference: f64,
    /// Of each strut.
    pub strokes: Vec<f64>,
    pub strut_forces: Vec<f64>,
    pub pad_force: Vector3<f64>,
    pub block_force: Vector3<f64>,
}

impl Instants {
    /// Columns of a landing.
    pub fn of(vehicle: &Vehicle, legs: &mut impl LegKind, instants: &[Instant]) -> Self {
        let mut columns = Self {
            legs: vec![LegColumns::default(); vehicle.leg_count()],
            ..Self::default()
        };
        for instant in instants {
            let matrix = instant.attitude.matrix().transpose();
            let mut rotation = [0.0; 9];
            for (place, number) in rotation.iter_mut().zip(matrix.iter()) {
                *place = rounded(*number);
            }
            columns.time_s.push(instant.time);
            columns.center_of_gravity.push(triple(&instant.position));
            columns.rotation.push(rotation);
            let angle = instant.stability_angle.to_degrees();
            columns.stability_angle_deg.push(rounded(angle));
            let critical = legs.critical_feet(instant);
            (columns.critical_edge).push(critical.map(|feet| feet.map(|foot| foot + 1)));
            let places = legs.places(instant);
            for ((place, leg), to) in places.iter().zip(&instant.legs).zip(&mut columns.legs) {
                to.add(place, leg);
            }
        }
        columns
    }
}

impl LegColumns {
    fn add(&mut self, place: &LegPlace, leg: &LegInstant) {
        let all_rounded = |numbers: &[f64]| numbers.iter().copied().map(rounded).collect();
        let sunk = leg.sinkages.unwrap_or(Sinkages::NONE);
        let [outer, inner] = place.pad_interference;
        let in_print = [outer - sunk.pad[0], inner - sunk.pad[1]];
        self.pivot.push(triple(&place.pivot));
        self.pad_axis.push(triple(&place.pad_axis));
        self.pad_interference.push(in_print.map(above_zero));
        self.pad_crush.push(leg.pad_sets.map(rounded));
        self.block_interference
            .push(above_zero(place.block_interference - sunk.block));
        self.block_crush.push(rounded(leg.block_set));
        self.strokes.push(all_rounded(&place.strokes));
        self.strut_forces.push(all_rounded(&place.strut_forces));
        self.pad_force.push(triple(&place.pad_force));
        self.block_force.push(triple(&place.block_force));
        self.is_down.push(leg.pad_normal > 0.0);
    }
}

fn above_zero(depth: f64) -> f64 {
    rounded(depth.max(0.0))
}
