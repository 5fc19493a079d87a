//! Elements on soil: crush and sinkage act in series (docs/model.md, "Soil").
//!
//! Both carry the same pressure, so that the interference is the sum of crush and sinkage at that pressure. The sum has a
//! front and an elastic line as an element alone has, and the same events.

use super::CrushLaw;
use crate::profile::Segment;
use crate::soil::{Bearing, Soil};

/// Slope of the elastic line of an element of crush pressure C (lb/ft²) on soil, given that `slope` (1/ft) on rock.
pub(crate) fn elastic_slope(slope: f64, soil: &Soil, crush_pressure: f64) -> f64 {
    match soil {
        Soil::Rock => slope,
        Soil::Yielding(bearing) => series(slope, bearing.unloading_slope() / crush_pressure),
    }
}

/// Slope of two springs in series.
fn series(one: f64, other: f64) -> f64 {
    one * other / (one + other)
}

impl CrushLaw {
    /// The law of this element of crush pressure C (lb/ft²) on yielding soil.
    pub fn on_soil(self, bearing: &Bearing, crush_pressure: f64) -> Self {
        if self.is_absent() {
            return self;
        }
        // Relative pressure against sinkage.
        let soil: Vec<Segment> = (bearing.sinking().into_iter())
            .map(|line| Segment {
                offset: line.offset / crush_pressure,
                slope: line.slope / crush_pressure,
                ..line
            })
            .collect();
        let (mut front, mut sinkage) = (Vec::new(), Vec::new());
        let (mut crush, mut interference, mut yielding) = (0.0, 0.0, 0);
        for line in self.segments.iter() {
            while crush < line.upper {
                let beneath = soil[yielding];
                // Parts of the way: all of it is crush where the element crushes under constant pressure.
                let both = line.slope + beneath.slope;
                let (sinking, crushing) = (line.slope / both, beneath.slope / both);
                let slope = line.slope * crushing;
                let pressure = line.offset + line.slope * crush;
                let greatest = beneath.offset + beneath.slope * beneath.upper;
                let next = crush + (greatest - pressure).max(0.0) / line.slope;
                let is_next = line.slope > 0.0 && next < line.upper;
                let end = if is_next { next } else { line.upper };
                if end > crush {
                    let upper = interference + (end - crush) / crushing;
                    front.push(Segment {
                        offset: pressure - slope * interference,
                        slope,
                        upper,
                    });
                    sinkage.push(Segment {
                        offset: interference - crush - sinking * interference,
                        slope: sinking,
                        upper,
                    });
                    (crush, interference) = (end, upper);
                }
                yielding += usize::from(is_next);
            }
        }
        let unloading = bearing.unloading_slope() / crush_pressure;
        Self {
            elastic_slope: series(self.elastic_slope, unloading),
            segments: front.into(),
            sinkage: sinkage.into(),
            compliance: 1.0 / unloading,
            drag: bearing.inertial_drag() / crush_pressure,
            ..self
        }
    }

    /// Returns whether the element stands on soil.
    pub fn is_on_soil(&self) -> bool {
        !self.sinkage.is_empty()
    }

    /// Relative pressure per squared rate of the interference on a line of the front, s²/ft²: the soil sinks at its part of
    /// the rate.
    pub(super) fn front_drag(&self, segment: usize) -> f64 {
        let sinking = self.sinkage.get(segment).map_or(0.0, |line| line.slope);
        self.drag * sinking * sinking
    }

    /// Part of a set P (ft) that is the element's own.
    pub fn own_set(&self, set: f64) -> f64 {
        if !self.is_on_soil() {
            return set;
        }
        let deepest = self.deepest(set);
        let pressure = self.elastic_slope * (deepest - set);
        (set - self.sinkage_at(deepest) + self.compliance * pressure).max(0.0)
    }

    /// Part of the interference `deepest` (ft) on the front that is sinkage, ft.
    pub fn sinkage_at(&self, deepest: f64) -> f64 {
        let line = self.sinkage.iter().find(|line| deepest <= line.upper);
        line.map_or(0.0, |line| line.offset + line.slope * deepest)
    }

    /// Interference on the front at which the element is crushed by `crush`, ft.
    pub fn interference_at_crush(&self, crush: f64) -> f64 {
        let reaches = |line: &Segment| (crush + line.offset) / (1.0 - line.slope);
        let found = self.sinkage.iter().map(|line| (reaches(line), line.upper));
        let mut fitting = found.filter(|(interference, upper)| interference <= upper);
        fitting
            .next()
            .map_or(crush, |(interference, _)| interference)
    }
}
