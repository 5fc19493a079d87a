//! The lander: mass properties and legs (model chapter 8), checked once and correct from then on.
//!
//! Foot, slug, pound, second and radian throughout. The plain structs ([`LegDesign`] and its parts) describe an input
//! file; [`Vehicle::new`] and [`Leg::new`] turn them into a vehicle that every law of the model can use without further
//! checks.

use libm::{asin, cos, sin, sincos};
use nalgebra::{Matrix3, SymmetricEigen};

pub use super::footprint::Ring;
use crate::contact::LegLaws;
pub use crate::parts::{
    Block, Body, Damper, Footpad, Honeycomb, Inertia, LegDesign, Linkage, Strut, StrutElement,
};

use super::footprint::{Stand, check_offset, ring_of};
use super::three_strut_leg::ThreeStrutLeg;
use crate::invalid::{Invalid, require};
use crate::per_leg::MOST_LEGS;
use crate::quantities;
use crate::quantity::check;
use crate::rules::Rules;

/// Least number of legs that a vehicle stands on.
pub const LEAST_LEGS: usize = 3;

/// Mass properties and legs of a lander.
#[derive(Debug, Clone, PartialEq)]
pub struct Vehicle {
    mass: f64,
    gravity: f64,
    center_of_gravity_height: f64,
    center_of_gravity_offset: [f64; 2],
    inertia: Matrix3<f64>,
    rules: Rules,
    ring: Ring,
    /// Greatest height of the plane of the lower hardpoints over level ground, ft.
    stance: f64,
    legs: Legs,
}

/// The legs of a vehicle, all of one kind, in the order of its file.
#[derive(Debug, Clone, PartialEq)]
pub enum Legs {
    /// Legs that turn about one hinge.
    Hinged(Vec<Leg>),
    /// Legs of three struts.
    ThreeStrut(Vec<ThreeStrutLeg>),
}

impl From<Vec<Leg>> for Legs {
    fn from(legs: Vec<Leg>) -> Self {
        Self::Hinged(legs)
    }
}

impl<const LEGS: usize> From<[Leg; LEGS]> for Legs {
    fn from(legs: [Leg; LEGS]) -> Self {
        Self::Hinged(legs.into())
    }
}

impl From<Vec<ThreeStrutLeg>> for Legs {
    fn from(legs: Vec<ThreeStrutLeg>) -> Self {
        Self::ThreeStrut(legs)
    }
}

impl Legs {
    /// Where each leg stands at rest.
    fn stands(&self) -> Vec<Stand> {
        let stand = |azimuth: f64, reach: f64, stance| {
            let (sine, cosine) = sincos(azimuth);
            Stand {
                azimuth,
                foot: [reach * sine, reach * cosine],
                stance,
            }
        };
        match self {
            Self::Hinged(legs) => (legs.iter())
                .map(|leg| stand(leg.design.azimuth, leg.reach(), leg.stance()))
                .collect(),
            Self::ThreeStrut(legs) => (legs.iter())
                .map(|leg| stand(leg.design().azimuth, leg.design().foot.radius, leg.stance()))
                .collect(),
        }
    }
}

/// A leg whose numbers are consistent.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    design: LegDesign,
    extended_angle: f64,
    laws: LegLaws,
}

