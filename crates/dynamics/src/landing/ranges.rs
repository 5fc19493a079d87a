//! The ranges in which the legs' signals have to stay for the active pieces to hold.

use arrayvec::ArrayVec;
use pulp::NullaryFnOnce;

use crate::registers::{Four, Registers};

use crate::integrator::event::{Bounds, Exit, Watch};
use crate::integrator::ranges::Ranges;
use crate::motion::{Glance, Signal};
use crate::quad::{GROUPS, LANES, Quad};
use crate::wide::Wide;

/// Quads of signals that have ranges.
const QUADS: usize = Signal::RANGED * GROUPS;
/// Those of them that hold signals whose rates are signals too.
const RATED: usize = Signal::RATED * GROUPS;
/// How far beyond their ranges signals get, while nothing is known of it.
const NOWHERE: [Quad; QUADS] = [Wide([0.0; LANES]); QUADS];

/// Signals to be watched, as many as there can be.
pub(super) type Watches = ArrayVec<Watch, { QUADS * LANES }>;

/// Ranges of all legs' signals, laid out as the signals are.
#[derive(Debug, Clone)]
pub(super) struct SignalRanges<const LEGS: usize>(Ranges<QUADS>);

impl<const LEGS: usize> SignalRanges<LEGS> {
    /// The ranges of all legs, signal by signal.
    pub(super) fn new(legs: &[[Bounds; Signal::RANGED]; LEGS]) -> Self {
        let mut ranges = Self(Ranges::free());
        for (leg, bounds) in legs.iter().enumerate() {
            ranges.set(leg, bounds);
        }
        ranges
    }

    /// Sets the ranges of leg `leg`, signal by signal.
    pub(super) fn set(&mut self, leg: usize, ranges: &[Bounds; Signal::RANGED]) {
        for (&range, signal) in ranges.iter().zip(Signal::ALL) {
            self.0.set(Glance::<LEGS>::index(leg, signal), range);
        }
    }

    fn get(&self, leg: usize, signal: Signal) -> Bounds {
        self.0.get(Glance::<LEGS>::index(leg, signal))
    }

    /// Whether a signal of any leg has a range to stay in.
    pub(super) fn has(&self, signal: Signal) -> bool {
        (0..LEGS).any(|leg| !self.get(leg, signal).is_free())
    }

    /// The first signal of each leg that has left its range, and on which side.
    pub(super) fn exits(
        &self,
        registers: Four,
        signals: &Glance<LEGS>,
    ) -> [Option<(Signal, Exit)>; LEGS] {
        if registers.dispatch(Hold(&self.0, signals)) {
            return [None; LEGS];
        }
        std::array::from_fn(|leg| {
            Signal::ALL[..Signal::RANGED].iter().find_map(|&signal| {
                let range = self.get(leg, signal);
                let exit = range.exit(signals.of(leg, signal))?;
                (!range.is_free()).then_some((signal, exit))
            })
        })
    }

    /// Whether no signal can have left its range within a step of `length` s, as looks before the step before, at the
    /// start and at the end of the step tell, `ratio` being this step's length over the time between the first
    /// two. Those that may have are put into `watches`.
    #[inline(always)]
    pub(super) fn keep(
        &self,
        registers: Four,
        looks: [&Glance<LEGS>; 3],
        ratio: f64,
        length: f64,
        watches: &mut Watches,
    ) -> bool {
        let mut reach = NOWHERE;
        let is_kept = registers.dispatch(KeepByRates(&self.0, looks, [ratio, length], &mut reach));
        if !is_kept {
            self.watch(&reach, watches);
        }
        is_kept
    }

    /// Puts those signals into `watches` that may have left their ranges within a step, as looks at its start,
    /// middle and end tell.
    #[inline(always)]
    pub(super) fn watch_suspects(
        &self,
        registers: Four,
        looks: [&Glance<LEGS>; 3],
        watches: &mut Watches,
    ) {
        let mut reach = NOWHERE;
        registers.dispatch(Keep(&self.0, looks, &mut reach));
        self.watch(&reach, watches);
    }

    /// Watches those signals that reach beyond their ranges.
    fn watch(&self, reach: &[Quad; QUADS], watches: &mut Watches) {
        watches.clear();
        for (quad, reach) in reach.iter().enumerate() {
            if reach
                .0
                .iter()
                .fold(true, |stays, reach| stays & (*reach < 0.0))
            {
                continue;
            }
            for (lane, reach) in reach.0.iter().enumerate() {
                let signal = quad * LANES + lane;
                let range = self.0.get(signal);
                if (*reach >= 0.0 || reach.is_nan()) && !range.is_free() {
                    watches.push(Watch { signal, range });
                }
            }
        }
    }
}

/// [`Ranges::hold`], compiled for each kind of register.
struct Hold<'a, const LEGS: usize>(&'a Ranges<QUADS>, &'a Glance<LEGS>);

impl<const LEGS: usize> NullaryFnOnce for Hold<'_, LEGS> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Self(ranges, signals) = self;
        ranges.hold(signals.ranged())
    }
}

/// [`Ranges::keep`] over looks at equal distances, compiled for each kind of register.
struct Keep<'a, const LEGS: usize>(
    &'a Ranges<QUADS>,
    [&'a Glance<LEGS>; 3],
    &'a mut [Quad; QUADS],
);

impl<const LEGS: usize> NullaryFnOnce for Keep<'_, LEGS> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Self(ranges, looks, reach) = self;
        ranges.keep(looks.map(Glance::ranged), 1.0, reach)
    }
}

/// [`Ranges::keep_by_rates`], compiled for each kind of register.
struct KeepByRates<'a, const LEGS: usize>(
    &'a Ranges<QUADS>,
    [&'a Glance<LEGS>; 3],
    [f64; 2],
    &'a mut [Quad; QUADS],
);

impl<const LEGS: usize> NullaryFnOnce for KeepByRates<'_, LEGS> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Self(ranges, looks, [ratio, length], reach) = self;
        ranges.keep_by_rates(looks.map(Glance::ranged), ratio, length, RATED, reach)
    }
}
