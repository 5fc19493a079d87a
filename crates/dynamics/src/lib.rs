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
//! # One landing
//!
//! The parts of a lander are plain numbers ([`parts`]). [`vehicle::Leg`], [`vehicle::Vehicle`] and [`scene::Scene`] check
//! them once; whatever is out of its range is an [`invalid::Invalid`] that names it.
//!
//! ```
#![doc = include_str!("../examples/lander/mod.rs")]
//!
//! use touchdown_dynamics::land::land;
//! use touchdown_dynamics::outcome::Class;
//! use touchdown_dynamics::scene::Settings;
//!
//! fn main() -> Result<(), Invalid> {
//!     let landing = land(&four_legs()?, &downhill(4.0)?, &Settings::default());
//!     assert_eq!(landing.outcome.class(), Class::Stable);
//!     assert!(landing.max_stroke_share.iter().all(|share| *share < 0.6));
//!     // The account of the energies closes.
//!     assert!(landing.energies.closure().abs() < 1e-3);
//!     Ok(())
//! }
//! ```
//!
//! [`land::land_observed`] reports the state every so many seconds: the examples `landing` (a history) and `observer` (the
//! loads on a payload) use it.
//!
//! # Many landings
//!
//! [`batch::land_many`] takes several landings side by side through the lanes of vector registers, with the same bits.
//!
//! ```
//! # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/lander/mod.rs"));
//! use std::sync::Arc;
//!
//! use touchdown_dynamics::batch::{Request, land_many};
//! use touchdown_dynamics::outcome::Class;
//! use touchdown_dynamics::scene::Settings;
//!
//! # fn main() -> Result<(), Invalid> {
//! let vehicle = Arc::new(four_legs()?);
//! let scenes = (0..24).map(|speed| downhill(f64::from(speed)));
//! let scenes: Vec<Scene> = scenes.collect::<Result<_, _>>()?;
//! let mut requests = scenes.iter().enumerate().map(|(speed, scene)| Request {
//!     key: speed,
//!     vehicle: Arc::clone(&vehicle),
//!     scene: *scene,
//!     settings: Settings::default(),
//! });
//! let mut bottoming = Vec::new();
//! land_many(&mut || requests.next(), &mut |speed, landing| {
//!     if landing.outcome.class() == Class::Bottomed {
//!         bottoming.push(speed);
//!     }
//! });
//! // It does not topple; from 17 ft/s on a strut bottoms.
//! assert_eq!(bottoming.iter().min(), Some(&17));
//! # Ok(())
//! # }
//! ```
//!
//! The crate `touchdown-sweep` reads landers from files, searches the speed at which they topple, and sweeps it.
//!
//! # Features and versions
//!
//! `serde` makes results serializable. Until version 1.0 a new minor version may change the interface. What changes any bit
//! of a result raises [`model_version::MODEL_VERSION`].
//!
//! # Layout
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
//! | `design` | plain data of a lander | [`parts`], [`quantities`], [`profile`], [`crush_load`], [`attitude`], [`rules`], [`invalid`] |
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

pub use design::{attitude, crush_load, invalid, parts, profile, quantities, quantity, rules};
pub use equations::{kinematics, motion, response, state};
pub use lander::{error_control, ground, method, scene, settings, thrust, vehicle};
pub use landing::{critical_feet, energy, record, stability, touchdown};
pub use laws::{contact, crush, friction, hinge, leg_pieces, outcome, signal, strut};
pub use numbers::{extremes, lanes, per_leg, products, registers, scalar};
