//! Crushing of footpad sections, body blocks (model chapter 4), edges of footpads and cartridges of struts.
//!
//! An element's pressure profile p(I) is its crushing front. Unloading and reloading run along the elastic line
//! E (I − P), with E the slope of the first segment and P the plastic set. Between events an element is on one straight
//! line of pressure against interference. On soil, the front is that of element and soil in series.

mod on_soil;
mod pressure_line;

use std::sync::Arc;

use crate::crush_load::CrushLoad;
use crate::integrator::event::{Bounds, Exit};
use crate::parts::{Honeycomb, PadEdge};
use crate::profile::{Profile, Segment};

pub(crate) use on_soil::elastic_slope;
pub use pressure_line::PressureLine;

/// Crush law of one kind of element.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushLaw {
    elastic_slope: f64,
    segments: Arc<[Segment]>,
    pressure_threshold: f64,
    /// Part of the interference that is sinkage, segment by segment; empty on rock.
    sinkage: Arc<[Segment]>,
    /// Elastic sinkage per relative pressure, ft.
    compliance: f64,
    /// Relative pressure per squared rate of sinkage, s²/ft².
    drag: f64,
}

/// Elastic interference I − P above which elements count as in contact, ft.
const CONTACT_THRESHOLD: f64 = 1e-6;
/// Slack of interference guards, ft.
const SLACK: f64 = 1e-13;
/// Slack of the guards on rates, ft/s.
const RATE_SLACK: f64 = 1e-11;

impl CrushLaw {
    /// Least I − P at which a footpad section has pressure, ft.
    pub const PAD_PRESSURE_THRESHOLD: f64 = 1e-5;
    /// Least I − P at which a block has pressure, ft.
    pub const BLOCK_PRESSURE_THRESHOLD: f64 = 1e-6;

    /// The law of a profile, with the least I − P (ft) that gives pressure.
    pub fn new(profile: &Profile, pressure_threshold: f64) -> Self {
        Self::of_segments(profile.segments(), pressure_threshold)
    }

    /// The same law with another least I − P (ft) that gives pressure.
    pub fn with_pressure_threshold(self, pressure_threshold: f64) -> Self {
        Self {
            pressure_threshold,
            ..self
        }
    }

    /// The law of an absent element.
    pub fn absent() -> Self {
        Self::of_segments(Vec::new(), 0.0)
    }

    /// The law of a front with an elastic first segment.
    fn of_segments(segments: Vec<Segment>, pressure_threshold: f64) -> Self {
        Self {
            elastic_slope: segments.first().map_or(0.0, |elastic| elastic.slope),
            segments: segments.into(),
            pressure_threshold,
            sinkage: Arc::default(),
            compliance: 0.0,
            drag: 0.0,
        }
    }

    /// The law of a strut's cartridge: load (lb) stands for pressure, stroke for interference.
    pub fn of_cartridge(honeycomb: &Honeycomb) -> Self {
        Self::of_load(&honeycomb.crush_load, honeycomb.unloading_stiffness)
    }

    /// The law of a strut that crushes under this load, and unloads and reloads at a stiffness, lb/ft.
    pub fn of_load(load: &CrushLoad, stiffness: f64) -> Self {
        Self::of_segments(load.front(stiffness), 0.0)
    }

    /// The law of a spring of this stiffness, lb/ft, which never crushes.
    pub fn elastic(stiffness: f64) -> Self {
        let line = Segment {
            offset: 0.0,
            slope: stiffness,
            upper: f64::INFINITY,
        };
        Self::of_segments(vec![line], 0.0)
    }

    /// The elastic line of an element without a set.
    pub fn elastic_line(&self) -> PressureLine<f64> {
        self.line_from(0.0)
    }

    /// The elastic line of an element with this plastic set, ft.
    fn line_from(&self, set: f64) -> PressureLine<f64> {
        PressureLine {
            offset: -self.elastic_slope * set,
            slope: self.elastic_slope,
            drag: 0.0,
        }
    }

    /// A line of the front.
    fn front_line(&self, segment: usize) -> PressureLine<f64> {
        let Segment { offset, slope, .. } = self.segments[segment];
        PressureLine {
            offset,
            slope,
            drag: self.front_drag(segment),
        }
    }

