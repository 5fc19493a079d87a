//! The error of an interval as a share of the allowed error (3.3).

/// Greatest truncation errors of the variables per second of simulated time; infinite where no limit is set.
#[derive(Debug, Clone)]
pub struct ErrorCheck {
    limits: Vec<f64>,
    /// Truncation errors of the interval last checked.
    pub errors: Vec<f64>,
}

/// The greatest error as a share of the allowed one, and its variable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// The error over its limit; infinite if it is NaN.
    pub ratio: f64,
    /// Index of the variable; `None` while no error is greater than zero.
    pub variable: Option<usize>,
}

impl ErrorCheck {
    /// A check against these limits.
    pub fn new(limits: Vec<f64>) -> Self {
        Self {
            errors: Vec::with_capacity(limits.len()),
            limits,
        }
    }

    /// Checks errors that are a `fraction` of `differences`, over an interval of `length` seconds.
    pub fn worst(
        &mut self,
        length: f64,
        fraction: f64,
        differences: impl FnOnce(&mut Vec<f64>),
    ) -> Worst {
        differences(&mut self.errors);
        let mut worst = Worst {
            ratio: 0.0,
            variable: None,
        };
        for (variable, (error, limit)) in self.errors.iter_mut().zip(&self.limits).enumerate() {
            *error *= fraction;
            let ratio = error.abs() / (length * limit);
            if ratio > worst.ratio || ratio.is_nan() {
                worst = Worst {
                    ratio: if ratio.is_nan() { f64::INFINITY } else { ratio },
                    variable: Some(variable),
                };
            }
        }
        worst
    }
}
