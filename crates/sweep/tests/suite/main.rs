//! Tests of whole searches and of input files, in one program.

mod disputed;
mod fuzz;
mod hidden_bands;
mod place;
mod reference_of_keys;
mod search_switches;
mod sensitivity;
mod si_units;
