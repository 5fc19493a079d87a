//! Steps of several landings, one per lane, compiled for the registers available.

use pulp::NullaryFnOnce;

use crate::integrator::step::Step;
use crate::landing::{Simulation, StepKind, TakeStep, Workspace};
use crate::lanes::Lanes;
use crate::motion::{Motion, Pieces, Signals};
use crate::registers::{Registers, Transpose};
use crate::state::State;

/// Steps of one kind, one landing per lane.
pub(super) struct LaneSteps<const N: usize> {
    motion: Motion<Lanes<N>>,
    pieces: Pieces<Lanes<N>>,
    workspace: Workspace<Lanes<N>>,
    step: Step<Lanes<N>, State<Lanes<N>>>,
    /// Start times of steps, s after first contact, and their lengths, s.
    time: Lanes<N>,
    length: Lanes<N>,
    /// Signals midway through implicit steps, and at the ends.
    middle: Signals<Lanes<N>>,
    signals: Signals<Lanes<N>>,
    /// Estimated errors ([`Step::error`]).
    errors: [Lanes<N>; 2],
    /// Receives the numbers of lanes without a landing.
    idle: Box<[Idle; N]>,
}

struct Idle {
    step: Step<f64, State<f64>>,
    signals: Signals<f64>,
    middle: Signals<f64>,
}

impl<const N: usize> LaneSteps<N> {
    /// Empty lanes for landings such as this one.
    pub(super) fn new(motion: &Motion<f64>) -> Self {
        let legs = motion.leg_count();
        let wide: Motion<Lanes<N>> = motion.in_all_lanes();
        let zero = State::zero(legs);
        Self {
            workspace: Workspace::new(&wide),
            motion: wide,
            pieces: Pieces::absent(legs),
            step: Step::from(zero, zero),
            time: Lanes([0.0; N]),
            length: Lanes([0.0; N]),
            middle: Signals::blank(legs),
            signals: Signals::blank(legs),
            errors: [Lanes([0.0; N]); 2],
            idle: Box::new(std::array::from_fn(|_| Idle {
                step: Step::from(State::zero(legs), State::zero(legs)),
                signals: Signals::blank(legs),
                middle: Signals::blank(legs),
            })),
        }
    }

    /// Puts a landing into a lane.
    pub(super) fn load(&mut self, lane: usize, simulation: &Simulation<'_>) {
        self.motion.set_lane(lane, &simulation.trajectory.motion);
        for leg in 0..self.motion.leg_count() {
            self.load_pieces(lane, leg, simulation);
        }
        self.load_start(lane, simulation);
        self.load_length(lane, simulation);
    }

    /// Puts the active coefficients of a leg into a lane.
    pub(super) fn load_pieces(&mut self, lane: usize, leg: usize, simulation: &Simulation<'_>) {
        self.pieces
            .set_lane(lane, leg, &simulation.trajectory.pieces);
    }

    /// Puts the start of a step into a lane.
    pub(super) fn load_start(&mut self, lane: usize, simulation: &Simulation<'_>) {
        let step = &simulation.trajectory.step;
        self.step.before.set_lane(lane, &step.before);
        self.step.slopes[0].set_lane(lane, &step.slopes[0]);
    }

    /// Puts time and length of a step into a lane.
    pub(super) fn load_length(&mut self, lane: usize, simulation: &Simulation<'_>) {
        self.time.0[lane] = simulation.time();
        self.length.0[lane] = simulation.length();
    }

    /// Upper bound of the decay rates in a lane at the start of its implicit step, 1/s.
    pub(super) fn rate(&self, lane: usize) -> f64 {
        self.workspace.greatest_decay.0[lane]
    }

    /// Estimated error of the step in a lane ([`Step::error`]).
    pub(super) fn errors(&self, lane: usize) -> [f64; 2] {
        self.errors.map(|error| error.0[lane])
    }

    /// Takes a step in all lanes.
    pub(super) fn take<R: Registers>(&mut self, registers: R, kind: StepKind) {
        self.errors = registers.dispatch(TakeStep {
            registers,
            kind,
            motion: &self.motion,
            pieces: &self.pieces,
            step: &mut self.step,
            time: self.time,
            length: self.length,
            workspace: &mut self.workspace,
            middle: &mut self.middle,
            signals: &mut self.signals,
        });
    }

    /// Hands each landing its step.
    pub(super) fn store<R: Transpose<N>>(
        &mut self,
        registers: R,
        kind: StepKind,
        landings: [Option<&mut Simulation<'static>>; N],
    ) {
        registers.dispatch(Store {
            registers,
            kind,
            steps: self,
            landings,
        });
    }

    /// Advances some lanes to the ends of their steps.
    pub(super) fn finish_step<R: Registers>(&mut self, registers: R, lanes: [bool; N]) {
        registers.dispatch(GoOn { steps: self, lanes });
    }
}

/// Destination of a lane's numbers.
struct Place<'a> {
    step: &'a mut Step<f64, State<f64>>,
    middle: &'a mut Signals<f64>,
    signals: &'a mut Signals<f64>,
}

/// Hands each landing its step.
struct Store<'a, R, const N: usize> {
    registers: R,
    kind: StepKind,
    steps: &'a mut LaneSteps<N>,
    landings: [Option<&'a mut Simulation<'static>>; N],
}

impl<R: Transpose<N>, const N: usize> NullaryFnOnce for Store<'_, R, N> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self {
            registers,
            kind,
            steps,
            landings,
        } = self;
        let mut idle = steps.idle.iter_mut();
        let mut places = landings.map(|landing| {
            // There are as many idle places as lanes.
            let idle = idle.next();
            match (landing, idle) {
                (Some(simulation), _) => {
                    let trajectory = &mut simulation.trajectory;
                    Place {
                        step: &mut trajectory.step,
                        middle: &mut trajectory.middle,
                        signals: trajectory.signals.end_mut(),
                    }
                }
                (
                    None,
                    Some(Idle {
                        step,
                        signals,
                        middle,
                    }),
                ) => Place {
                    step,
                    middle,
                    signals,
                },
                (None, None) => unreachable!("an idle place for each lane"),
            }
        });
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
        if kind == StepKind::Implicit {
            let signals = places.each_mut().map(|place| &mut *place.middle);
            steps.middle.deal(registers, signals);
        }
        let signals = places.each_mut().map(|place| &mut *place.signals);
        steps.signals.deal(registers, signals);
    }
}

/// Advances some lanes to the ends of their steps.
struct GoOn<'a, const N: usize> {
    steps: &'a mut LaneSteps<N>,
    lanes: [bool; N],
}

impl<const N: usize> NullaryFnOnce for GoOn<'_, N> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let mut stays = Lanes([1.0; N]);
        for lane in 0..N {
            if self.lanes[lane] {
                stays.0[lane] = 0.0;
            }
        }
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
