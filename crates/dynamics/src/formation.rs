//! What lies side by side in registers: the legs of one landing, or the same leg of several landings.
//!
//! The equations are written once, over the numbers of a body and those of its legs. With the legs abreast a body's
//! are single numbers and a leg's are quads, a lane for each leg. With landings abreast both have a lane for each
//! landing, and leg follows leg. Either way each number comes out of the same operations in the same order.

use std::fmt::Debug;
use std::ops::{Index, IndexMut};

use nalgebra::Vector6;

use crate::kinematics::BodyFrame;
use crate::quad::{LANES, Quad};
use crate::scalar::Real;
use crate::state::{LegState, State};
use crate::wide::{Abreast, Wide};

/// How numbers of bodies and legs lie in registers.
pub trait Formation<const LEGS: usize>: Debug + Clone + Copy {
    /// A number of the body.
    type Body: Real;
    /// A number of each leg in a group that is computed together.
    type Leg: Real;
    /// Something for each group of legs.
    type Groups<T: Debug + Clone + Copy>: Debug
        + Clone
        + Copy
        + Index<usize, Output = T>
        + IndexMut<usize>;
    /// Groups of legs.
    const GROUPS: usize;

    /// Something for each group of legs.
    fn groups<T: Debug + Clone + Copy>(of: impl FnMut(usize) -> T) -> Self::Groups<T>;

    /// A number of the body, for each leg of a group.
    fn shared(number: Self::Body) -> Self::Leg;

    /// The body's frame, for each leg of a group.
    fn frame(frame: &BodyFrame<Self::Body>) -> BodyFrame<Self::Leg>;

    /// Adds to sums what the legs of a group give, one after the other.
    fn add<const M: usize>(sums: &mut [Self::Body; M], legs: &[Self::Leg; M]);

    /// A number of each leg, one by one.
    fn one_by_one(of: impl Fn(usize) -> Self::Leg) -> [Self::Body; LEGS];

    /// The legs of a group.
    fn legs(state: &State<Self::Body, LEGS>, group: usize) -> LegState<Self::Leg>;

    /// Writes the legs of a group.
    fn set_legs(state: &mut State<Self::Body, LEGS>, group: usize, legs: &LegState<Self::Leg>);

    /// Six numbers of the body, for each leg of a group.
    #[inline(always)]
    fn shared_six(v: &Vector6<Self::Body>) -> Vector6<Self::Leg> {
        let shared = Self::shared;
        Vector6::new(
            shared(v[0]),
            shared(v[1]),
            shared(v[2]),
            shared(v[3]),
            shared(v[4]),
            shared(v[5]),
        )
    }
}

/// One landing, its legs side by side.
#[derive(Debug, Clone, Copy)]
pub struct LegsAbreast;

impl<const LEGS: usize> Formation<LEGS> for LegsAbreast {
    type Body = f64;
    type Leg = Quad;
    type Groups<T: Debug + Clone + Copy> = [T; 1];
    const GROUPS: usize = 1;

    #[inline(always)]
    fn groups<T: Debug + Clone + Copy>(of: impl FnMut(usize) -> T) -> [T; 1] {
        std::array::from_fn(of)
    }

    #[inline(always)]
    fn shared(number: f64) -> Quad {
        Quad::constant(number)
    }

    #[inline(always)]
    fn frame(frame: &BodyFrame<f64>) -> BodyFrame<Quad> {
        frame.shared()
    }

    #[inline(always)]
    fn add<const M: usize>(sums: &mut [f64; M], legs: &[Quad; M]) {
        for lane in 0..LANES.min(LEGS) {
            for i in 0..M {
                sums[i] += legs[i].0[lane];
            }
        }
    }

    #[inline(always)]
    fn one_by_one(of: impl Fn(usize) -> Quad) -> [f64; LEGS] {
        let legs = of(0);
        std::array::from_fn(|leg| legs.0[leg])
    }

    #[inline(always)]
    fn legs(state: &State<f64, LEGS>, group: usize) -> LegState<Quad> {
        state.legs_abreast(group)
    }

    #[inline(always)]
    fn set_legs(state: &mut State<f64, LEGS>, group: usize, legs: &LegState<Quad>) {
        state.set_legs_abreast(group, legs);
    }
}

/// So many landings side by side, their legs one after the other.
#[derive(Debug, Clone, Copy)]
pub struct LandingsAbreast<const N: usize>;

impl<const N: usize, const LEGS: usize> Formation<LEGS> for LandingsAbreast<N> {
    type Body = Wide<N>;
    type Leg = Wide<N>;
    type Groups<T: Debug + Clone + Copy> = [T; LEGS];
    const GROUPS: usize = LEGS;

    #[inline(always)]
    fn groups<T: Debug + Clone + Copy>(of: impl FnMut(usize) -> T) -> [T; LEGS] {
        std::array::from_fn(of)
    }

    #[inline(always)]
    fn shared(number: Wide<N>) -> Wide<N> {
        number
    }

    #[inline(always)]
    fn frame(frame: &BodyFrame<Wide<N>>) -> BodyFrame<Wide<N>> {
        *frame
    }

    #[inline(always)]
    fn add<const M: usize>(sums: &mut [Wide<N>; M], leg: &[Wide<N>; M]) {
        for i in 0..M {
            sums[i] += leg[i];
        }
    }

    #[inline(always)]
    fn one_by_one(of: impl Fn(usize) -> Wide<N>) -> [Wide<N>; LEGS] {
        std::array::from_fn(of)
    }

    #[inline(always)]
    fn legs(state: &State<Wide<N>, LEGS>, leg: usize) -> LegState<Wide<N>> {
        state.leg(leg)
    }

    #[inline(always)]
    fn set_legs(state: &mut State<Wide<N>, LEGS>, leg: usize, legs: &LegState<Wide<N>>) {
        state.set_leg(leg, legs);
    }
}
