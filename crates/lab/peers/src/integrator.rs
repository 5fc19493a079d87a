//! What computes whole landings here, by the name that the table gives it.

use touchdown_dynamics::invalid::Invalid;
use touchdown_dynamics::methods::{ErrorControl, Method};
use touchdown_dynamics::scene::{CrushRule, Settings};

use crate::plain_landing::PlainLanding;
use crate::variables::COUNT;
use crate::{diffsol_tsit45, ode_solvers_dopri5};

/// Integrates a plain landing with a tolerance; its variables at the end.
type Peer = fn(&mut PlainLanding, f64) -> Result<[f64; COUNT], String>;

/// An integrator at a tolerance.
pub enum Integrator {
    /// Another crate's, on the plain landing.
    Peer(Peer, f64),
    /// Ours.
    Own(Settings),
}

impl Integrator {
    /// The integrator of a name; `None` where there is none.
    pub fn named(name: &str, tolerance: f64) -> Result<Option<Self>, Invalid> {
        Ok(Some(match name {
            "ode_solvers Dopri5" => Self::Peer(ode_solvers_dopri5::integrate, tolerance),
            "diffsol TSIT45" => Self::Peer(diffsol_tsit45::integrate, tolerance),
            "touchdown" => Self::Own(settings(tolerance)?),
            // With the error limits of 4.1.4, whatever the tolerance.
            "touchdown --method report" => {
                Self::Own(settings(tolerance)?.with_method(Method::Report(ErrorControl::default())))
            }
            _ => return Ok(None),
        }))
    }
}

/// Settings of a landing but for its tolerance.
pub fn settings(tolerance: f64) -> Result<Settings, Invalid> {
    Settings::new(
        tolerance,
        Settings::DEFAULT_TIME_LIMIT,
        CrushRule::default(),
    )
}
