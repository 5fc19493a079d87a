//! The laws of a leg of three struts: a footpad on a ball joint, and struts that crush both ways.
//!
//! As everywhere, a mode yields the coefficients of the active pieces and the ranges of signals over which they hold.

use std::ops::Range;

use crate::crush::{Crush, CrushLaw, PressureLine};
use crate::friction::{FrictionLaw, FrictionPiece, Sliding};
use crate::integrator::event::{Bounds, Exit};
use crate::lanes::per_lane;
use crate::outcome::Outcome;
use crate::scalar::Real;
use crate::soil::Soil;
use crate::three_struts::{LegStrut, ThreeStrutDesign};

/// Number of struts of a leg.
pub const STRUTS: usize = 3;

/// Index of the pad's interference I (ft) among the signals of a leg; of dI/dt (ft/s); of the squared sliding speed S²
/// (ft²/s²); of the strokes of the struts (ft, shorter is positive) and of their rates (ft/s).
pub const INTERFERENCE: usize = 0;
pub const INTERFERENCE_RATE: usize = 1;
pub const SLIDING: usize = 2;
pub const STROKES: Range<usize> = 3..6;
pub const STROKE_RATES: Range<usize> = 6..9;
/// Index of the load of the primary strut, lb: for the record, without a range.
pub const LOAD: usize = 9;
/// Number of signals of a leg.
pub const SIGNALS: usize = 10;

/// The signals of one leg.
pub type LegSignals<S> = [S; SIGNALS];

/// The laws of one leg. A clone shares its tables.
#[derive(Debug, Clone, PartialEq)]
pub struct LegLaws {
    pad: CrushLaw,
    /// Interference at which the pad is crushed by its whole height, ft.
    pad_height: f64,
    friction: FrictionLaw,
    struts: [TwoWayLaw; STRUTS],
}

/// The law of a strut: how it crushes in compression and in tension.
#[derive(Debug, Clone, PartialEq)]
struct TwoWayLaw {
    compression: CrushLaw,
    tension: CrushLaw,
    /// Strokes at which the strut bottoms and at which it is drawn out, ft.
    limits: [f64; 2],
}

/// The mode of one leg.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegMode {
    pad: Crush,
    sliding: Sliding,
    struts: [TwoWay; STRUTS],
}

/// The mode of a strut.
#[derive(Debug, Clone, Copy, PartialEq)]
struct TwoWay {
    compression: Crush,
    tension: Crush,
}

/// Coefficients of the active pieces of one leg.
#[derive(Debug, Clone, Copy)]
pub struct LegPieces<S> {
    /// Relative pressure on the footpad against interference.
    pub pad: PressureLine<S>,
    /// Friction under it.
    pub friction: FrictionPiece<S>,
    /// The struts.
    pub struts: [StrutLine<S>; STRUTS],
}

/// Load of a strut against its stroke.
#[derive(Debug, Clone, Copy)]
pub struct StrutLine<S> {
    compression: PressureLine<S>,
    tension: PressureLine<S>,
}

per_lane!(
    LegPieces { pad, friction, struts }
    StrutLine { compression, tension }
);

impl<S: Real> StrutLine<S> {
    /// Load at a stroke (ft), lb; compression is positive.
    #[inline(always)]
    pub fn at(&self, stroke: S) -> S {
        self.compression.at(stroke) - self.tension.at(-stroke)
    }

    /// Change of the load with the stroke, lb/ft.
    #[inline(always)]
    pub fn slope(&self) -> S {
        self.compression.slope() + self.tension.slope()
    }
}

impl TwoWayLaw {
    fn of(strut: &LegStrut) -> Self {
        let stiffness = strut.stiffness;
        let law = |load: &Option<_>| match load {
            Some(load) => CrushLaw::of_load(load, stiffness),
            None => CrushLaw::elastic(stiffness),
        };
        Self {
            compression: law(&strut.compression_load),
            tension: law(&strut.tension_load),
            limits: [strut.compression_stroke, strut.tension_stroke],
        }
    }
}

impl TwoWay {
    /// Returns whether neither side has crushed yet: the strut is then one spring both ways.
    fn is_new(&self) -> bool {
        let is_new = |side: &Crush| side.set() == 0.0 && !side.is_on_front();
        is_new(&self.compression) && is_new(&self.tension)
    }

    fn line(&self, law: &TwoWayLaw) -> StrutLine<f64> {
        if self.is_new() {
            return StrutLine {
                compression: law.compression.elastic_line(),
                tension: PressureLine::slack(),
            };
        }
        StrutLine {
            compression: self.compression.line(&law.compression),
            tension: self.tension.line(&law.tension),
        }
    }

