//! The equations of motion of a vehicle on legs of three struts (docs/model.md, "Legs of three struts").
//!
//! A foot is a point mass with three degrees of freedom. The struts of a leg pull and push it according to their lengths,
//! which depend on where it is seen from the body; their reaction on the body is the opposite force on the same line. A
//! kind of leg is no more than the lengths of its struts ([`struts`]).

mod bearing;
mod leg;
mod motion;
mod response;
mod state;
mod struts;

pub use motion::{Motion, Pieces, Signals};
pub use response::{Response, StageFactors};
pub use state::State;
