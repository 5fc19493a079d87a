//! The interface of the explorer as a WebAssembly module, so that an exported page computes landings itself.
//!
//! Texts go through two buffers: a caller makes room with `explorer_input`, writes there, calls, and reads as many bytes as
//! the call says from `explorer_output`.

#![cfg(target_family = "wasm")]
// A name that a module exports must not be mangled, which is an unsafe attribute because two such names could clash: these
// begin with the name of this crate. Nothing else here is unsafe.
#![expect(unsafe_code, reason = "exported names")]

use std::sync::{Mutex, MutexGuard, PoisonError};

use serde::Deserialize;
use touchdown_explorer::interface::{self, Complaint};
use touchdown_explorer::named::Named;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::documents::output_units::OutputUnits;

static INPUT: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static OUTPUT: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static NAMED: Mutex<Option<Named>> = Mutex::new(None);

/// What an exported page explores: files as they were named, with copies of all that were read.
#[derive(Deserialize)]
struct Opened {
    files: Vec<std::path::PathBuf>,
    copies: Vec<Copy>,
    units: OutputUnits,
}

#[derive(Deserialize)]
struct Copy {
    path: std::path::PathBuf,
    text: String,
}

/// Makes room for an input of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn explorer_input(length: usize) -> *mut u8 {
    let mut input = held(&INPUT);
    input.resize(length, 0);
    input.as_mut_ptr()
}

/// Where the output is.
#[unsafe(no_mangle)]
pub extern "C" fn explorer_output() -> *const u8 {
    held(&OUTPUT).as_ptr()
}

/// Reads what is to be explored. The output is a complaint; of no bytes where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn explorer_open() -> usize {
    let opened = open(&held(&INPUT));
    let said = match opened {
        Ok(named) => {
            *held(&NAMED) = Some(named);
            String::new()
        }
        Err(complaint) => complaint.json(),
    };
    put_out(said)
}

/// Answers the request that the input holds behind its name of so many bytes. The output is the answer or a complaint.
#[unsafe(no_mangle)]
pub extern "C" fn explorer_answer(name_length: usize) -> usize {
    let answered = answer(&held(&INPUT), name_length);
    put_out(answered.unwrap_or_else(|complaint| complaint.json()))
}

fn open(input: &[u8]) -> Result<Named, Complaint> {
    let not_so = |error| Complaint::request(format!("not an exported page: {error}"));
    let opened: Opened = serde_json::from_slice(input).map_err(not_so)?;
    let copies = opened.copies.into_iter();
    let copies: Vec<Source> = copies
        .map(|Copy { path, text }| Source { path, text })
        .collect();
    let library = Library::Copies(&copies);
    Ok(Named::read(&opened.files, library, Some(opened.units))?)
}

fn answer(input: &[u8], name_length: usize) -> Result<String, Complaint> {
    let (name, request) = input.split_at_checked(name_length).unwrap_or((input, &[]));
    let text = |bytes| {
        std::str::from_utf8(bytes).map_err(|_| Complaint::request("not a request: expected UTF-8"))
    };
    match &*held(&NAMED) {
        Some(named) => interface::answer(named, text(name)?, text(request)?, &|| false),
        None => Err(Complaint::request("nothing is open")),
    }
}

fn put_out(text: String) -> usize {
    let mut output = held(&OUTPUT);
    *output = text.into_bytes();
    output.len()
}

/// There is one thread: nobody else holds it, and a panic ends the module.
fn held<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}
