//! The ground under the legs: where it is higher, lower or steeper than the surface.

use crate::invalid::{Invalid, require};
use crate::per_leg::MOST_LEGS;

/// A plane of the ground under a footpad or a block.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Patch {
    /// Height over the surface, along its normal, ft, of the plane's point on the vertical through the footpad's pivot
    /// or the block's centre at first contact.
    pub height: f64,
    /// Tilt added to the slope, rad: steeper when positive.
    pub tilt_along: f64,
    /// Tilt across the slope, rad: rising toward X of the ground axes when positive.
    pub tilt_across: f64,
}

impl Patch {
    /// Returns whether the plane is that of the surface.
    pub fn is_even(&self) -> bool {
        *self == Self::default()
    }

    /// Returns whether the plane is not parallel to the surface.
    pub fn is_tilted(&self) -> bool {
        self.tilt_along != 0.0 || self.tilt_across != 0.0
    }
}

/// The ground under one leg.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LegFooting {
    /// Ground under its footpad.
    pub pad: Patch,
    /// Ground under its block.
    pub block: Patch,
}

/// The ground under all legs a vehicle can have.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Ground([LegFooting; MOST_LEGS]);

/// Greatest height or depth, ft, and greatest tilt, deg.
const GREATEST_HEIGHT: f64 = 1000.0;
const GREATEST_TILT: f64 = 60.0;

impl Ground {
    /// The ground under the vehicle's legs in their order. Legs beyond the given ones have the surface.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the sweep file.
    pub fn new(legs: &[LegFooting]) -> Result<Self, Invalid> {
        let mut ground = Self::default();
        for (index, (leg, place)) in legs.iter().zip(&mut ground.0).enumerate() {
            check(index, "", &leg.pad)?;
            check(index, "block_", &leg.block)?;
            *place = *leg;
        }
        Ok(ground)
    }

    /// Checks that no plane is vertical or overhangs on a surface of this slope, rad.
    ///
    /// # Errors
    /// Names the tilt.
    pub(super) fn check_on(&self, slope: f64) -> Result<(), Invalid> {
        let legs = self.0.iter().enumerate();
        let patches = legs
            .flat_map(|(leg, LegFooting { pad, block })| [(leg, "", pad), (leg, "block_", block)]);
        for (leg, part, patch) in patches.filter(|(.., patch)| patch.is_tilted()) {
            let steepest = (slope + patch.tilt_along).to_degrees();
            require(
                &name(leg, part, "tilt_along_deg"),
                patch.tilt_along.to_degrees(),
                "a tilt that leaves slope and tilt together between -90 and 90",
                |_| steepest.abs() < 90.0,
            )?;
        }
        Ok(())
    }

    /// Ground under leg `index`.
    pub fn leg(&self, index: usize) -> &LegFooting {
        &self.0[index]
    }
}

fn name(leg: usize, part: &str, key: &str) -> String {
    format!("footing[{}].{part}{key}", leg + 1)
}

fn check(leg: usize, part: &str, patch: &Patch) -> Result<(), Invalid> {
    require(
        &name(leg, part, "height_ft"),
        patch.height,
        "-1000 ≤ value ≤ 1000",
        |height| height.abs() <= GREATEST_HEIGHT,
    )?;
    for (key, tilt) in [
        ("tilt_along_deg", patch.tilt_along),
        ("tilt_across_deg", patch.tilt_across),
    ] {
        require(
            &name(leg, part, key),
            tilt.to_degrees(),
            "-60 ≤ value ≤ 60",
            |tilt| tilt.abs() <= GREATEST_TILT,
        )?;
    }
    Ok(())
}