    fn stroke_bounds(&self, law: &TwoWayLaw) -> Bounds {
        let [shortest, longest] = law.limits;
        let [compression, tension] = if self.is_new() {
            [&self.compression, &self.tension].map(Crush::up_to_onset)
        } else {
            [
                self.compression
                    .interference_bounds(&law.compression, false),
                self.tension.interference_bounds(&law.tension, false),
            ]
        };
        compression
            .meet(mirrored(tension))
            .meet(Bounds::between(-longest, shortest))
    }

    fn rate_bounds(&self) -> Bounds {
        (self.compression.rate_bounds()).meet(mirrored(self.tension.rate_bounds()))
    }

    fn cross_stroke(&mut self, law: &TwoWayLaw, stroke: f64) {
        let is_new = self.is_new();
        let left = |side: &Crush, law: &CrushLaw, stroke: f64| match is_new {
            true => side.up_to_onset().exit(stroke),
            false => side.interference_bounds(law, false).exit(stroke),
        };
        if let Some(exit) = left(&self.compression, &law.compression, stroke) {
            (self.compression).cross_interference(&law.compression, exit, stroke, true);
        }
        if let Some(exit) = left(&self.tension, &law.tension, -stroke) {
            (self.tension).cross_interference(&law.tension, exit, -stroke, true);
        }
    }

    fn cross_rate(&mut self, law: &TwoWayLaw, stroke: f64, rate: f64) {
        if rate < 0.0 {
            self.compression.leave_front(&law.compression, stroke);
        } else {
            self.tension.leave_front(&law.tension, -stroke);
        }
    }

    /// Returns whether the strut gives way to this load (lb) in the end: it crushes beyond its limit.
    fn gives_way(&self, law: &TwoWayLaw, load: f64) -> bool {
        let [shortest, longest] = law.limits;
        let (side, law, last) = match load >= 0.0 {
            true => (&self.compression, &law.compression, shortest),
            false => (&self.tension, &law.tension, longest),
        };
        load.abs() >= side.greatest_front(law, last)
    }
}

/// The range of the negative of a quantity.
fn mirrored(range: Bounds) -> Bounds {
    Bounds::between(-range.upper, -range.lower)
}

impl LegLaws {
    /// The laws of a leg of this design on this soil.
    pub fn of(design: &ThreeStrutDesign, soil: &Soil, friction: FrictionLaw) -> Self {
        let footpad = &design.footpad;
        let pad = CrushLaw::new(&footpad.profile, 0.0);
        let pad = match soil {
            Soil::Rock => pad,
            Soil::Yielding(bearing) => pad.on_soil(bearing, footpad.crush_pressure),
        };
        Self {
            pad_height: pad.interference_at_crush(footpad.height),
            pad,
            friction,
            struts: design.struts().map(TwoWayLaw::of),
        }
    }

    /// Greatest of the strokes of a strut as a share of the one at which it bottoms, or is drawn out.
    pub fn stroke_share(&self, strut: usize, stroke: f64) -> f64 {
        let [shortest, longest] = self.struts[strut].limits;
        (stroke / shortest).max(-stroke / longest)
    }

    /// Friction of the footpad.
    pub fn friction(&self) -> &FrictionLaw {
        &self.friction
    }
}

impl LegMode {
    /// A leg before its first contact.
    pub fn untouched(laws: &LegLaws) -> Self {
        Self {
            pad: Crush::untouched(&laws.pad),
            sliding: Sliding::Steady,
            struts: std::array::from_fn(|k| TwoWay {
                compression: Crush::untouched(&laws.struts[k].compression),
                tension: Crush::untouched(&laws.struts[k].tension),
            }),
        }
    }

    /// Returns whether the footpad is on the ground.
    pub fn in_contact(&self) -> bool {
        self.pad.in_contact()
    }

    /// Returns whether the ground pushes on the footpad.
    pub fn is_pressed(&self) -> bool {
        self.pad.is_loaded()
    }

    /// Coefficients of the active pieces.
    pub fn pieces(&self, laws: &LegLaws) -> LegPieces<f64> {
        LegPieces {
            pad: self.pad.line(&laws.pad),
            friction: self.sliding.piece(&laws.friction),
            struts: std::array::from_fn(|k| self.struts[k].line(&laws.struts[k])),
        }
    }

