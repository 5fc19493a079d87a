//! A leg of three struts whose numbers are consistent.

use nalgebra::Vector3;

use crate::invalid::{Invalid, require};
use crate::quantities;
use crate::quantity::check;
use crate::three_struts::{Arrangement, LegStrut, ThreeStrutDesign};

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
        if let Arrangement::Cantilever { collar } = design.arrangement {
            quantities::COLLAR.check("linkage", collar)?;
            let least = primary - design.primary.compression_stroke;
            require(
                "linkage.collar_ft",
                collar,
                &format!("less than the primary strut is long when it bottoms, {least:.4} ft"),
                |collar| collar < least,
            )?;
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
            Arrangement::Cantilever { collar } => hardpoint + along * collar,
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
