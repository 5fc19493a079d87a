//! The parts of a lander as an input file describes them: plain numbers, not yet checked.
//!
//! Foot, slug, pound, second and radian throughout. Defaults are blanks to fill in; no lander has them. Keys, ranges and
//! meanings of the numbers are in [`crate::quantities`].

use nalgebra::Matrix3;

use crate::crush_load::CrushLoad;
use crate::profile::Profile;

/// The body of a lander, apart from its inertia.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Body {
    /// Mass M, slug.
    pub mass: f64,
    /// Acceleration of gravity g, ft/s².
    pub gravity: f64,
    /// Height ΔCG of the CG above the plane of the lower hardpoints, ft.
    pub center_of_gravity_height: f64,
}

/// Moments and products of inertia about the CG in vehicle axes, slug·ft². Products are as in the report's input: the
/// inertia matrix holds their negatives (59).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
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

/// One leg as an input file describes it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LegDesign {
    /// Azimuth θj of the leg about the centreline, rad; leg 1 of the Surveyor is at 0, along y.
    pub azimuth: f64,
    /// The lower link and its hinges.
    pub linkage: Linkage,
    /// The shock absorber.
    pub strut: Strut,
    /// The crushable footpad.
    pub footpad: Footpad,
    /// The crushable body block, if the leg has one.
    pub block: Option<Block>,
}

/// The lower link and the hinges it shares with the strut (Figures 2-4 and 2-5 of the report).
#[derive(Debug, Clone, Default, PartialEq)]
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

/// The strut: its travel, its friction and its load-carrying element.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Strut {
    /// Length l_D0 when extended, ft.
    pub extended_length: f64,
    /// Least length l_Dmin, ft: bottoming ends the landing.
    pub minimum_length: f64,
    /// Friction ν, a fraction of the load that the element carries.
    pub friction_fraction: f64,
    /// The load-carrying element.
    pub element: StrutElement,
}

impl Strut {
    /// The shock absorber, if it has one.
    pub fn damper(&self) -> Option<&Damper> {
        match &self.element {
            StrutElement::Damper(damper) => Some(damper),
            StrutElement::Honeycomb(_) => None,
        }
    }
}

/// Load-carrying element of a strut.
#[derive(Debug, Clone, PartialEq)]
pub enum StrutElement {
    /// The Surveyor's shock absorber.
    Damper(Damper),
    /// A crushable cartridge.
    Honeycomb(Honeycomb),
}

impl Default for StrutElement {
    fn default() -> Self {
        Self::Damper(Damper::default())
    }
}

/// The shock absorber (42)-(45).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Damper {
    /// Structural stiffness K_s below the preload, lb/ft.
    pub structural_stiffness: f64,
    /// Preload F_p, lb.
    pub preload: f64,
    /// Spring constant K_D above the preload, lb/ft.
    pub spring_constant: f64,
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

/// A honeycomb cartridge. It crushes at the load of its table, unloads and reloads along a straight line, never pulls
/// and keeps its set.
#[derive(Debug, Clone, PartialEq)]
pub struct Honeycomb {
    /// Stiffness of unloading and reloading, lb/ft.
    pub unloading_stiffness: f64,
    /// Crush load against stroke.
    pub crush_load: CrushLoad,
}

/// The crushable footpad, hinged at the end of the lower link.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Footpad {
    /// Diameter d_f, ft.
    pub diameter: f64,
    /// Uncrushed height h_f0 below the pivot, ft.
    pub height: f64,
    /// Crush pressure C_f by which the profile is multiplied, lb/ft².
    pub crush_pressure: f64,
    /// Moment of inertia I_α about the pivot, slug·ft².
    pub inertia: f64,
    /// Damping of its hinge, ft·lb·s/rad; only under [`crate::rules::ContactRule::Face`].
    pub hinge_damping: f64,
    /// Least angle α between pad and link, rad (inner stop).
    pub minimum_angle: f64,
    /// Greatest angle α between pad and link, rad (outer stop).
    pub maximum_angle: f64,
    /// Relative crush pressure against interference in ft.
    pub profile: Profile,
    /// Load after it has turned over on its edge; without it, such a landing cannot be computed further.
    pub edge: Option<PadEdge>,
}

/// A footpad on its edge: its lowest rim, at half of its height, crushes under a constant load, as in the program of
/// 1966 (187 lb beyond 65 deg).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PadEdge {
    /// Inclination ξ beyond which it is on its edge, rad.
    pub angle: f64,
    /// Load under which it crushes, lb.
    pub load: f64,
}

/// The crushable block under the body beside each leg.
#[derive(Debug, Clone, Default, PartialEq)]
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
