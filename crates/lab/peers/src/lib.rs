//! The landings of `touchdown-lab work-precision` by integrators of other people, and by ours.
//!
//! `compare.py` measures and prints; this module gives it the landings: whole ones by the crates
//! ode_solvers and diffsol and by `touchdown`, and their right-hand side for SciPy.

mod case;
mod diffsol_tsit45;
mod integrator;
mod ode_solvers_dopri5;
mod plain_landing;
mod variables;

#[pyo3::pymodule]
mod touchdown_peers {
    #[pymodule_export]
    use crate::case::{Case, PlainCase, cases};
}
