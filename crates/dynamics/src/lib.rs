//! Touchdown dynamics of legged landers.
//!
//! A rigid body on hinged legs with shock absorbers, crushable footpads and body blocks touches a
//! sloping surface with friction; [`land::land`] integrates from first contact until the
//! vehicle has come to rest, toppled, or bottomed a strut. The model is that of Bendix report
//! MM-66-19 (1966); numbers in parentheses in the documentation are its equations.
//!
//! Units are foot, slug, pound, second and radian throughout. Nothing here reads or writes files, starts threads, or
//! looks at a clock. A landing is plain IEEE arithmetic in a fixed order, its elementary functions included, so it
//! comes out the same, bit for bit, on every machine. The standard library's elementary functions are the machine's own
//! and are not allowed here (`clippy.toml`).
//!
//! The crate has floors, each of which knows only those below it (`scripts/floors.py` checks that):
//!
//! | floor | what | modules |
//! |---|---|---|
//! | [`batch`] | many landings, a lane of a register for each | |
//! | [`land`], [`methods`], [`impact_surface`] | one landing by any method; the methods of 1966; the surface from impact times | |
//! | [`landing`] | one landing: steps, events, verdicts, its account | [`touchdown`], [`energy`], [`critical_feet`], [`stability`], [`record`] |
//! | `equations` | kinematics and equations of motion | [`state`], [`kinematics`], [`motion`], [`response`] |
//! | `lander` | vehicle and touchdown, checked; settings | [`vehicle`], [`scene`], [`ground`], [`thrust`], [`settings`], [`method`], [`error_control`] |
//! | `laws` | the laws of a leg | [`crush`], [`friction`], [`strut`], [`hinge`], [`contact`], [`leg_pieces`], [`signal`], [`outcome`] |
//! | `design` | plain data of a lander | [`parts`], [`profile`], [`crush_load`], [`attitude`], [`rules`], [`invalid`] |
//! | [`integrator`] | methods, dense output, step control, event location: knows nothing of legs | |
//! | `numbers` | scalars, lanes, registers, one item per leg | [`scalar`], [`lanes`], [`registers`], [`per_leg`], [`products`] |

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod design;
mod equations;
mod lander;
mod laws;
mod numbers;

pub mod batch;
pub mod impact_surface;
pub mod integrator;
pub mod land;
pub mod landing;
pub mod methods;
pub mod model_version;

pub use design::{attitude, crush_load, invalid, parts, profile, rules};
pub use equations::{kinematics, motion, response, state};
pub use lander::{error_control, ground, method, scene, settings, thrust, vehicle};
pub use landing::{critical_feet, energy, record, stability, touchdown};
pub use laws::{contact, crush, friction, hinge, leg_pieces, outcome, signal, strut};
pub use numbers::{extremes, lanes, per_leg, products, registers, scalar};
