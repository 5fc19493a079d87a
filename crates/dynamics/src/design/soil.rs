//! Soil under footpads and blocks: how it bears.

use libm::pow;

use crate::invalid::{Invalid, require};
use crate::profile::{Segment, lines};
use crate::quantities::{
    BEARING_DEPTH, BEARING_EXPONENT, BEARING_STRENGTH, INERTIAL_DRAG, REBOUND,
};

/// Material of the ground.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Soil {
    /// It does not yield.
    #[default]
    Rock,
    /// It yields under pressure.
    Yielding(Bearing),
}

/// Bearing of a plate by soil: the pressure σ = σ₀ (z/z₀)ⁿ (lb/ft²; Bekker's law) at a growing sinkage z (ft), a straight line
/// back, and a set that stays; and a pressure α ż² against sinking at a rate ż (docs/model.md, "Soil").
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    strength: f64,
    depth: f64,
    exponent: f64,
    rebound: f64,
    inertial_drag: f64,
}

impl Soil {
    /// Returns the same material, its bearing strength times a factor.
    pub fn strengthened(self, factor: f64) -> Self {
        match self {
            Self::Rock => Self::Rock,
            Self::Yielding(bearing) => Self::Yielding(Bearing {
                strength: bearing.strength * factor,
                ..bearing
            }),
        }
    }
}

/// Table of these numbers in input files.
const TABLE: &str = "soil";

/// Sinkages of the table's knots, over z₀, where the law is no straight line.
const KNOTS: [f64; 7] = [0.0, 0.0625, 0.25, 0.5, 1.0, 1.5, 2.0];

impl Bearing {
    /// Soil in which a plate sinks by `depth` z₀ (ft) under the pressure `strength` σ₀ (lb/ft²). The pressure grows with the
    /// `exponent` n of the sinkage. Unloaded from σ₀, the plate rises by the part `rebound` of z₀.
    ///
    /// # Errors
    /// Names the first number outside its range, in the words of the sweep file.
    pub fn new(strength: f64, depth: f64, exponent: f64, rebound: f64) -> Result<Self, Invalid> {
        BEARING_STRENGTH.check(TABLE, strength)?;
        BEARING_DEPTH.check(TABLE, depth)?;
        BEARING_EXPONENT.check(TABLE, exponent)?;
        REBOUND.check(TABLE, rebound)?;
        let bearing = Self {
            strength,
            depth,
            exponent,
            rebound,
            inertial_drag: 0.0,
        };
        let slopes = bearing.sinking().into_iter().map(|line| line.slope);
        let steepest = slopes.fold(0.0_f64, f64::max);
        // Otherwise sinking would heal.
        let most = strength / depth / steepest;
        require(
            &format!("{TABLE}.{}", REBOUND.key),
            rebound,
            &format!("0 < value ≤ {most:.4}: unloading is steeper than sinking everywhere"),
            |rebound| rebound <= most * (1.0 + 1e-9),
        )?;
        Ok(bearing)
    }

    /// Pressure (lb/ft²) against sinkage (ft) of a plate that sinks: straight lines between knots of the law, which they
    /// leave by 6 % of σ₀ at most, and straight on beyond 2 z₀.
    pub fn sinking(&self) -> Vec<Segment> {
        let parts: &[f64] = match self.exponent == 1.0 {
            true => &[0.0, 1.0],
            false => &KNOTS,
        };
        let knot = |part: &f64| {
            let pressure = self.strength * pow(*part, self.exponent);
            [self.depth * part, pressure]
        };
        let knots: Vec<[f64; 2]> = parts.iter().map(knot).collect();
        lines(&knots)
    }

    /// Gives the soil an inertial drag α, slug/ft³: what a plate that sinks at a rate ż pushes aside resists with α ż².
    ///
    /// # Errors
    /// If α is outside its range.
    pub fn with_inertial_drag(self, inertial_drag: f64) -> Result<Self, Invalid> {
        INERTIAL_DRAG.check(TABLE, inertial_drag)?;
        Ok(Self {
            inertial_drag,
            ..self
        })
    }

    /// Inertial drag α, slug/ft³.
    pub fn inertial_drag(&self) -> f64 {
        self.inertial_drag
    }

    /// Slope of unloading and reloading, lb/ft³.
    pub fn unloading_slope(&self) -> f64 {
        self.strength / (self.rebound * self.depth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plate_sinks_by_the_power_law() {
        for exponent in [0.5, 0.8, 1.0, 1.3, 2.0] {
            let lines = Bearing::new(800.0, 0.15, exponent, 0.01).unwrap().sinking();
            let off = (1..400).map(|step| {
                let part = 0.005 * f64::from(step);
                let sinkage = 0.15 * part;
                let line = lines.iter().find(|line| sinkage < line.upper).unwrap();
                let found = line.offset + line.slope * sinkage;
                (found / 800.0 - pow(part, exponent)).abs()
            });
            let allowed = if exponent == 1.0 { 1e-12 } else { 0.0626 };
            assert!(off.fold(0.0, f64::max) < allowed, "{exponent}");
        }
    }
}