    /// The law of a footpad's edge: load (lb) stands for pressure, depth for interference. The edge reaches its load at
    /// the depth (ft) at which the footpad's profile ceases to be elastic.
    pub fn of_edge(edge: &PadEdge, profile: &Profile) -> Self {
        let elastic = profile.segments()[0].upper;
        let stiffness = edge.load / elastic;
        let crushing = Segment {
            offset: edge.load,
            slope: 0.0,
            upper: f64::INFINITY,
        };
        let front = [
            Segment {
                offset: 0.0,
                slope: stiffness,
                upper: elastic,
            },
            crushing,
        ];
        Self::of_segments(front.to_vec(), 0.0)
    }

    /// Returns whether the element is absent.
    pub fn is_absent(&self) -> bool {
        self.segments.is_empty()
    }

    /// Plastic set that the crushing front leaves at interference I: I − p(I)/E.
    fn front_set(&self, segment: usize, interference: f64) -> f64 {
        let Segment { offset, slope, .. } = self.segments[segment];
        interference - (offset + slope * interference) / self.elastic_slope
    }

    /// Interference at which the elastic line of a plastic set meets the front, and the segment there.
    fn onset_of(&self, set: f64) -> (f64, usize) {
        let slope = self.elastic_slope;
        let meets = |s: &Segment| (slope * set + s.offset) / (slope - s.slope);
        (self.segments.iter().enumerate())
            .filter(|(_, s)| s.slope < slope)
            .map(|(index, s)| (meets(s), index))
            .find(|&(onset, index)| onset <= self.segments[index].upper)
            .unwrap_or((f64::INFINITY, self.segments.len() - 1))
    }

    /// Greatest interference to which an element with this plastic set was crushed, ft.
    pub fn deepest(&self, set: f64) -> f64 {
        if set > 0.0 { self.onset_of(set).0 } else { 0.0 }
    }

    fn segment_at(&self, interference: f64) -> usize {
        let last = self.segments.len() - 1;
        self.segments
            .iter()
            .position(|s| interference < s.upper)
            .unwrap_or(last)
    }

    /// The piece of an element with plastic set `set` (ft) at an interference, for methods that ask anew at every
    /// evaluation. `driven` says whether it may crush further.
    pub fn state_at(&self, set: f64, interference: f64, driven: bool) -> CrushState {
        let elastic = interference - set;
        if self.is_absent() {
            return CrushState {
                line: PressureLine::slack(),
                set,
                in_contact: false,
            };
        }
        if elastic <= self.pressure_threshold {
            return CrushState {
                line: PressureLine::slack(),
                set,
                in_contact: elastic > CONTACT_THRESHOLD,
            };
        }
        let segment = self.segment_at(interference);
        let front_set = self.front_set(segment, interference);
        if driven && front_set >= set {
            return CrushState {
                line: self.front_line(segment),
                set: front_set,
                in_contact: true,
            };
        }
        CrushState {
            line: self.line_from(set),
            set,
            in_contact: true,
        }
    }
}

/// State of an element at one interference.
#[derive(Debug, Clone, Copy)]
pub struct CrushState {
    /// The active line of pressure.
    pub line: PressureLine<f64>,
    /// Plastic set after it, ft.
    pub set: f64,
    /// True if the element is in contact.
    pub in_contact: bool,
}

/// Place of an element on its law.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Stage {
    /// No such element.
    Absent,
    /// Not in contact: I − P ≤ 1e-6 ft.
    Clear,
    /// In contact, not yet pressed.
    Touching,
    /// On the elastic line, short of the front.
    Elastic,
    /// On the elastic line beyond the front: driven deeper while crushing was not allowed.
    Overdriven,
    /// On the crushing front, in this segment of the profile.
    Front(usize),
    /// Taking over from another element, at any depth: its part below the surface counts as crushed.
    TakingOver,
}

/// Crush memory and active stage of one element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crush {
    stage: Stage,
    /// Plastic set P, ft, as of the last time off the front.
    set: f64,
    /// Interference at which the front is met again, ft.
    onset: f64,
    /// Segment of the front met there.
    onset_segment: usize,
}

