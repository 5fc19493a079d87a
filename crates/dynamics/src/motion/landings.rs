//! The equations of motion of several landings side by side.

use super::leg::LegAction;
use super::pieces::{GroupPieces, Pressed};
use super::{Equations, Glance, LegPieces, Legs, Motion, Pieces, Push, Signal};
use crate::formation::LandingsAbreast;
use crate::kinematics::BodyFrame;
use crate::quad::MOST_LEGS;
use crate::registers::Lanes;
use crate::response::Response;
use crate::state::State;
use crate::wide::{Abreast, Wide};

/// The equations of motion of so many landings, a lane for each, with the coefficients that are in force.
#[derive(Debug, Clone)]
pub struct MotionsAbreast<const N: usize, const LEGS: usize> {
    equations: Equations<LandingsAbreast<N>, LEGS>,
    pub(super) pieces: [GroupPieces<Wide<N>>; LEGS],
}

/// The signals of so many landings, laid out as in a [`Glance`].
#[derive(Debug, Clone)]
#[repr(align(64))]
pub struct GlancesAbreast<const N: usize, const LEGS: usize> {
    rows: [[Wide<N>; MOST_LEGS]; Signal::COUNT],
}

impl<const N: usize, const LEGS: usize> GlancesAbreast<N, LEGS> {
    /// Nothing seen yet: all signals zero.
    pub fn blank() -> Self {
        Self {
            rows: [[Wide([0.0; N]); MOST_LEGS]; Signal::COUNT],
        }
    }

    /// Writes a signal of leg `leg`.
    pub(super) fn set(&mut self, leg: usize, signal: Signal, values: Wide<N>) {
        self.rows[signal as usize][leg] = values;
    }

    /// Writes the signals of each landing.
    #[inline(always)]
    pub fn deal<R: Lanes<N>>(&self, registers: R, glances: [&mut Glance<LEGS>; N]) {
        registers.deal(self.rows.as_flattened(), glances.map(Glance::numbers_mut));
    }
}

impl<const N: usize, const LEGS: usize> MotionsAbreast<N, LEGS> {
    /// The same landing in all lanes, its legs in the air.
    pub fn new(motion: &Motion<LEGS>) -> Self {
        let equations = &motion.equations;
        Self {
            equations: Equations {
                surface: equations.surface.shared(),
                gravity: equations.gravity.shared(),
                inverse_mass: equations.inverse_mass.shared(),
                inertia: equations.inertia.shared(),
                inverse_inertia: equations.inverse_inertia.shared(),
                groups: std::array::from_fn(|j| motion.legs[j].shared()),
            },
            pieces: std::array::from_fn(|_| GroupPieces::new(LegPieces::absent().shared())),
        }
    }

    /// Puts a landing into a lane.
    pub fn set_motion(&mut self, lane: usize, motion: &Motion<LEGS>) {
        let (one, all) = (&motion.equations, &mut self.equations);
        one.surface.set_lane(&mut all.surface, lane);
        one.gravity.set_lane(&mut all.gravity, lane);
        one.inverse_mass.set_lane(&mut all.inverse_mass, lane);
        one.inertia.set_lane(&mut all.inertia, lane);
        one.inverse_inertia.set_lane(&mut all.inverse_inertia, lane);
        for (leg, legs) in motion.legs.iter().zip(&mut all.groups) {
            leg.set_lane(legs, lane);
        }
    }

    /// Puts coefficients of leg `leg` in force in a lane.
    pub fn set_pieces(&mut self, lane: usize, leg: usize, pieces: &Pieces<LEGS>) {
        let GroupPieces { legs, pressed } = &mut self.pieces[leg];
        pieces.leg(leg).set_lane(legs, lane);
        *pressed = Pressed::of(legs);
    }

    /// Writes the time derivatives of the states. `STOPS` says whether pads press on stops ([`Self::press_stops`]):
    /// known beforehand, it takes no branch among the equations, which would cost more than what is so seldom asked for.
    #[inline(always)]
    pub fn derivative<const STOPS: bool>(
        &self,
        states: &State<Wide<N>, LEGS>,
        derivatives: &mut State<Wide<N>, LEGS>,
    ) {
        let legs = Deriving::<STOPS, N, LEGS> {
            motions: self,
            states,
        };
        self.equations.push(states, derivatives, legs);
        if STOPS {
            self.turn(states, derivatives);
        }
    }

