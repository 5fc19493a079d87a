//! The lander: mass properties and legs (model chapter 8), checked once and correct from then on.
//!
//! Foot, slug, pound, second and radian throughout. The plain structs ([`LegDesign`] and its
//! parts) are what an input file says; [`Vehicle::new`] and [`Leg::new`] turn them into a vehicle
//! that every law of the model can use without asking again.

use libm::{asin, sin};
use nalgebra::{Matrix3, SymmetricEigen};

use crate::contact::LegLaws;
use crate::invalid::{Invalid, non_negative, positive, require};
use crate::per_leg::MOST_LEGS;
use crate::profile::Profile;

/// Legs that a vehicle needs to stand on.
pub const LEAST_LEGS: usize = 3;

/// Mass properties and legs of a lander.
#[derive(Debug, Clone, PartialEq)]
pub struct Vehicle {
    mass: f64,
    gravity: f64,
    center_of_gravity_height: f64,
    inertia: Matrix3<f64>,
    legs: Vec<Leg>,
}

/// Moments and products of inertia about the CG in vehicle axes, slug·ft², products as the
/// report's input gives them: the inertia matrix holds their negatives (59).
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub struct Inertia {
    pub xx: f64,
    pub yy: f64,
    pub zz: f64,
    pub xy: f64,
    pub xz: f64,
    pub yz: f64,
}

impl Inertia {
    /// The inertia matrix J (59).
    pub fn matrix(&self) -> Matrix3<f64> {
        Matrix3::new(
            self.xx, -self.xy, -self.xz, //
            -self.xy, self.yy, -self.yz, //
            -self.xz, -self.yz, self.zz,
        )
    }
}

/// What an input file says of one leg.
#[derive(Debug, Clone, PartialEq)]
pub struct LegDesign {
    /// Azimuth θj of the leg about the centreline, rad; leg 1 of the Surveyor is at 0, along y.
    pub azimuth: f64,
    /// The lower link and its hinges.
    pub linkage: Linkage,
    /// The shock absorber.
    pub strut: Strut,
    /// The crushable footpad.
    pub footpad: Footpad,
    /// The crushable body block.
    pub block: Block,
}

/// The lower link and the hinges it shares with the strut (Figures 2-4 and 2-5 of the report).
#[derive(Debug, Clone, PartialEq)]
pub struct Linkage {
    /// Distance l_p from the centreline to the lower hardpoint, ft.
    pub lower_hardpoint_radius: f64,
    /// Length l_L of the lower link, hardpoint to footpad pivot, ft.
    pub lower_link_length: f64,
    /// Distance l_A between the hardpoints, ft.
    pub hardpoint_distance: f64,
    /// Angle β between the line joining the hardpoints and the centreline, rad.
    pub hardpoint_angle: f64,
    /// Moment of inertia I_γ of the lower link about the lower hardpoint, slug·ft².
    pub inertia: f64,
}

/// The shock absorber (42)-(45).
#[derive(Debug, Clone, PartialEq)]
pub struct Strut {
    /// Length l_D0 when extended, ft.
    pub extended_length: f64,
    /// Least length l_Dmin, ft: bottoming ends the landing.
    pub minimum_length: f64,
    /// Structural stiffness K_s below the preload, lb/ft.
    pub structural_stiffness: f64,
    /// Preload F_p, lb.
    pub preload: f64,
    /// Spring constant K_D above the preload, lb/ft.
    pub spring_constant: f64,
    /// Seal friction ν, a fraction of the spring force.
    pub friction_fraction: f64,
    /// Compression damping R_c, lb·s²/ft².
    pub compression_damping: f64,
    /// Rebound damping R_R, lb·s²/ft².
    pub rebound_damping: f64,
    /// Growth SRL of the rebound damping with stroke, 1/ft.
    pub rebound_growth: f64,
    /// Multiplier S_K of the spring constant against stroke in ft.
    pub spring_profile: Profile,
    /// Multiplier S_D of the compression damping against stroke in ft.
    pub damping_profile: Profile,
}