impl Crush {
    /// An untouched element.
    pub fn untouched(law: &CrushLaw) -> Self {
        if law.is_absent() {
            return Self {
                stage: Stage::Absent,
                set: 0.0,
                onset: 0.0,
                onset_segment: 0,
            };
        }
        // Soil yields from the first pressure on.
        let (onset, onset_segment) = match law.segments[0].slope < law.elastic_slope {
            true => (0.0, 0),
            false => (law.segments[0].upper, 1.min(law.segments.len() - 1)),
        };
        Self {
            stage: Stage::Clear,
            set: 0.0,
            onset,
            onset_segment,
        }
    }

    /// Returns whether the element is in contact: I − P > 1e-6 ft. Where contact is not watched, this is as of the last
    /// [`Self::update_contact`].
    pub fn in_contact(&self) -> bool {
        !matches!(self.stage, Stage::Absent | Stage::Clear | Stage::TakingOver)
    }

    /// Updates contact at an interference, if the element carries no pressure.
    pub fn update_contact(&mut self, interference: f64) {
        if matches!(self.stage, Stage::Clear | Stage::Touching) {
            self.stage = if interference - self.set > CONTACT_THRESHOLD {
                Stage::Touching
            } else {
                Stage::Clear
            };
        }
    }

    /// Returns whether the element carries pressure.
    pub fn is_loaded(&self) -> bool {
        matches!(
            self.stage,
            Stage::Elastic | Stage::Overdriven | Stage::Front(_)
        )
    }

    /// Returns whether the element is on its crushing front.
    pub fn is_on_front(&self) -> bool {
        matches!(self.stage, Stage::Front(_))
    }

    /// Greatest relative pressure on the front between the point where it is met again and a deeper interference
    /// `last`, ft.
    pub fn greatest_front(&self, law: &CrushLaw, last: f64) -> f64 {
        let segments = &law.segments[self.onset_segment.min(law.segments.len() - 1)..];
        let mut from = self.onset.min(last);
        let mut greatest = 0.0_f64;
        for Segment {
            offset,
            slope,
            upper,
        } in segments
        {
            let to = upper.min(last);
            greatest = greatest.max(offset + slope * from).max(offset + slope * to);
            if *upper >= last {
                break;
            }
            from = to;
        }
        greatest
    }

    /// Range of the driving rate over which the stage holds, if it matters. The element leaves the front when it is no
    /// longer driven into the ground, and jumps onto it when it is again.
    pub fn drive_bounds(&self) -> Bounds {
        match self.stage {
            Stage::Front(_) => Bounds::above(0.0).widened(RATE_SLACK),
            Stage::Overdriven => Bounds::below(0.0).widened(RATE_SLACK),
            Stage::Absent | Stage::Clear | Stage::Touching | Stage::Elastic | Stage::TakingOver => {
                Bounds::FREE
            }
        }
    }

    /// The active line of pressure.
    pub fn line(&self, law: &CrushLaw) -> PressureLine<f64> {
        match self.stage {
            Stage::Absent | Stage::Clear | Stage::Touching | Stage::TakingOver => {
                PressureLine::slack()
            }
            Stage::Elastic | Stage::Overdriven => law.line_from(self.set),
            Stage::Front(segment) => law.front_line(segment),
        }
    }

    /// Plastic set at the present interference, ft.
    pub fn set_at(&self, law: &CrushLaw, interference: f64) -> f64 {
        match self.stage {
            Stage::Front(segment) => law.front_set(segment, interference),
            _ => self.set,
        }
    }

    /// Plastic set P, ft, as of the last time off the front.
    pub fn set(&self) -> f64 {
        self.set
    }

    /// Greatest interference to which the element was crushed, ft, given its present one.
    pub fn deepest(&self, interference: f64) -> f64 {
        match self.stage {
            Stage::Front(_) => interference,
            _ if self.set > 0.0 && self.onset.is_finite() => self.onset,
            _ => self.set,
        }
    }

    /// Interferences short of the one at which the front is met.
    pub fn up_to_onset(&self) -> Bounds {
        Bounds::below(self.onset).widened(SLACK)
    }

