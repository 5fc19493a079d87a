//! Thrust of an engine that dies away at touchdown.

use crate::invalid::{Invalid, require};
use crate::lanes::per_lane;
use crate::quantities::{THRUST_FORCE, THRUST_OFFSET_X, THRUST_OFFSET_Y};
use crate::scalar::Real;

/// Most knots of a table of thrust.
pub const MOST_KNOTS: usize = 16;

/// A force along the centreline, upward in the vehicle, over time since first contact. It is linear between its knots
/// and constant after the last one.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Thrust {
    knots: [[f64; 2]; MOST_KNOTS],
    count: usize,
    offset: [f64; 2],
}

impl Thrust {
    /// Thrust with these knots of time (s) and force (lb). Its line of action has this `offset` from the centreline (x
    /// and y of vehicle axes, ft).
    ///
    /// # Errors
    /// Times start at 0 and increase, forces are not negative, and there are 1 to 16 knots.
    pub fn new(knots: &[[f64; 2]], offset: [f64; 2]) -> Result<Self, Invalid> {
        if knots.is_empty() || knots.len() > MOST_KNOTS {
            let count = knots.len() as f64;
            return Err(Invalid::new("thrust.time_s", count, "1 to 16 numbers"));
        }
        require(
            "thrust.time_s",
            knots[0][0],
            "0 as the first time",
            |time| time == 0.0,
        )?;
        for pair in knots.windows(2) {
            let before = pair[0][0];
            require(
                "thrust.time_s",
                pair[1][0],
                &format!("a time after the one before, {before}, and ≤ 10000"),
                |time| time > before && time <= 1e4,
            )?;
        }
        for knot in knots {
            THRUST_FORCE.check("thrust", knot[1])?;
        }
        for (quantity, value) in [THRUST_OFFSET_X, THRUST_OFFSET_Y].iter().zip(offset) {
            quantity.check("thrust", value)?;
        }
        // An engine that never pushes counts as none.
        if knots.iter().all(|knot| knot[1] == 0.0) {
            return Ok(Self::default());
        }
        let mut thrust = Self {
            count: knots.len(),
            offset,
            ..Self::default()
        };
        thrust.knots[..knots.len()].copy_from_slice(knots);
        Ok(thrust)
    }

    fn knots(&self) -> &[[f64; 2]] {
        &self.knots[..self.count]
    }

    /// Returns whether there is none.
    pub fn is_none(&self) -> bool {
        self.count == 0
    }

    /// Offset of its line of action from the centreline: x and y of vehicle axes, ft.
    pub fn offset(&self) -> [f64; 2] {
        self.offset
    }

    /// The line of thrust from a time (s) on, and the end of that line, s.
    pub fn line_from(&self, time: f64) -> (ThrustLine<f64>, f64) {
        let knots = self.knots();
        let next = knots.iter().position(|knot| knot[0] > time);
        let line = match next {
            Some(next) => {
                let [[t0, f0], [t1, f1]] = [knots[next - 1], knots[next]];
                let slope = (f1 - f0) / (t1 - t0);
                ThrustLine {
                    offset: f0 - slope * t0,
                    slope,
                }
            }
            None => ThrustLine {
                offset: knots.last().map_or(0.0, |last| last[1]),
                slope: 0.0,
            },
        };
        (line, next.map_or(f64::INFINITY, |next| knots[next][0]))
    }
}

/// A straight line of thrust (lb) over time since first contact (s).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrustLine<S> {
    offset: S,
    slope: S,
}

per_lane!(ThrustLine { offset, slope });

impl<S: Real> ThrustLine<S> {
    /// No thrust.
    pub fn none() -> Self {
        Self {
            offset: S::zero(),
            slope: S::zero(),
        }
    }

    /// Returns whether there is none.
    #[inline(always)]
    pub fn is_none(&self) -> bool {
        self.offset.is_zero() && self.slope.is_zero()
    }

    /// Thrust at a time.
    #[inline(always)]
    pub fn at(&self, time: S) -> S {
        self.offset + self.slope * time
    }

    /// Its rate, lb/s.
    #[inline(always)]
    pub fn rate(&self) -> S {
        self.slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thrust_is_linear_between_knots_and_stays_after_the_last() {
        let thrust = Thrust::new(&[[0.0, 300.0], [0.5, 100.0], [2.0, 0.0]], [0.1, 0.0]).unwrap();
        for (time, force, until) in [
            (0.0, 300.0, 0.5),
            (0.25, 200.0, 0.5),
            (0.5, 100.0, 2.0),
            (2.0, 0.0, f64::INFINITY),
            (9.0, 0.0, f64::INFINITY),
        ] {
            let (line, end) = thrust.line_from(time);
            assert!((line.at(time) - force).abs() < 1e-12, "{time}");
            assert_eq!(end, until);
        }
        assert!(thrust.line_from(2.0).0.is_none());
        assert!(Thrust::default().is_none());
    }

    #[test]
    fn tables_that_mean_nothing_are_refused() {
        for knots in [
            vec![],
            vec![[0.1, 1.0]],
            vec![[0.0, 1.0], [0.0, 2.0]],
            vec![[0.0, 1.0], [1.0, -1.0]],
            vec![[0.0, f64::NAN]],
            vec![[0.0, 1.0]; 17],
        ] {
            assert!(Thrust::new(&knots, [0.0; 2]).is_err(), "{knots:?}");
        }
    }
}
