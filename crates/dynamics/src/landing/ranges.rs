//! The ranges in which the legs' signals have to stay for the active pieces to hold.

use arrayvec::ArrayVec;
use num_traits::Zero;

use crate::integrator::event::{Bounds, Exit, Watch};
use crate::integrator::ranges::{LANES, Quad, Ranges};
use crate::motion::{Glance, Signal};
use crate::per_leg::{MOST_LEGS, PerLeg};

/// Quads of a leg's signals that have ranges.
const QUADS: usize = Glance::RANGED_QUADS;

/// Signals to be watched, as many as there can be.
pub(super) type Watches = ArrayVec<Watch, { QUADS * LANES * MOST_LEGS }>;

/// How far beyond their ranges signals get.
type Reach = PerLeg<[Quad; QUADS]>;

/// Ranges of all legs' signals.
#[derive(Debug, Clone)]
pub(super) struct SignalRanges(PerLeg<Ranges<QUADS>>);

impl SignalRanges {
    /// The ranges of all legs, signal by signal.
    pub(super) fn new(legs: &[[Bounds; Signal::RANGED]]) -> Self {
        let mut ranges = Self(PerLeg::same(legs.len(), Ranges::free()));
        for (leg, bounds) in legs.iter().enumerate() {
            ranges.set(leg, bounds);
        }
        ranges
    }

    /// Sets the ranges of leg `leg`, signal by signal.
    pub(super) fn set(&mut self, leg: usize, ranges: &[Bounds; Signal::RANGED]) {
        for (&range, signal) in ranges.iter().zip(Signal::ALL) {
            self.0[leg].set(signal as usize, range);
        }
    }

    fn get(&self, leg: usize, signal: Signal) -> Bounds {
        self.0[leg].get(signal as usize)
    }

    /// Whether a signal of any leg has a range to stay in.
    pub(super) fn has(&self, signal: Signal) -> bool {
        (0..self.0.len()).any(|leg| !self.get(leg, signal).is_free())
    }

    /// The first signal of each leg that has left its range, and on which side.
    pub(super) fn exits(&self, signals: &Glance<f64>) -> PerLeg<Option<(Signal, Exit)>> {
        PerLeg::from_fn(self.0.len(), |leg| {
            if self.0[leg].hold(signals.ranged(leg)) {
                return None;
            }
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
        looks: [&Glance<f64>; 3],
        ratio: f64,
        length: f64,
        watches: &mut Watches,
    ) -> bool {
        let mut reach = self.nowhere();
        let mut is_kept = true;
        for (leg, ranges) in self.0.iter().enumerate() {
            let looks = looks.map(|signals| signals.ranged(leg));
            let rated = Glance::RATED_QUADS;
            is_kept &= ranges.keep_by_rates(looks, ratio, length, rated, &mut reach[leg]);
        }
        if !is_kept {
            self.watch(&reach, watches);
        }
        is_kept
    }

    /// Puts those signals into `watches` that may have left their ranges within a step, as looks at its start,
    /// middle and end tell.
    #[inline(always)]
    pub(super) fn watch_suspects(&self, looks: [&Glance<f64>; 3], watches: &mut Watches) {
        let mut reach = self.nowhere();
        for (leg, ranges) in self.0.iter().enumerate() {
            let looks = looks.map(|signals| signals.ranged(leg));
            ranges.keep(looks, 1.0, &mut reach[leg]);
        }
        self.watch(&reach, watches);
    }

    /// What nothing is known of yet.
    fn nowhere(&self) -> Reach {
        PerLeg::same(self.0.len(), [Quad::zero(); QUADS])
    }

    /// Watches those signals that reach beyond their ranges.
    fn watch(&self, reach: &Reach, watches: &mut Watches) {
        watches.clear();
        for (leg, (ranges, reach)) in self.0.iter().zip(reach).enumerate() {
            for (quad, reach) in reach.iter().enumerate() {
                if (reach.0.iter()).fold(true, |stays, reach| stays & (*reach < 0.0)) {
                    continue;
                }
                for (lane, reach) in reach.0.iter().enumerate() {
                    let signal = quad * LANES + lane;
                    let range = ranges.get(signal);
                    if (*reach >= 0.0 || reach.is_nan()) && !range.is_free() {
                        let signal = leg * Signal::COUNT + signal;
                        watches.push(Watch { signal, range });
                    }
                }
            }
        }
    }
}
