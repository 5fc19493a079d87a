//! The crate diffsol: Tsitouras's method of order 5.

use std::cell::RefCell;

use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason, VectorCommon};

use crate::plain_landing::PlainLanding;
use crate::variables::COUNT;

/// Integrates a landing; its variables at the end.
pub fn integrate(landing: &mut PlainLanding, tolerance: f64) -> Result<[f64; COUNT], String> {
    let (first, last) = (landing.start(), landing.last());
    let landing = RefCell::new(landing);
    let told = |error: diffsol::DiffsolError| error.to_string();
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .rhs(|y, _, _, slope| landing.borrow().derivative(y, slope))
        .init(|_, _, y| y.copy_from_slice(&first), COUNT)
        .build()
        .map_err(told)?;
    let mut solver = problem.tsit45().map_err(told)?;
    solver.set_stop_time(last).map_err(told)?;
    loop {
        let reason = solver.step().map_err(told)?;
        let y = solver.state().y.inner().as_slice();
        let ends = landing.borrow_mut().accept(y);
        if ends || reason == OdeSolverStopReason::TstopReached {
            let mut variables = [0.0; COUNT];
            variables.copy_from_slice(y);
            return Ok(variables);
        }
    }
}