impl Leg {
    /// Checks a leg.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the vehicle file.
    pub fn new(design: LegDesign) -> Result<Self, Invalid> {
        let LegDesign {
            linkage,
            strut,
            footpad,
            block,
            ..
        } = &design;

        check("", &quantities::LEG, &design)?;
        check("linkage", &quantities::LINKAGE, linkage)?;
        check("strut", &quantities::STRUT, strut)?;
        let extended = strut.extended_length;
        require(
            "strut.minimum_length_ft",
            strut.minimum_length,
            "positive and below strut.extended_length_ft",
            |v| v < extended,
        )?;
        match &strut.element {
            StrutElement::Damper(damper) => check("strut", &quantities::DAMPER, damper)?,
            StrutElement::Honeycomb(honeycomb) => {
                check("strut", &quantities::HONEYCOMB, honeycomb)?;
            }
        }
        check("footpad", &quantities::FOOTPAD, footpad)?;
        footpad.profile.check_crush("footpad.profile")?;
        if let Some(edge) = &footpad.edge {
            check("footpad", &quantities::EDGE, edge)?;
        }
        if let Some(block) = block {
            check("block", &quantities::BLOCK, block)?;
            block.profile.check_crush("block.profile")?;
        }

        let extended_angle = extended_angle(linkage, strut)?;
        let (minimum, maximum) = (footpad.minimum_angle, footpad.maximum_angle);
        let extended_deg = extended_angle.to_degrees();
        require(
            "footpad.minimum_angle_deg",
            minimum.to_degrees(),
            &format!("below the angle of the extended link, {extended_deg:.4} deg"),
            |v| v < extended_deg,
        )?;
        require(
            "footpad.maximum_angle_deg",
            maximum.to_degrees(),
            &format!("above the angle of the extended link, {extended_deg:.4} deg"),
            |v| v > extended_deg,
        )?;
        Ok(Self {
            laws: LegLaws::of(&design),
            design,
            extended_angle,
        })
    }

    /// The leg as designed.
    pub fn design(&self) -> &LegDesign {
        &self.design
    }

    /// Its laws, made from the design once for all landings.
    pub fn laws(&self) -> &LegLaws {
        &self.laws
    }

    /// Lower-link angle γ at which the strut has its extended length, rad: the initial γ.
    pub fn extended_angle(&self) -> f64 {
        self.extended_angle
    }

    /// Distance of the footpad's pivot from the centreline with the strut extended, ft.
    fn reach(&self) -> f64 {
        let linkage = &self.design.linkage;
        linkage.lower_hardpoint_radius + linkage.lower_link_length * cos(self.extended_angle)
    }

    /// Height of the lower hardpoints over level ground with the strut extended, ft.
    pub fn stance(&self) -> f64 {
        let design = &self.design;
        design.linkage.lower_link_length * sin(self.extended_angle) + design.footpad.height
    }
}

/// Solves (11) for the angle γ of the extended strut.
fn extended_angle(linkage: &Linkage, strut: &Strut) -> Result<f64, Invalid> {
    let (a, l) = (linkage.hardpoint_distance, linkage.lower_link_length);
    let sine = (strut.extended_length * strut.extended_length - a * a - l * l) / (2.0 * a * l);
    require(
        "strut.extended_length_ft",
        strut.extended_length,
        "a length that the hardpoints and the lower link can span",
        |_| sine.abs() < 1.0,
    )?;
    let angle = asin(sine) + linkage.hardpoint_angle;
    require(
        "strut.extended_length_ft",
        strut.extended_length,
        "a length at which the lower link stands between -60 and 60 deg",
        |_| angle.abs() < 60f64.to_radians(),
    )?;
    Ok(angle)
}

