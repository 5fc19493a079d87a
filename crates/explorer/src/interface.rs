//! The requests of a page: a name and a JSON text, answered by a JSON text.
//!
//! An answer depends only on the request and the named files: not on other files, clocks or threads.

mod bands;
mod bins;
mod complaint;
mod computed;
mod in_units;
mod inputs;
mod landing;
mod map;
mod parameters;
mod request;
mod rows;
mod sample;
mod search;
mod strip;
mod take_away;
mod touchdown;

use crate::named::Named;

pub use complaint::{Complaint, Fault};

/// Names of all requests.
pub const NAMES: [&str; 14] = [
    "inputs",
    "parameters",
    "landing",
    "strip",
    "bands",
    "boundary",
    "map",
    "at",
    "sample",
    "bins",
    "table_file",
    "scene_file",
    "history_file",
    "command",
];

/// Asked before every step of a landing and between those of a strip; true once the answer is no longer wanted.
pub type IsOver<'a> = &'a dyn Fn() -> bool;

/// Answers a request.
///
/// # Errors
/// The reason why there is no answer, in the words of the command line.
pub fn answer(
    named: &Named,
    name: &str,
    request: &str,
    is_over: IsOver,
) -> Result<String, Complaint> {
    match name {
        "inputs" => inputs::answer(named, request),
        "parameters" => parameters::answer(named, request),
        "landing" => landing::answer(named, request, is_over),
        "strip" => strip::answer(named, request, is_over),
        "bands" => bands::answer(named, request, is_over),
        "boundary" => search::boundary(named, request, is_over),
        "map" => map::answer(named, request),
        "at" => map::answer_at(named, request),
        "sample" => sample::answer(named, request),
        "bins" => bins::answer(named, request),
        "table_file" => take_away::table_file(named, request),
        "scene_file" => take_away::scene_file(named, request),
        "history_file" => take_away::history_file(named, request, is_over),
        "command" => take_away::command(named, request),
        _ => Err(Complaint::unknown(name, &NAMES)),
    }
}
