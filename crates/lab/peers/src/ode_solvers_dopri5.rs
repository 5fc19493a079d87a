//! The crate ode_solvers: Dormand and Prince's method of order 5.

use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dopri5, SVector, System};

use crate::plain_landing::PlainLanding;
use crate::variables::COUNT;

type Variables = SVector<f64, COUNT>;

/// Parameters that are its defaults, as `Dopri5::new` has them.
const SAFETY: f64 = 0.9;
const BETA: f64 = 0.04;
const LEAST_FACTOR: f64 = 0.2;
const GREATEST_FACTOR: f64 = 10.0;
/// Chosen by the method itself.
const FIRST_STEP: f64 = 0.0;
const MOST_STEPS: u32 = 1_000_000;
/// Steps between tests for stiffness, which would end a landing that rocks on sticking feet.
const NEVER: u32 = u32::MAX;

struct Landing<'a>(&'a mut PlainLanding);

impl System<f64, Variables> for Landing<'_> {
    fn system(&self, _time: f64, y: &Variables, slope: &mut Variables) {
        self.0.derivative(y.as_slice(), slope.as_mut_slice());
    }

    fn solout(&mut self, _time: f64, y: &Variables, _slope: &Variables) -> bool {
        self.0.accept(y.as_slice())
    }
}

/// Integrates a landing; its variables at the end.
pub fn integrate(landing: &mut PlainLanding, tolerance: f64) -> Result<[f64; COUNT], String> {
    let (first, last) = (Variables::from(landing.start()), landing.last());
    let mut solver = Dopri5::from_param(
        Landing(landing),
        0.0,
        last,
        0.0,
        first,
        tolerance,
        tolerance,
        SAFETY,
        BETA,
        LEAST_FACTOR,
        GREATEST_FACTOR,
        last,
        FIRST_STEP,
        MOST_STEPS,
        NEVER,
        OutputType::Sparse,
    );
    solver.integrate().map_err(|error| error.to_string())?;
    match solver.y_out().last() {
        Some(y) => Ok((*y).into()),
        None => Err("no step taken".to_owned()),
    }
}