impl Vehicle {
    /// Checks a vehicle: mass (slug), gravity (ft/s²), height of the CG above the plane of the lower hardpoints ΔCG
    /// (ft), inertia, and legs, which are numbered in the given order.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the vehicle file.
    pub fn new(
        mass: f64,
        gravity: f64,
        center_of_gravity_height: f64,
        inertia: Inertia,
        legs: impl Into<Legs>,
    ) -> Result<Self, Invalid> {
        let legs = legs.into();
        let stands = legs.stands();
        let body = Body {
            mass,
            gravity,
            center_of_gravity_height,
        };
        check("", &quantities::BODY, &body)?;
        check("inertia_slug_ft2", &quantities::INERTIA, &inertia)?;
        let matrix = inertia.matrix();
        let moments = SymmetricEigen::new(matrix).eigenvalues;
        let (least, greatest) = (moments.min(), moments.max());
        require(
            "inertia_slug_ft2 (least principal moment)",
            least,
            "positive: the inertia matrix must be positive definite",
            |v| v > 0.0,
        )?;
        let others = moments.sum() - greatest;
        require(
            "inertia_slug_ft2 (greatest principal moment)",
            greatest,
            &format!("at most the sum of the other two, {others:.4}: no body has more"),
            |v| v <= others * (1.0 + 1e-9),
        )?;
        require(
            "legs",
            stands.len() as f64,
            &format!("{LEAST_LEGS} to {MOST_LEGS} legs"),
            |_| (LEAST_LEGS..=MOST_LEGS).contains(&stands.len()),
        )?;
        for (index, leg) in stands.iter().enumerate() {
            require(
                &format!("center_of_gravity_height_ft (over footpad {})", index + 1),
                center_of_gravity_height + leg.stance,
                "the CG above the footpads",
                |v| v > 0.0,
            )?;
        }
        let stance = stands.iter().map(|leg| leg.stance);
        Ok(Self {
            mass,
            gravity,
            center_of_gravity_height,
            center_of_gravity_offset: [0.0; 2],
            inertia: matrix,
            rules: Rules::PHYSICAL,
            ring: ring_of(&stands)?,
            stance: stance.fold(f64::NEG_INFINITY, f64::max),
            legs,
        })
    }

    /// The same vehicle under these rules, unless settings choose others.
    pub fn with_rules(self, rules: Rules) -> Self {
        Self { rules, ..self }
    }

    /// The same vehicle with its CG off the centreline: x and y of vehicle axes, ft. The inertia is still about the CG.
    ///
    /// # Errors
    /// When the CG is not over the polygon of the extended feet.
    pub fn with_center_of_gravity_offset(self, offset: [f64; 2]) -> Result<Self, Invalid> {
        let feet: Vec<[f64; 2]> = self.legs.stands().iter().map(|leg| leg.foot).collect();
        check_offset(offset, &feet)?;
        Ok(Self {
            center_of_gravity_offset: offset,
            ..self
        })
    }

    /// Mass, slug.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Acceleration of gravity, ft/s².
    pub fn gravity(&self) -> f64 {
        self.gravity
    }

    /// Height ΔCG of the CG above the plane of the lower hardpoints, ft.
    pub fn center_of_gravity_height(&self) -> f64 {
        self.center_of_gravity_height
    }

    /// Offset of the CG from the centreline: x and y of vehicle axes, ft.
    pub fn center_of_gravity_offset(&self) -> [f64; 2] {
        self.center_of_gravity_offset
    }

    /// Height of the CG over level ground on which the vehicle stands with its struts extended, ft.
    pub fn standing_height(&self) -> f64 {
        self.center_of_gravity_height + self.stance
    }

    /// The legs by azimuth. Each stands next to the ones before and after it, the last next to the first.
    pub fn ring(&self) -> &Ring {
        &self.ring
    }

    /// The rules by which it lands, unless settings choose others.
    pub fn rules(&self) -> Rules {
        self.rules
    }

    /// Inertia matrix J about the CG, vehicle axes, slug·ft².
    pub fn inertia(&self) -> &Matrix3<f64> {
        &self.inertia
    }

    /// The legs in the given order, which all results follow.
    pub fn legs(&self) -> &Legs {
        &self.legs
    }

    /// Number of legs.
    pub fn leg_count(&self) -> usize {
        match &self.legs {
            Legs::Hinged(legs) => legs.len(),
            Legs::ThreeStrut(legs) => legs.len(),
        }
    }

    /// Returns whether the legs turn about one hinge.
    pub fn has_hinged_legs(&self) -> bool {
        matches!(self.legs, Legs::Hinged(_))
    }

    /// The legs that turn about one hinge: all or none.
    pub fn hinged_legs(&self) -> &[Leg] {
        match &self.legs {
            Legs::Hinged(legs) => legs,
            Legs::ThreeStrut(_) => &[],
        }
    }
}
