//! Touchdown dynamics of legged landers.
//!
//! A rigid body on hinged legs with shock absorbers, or on tripod or cantilever legs, crushable footpads and body blocks touches a
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
//! # How a landing is computed
//!
//! **One way to compute a landing.** The equations are written once over a number type (`scalar::Real`): `f64` for a landing
//! alone, `Lanes<N>` for 2, 4 or 8 landings. Legs follow one another in loops; a vehicle has 3 to 8 of them (`PerLeg`), counted at
//! run time. In a batch (`batch.rs`) each landing has its own time, step length, laws and events. Those whose next steps are of one
//! kind, explicit or implicit, take them together in lanes; what follows a step is done one by one by the same code as alone
//! (`landing/simulation`), compiled for the registers of a single landing. The widest registers of the processor are found at run
//! time (`registers`), and each width is compiled for its own instruction set. Nothing is contracted or reordered, and elementary
//! functions come from `libm`, so every bit is the same for any width, neighbour and machine (`tests/suite/batch.rs`).
//!
//! **The mode is data.** Every law is piecewise smooth. Each law's file has a small state machine that knows its active piece
//! (crushing front or elastic line, table segment, friction branch, stroke or rebound, stop) and gives three things: the
//! *coefficients* of that piece, the *range* of each signal over which they hold, and the *next piece* when a signal leaves its
//! range. The equations of motion are arithmetic in the coefficients. An event is a signal that leaves its range; there is no
//! other kind.
//!
//! **Events are located, not sampled.** After each accepted step the signals of all legs are compared with their ranges
//! (`integrator/ranges`). Interferences and strokes come with their rates, so the cubic through both ends of the step tells whether
//! they stay or where they leave (`integrator/cubic`). Where that is doubtful, the middle of the step is evaluated too. The first exit is
//! located on the dense output to 1e-3 s times the tolerance, and the step ends just beyond it. Ranges are widened by a slack far
//! above rounding and far below anything physical, and the next range reaches back by as much: the side after an event is known,
//! and a root cannot fire twice. Then the laws *settle* (`landing/events`): one change may bring another, until every signal lies
//! in its range.
//!
//! **Verdicts are events too**, but they change no law: critical feet, the plane of motion, calm and σ, or under the rule `"hull"` σ alone, are followed over each step's
//! dense output without restarting the integration (`landing/verdict`). Not located are rest on supports (`landing/rest`), endless slides (`landing/steadiness`) and toppling of a vehicle
//! that touched down beyond its feet: they last, so they are asked for at ends of steps. **Extremes lie within steps**: parabolas close in on a least
//! σ or clearance and on a greatest strut force; steps that may hide one are kept until it is known not to matter (`landing/hidden_forces`).
//!
//! **Stiff are a few directions.** A foot stuck by friction slows at thousands per second, and links and pads swing on the elasticity
//! of what is pressed in. All of it acts through a few quantities a leg, whose force derivatives `response` holds. Where the fastest
//! decay times the step exceeds 2.5 (`landing/stiffness`), the step is linearly implicit (Rodas4P2 of Steinebach): legs touch the body but
//! not each other, so each stage solves six equations.
//!
//! **Contact at the face is a variant of the equations** (`motion/face`), compiled beside that of 1966, which pays nothing for it. A batch has the rule
//! of its first landing in its lanes; others land alone.
//!
//! **Legs of three struts are a second set of equations** (`equations/three_struts`, `laws/three_struts`, `landing/three_struts`). What follows a step is the
//! same where it knows no legs: event location, the hull of the feet, rest on supports, histories, results. Their landings are computed alone.
//!
//! **What has a closed form is not integrated.** While all legs hang, steps follow the body's parabola, the power series of its rotation
//! and the exponentials of its links (`motion/free_flight`). A pad that presses on a stop is carried by what it has *turned*; its
//! angle follows (`hinge`).
//!
//! **The integrators of 1966 stand beside it** (`methods/`). They choose each law's piece from the state at every evaluation
//! (`contact/choice`) and judge at the starts of intervals, as the report's program did.
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
//! | [`landing`] | one landing: steps, events, verdicts, its account | [`touchdown`], [`energy`], `critical_feet`, [`stability`], [`record`] |
//! | `equations` | kinematics and equations of motion | [`state`], [`kinematics`], [`motion`], [`response`] |
//! | `lander` | vehicle and touchdown, checked; settings | [`vehicle`], [`scene`], [`ground`], [`thrust`], `settings`, [`method`] |
//! | `laws` | the laws of a leg | [`crush`], [`friction`], [`strut`], [`hinge`], [`contact`], [`leg_pieces`], `signal`, [`outcome`] |
//! | `design` | plain data of a lander | [`parts`], [`quantities`], [`profile`], [`crush_load`], [`attitude`], [`rules`], [`soil`], [`invalid`] |
//! | [`integrator`] | methods, dense output, step control, event location: knows nothing of legs | |
//! | `numbers` | scalars, lanes, registers, one item per leg, legs in lanes | [`scalar`], [`lanes`], [`registers`], [`per_leg`], `quads`, `products` |

#![warn(unnameable_types)]
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

pub use design::{
    attitude, crush_load, invalid, parts, profile, quantities, quantity, rules, soil, three_struts,
};
pub use equations::{kinematics, motion, response, state};
pub use lander::{ground, method, scene, three_strut_leg, thrust, vehicle};
use landing::critical_feet;
pub use landing::{energy, record, stability, touchdown};
use laws::signal;
pub use laws::{contact, crush, friction, hinge, leg_pieces, outcome, strut};
use numbers::{extremes, products, quads};
pub use numbers::{lanes, per_leg, registers, scalar};