    /// Ranges of the signals over which the active pieces hold.
    pub fn ranges(&self, laws: &LegLaws) -> [Bounds; SIGNALS] {
        let mut ranges = [Bounds::FREE; SIGNALS];
        ranges[INTERFERENCE] = self.pad.interference_bounds(&laws.pad, false);
        if self.pad.is_loaded() {
            ranges[INTERFERENCE] = ranges[INTERFERENCE].meet(Bounds::below(laws.pad_height));
            ranges[SLIDING] = self.sliding.bounds(&laws.friction);
        }
        ranges[INTERFERENCE_RATE] = self.pad.rate_bounds();
        for (k, (strut, law)) in self.struts.iter().zip(&laws.struts).enumerate() {
            ranges[STROKES.start + k] = strut.stroke_bounds(law);
            ranges[STROKE_RATES.start + k] = strut.rate_bounds();
        }
        ranges
    }

    /// Sets the next piece after `signal` left its range. `leg` is this leg's index.
    ///
    /// # Errors
    /// The outcome, when the event ends the landing.
    pub fn cross(
        &mut self,
        laws: &LegLaws,
        leg: usize,
        signal: usize,
        exit: Exit,
        signals: &LegSignals<f64>,
    ) -> Result<(), Outcome> {
        let was_loaded = self.pad.is_loaded();
        let value = signals[signal];
        match signal {
            INTERFERENCE if was_loaded && value >= laws.pad_height => {
                return Err(Outcome::BottomedPad { leg });
            }
            INTERFERENCE => self.pad.cross_interference(&laws.pad, exit, value, true),
            INTERFERENCE_RATE => self.pad.leave_front(&laws.pad, signals[INTERFERENCE]),
            SLIDING => self.sliding = self.sliding.neighbour(exit == Exit::Above),
            _ if STROKES.contains(&signal) => {
                let k = signal - STROKES.start;
                if laws.stroke_share(k, value) >= 1.0 {
                    return Err(Outcome::Bottomed { leg });
                }
                self.struts[k].cross_stroke(&laws.struts[k], value);
            }
            _ => {
                // The load has no range.
                let k = signal - STROKE_RATES.start;
                let stroke = signals[STROKES.start + k];
                self.struts[k].cross_rate(&laws.struts[k], stroke, value);
            }
        }
        if !was_loaded && self.pad.is_loaded() {
            self.sliding = Sliding::at(&laws.friction, signals[SLIDING]);
        }
        Ok(())
    }

    /// Gap between the footpad and its ground, along the ground's normal, ft.
    pub fn pad_gap(&self, laws: &LegLaws, signals: &LegSignals<f64>) -> f64 {
        let interference = signals[INTERFERENCE];
        (self.pad.set_at(&laws.pad, interference) - interference).max(0.0)
    }

    /// Plastic set of the footpad, ft, without that of soil, and its greatest sinkage if it stands on soil.
    pub fn pad_set(&self, laws: &LegLaws, signals: &LegSignals<f64>) -> (f64, Option<f64>) {
        let set = self.pad.set_at(&laws.pad, signals[INTERFERENCE]);
        let sinkage = || laws.pad.sinkage_at(laws.pad.deepest(set));
        (laws.pad.own_set(set), laws.pad.is_on_soil().then(sinkage))
    }

    /// Greatest crush of the footpad, that crush with its joint on the ground, and its greatest sinkage, ft.
    pub fn pad_depths(&self, laws: &LegLaws, signals: &LegSignals<f64>) -> [f64; 3] {
        let deepest = self.pad.deepest(signals[INTERFERENCE]);
        let sinkage = laws.pad.sinkage_at(deepest);
        let height = laws.pad_height - laws.pad.sinkage_at(laws.pad_height);
        [deepest - sinkage, height, sinkage]
    }

    /// Returns whether the footpad is crushed faster than `limit`, ft/s.
    pub fn pad_crushes(&self, limit: f64, signals: &LegSignals<f64>) -> bool {
        self.pad.is_on_front() && signals[INTERFERENCE_RATE] > limit
    }

    /// Returns whether the struts bear these loads (lb): none crushes faster than `limit` (ft/s) under less than its
    /// load, and none crushes beyond its limit.
    pub fn struts_bear(
        &self,
        laws: &LegLaws,
        loads: &[f64; STRUTS],
        present: &[f64; STRUTS],
        limit: f64,
        signals: &LegSignals<f64>,
    ) -> bool {
        (0..STRUTS).all(|k| {
            let (strut, law) = (&self.struts[k], &laws.struts[k]);
            let crushes = strut.compression.is_on_front() || strut.tension.is_on_front();
            let is_fast = signals[STROKE_RATES.start + k].abs() > limit;
            let falls_short = crushes && is_fast && present[k].abs() < loads[k].abs();
            !falls_short && !strut.gives_way(law, loads[k])
        })
    }
}