    /// Writes the time derivatives of the states and the signals of all legs; `STOPS` as for [`Self::derivative`].
    #[inline(always)]
    pub fn evaluate<const STOPS: bool>(
        &self,
        states: &State<Wide<N>, LEGS>,
        derivatives: &mut State<Wide<N>, LEGS>,
        glances: &mut GlancesAbreast<N, LEGS>,
    ) {
        let legs = Evaluating::<STOPS, N, LEGS> {
            motions: self,
            states,
            glances: &mut *glances,
        };
        self.equations.push(states, derivatives, legs);
        if STOPS {
            self.turn(states, derivatives);
            self.tell_turns(states, glances);
        }
    }

    /// A response to be overwritten by [`Self::respond`].
    #[inline(always)]
    pub fn response(&self) -> Response<LandingsAbreast<N>, LEGS> {
        self.equations.response()
    }

    /// Writes how the forces answer.
    #[inline(always)]
    pub fn respond(
        &self,
        states: &State<Wide<N>, LEGS>,
        response: &mut Response<LandingsAbreast<N>, LEGS>,
    ) {
        // Landings come and go, and their bodies with them.
        response.mass = self.equations.mass();
        response.inertia = self.equations.inertia;
        let frame = self.equations.face(states, response);
        for (leg, GroupPieces { legs, pressed }) in self.pieces.iter().enumerate() {
            self.equations.groups[leg].respond(
                &frame,
                &self.bend(leg, states.leg(leg)),
                legs,
                *pressed,
                &mut response.groups[leg],
            );
        }
    }

    #[inline(always)]
    fn action<const SIGNALS: bool, const STOPS: bool>(
        &self,
        leg: usize,
        frame: &BodyFrame<Wide<N>>,
        states: &State<Wide<N>, LEGS>,
    ) -> LegAction<Wide<N>> {
        let GroupPieces { legs, pressed } = &self.pieces[leg];
        let mut states = states.leg(leg);
        if STOPS {
            states = self.bend(leg, states);
        }
        self.equations.groups[leg].action::<true, SIGNALS>(frame, &states, legs, *pressed)
    }
}

/// Legs whose derivatives are asked for.
struct Deriving<'a, const STOPS: bool, const N: usize, const LEGS: usize> {
    motions: &'a MotionsAbreast<N, LEGS>,
    states: &'a State<Wide<N>, LEGS>,
}

impl<const STOPS: bool, const N: usize, const LEGS: usize> Legs<LandingsAbreast<N>, LEGS>
    for Deriving<'_, STOPS, N, LEGS>
{
    #[inline(always)]
    fn push(
        &mut self,
        leg: usize,
        frame: &BodyFrame<Wide<N>>,
        derivatives: &mut State<Wide<N>, LEGS>,
    ) -> Push<Wide<N>> {
        let push = (self.motions)
            .action::<false, STOPS>(leg, frame, self.states)
            .push;
        derivatives.set_leg(leg, &push.derivative);
        [push.force, push.torque]
    }
}

/// Legs whose derivatives and signals are asked for.
struct Evaluating<'a, const STOPS: bool, const N: usize, const LEGS: usize> {
    motions: &'a MotionsAbreast<N, LEGS>,
    states: &'a State<Wide<N>, LEGS>,
    glances: &'a mut GlancesAbreast<N, LEGS>,
}

impl<const STOPS: bool, const N: usize, const LEGS: usize> Legs<LandingsAbreast<N>, LEGS>
    for Evaluating<'_, STOPS, N, LEGS>
{
    #[inline(always)]
    fn push(
        &mut self,
        leg: usize,
        frame: &BodyFrame<Wide<N>>,
        derivatives: &mut State<Wide<N>, LEGS>,
    ) -> Push<Wide<N>> {
        let LegAction { push, signals, .. } =
            (self.motions).action::<true, STOPS>(leg, frame, self.states);
        derivatives.set_leg(leg, &push.derivative);
        for (row, signal) in self.glances.rows.iter_mut().zip(&signals) {
            row[leg] = *signal;
        }
        [push.force, push.torque]
    }
}
