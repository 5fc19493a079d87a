//! Ranges in which the legs' signals stay while the active pieces hold.

use arrayvec::ArrayVec;
use pulp::NullaryFnOnce;

use crate::integrator::event::{Bounds, Exit, Guard};
use crate::integrator::ranges::{LANES, Quad, Ranges};
use crate::lanes::Lanes;
use crate::motion::{Signal, Signals};
use crate::per_leg::{MOST_LEGS, PerLeg};
use crate::registers::{Registers, Single};

/// Number of quads of a leg's signals with ranges.
const QUADS: usize = Signals::RANGED_QUADS;

/// Reach of signals beyond their ranges, before any is known.
const NOWHERE: [Quad; QUADS] = [Lanes([0.0; LANES]); QUADS];

/// Guarded signals, with room for all.
pub(super) type Guards = ArrayVec<Guard, { QUADS * LANES * MOST_LEGS }>;

/// Ranges of all legs' signals.
#[derive(Debug, Clone)]
pub(super) struct SignalRanges {
    registers: Single,
    legs: PerLeg<Ranges<QUADS>>,
}

impl SignalRanges {
    /// The ranges of all legs, signal by signal.
    pub(super) fn new(legs: &[[Bounds; Signal::RANGED]]) -> Self {
        let mut ranges = Self {
            registers: Single::fastest(),
            legs: PerLeg::same(legs.len(), Ranges::free()),
        };
        for (leg, bounds) in legs.iter().enumerate() {
            ranges.set(leg, bounds);
        }
        ranges
    }

    /// Sets the ranges of leg `leg`, signal by signal.
    pub(super) fn set(&mut self, leg: usize, ranges: &[Bounds; Signal::RANGED]) {
        for (&range, signal) in ranges.iter().zip(Signal::ALL) {
            self.legs[leg].set(signal as usize, range);
        }
    }

    fn get(&self, leg: usize, signal: Signal) -> Bounds {
        self.legs[leg].get(signal as usize)
    }

    /// The first signal of each leg out of its range, and the side on which it left.
    pub(super) fn exits(&self, signals: &Signals<f64>) -> PerLeg<Option<(Signal, Exit)>> {
        let holds = self.registers.dispatch(Hold(self, signals));
        PerLeg::from_fn(self.legs.len(), |leg| {
            if holds[leg] {
                return None;
            }
            Signal::ALL[..Signal::RANGED].iter().find_map(|&signal| {
                let range = self.get(leg, signal);
                let exit = range.exit(signals.of(leg, signal))?;
                (!range.is_free()).then_some((signal, exit))
            })
        })
    }

    /// Returns whether no signal can have left its range within a step of `length` s, judged from the signals at the
    /// start of the previous step and at the start and end of this one. `ratio` is this step's length over the previous
    /// one's. Puts signals that may have left into `guards`.
    #[inline(always)]
    pub(super) fn keep(
        &self,
        looks: [&Signals<f64>; 3],
        ratio: f64,
        length: f64,
        guards: &mut Guards,
    ) -> bool {
        guards.clear();
        (self.registers).dispatch(Keep(self, looks, Some([ratio, length]), guards))
    }

    /// Puts signals that may have left their ranges within a step into `guards`, judged from its start, middle and end.
    #[inline(always)]
    pub(super) fn guard_suspects(&self, looks: [&Signals<f64>; 3], guards: &mut Guards) {
        guards.clear();
        (self.registers).dispatch(Keep(self, looks, None, guards));
    }

    /// Guards the signals of a leg that reach beyond their ranges.
    fn guard(&self, leg: usize, reach: &[Quad; QUADS], guards: &mut Guards) {
        for (quad, reach) in reach.iter().enumerate() {
            if (reach.0.iter()).fold(true, |stays, reach| stays & (*reach < 0.0)) {
                continue;
            }
            for (lane, reach) in reach.0.iter().enumerate() {
                let signal = quad * LANES + lane;
                let range = self.legs[leg].get(signal);
                if (*reach >= 0.0 || reach.is_nan()) && !range.is_free() {
                    let signal = leg * Signal::COUNT + signal;
                    guards.push(Guard { signal, range });
                }
            }
        }
    }
}

/// Tests whether all signals of each leg are in range.
struct Hold<'a>(&'a SignalRanges, &'a Signals<f64>);

impl NullaryFnOnce for Hold<'_> {
    type Output = PerLeg<bool>;

    #[inline(always)]
    fn call(self) -> PerLeg<bool> {
        let Self(all, signals) = self;
        let mut holds = PerLeg::same(all.legs.len(), true);
        for (leg, ranges) in all.legs.iter().enumerate() {
            holds[leg] = ranges.hold(signals.ranged(leg));
        }
        holds
    }
}

/// Tests whether all signals stay in range, by rates if ratio and length of the step are given. Those that may not
/// become guards.
struct Keep<'a>(
    &'a SignalRanges,
    [&'a Signals<f64>; 3],
    Option<[f64; 2]>,
    &'a mut Guards,
);

impl NullaryFnOnce for Keep<'_> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Self(all, looks, rated, guards) = self;
        let mut are_kept = true;
        for (leg, ranges) in all.legs.iter().enumerate() {
            let [first, second, third] = looks;
            let looks = [first.ranged(leg), second.ranged(leg), third.ranged(leg)];
            let mut reach = NOWHERE;
            let is_kept = match rated {
                Some([ratio, length]) => {
                    ranges.keep_by_rates(looks, ratio, length, Signals::RATED_QUADS, &mut reach)
                }
                None => ranges.keep(looks, 1.0, &mut reach),
            };
            if !is_kept {
                are_kept = false;
                all.guard(leg, &reach, guards);
            }
        }
        are_kept
    }
}
