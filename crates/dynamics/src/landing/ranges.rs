//! The ranges in which the legs' signals have to stay for the active pieces to hold.

use num_traits::Zero;
use pulp::{Arch, NullaryFnOnce};

use crate::integrator::event::{Bounds, Exit, Watch};
use crate::motion::{Glance, Signal};
use crate::quad::{GROUPS, LANES, MOST_LEGS, Quad};
use crate::scalar::Real;

/// A number for each signal with a range, laid out as the signals are.
type Rows = [[f64; MOST_LEGS]; Signal::RANGED];
/// The same in quads.
type Reach = [Quad; Signal::RANGED * GROUPS];
const NOWHERE: Reach = [Quad([0.0; LANES]); Signal::RANGED * GROUPS];

/// Ranges of all legs' signals.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(super) struct Ranges<const LEGS: usize> {
    lower: Rows,
    upper: Rows,
}

impl<const LEGS: usize> Ranges<LEGS> {
    /// The ranges of all legs, signal by signal.
    pub(super) fn new(legs: &[[Bounds; Signal::RANGED]; LEGS]) -> Self {
        let mut ranges = Self {
            lower: [[Bounds::FREE.lower; MOST_LEGS]; Signal::RANGED],
            upper: [[Bounds::FREE.upper; MOST_LEGS]; Signal::RANGED],
        };
        for (leg, bounds) in legs.iter().enumerate() {
            ranges.set(leg, bounds);
        }
        ranges
    }

    /// Sets the ranges of leg `leg`, signal by signal.
    pub(super) fn set(&mut self, leg: usize, ranges: &[Bounds; Signal::RANGED]) {
        for (row, range) in ranges.iter().enumerate() {
            self.lower[row][leg] = range.lower;
            self.upper[row][leg] = range.upper;
        }
    }

    fn get(&self, signal: Signal, leg: usize) -> Bounds {
        Bounds {
            lower: self.lower[signal as usize][leg],
            upper: self.upper[signal as usize][leg],
        }
    }

    /// Whether a signal of any leg has a range to stay in.
    pub(super) fn has(&self, signal: Signal) -> bool {
        (0..LEGS).any(|leg| !self.get(signal, leg).is_free())
    }

    /// The first signal of each leg that has left its range, and on which side.
    pub(super) fn exits(
        &self,
        arch: Arch,
        signals: &Glance<LEGS>,
    ) -> [Option<(Signal, Exit)>; LEGS] {
        if arch.dispatch(Inside(self, signals)) {
            return [None; LEGS];
        }
        std::array::from_fn(|leg| {
            Signal::ALL[..Signal::RANGED].iter().find_map(|&signal| {
                let exit = (self.get(signal, leg)).exit(signals.of(leg, signal))?;
                Some((signal, exit))
            })
        })
    }

    /// Whether no signal can have left its range within a step, as looks before the step before, at the start and at
    /// the end of the step tell, `ratio` being this step's length over that one's.
    #[inline(always)]
    pub(super) fn are_quiet(&self, arch: Arch, looks: [&Glance<LEGS>; 3], ratio: f64) -> bool {
        arch.dispatch(Quiet {
            ranges: self,
            looks,
            ratio,
            reach: &mut NOWHERE.clone(),
        })
    }

    /// Puts those signals into `watches` that may have left their ranges within a step, as looks at its start,
    /// middle and end tell.
    #[inline(always)]
    pub(super) fn watch_suspects(
        &self,
        arch: Arch,
        looks: [&Glance<LEGS>; 3],
        watches: &mut Vec<Watch>,
    ) {
        watches.clear();
        let mut reach = NOWHERE;
        let quiet = Quiet {
            ranges: self,
            looks,
            ratio: 1.0,
            reach: &mut reach,
        };
        if arch.dispatch(quiet) {
            return;
        }
        for leg in 0..LEGS {
            for &signal in &Signal::ALL[..Signal::RANGED] {
                let range = self.get(signal, leg);
                let reach = reach[signal as usize * GROUPS + leg / LANES].0[leg % LANES];
                if !(reach < 0.0) && !range.is_free() {
                    watches.push(Watch {
                        signal: Glance::<LEGS>::index(leg, signal),
                        range,
                    });
                }
            }
        }
    }
}

/// Whether no signal can have left its range within a step; and the room that each has, less how far it can stray.
struct Quiet<'a, const LEGS: usize> {
    ranges: &'a Ranges<LEGS>,
    /// Before the step before, at the start and at the end of the step.
    looks: [&'a Glance<LEGS>; 3],
    /// The step's length over that of the one before.
    ratio: f64,
    reach: &'a mut Reach,
}

impl<const LEGS: usize> NullaryFnOnce for Quiet<'_, LEGS> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Self {
            ranges,
            looks,
            ratio,
            reach,
        } = self;
        let [before, start, end] = looks.map(|look| quads(&look.rows()[..Signal::RANGED]));
        let (lower, upper) = (quads(&ranges.lower), quads(&ranges.upper));
        let ratio = Quad::constant(ratio);
        let mut farthest = Quad::constant(f64::NEG_INFINITY);
        // A maximum drops what is not a number, a sum keeps it.
        let mut sum = Quad::zero();
        let looks = before.zip(start).zip(end);
        for (((((before, start), end), lower), upper), reach) in
            looks.zip(lower).zip(upper).zip(reach)
        {
            let stray = (end - start).abs() + ratio * (start - before).abs();
            let below = greater(lower - start, lower - end);
            let above = greater(start - upper, end - upper);
            *reach = greater(below, above) + stray;
            farthest = greater(farthest, *reach);
            sum += *reach;
        }
        farthest.0.iter().all(|reach| *reach < 0.0) && sum.0.iter().all(|sum| !sum.is_nan())
    }
}

/// Whether every signal is in its range.
struct Inside<'a, const LEGS: usize>(&'a Ranges<LEGS>, &'a Glance<LEGS>);

impl<const LEGS: usize> NullaryFnOnce for Inside<'_, LEGS> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let Self(ranges, signals) = self;
        let signals = quads(&signals.rows()[..Signal::RANGED]);
        let ranges = quads(&ranges.lower).zip(quads(&ranges.upper));
        let mut farthest = Quad::constant(f64::NEG_INFINITY);
        let mut sum = Quad::zero();
        for (signal, (lower, upper)) in signals.zip(ranges) {
            let beyond = greater(lower - signal, signal - upper);
            farthest = greater(farthest, beyond);
            sum += beyond;
        }
        farthest.0.iter().all(|beyond| *beyond <= 0.0) && sum.0.iter().all(|sum| !sum.is_nan())
    }
}

/// Four numbers at a time.
#[inline(always)]
fn quads(rows: &[[f64; MOST_LEGS]]) -> impl Iterator<Item = Quad> {
    let (quads, _) = rows.as_flattened().as_chunks();
    quads.iter().map(|&four| Quad(four))
}

#[inline(always)]
fn greater(a: Quad, b: Quad) -> Quad {
    Quad(std::array::from_fn(|i| if a.0[i] > b.0[i] { a.0[i] } else { b.0[i] }))
}
