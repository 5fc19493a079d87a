//! Steps of several landings, a lane for each, compiled for the registers there are.

use pulp::NullaryFnOnce;

use crate::formation::LandingsAbreast;
use crate::integrator::rosenbrock::GAMMA;
use crate::integrator::step::{Step, Weights};
use crate::integrator::{dormand_prince, rosenbrock};
use crate::motion::{Glance, GlancesAbreast, Motion, MotionsAbreast, Pieces};
use crate::registers::Lanes;
use crate::response::Response;
use crate::state::State;
use crate::wide::Wide;

/// Kind of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Explicit,
    Implicit,
}

impl Kind {
    /// Evaluations of the derivative in such a step.
    pub(super) fn evaluations(self) -> u64 {
        match self {
            Self::Explicit => dormand_prince::EVALUATIONS,
            Self::Implicit => rosenbrock::EVALUATIONS,
        }
    }

    /// Weights of its slopes.
    pub(super) fn weights(self) -> Weights<f64> {
        match self {
            Self::Explicit => dormand_prince::weights(),
            Self::Implicit => rosenbrock::weights(),
        }
    }
}

/// Where the numbers of a lane go.
pub(super) struct Place<'a, const LEGS: usize> {
    pub(super) step: &'a mut Step<f64, LEGS>,
    pub(super) middle: &'a mut Glance<LEGS>,
    pub(super) signals: &'a mut Glance<LEGS>,
}

/// Where those of an empty lane go.
pub(super) struct Spare<const LEGS: usize> {
    step: Step<f64, LEGS>,
    middle: Glance<LEGS>,
    signals: Glance<LEGS>,
}

impl<const LEGS: usize> Spare<LEGS> {
    pub(super) fn new() -> Self {
        Self {
            step: Step::from(State::zero(), State::zero()),
            middle: Glance::blank(),
            signals: Glance::blank(),
        }
    }

    pub(super) fn place(&mut self) -> Place<'_, LEGS> {
        let Self {
            step,
            middle,
            signals,
        } = self;
        Place {
            step,
            middle,
            signals,
        }
    }
}

/// Steps of one kind, a lane for each landing.
pub(super) struct Steps<const N: usize, const LEGS: usize> {
    motions: MotionsAbreast<N, LEGS>,
    response: Response<LandingsAbreast<N>, LEGS>,
    step: Step<Wide<N>, LEGS>,
    /// Stages of implicit steps.
    stages: [State<Wide<N>, LEGS>; 6],
    lengths: Wide<N>,
    /// Signals midway through implicit steps, and at the ends.
    middle: GlancesAbreast<N, LEGS>,
    signals: GlancesAbreast<N, LEGS>,
    /// Rates (1/s) that no decay exceeds at the starts of implicit steps.
    rates: Wide<N>,
    /// Errors of the motion for a tolerance of 1, and of the works, ft·lb.
    errors: [f64; N],
    work_errors: Wide<N>,
}

impl<const N: usize, const LEGS: usize> Steps<N, LEGS> {
    /// Lanes for landings such as this one; there are none in them yet.
    pub(super) fn new(motion: &Motion<LEGS>) -> Self {
        let motions = MotionsAbreast::new(motion);
        Self {
            response: motions.response(),
            motions,
            step: Step::from(State::zero(), State::zero()),
            stages: [State::zero(); 6],
            lengths: Wide([0.0; N]),
            middle: GlancesAbreast::blank(),
            signals: GlancesAbreast::blank(),
            rates: Wide([0.0; N]),
            errors: [0.0; N],
            work_errors: Wide([0.0; N]),
        }
    }

    /// Puts a landing's equations into a lane.
    pub(super) fn set_motion(&mut self, lane: usize, motion: &Motion<LEGS>) {
        self.motions.set_motion(lane, motion);
    }

    /// Puts the coefficients of a leg that are in force into a lane.
    pub(super) fn set_pieces(&mut self, lane: usize, leg: usize, pieces: &Pieces<LEGS>) {
        self.motions.set_pieces(lane, leg, pieces);
    }

    /// Puts the start of a step into a lane.
    pub(super) fn set_start(&mut self, lane: usize, step: &Step<f64, LEGS>) {
        self.step.before.set_lane(lane, &step.before);
        self.step.slopes[0].set_lane(lane, &step.slopes[0]);
    }

    /// Puts the length of a step (s) into a lane.
    pub(super) fn set_length(&mut self, lane: usize, length: f64) {
        self.lengths.0[lane] = length;
    }

    /// Rate (1/s) that no decay in a lane exceeds at the start of the implicit step there.
    pub(super) fn rate(&self, lane: usize) -> f64 {
        self.rates.0[lane]
    }

    /// Error of the step in a lane in units of the tolerance, `work` ft·lb being allowed to a work.
    pub(super) fn error(&self, lane: usize, tolerance: f64, work: f64) -> f64 {
        (self.errors[lane] / tolerance).max(self.work_errors.0[lane] / work)
    }

    /// Takes a step in all lanes.
    pub(super) fn take<R: Lanes<N>>(&mut self, registers: R, kind: Kind) {
        match kind {
            Kind::Explicit => registers.dispatch(Take::<_, false, N, LEGS> {
                registers,
                steps: self,
            }),
            Kind::Implicit => registers.dispatch(Take::<_, true, N, LEGS> {
                registers,
                steps: self,
            }),
        }
    }

