//! One landing on legs of three struts: steps, events, verdict, account.
//!
//! Feet are light and held by stiff struts and by friction, so that every step is linearly implicit. Events are located as
//! those of hinged legs are; toppling and rest are judged by the rules that hold for any lander ([`Rules::PHYSICAL`]).
//!
//! [`Rules::PHYSICAL`]: crate::rules::Rules::PHYSICAL

mod account;
mod extremes;
mod peaks;
mod simulation;
mod standing;
mod step_attempt;

pub(super) use simulation::Simulation;
