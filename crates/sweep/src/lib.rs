//! Sweeps of lander touchdowns: from input files to result tables.
//!
//! Landings themselves are those of `touchdown-dynamics`, input files those of [`input`], searches those of [`search`]; numbers are in feet, pounds, slugs and seconds, and angles of input
//! files and tables in degrees. Results do not depend on the number of threads, on interruptions or on the machine.
//!
//! # A boundary
//!
//! V_H is the lowest horizontal velocity at which a landing is not stable. A sweep file names a vehicle, conditions, axes and
//! a search; [`threads::run::Workers`] search its points on all cores.
//!
//! ```
//! use std::path::Path;
//!
//! use touchdown_dynamics::outcome::Class;
//! use touchdown_sweep::input::sweeps::sweep_file::Sweep;
//! use touchdown_sweep::threads::run::Workers;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # std::env::set_current_dir("../..")?;
//! let sweep = Sweep::read(Path::new("sweeps/figure-4-09.toml"))?;
//! assert_eq!(sweep.place(12), "roll_deg = 0");
//! let findings = Workers::start(None)?.points(&sweep, &[12])?;
//! let boundary = findings[0].boundary().ok_or("the sweep searches no boundary")?;
//! let transition = boundary.transition.ok_or("no transition up to 25 ft/s")?;
//! assert_eq!(transition.to, Class::Unstable);
//! assert!((transition.speed() - 11.40).abs() < 0.005);
//! // Every band up to the highest speed, as bands = "all" asks for.
//! assert_eq!(boundary.bands[0].class, Class::Stable);
//! # Ok(())
//! # }
//! ```
//!
//! The example `boundaries` searches a batch of designs from files in memory, `monte_carlo` lands touchdowns at random on
//! threads of its own.
//!
//! # A sweep
//!
//! [`threads::runner`] computes a whole sweep into a journal, from which an interrupted run goes on, and writes its tables; its page
//! has the few lines that this takes. [`input::sweeps::overrides::Overrides`] replaces values as the
//! options of the command line do.
//!
//! # How a sweep is computed
//!
//! **Searches ask, threads land.** A search knows which landing it wants next only when it knows the last one, while lanes want many at
//! a time. So searches are `async` and ask at once for all landings that they will need anyway. Many searches run side by side on the
//! first thread, which lands too and keeps the journal, and what they ask for waits in the `threads/landing_queue`, the first point first. A landing does not depend
//! on its neighbours, so neither does a search.
//!
//! **Maps want points in rounds.** What is wanted of a first-level cell (`maps/cell_refinement`, `maps/interval_refinement` over one axis) depends on what is known in it alone, so
//! that threads, interruptions and shards, each of which has whole cells, change nothing. A round is what all results of the rounds
//! before call for; with a budget, the most urgent part of it (`maps/rounds`). Every place has a number in the finest grid
//! (`input/points/refined_grid`), by which the journal knows it.
//!
//! **Results outlive a crash.** A grid is never written out: a point follows from its number. Each result goes to the journal as soon as it is
//! known; tables are written from the journal in the order of the points, beside their place and then renamed. Tables of
//! cases go the same way, a row being a point.
//!
//! **Units change at the end.** Everything up to the journal is in feet and pounds. `OutputUnits::quantity` turns the name of a column
//! and its numbers into SI where tables, records and reports are written (`output/tables`, `output/landing_report`, `sweeps/input_in_units` of [`input`]), and pictures
//! take their units from the names in the tables.
//!
//! # Versions
//!
//! Until version 1.0 a new minor version may change the interface, which follows the program. Journals of another model
//! version ([`touchdown_dynamics::model_version`]) are refused.
//!
//! # Layout
//!
//! The crate has floors; each uses only those below it (checked by `scripts/floors.py`):
//!
//! | floor | content |
//! |---|---|
//! | [`threads`] | landings and searches on all cores |
//! | [`output`] | result tables, records, histories; files written completely or not at all |
//! | [`maps`] | choice of the next points of a map, its surface and edges |
//! | [`journal`] | every finished point stored at once; resuming, shards, merging |
//! | [`summary`] | results of points, and their summary |
//! | [`sensitivity`] | dependence of transitions on the input |
//!
//! Below it are two crates, shown here as [`input`] and [`search`], so that one dependency is enough.
//!
//! Nothing here prints: progress goes to a [`threads::run::Observer`], input errors are [`input::documents::input_error::InputError`]s.

#![warn(unnameable_types)]
#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

#[cfg(test)]
mod examples;
pub mod journal;
pub mod maps;
pub mod output;
pub mod sensitivity;
pub mod summary;
pub mod threads;

#[doc(no_inline)]
pub use touchdown_input as input;
#[doc(no_inline)]
pub use touchdown_search as search;