    /// Hands each landing its step.
    pub(super) fn deal<R: Lanes<N>>(&self, registers: R, kind: Kind, places: [Place<'_, LEGS>; N]) {
        registers.dispatch(Deal {
            registers,
            steps: self,
            kind,
            places,
        });
    }

    /// Goes on to the ends of the steps in some lanes.
    pub(super) fn go_on<R: Lanes<N>>(&mut self, registers: R, lanes: [bool; N]) {
        registers.dispatch(GoOn { steps: self, lanes });
    }
}

/// Derivatives in all lanes.
struct Derive<'a, const STOPS: bool, const N: usize, const LEGS: usize>(
    &'a MotionsAbreast<N, LEGS>,
    &'a State<Wide<N>, LEGS>,
    &'a mut State<Wide<N>, LEGS>,
);

impl<const STOPS: bool, const N: usize, const LEGS: usize> NullaryFnOnce
    for Derive<'_, STOPS, N, LEGS>
{
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0.derivative::<STOPS>(self.1, self.2);
    }
}

/// Derivatives and signals in all lanes.
struct Evaluate<'a, const STOPS: bool, const N: usize, const LEGS: usize>(
    &'a MotionsAbreast<N, LEGS>,
    &'a State<Wide<N>, LEGS>,
    &'a mut State<Wide<N>, LEGS>,
    &'a mut GlancesAbreast<N, LEGS>,
);

impl<const STOPS: bool, const N: usize, const LEGS: usize> NullaryFnOnce
    for Evaluate<'_, STOPS, N, LEGS>
{
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0.evaluate::<STOPS>(self.1, self.2, self.3);
    }
}

/// Takes explicit or implicit steps in all lanes.
struct Take<'a, R, const IMPLICIT: bool, const N: usize, const LEGS: usize> {
    registers: R,
    steps: &'a mut Steps<N, LEGS>,
}

impl<R: Lanes<N>, const IMPLICIT: bool, const N: usize, const LEGS: usize> NullaryFnOnce
    for Take<'_, R, IMPLICIT, N, LEGS>
{
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let registers = self.registers;
        let Steps {
            motions,
            response,
            step,
            stages,
            lengths,
            middle,
            signals,
            rates,
            errors,
            work_errors,
        } = self.steps;
        let motions = &*motions;
        let stops = motions.press_stops();
        let evaluate = |states: &State<Wide<N>, LEGS>,
                        slopes: &mut State<Wide<N>, LEGS>,
                        signals: &mut GlancesAbreast<N, LEGS>| {
            if stops {
                registers.dispatch(Evaluate::<true, N, LEGS>(motions, states, slopes, signals));
            } else {
                registers.dispatch(Evaluate::<false, N, LEGS>(motions, states, slopes, signals));
            }
        };
        let derivative = |states: &State<Wide<N>, LEGS>, slopes: &mut State<Wide<N>, LEGS>| {
            if stops {
                registers.dispatch(Derive::<true, N, LEGS>(motions, states, slopes));
            } else {
                registers.dispatch(Derive::<false, N, LEGS>(motions, states, slopes));
            }
        };
        let last = |states: &State<Wide<N>, LEGS>, slopes: &mut State<Wide<N>, LEGS>| {
            evaluate(states, slopes, signals);
        };
        if IMPLICIT {
            motions.respond(&step.before, response);
            *rates = response.greatest_rate();
            let system = response.over(Wide([GAMMA; N]) * *lengths);
            let midway = |states: &State<Wide<N>, LEGS>, slopes: &mut State<Wide<N>, LEGS>| {
                evaluate(states, slopes, middle);
            };
            step.take_implicit(*lengths, &system, stages, derivative, midway, last);
        } else {
            step.take_explicit(*lengths, derivative, last);
        }
        let error = step.error();
        *errors = error.error_norms(&step.before, &step.after);
        *work_errors = error.greatest_works();
    }
}

/// Hands each landing its step.
struct Deal<'a, R, const N: usize, const LEGS: usize> {
    registers: R,
    steps: &'a Steps<N, LEGS>,
    kind: Kind,
    places: [Place<'a, LEGS>; N],
}

impl<R: Lanes<N>, const N: usize, const LEGS: usize> NullaryFnOnce for Deal<'_, R, N, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self {
            registers,
            steps,
            kind,
            mut places,
        } = self;
        let Step { after, slopes, .. } = &steps.step;
        after.deal(
            registers,
            places.each_mut().map(|place| &mut place.step.after),
        );
        for (k, slope) in slopes.iter().enumerate().skip(1) {
            slope.deal(
                registers,
                places.each_mut().map(|place| &mut place.step.slopes[k]),
            );
        }
        if kind == Kind::Implicit {
            let glances = places.each_mut().map(|place| &mut *place.middle);
            steps.middle.deal(registers, glances);
        }
        let glances = places.each_mut().map(|place| &mut *place.signals);
        steps.signals.deal(registers, glances);
    }
}

/// Goes on to the ends of the steps in some lanes.
struct GoOn<'a, const N: usize, const LEGS: usize> {
    steps: &'a mut Steps<N, LEGS>,
    lanes: [bool; N],
}

impl<const N: usize, const LEGS: usize> NullaryFnOnce for GoOn<'_, N, LEGS> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let stays = Wide(std::array::from_fn(|lane| {
            f64::from(u8::from(!self.lanes[lane]))
        }));
        let Step {
            before,
            after,
            slopes: [first, .., last],
            ..
        } = &mut self.steps.step;
        before.replace(stays, after);
        first.replace(stays, last);
    }
}
