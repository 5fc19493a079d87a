//! The ground under the legs: where it is higher, lower or steeper than the surface.

use crate::invalid::{Invalid, require};
use crate::per_leg::MOST_LEGS;
use crate::quantities::{
    BEARING_FACTOR, BLOCK_GROUND_HEIGHT, BLOCK_TILT_ACROSS, BLOCK_TILT_ALONG, PAD_GROUND_HEIGHT,
    PAD_TILT_ACROSS, PAD_TILT_ALONG,
};
use crate::quantity::Quantity;
use crate::soil::Soil;

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

/// The plane of the surface.
const EVEN: Patch = Patch {
    height: 0.0,
    tilt_along: 0.0,
    tilt_across: 0.0,
};

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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegFooting {
    /// Ground under its footpad.
    pub pad: Patch,
    /// Ground under its block.
    pub block: Patch,
    /// Factor on the bearing strength of the soil; 1 on rock.
    pub bearing_factor: f64,
}

impl LegFooting {
    /// The surface.
    pub const SURFACE: Self = Self::of(EVEN, EVEN);

    /// Planes under footpad and block, of the material of the surface.
    pub const fn of(pad: Patch, block: Patch) -> Self {
        Self {
            pad,
            block,
            bearing_factor: 1.0,
        }
    }
}

impl Default for LegFooting {
    fn default() -> Self {
        Self::SURFACE
    }
}

/// The ground under all legs a vehicle can have.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Ground([LegFooting; MOST_LEGS]);

impl Ground {
    /// The ground under the vehicle's legs in their order. Legs beyond the given ones have the surface.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the sweep file.
    pub fn new(legs: &[LegFooting]) -> Result<Self, Invalid> {
        let mut ground = Self::default();
        for (index, (leg, place)) in legs.iter().zip(&mut ground.0).enumerate() {
            check(index, &PAD, &leg.pad)?;
            check(index, &BLOCK, &leg.block)?;
            check_factor(index, leg.bearing_factor)?;
            *place = *leg;
        }
        Ok(ground)
    }

    /// Checks that no plane is vertical or overhangs on a surface of this slope, rad, and that only soil is stronger under one leg
    /// than under another.
    ///
    /// # Errors
    /// Names the tilt or the factor.
    pub(super) fn check_on(&self, slope: f64, soil: &Soil) -> Result<(), Invalid> {
        if *soil == Soil::Rock {
            for (leg, footing) in self.0.iter().enumerate() {
                require(
                    &name(leg, BEARING_FACTOR.key),
                    footing.bearing_factor,
                    "1 on rock, which does not yield",
                    |factor| factor == 1.0,
                )?;
            }
        }
        let legs = self.0.iter().enumerate();
        let patches = legs.flat_map(|(leg, of)| [(leg, &PAD, &of.pad), (leg, &BLOCK, &of.block)]);
        for (leg, [_, along, _], patch) in patches.filter(|(.., patch)| patch.is_tilted()) {
            let steepest = (slope + patch.tilt_along).to_degrees();
            require(
                &name(leg, along.key),
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

/// Height and tilts of the ground under a footpad, and under a block.
const PAD: [Quantity; 3] = [PAD_GROUND_HEIGHT, PAD_TILT_ALONG, PAD_TILT_ACROSS];
const BLOCK: [Quantity; 3] = [BLOCK_GROUND_HEIGHT, BLOCK_TILT_ALONG, BLOCK_TILT_ACROSS];

fn name(leg: usize, key: &str) -> String {
    format!("footing[{}].{key}", leg + 1)
}

fn check_factor(leg: usize, factor: f64) -> Result<(), Invalid> {
    (BEARING_FACTOR.check("", factor)).map_err(|invalid| Invalid {
        quantity: name(leg, &invalid.quantity),
        ..invalid
    })
}

fn check(leg: usize, quantities: &[Quantity; 3], patch: &Patch) -> Result<(), Invalid> {
    let [height, along, across] = quantities;
    (height.check("", patch.height))
        .and_then(|()| along.check_radians("", patch.tilt_along))
        .and_then(|()| across.check_radians("", patch.tilt_across))
        .map_err(|invalid| Invalid {
            quantity: name(leg, &invalid.quantity),
            ..invalid
        })
}