    /// Range of the interference over which the active line holds and, where contact without pressure is watched, over
    /// which contact does not change.
    pub fn interference_bounds(&self, law: &CrushLaw, is_contact_watched: bool) -> Bounds {
        match self.stage {
            Stage::Absent => Bounds::FREE,
            Stage::Clear | Stage::Touching if !is_contact_watched => {
                Bounds::below(self.set + law.pressure_threshold)
            }
            Stage::Clear => Bounds::below(self.set + CONTACT_THRESHOLD.min(law.pressure_threshold)),
            Stage::Touching => Bounds::between(
                self.set + CONTACT_THRESHOLD,
                self.set + law.pressure_threshold,
            ),
            Stage::Elastic => Bounds::between(self.set + law.pressure_threshold, self.onset),
            Stage::Overdriven => Bounds::above(self.onset),
            Stage::Front(segment) => Bounds::below(law.segments[segment].upper),
            // At once, at any interference.
            Stage::TakingOver => Bounds::below(f64::NEG_INFINITY),
        }
        .widened(SLACK)
    }

    /// Range of the interference rate over which the active line holds: the front is left where the element stops going
    /// deeper.
    pub fn rate_bounds(&self) -> Bounds {
        match self.stage {
            Stage::Front(_) => Bounds::above(0.0).widened(RATE_SLACK),
            _ => Bounds::FREE,
        }
    }

    /// Takes over from another element, unloaded: it is not loaded all at once, nor does it give back the other's
    /// crush.
    pub fn take_over(&mut self) {
        if self.stage != Stage::Absent {
            self.stage = Stage::TakingOver;
        }
    }

    /// Handles an interference that left its range. `driven` says whether the element may crush further.
    pub fn cross_interference(
        &mut self,
        law: &CrushLaw,
        exit: Exit,
        interference: f64,
        driven: bool,
    ) {
        let touching_is_empty = law.pressure_threshold <= CONTACT_THRESHOLD;
        self.stage = match (self.stage, exit) {
            (Stage::Absent, _) => Stage::Absent,
            (Stage::Clear, _) if interference - self.set > law.pressure_threshold => Stage::Elastic,
            (Stage::Clear, _) => Stage::Touching,
            (Stage::Touching, Exit::Above) => Stage::Elastic,
            (Stage::Touching, Exit::Below) => Stage::Clear,
            (Stage::Elastic, Exit::Above) if !driven => Stage::Overdriven,
            (Stage::Elastic, Exit::Above)
                if interference < law.segments[self.onset_segment].upper =>
            {
                Stage::Front(self.onset_segment)
            }
            (Stage::Elastic, Exit::Above) => Stage::Front(law.segment_at(interference)),
            (Stage::Elastic, Exit::Below) if touching_is_empty => Stage::Clear,
            (Stage::Elastic, Exit::Below) => Stage::Touching,
            (Stage::Overdriven, _) => Stage::Elastic,
            (Stage::Front(segment), _) => Stage::Front((segment + 1).min(law.segments.len() - 1)),
            (Stage::TakingOver, _) => {
                self.set = self.set.max(interference);
                (self.onset, self.onset_segment) = law.onset_of(self.set);
                Stage::Clear
            }
        };
    }

    /// Leaves the front for the elastic line, keeping the set reached.
    pub fn leave_front(&mut self, law: &CrushLaw, interference: f64) {
        if let Stage::Front(segment) = self.stage {
            self.set = law.front_set(segment, interference).max(self.set);
            self.onset = interference;
            self.onset_segment = segment;
            self.stage = Stage::Elastic;
        }
    }

    /// Handles a change of sign of the rate that allows crushing (listing rule). Allowed again, an element that was
    /// driven past its front jumps onto it: its set grows at once.
    pub fn drive(&mut self, law: &CrushLaw, driven: bool, interference: f64) {
        match self.stage {
            Stage::Front(_) if !driven => self.leave_front(law, interference),
            Stage::Overdriven if driven => {
                self.stage = Stage::Front(law.segment_at(interference));
            }
            _ => {}
        }
    }
}