/// The crushable footpad, hinged at the end of the lower link.
#[derive(Debug, Clone, PartialEq)]
pub struct Footpad {
    /// Diameter d_f, ft.
    pub diameter: f64,
    /// Uncrushed height h_f0 below the pivot, ft.
    pub height: f64,
    /// Crush pressure C_f by which the profile is multiplied, lb/ft².
    pub crush_pressure: f64,
    /// Moment of inertia I_α about the pivot, slug·ft².
    pub inertia: f64,
    /// Least angle α between pad and link, rad (inner stop).
    pub minimum_angle: f64,
    /// Greatest angle α between pad and link, rad (outer stop).
    pub maximum_angle: f64,
    /// Relative crush pressure against interference in ft.
    pub profile: Profile,
}

/// The crushable block under the body beside each leg.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Distance l_c from the centreline, ft.
    pub radius: f64,
    /// Uncrushed height h_B0 below the lower hardpoint plane, ft.
    pub height: f64,
    /// Diameter d_B, ft.
    pub diameter: f64,
    /// Crush pressure C_B by which the profile is multiplied, lb/ft².
    pub crush_pressure: f64,
    /// Relative crush pressure against interference in ft.
    pub profile: Profile,
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
        require("azimuth_deg", design.azimuth, "a finite number", |_| true)?;
        let LegDesign {
            linkage,
            strut,
            footpad,
            block,
            ..
        } = &design;

        positive(
            "linkage.lower_hardpoint_radius_ft",
            linkage.lower_hardpoint_radius,
        )?;
        positive("linkage.lower_link_length_ft", linkage.lower_link_length)?;
        positive("linkage.hardpoint_distance_ft", linkage.hardpoint_distance)?;
        require(
            "linkage.hardpoint_angle_deg",
            linkage.hardpoint_angle.to_degrees(),
            "between 0 and 90",
            |v| (0.0..=90.0).contains(&v),
        )?;
        positive("linkage.inertia_slug_ft2", linkage.inertia)?;

        positive("strut.extended_length_ft", strut.extended_length)?;
        let extended = strut.extended_length;
        require(
            "strut.minimum_length_ft",
            strut.minimum_length,
            "positive and below strut.extended_length_ft",
            |v| v > 0.0 && v < extended,
        )?;
        positive(
            "strut.structural_stiffness_lb_per_ft",
            strut.structural_stiffness,
        )?;
        positive("strut.preload_lb", strut.preload)?;
        non_negative("strut.spring_constant_lb_per_ft", strut.spring_constant)?;
        require(
            "strut.friction_fraction",
            strut.friction_fraction,
            "0 ≤ value < 1",
            |v| (0.0..1.0).contains(&v),
        )?;
        non_negative("strut.compression_damping", strut.compression_damping)?;
        non_negative("strut.rebound_damping", strut.rebound_damping)?;
        non_negative("strut.rebound_growth_per_ft", strut.rebound_growth)?;

        positive("footpad.diameter_ft", footpad.diameter)?;
        positive("footpad.height_ft", footpad.height)?;
        positive("footpad.crush_pressure_psf", footpad.crush_pressure)?;
        positive("footpad.inertia_slug_ft2", footpad.inertia)?;
        crush_profile("footpad.profile", &footpad.profile)?;

        positive("block.radius_ft", block.radius)?;
        require("block.height_ft", block.height, "a finite number", |_| true)?;
        positive("block.diameter_ft", block.diameter)?;
        positive("block.crush_pressure_psf", block.crush_pressure)?;
        crush_profile("block.profile", &block.profile)?;

        let extended_angle = extended_angle(linkage, strut)?;
        let (minimum, maximum) = (footpad.minimum_angle, footpad.maximum_angle);
        let extended_deg = extended_angle.to_degrees();
        require(
            "footpad.minimum_angle_deg",
            minimum.to_degrees(),
            &format!("below the angle of the extended link, {extended_deg:.4} deg"),
            |v| v > -90.0 && v < extended_deg,
        )?;
        require(
            "footpad.maximum_angle_deg",
            maximum.to_degrees(),
            &format!("above the angle of the extended link, {extended_deg:.4} deg"),
            |v| v < 90.0 && v > extended_deg,
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

    /// Its laws, made of the design once for all landings.
    pub(crate) fn laws(&self) -> &LegLaws {
        &self.laws
    }

    /// Lower-link angle γ at which the strut has its extended length, rad: where γ starts.
    pub fn extended_angle(&self) -> f64 {
        self.extended_angle
    }

    /// Height of the lower hardpoints over level ground with the strut extended, ft.
    pub fn stance(&self) -> f64 {
        let design = &self.design;
        design.linkage.lower_link_length * sin(self.extended_angle) + design.footpad.height
    }
}

