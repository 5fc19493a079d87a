//! A leg of three struts whose numbers are consistent.

use nalgebra::Vector3;

use crate::invalid::{Invalid, require};
use crate::quantities;
use crate::quantity::check;
use crate::three_struts::{Arrangement, LegStrut, Telescope, ThreeStrutDesign};

/// Least volume that the directions of the three struts span, of the cube that three at right angles span. With less,
/// the foot moves almost freely in one direction.
const LEAST_VOLUME: f64 = 0.01;

/// A leg of three struts whose numbers are consistent.
#[derive(Debug, Clone, PartialEq)]
pub struct ThreeStrutLeg(ThreeStrutDesign);

impl ThreeStrutLeg {
    /// Checks a leg.
    ///
    /// # Errors
    /// Names the first quantity outside its range, in the words of the vehicle file.
    pub fn new(design: ThreeStrutDesign) -> Result<Self, Invalid> {
        check("", &quantities::THREE_STRUT_LEG, &design)?;
        check("linkage", &quantities::FOOT, &design.foot)?;
        check("primary", &quantities::LEG_STRUT, &design.primary)?;
        check("secondary", &quantities::LEG_STRUT, &design.secondary)?;
        quantities::SPREAD.check("secondary", design.spread)?;
        check("footpad", &quantities::BALL_FOOTPAD, &design.footpad)?;
        (design.footpad.profile).check_crush("footpad.profile")?;

        let [primary, secondary, _] = design.rest_lengths();
        for (table, strut, length) in [
            ("primary", &design.primary, primary),
            ("secondary", &design.secondary, secondary),
        ] {
            require(
                &format!("{table}.compression_stroke_ft"),
                strut.compression_stroke,
                &format!("less than the strut is long at rest, {length:.4} ft"),
                |stroke| stroke < length,
            )?;
        }
        if let Arrangement::Cantilever(telescope) = &design.arrangement {
            check("linkage", &quantities::TELESCOPE, telescope)?;
            check_telescope(telescope, &design.primary, primary)?;
        }
        let [a, b, c] = design.rest_directions();
        require(
            "linkage (volume that the directions of the three struts span)",
            a.cross(&b).dot(&c).abs(),
            &format!("at least {LEAST_VOLUME}: the struts hold the foot in all directions"),
            |volume| volume >= LEAST_VOLUME,
        )?;
        Ok(Self(design))
    }

    /// The leg as designed.
    pub fn design(&self) -> &ThreeStrutDesign {
        &self.0
    }

    /// Height of the plane of the lower hardpoints over level ground at rest, ft.
    pub fn stance(&self) -> f64 {
        self.0.foot.depth + self.0.footpad.height
    }
}

/// Checks the collar and the bearings of a primary strut of this `length` at rest, ft.
fn check_telescope(telescope: &Telescope, strut: &LegStrut, length: f64) -> Result<(), Invalid> {
    let (collar, least) = (telescope.collar, length - strut.compression_stroke);
    require(
        "linkage.collar_ft",
        collar,
        &format!("less than the primary strut is long when it bottoms, {least:.4} ft"),
        |collar| collar < least,
    )?;
    if telescope.bearing_friction == 0.0 {
        return Ok(());
    }
    let overhang = telescope.bearing_overhang;
    let (shortest, longest) = (strut.compression_stroke, length - collar);
    require(
        "linkage.bearing_overhang_ft",
        overhang,
        &format!(
            "{shortest:.4} < value ≤ {longest:.4} ft: the foot stays outside of the cylinder, which has the collar on it"
        ),
        |overhang| shortest < overhang && overhang <= longest,
    )?;
    let (shortest, longest) = (strut.tension_stroke, least - overhang);
    require(
        "linkage.bearing_overlap_ft",
        telescope.bearing_overlap,
        &format!(
            "{shortest:.4} < value ≤ {longest:.4} ft: the piston stays inside of the cylinder"
        ),
        |overlap| shortest < overlap && overlap <= longest,
    )?;
    Ok(())
}

impl ThreeStrutDesign {
    /// The primary strut and both secondary struts.
    pub fn struts(&self) -> [&LegStrut; 3] {
        [&self.primary, &self.secondary, &self.secondary]
    }

    /// Foot at rest and hardpoints of the three struts in leg axes, ft: outboard, across (toward greater azimuths),
    /// down, from the point of the centreline in the plane of the lower hardpoints.
    pub fn places(&self) -> (Vector3<f64>, [Vector3<f64>; 3]) {
        let foot = Vector3::new(self.foot.radius, 0.0, self.foot.depth);
        let place = |strut: &LegStrut, across| {
            Vector3::new(strut.hardpoint_radius, across, -strut.hardpoint_height)
        };
        let hardpoints = [
            place(&self.primary, 0.0),
            place(&self.secondary, -self.spread),
            place(&self.secondary, self.spread),
        ];
        (foot, hardpoints)
    }

    /// Ends of the three struts away from their hardpoints at rest, leg axes, ft.
    fn rest_ends(&self) -> [Vector3<f64>; 3] {
        let (foot, [hardpoint, ..]) = self.places();
        let along = (foot - hardpoint).normalize();
        let end = match self.arrangement {
            Arrangement::Tripod => foot,
            Arrangement::Cantilever(Telescope { collar, .. }) => hardpoint + along * collar,
        };
        [foot, end, end]
    }

    /// Lengths of the three struts at rest, ft.
    pub fn rest_lengths(&self) -> [f64; 3] {
        let (ends, (_, hardpoints)) = (self.rest_ends(), self.places());
        std::array::from_fn(|k| (ends[k] - hardpoints[k]).norm())
    }

    /// Directions of the three struts at rest, from their hardpoints, leg axes.
    fn rest_directions(&self) -> [Vector3<f64>; 3] {
        let (ends, (_, hardpoints)) = (self.rest_ends(), self.places());
        std::array::from_fn(|k| (ends[k] - hardpoints[k]).normalize())
    }
}
