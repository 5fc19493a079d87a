//! Touchdown dynamics of legged landers.
//!
//! A rigid body on hinged legs with shock absorbers, crushable footpads and body blocks touches a
//! sloping surface with friction; [`landing::land`] integrates from first contact until the
//! vehicle has come to rest, toppled, or bottomed a strut. The model is that of Bendix report
//! MM-66-19 (1966); numbers in parentheses in the documentation are its equations.
//!
//! Units are foot, slug, pound, second and radian throughout. Nothing here reads or writes files,
//! starts threads, or looks at a clock. A landing is plain IEEE arithmetic in a fixed order, its
//! elementary functions included, so that it comes out the same, bit for bit, on every machine; those
//! of the standard library come from the machine's own and are not allowed here (`clippy.toml`).
//!
//! | idea | module |
//! |---|---|
//! | the lander and the touchdown | [`vehicle`], [`profile`], [`scene`], [`attitude`] |
//! | where everything is | [`state`], [`kinematics`] |
//! | the laws | [`crush`], [`friction`], [`strut`], [`hinge`] |
//! | the motion, how its forces answer, and which piece of each law is active | [`motion`], [`response`], [`contact`] |
//! | the answer | [`critical_feet`], [`stability`], [`outcome`], [`touchdown`], [`landing`], [`record`] |
//! | the surface from impact times | [`impact_surface`] |
//! | how it is integrated | [`integrator`], [`model_version`] |
//! | many landings, a lane of a register for each | [`batch`], [`wide`], [`registers`] |
//! | how it was integrated in 1966, and what that was compared with | [`methods`] |

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

pub mod attitude;
pub mod batch;
pub mod contact;
pub mod critical_feet;
pub mod crush;
pub mod energy;
pub mod friction;
pub mod hinge;
pub mod impact_surface;
pub mod integrator;
pub mod invalid;
pub mod kinematics;
pub mod landing;
pub mod methods;
pub mod model_version;
pub mod motion;
pub mod outcome;
pub mod per_leg;
pub mod products;
pub mod profile;
pub mod record;
pub mod registers;
pub mod response;
pub mod scalar;
pub mod scene;
pub mod stability;
pub mod state;
pub mod strut;
pub mod touchdown;
pub mod vehicle;
pub mod wide;
