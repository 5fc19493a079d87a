//! Values set on the command line of a sweep: parameters, and numbers of `[sample]`, which no landing has.

use crate::documents::document::Value;
use crate::documents::input_error::InputError;
use crate::documents::key_path::KeyPath;
use crate::points::assignment::Assignment;

/// Table of the numbers that are no parameters.
const SAMPLE: &str = "sample.";
/// Numbers of `[sample]`.
const NUMBERS: [&str; 3] = [
    "sample.count",
    "sample.seed",
    "sample.stop_at_interval_width",
];

/// A value that replaces one of a sweep file or of its vehicle.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum SetValue {
    /// Of a parameter.
    Parameter(Assignment),
    /// Of a number of `[sample]`.
    Sample(SampleNumber),
}

/// A number of `[sample]` and its value.
#[derive(Debug, Clone)]
pub struct SampleNumber {
    name: &'static str,
    text: String,
    number: f64,
}

impl SetValue {
    /// Parses `KEY=VALUE`.
    ///
    /// # Errors
    /// As [`Assignment::parse`].
    pub fn parse(text: &str) -> Result<Self, InputError> {
        match text.split_once('=') {
            Some((name, value)) => Self::new(name.trim(), value.trim()),
            None => Assignment::parse(text).map(Self::Parameter),
        }
    }

    /// Sets the parameter or the number of `[sample]` that is called `name` to the value in `text`.
    ///
    /// # Errors
    /// As [`Assignment::new`].
    pub fn new(name: &str, text: &str) -> Result<Self, InputError> {
        if !name.starts_with(SAMPLE) {
            return Assignment::new(name, text).map(Self::Parameter);
        }
        let refuse = |complaint: String| InputError::other(format!("{name} = {text}: {complaint}"));
        let Some(name) = NUMBERS.into_iter().find(|known| *known == name) else {
            let known = NUMBERS.join(", ");
            return Err(refuse(format!("cannot be set: expected one of {known}")));
        };
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Self::Sample(SampleNumber {
                name,
                text: text.to_owned(),
                number,
            })),
            _ => Err(refuse("expected a finite number".to_owned())),
        }
    }

    /// The name and the value as typed.
    pub(crate) fn said(&self) -> (String, String) {
        let (name, text) = match self {
            Self::Parameter(one) => (one.parameter().name(), one.text()),
            Self::Sample(one) => (one.name, one.text.as_str()),
        };
        (name.to_owned(), text.to_owned())
    }
}

impl SampleNumber {
    /// Its dotted name.
    pub(crate) fn name(&self) -> &'static str {
        self.name
    }

    /// Key and value for the sweep file.
    pub(crate) fn entry(&self) -> Option<(KeyPath, Value)> {
        Some((KeyPath::parse(self.name)?, Value::Number(self.number)))
    }

    /// Error that it cannot be set.
    pub(crate) fn refuse(&self, complaint: &str) -> InputError {
        InputError::other(format!("--set {}={}: {complaint}", self.name, self.text))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_a_sample_are_told_from_parameters() {
        let parsed = |text| SetValue::parse(text).unwrap();
        assert!(matches!(parsed("friction=0.5"), SetValue::Parameter(_)));
        let SetValue::Sample(count) = parsed("sample.count = 2e3") else {
            panic!("a parameter");
        };
        assert_eq!((count.name(), count.number), ("sample.count", 2000.0));
        for (text, fragment) in [
            ("sample.cuont=5", "one of sample.count, sample.seed"),
            (
                "sample.count=many",
                "sample.count = many: expected a finite number",
            ),
            ("sample.count", "KEY=VALUE"),
        ] {
            let complaint = SetValue::parse(text).unwrap_err().to_string();
            assert!(complaint.contains(fragment), "{complaint}");
        }
    }
}