/// A crush profile starts at zero pressure, and no later segment is steeper than the first, which
/// is the elastic line: otherwise crushing would heal.
fn crush_profile(quantity: &str, profile: &Profile) -> Result<(), Invalid> {
    require(
        quantity,
        profile.knots()[0][1],
        "zero pressure at zero interference",
        |p| p == 0.0,
    )?;
    let segments = profile.segments();
    let elastic = positive(quantity, segments[0].slope)?;
    for segment in &segments[1..] {
        require(
            quantity,
            segment.slope,
            &format!("no segment falling or steeper than the first ({elastic} per ft)"),
            |slope| slope >= 0.0 && slope <= elastic * (1.0 + 1e-6),
        )?;
    }
    Ok(())
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
    /// Checks a vehicle: mass (slug), gravity (ft/s²), height of the CG above the plane of the
    /// lower hardpoints ΔCG (ft), inertia, and legs in the order in which they stand around the
    /// centreline.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the vehicle file.
    pub fn new(
        mass: f64,
        gravity: f64,
        center_of_gravity_height: f64,
        inertia: Inertia,
        legs: impl Into<Vec<Leg>>,
    ) -> Result<Self, Invalid> {
        let legs = legs.into();
        positive("mass_slug", mass)?;
        positive("gravity_fps2", gravity)?;
        require(
            "center_of_gravity_height_ft",
            center_of_gravity_height,
            "a finite number",
            |_| true,
        )?;
        let Inertia {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        } = inertia;
        for (name, value) in [("xx", xx), ("yy", yy), ("zz", zz)] {
            positive(&format!("inertia_slug_ft2.{name}"), value)?;
        }
        for (name, value) in [("xy", xy), ("xz", xz), ("yz", yz)] {
            require(
                &format!("inertia_slug_ft2.{name}"),
                value,
                "a finite number",
                |_| true,
            )?;
        }
        let matrix = inertia.matrix();
        let least = SymmetricEigen::new(matrix).eigenvalues.min();
        require(
            "inertia_slug_ft2 (least principal moment)",
            least,
            "positive: the inertia matrix must be positive definite",
            |v| v > 0.0,
        )?;
        require(
            "legs",
            legs.len() as f64,
            &format!("{LEAST_LEGS} to {MOST_LEGS} legs"),
            |_| (LEAST_LEGS..=MOST_LEGS).contains(&legs.len()),
        )?;
        for (index, leg) in legs.iter().enumerate() {
            require(
                &format!("center_of_gravity_height_ft (over footpad {})", index + 1),
                center_of_gravity_height + leg.stance(),
                "the CG above the footpads",
                |v| v > 0.0,
            )?;
        }
        Ok(Self {
            mass,
            gravity,
            center_of_gravity_height,
            inertia: matrix,
            legs,
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

    /// Height of the CG over level ground on which the vehicle stands with its struts extended, ft.
    pub fn standing_height(&self) -> f64 {
        let stances = self.legs.iter().map(Leg::stance);
        self.center_of_gravity_height + stances.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Inertia matrix J about the CG, vehicle axes, slug·ft².
    pub fn inertia(&self) -> &Matrix3<f64> {
        &self.inertia
    }

    /// The legs, in ring order.
    pub fn legs(&self) -> &[Leg] {
        &self.legs
    }
}
