//! A leg of three struts as an input file describes it: plain numbers, not yet checked.
//!
//! A primary strut and two secondary struts hold a foot that moves in all directions. Heights are over the plane of the
//! lower hardpoints, above which the height of the CG is given, too.

use crate::crush_load::CrushLoad;
use crate::profile::Profile;

/// One leg of three struts.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ThreeStrutDesign {
    /// Azimuth θj of the leg about the centreline, rad.
    pub azimuth: f64,
    /// Where the secondary struts end.
    pub arrangement: Arrangement,
    /// Place and mass of the foot.
    pub foot: Foot,
    /// The primary strut, in the plane of the leg.
    pub primary: LegStrut,
    /// The secondary struts, alike on both sides of that plane.
    pub secondary: LegStrut,
    /// Distance of their hardpoints from that plane, ft.
    pub spread: f64,
    /// The footpad.
    pub footpad: BallFootpad,
}

/// Where the secondary struts of a leg end.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Arrangement {
    /// At the foot, as the primary strut does.
    #[default]
    Tripod,
    /// At a collar of the primary strut's outer cylinder.
    Cantilever(Telescope),
}

/// A primary strut of an outer cylinder, which secondary struts hold at a collar, and a piston with the foot at its end.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Telescope {
    /// Distance of the collar from the primary strut's hardpoint, ft.
    pub collar: f64,
    /// Friction coefficient of the bearings on which the piston slides. With 0 the lengths below do not matter.
    pub bearing_friction: f64,
    /// Distance of the foot at rest from the lower bearing, at the end of the cylinder, ft.
    pub bearing_overhang: f64,
    /// Distance at rest between that bearing and the upper one, at the end of the piston, ft.
    pub bearing_overlap: f64,
}

impl Telescope {
    /// A collar at this distance from the primary strut's hardpoint (ft), and bearings without friction.
    pub fn without_friction(collar: f64) -> Self {
        Self {
            collar,
            ..Self::default()
        }
    }
}

/// The foot of a leg at rest: the end of its primary strut, to which the footpad is hinged.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Foot {
    /// Distance from the centreline, ft.
    pub radius: f64,
    /// Depth below the plane of the lower hardpoints, ft.
    pub depth: f64,
    /// Mass, slug, which the mass of the vehicle leaves out.
    pub mass: f64,
}

/// A strut that takes up load in compression and in tension.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LegStrut {
    /// Distance of its hardpoint from the centreline, in the plane of the leg, ft.
    pub hardpoint_radius: f64,
    /// Height of its hardpoint, ft.
    pub hardpoint_height: f64,
    /// Stiffness at which it takes up load, unloads and reloads, lb/ft.
    pub stiffness: f64,
    /// Damping: force per speed of the stroke, lb·s/ft.
    pub damping: f64,
    /// Damping: force per square of that speed, lb·s²/ft².
    pub square_damping: f64,
    /// Shortening at which it bottoms, ft.
    pub compression_stroke: f64,
    /// Lengthening at which it is drawn out, ft.
    pub tension_stroke: f64,
    /// Load under which it shortens for good, against its shortening; without it, it only gives elastically.
    pub compression_load: Option<CrushLoad>,
    /// Load under which it lengthens for good, against its lengthening; without it, it only gives elastically.
    pub tension_load: Option<CrushLoad>,
}

/// A crushable footpad on a ball joint. It lies flat on the ground and passes no moment on.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BallFootpad {
    /// Diameter d_f, ft.
    pub diameter: f64,
    /// Uncrushed height h_f0 below the joint, ft.
    pub height: f64,
    /// Crush pressure C_f by which the profile is multiplied, lb/ft².
    pub crush_pressure: f64,
    /// Relative crush pressure against crush in ft.
    pub profile: Profile,
}
