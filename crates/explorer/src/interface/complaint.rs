//! Reasons why a request has no answer.

use serde_json::json;
use touchdown_input::documents::input_error::InputError;

use crate::named::Results;

/// Kind of error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// The request is invalid.
    Request,
    /// No request has this name.
    Unknown,
    /// The answer is no longer wanted.
    Over,
    /// A fault of the program.
    Engine,
}

/// Reason why a request has no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    /// Kind.
    pub fault: Fault,
    /// Message, in the words of the command line.
    pub message: String,
    /// Name of the number concerned, if any.
    pub key: Option<String>,
    /// Its value.
    pub value: Option<String>,
    /// Allowed values.
    pub allowed: Option<String>,
}

impl Complaint {
    /// Any fault of a request.
    pub fn request(message: impl Into<String>) -> Self {
        Self {
            fault: Fault::Request,
            message: message.into(),
            key: None,
            value: None,
            allowed: None,
        }
    }

    /// A member of a request has a value that is not allowed.
    pub fn value(key: &str, value: impl std::fmt::Display, allowed: &str) -> Self {
        InputError::value(key, value, allowed).into()
    }

    /// No request has this name.
    pub fn unknown(name: &str, known: &[&str]) -> Self {
        Self {
            fault: Fault::Unknown,
            ..Self::value(
                "request",
                format!("{name:?}"),
                &format!("one of {}", known.join(", ")),
            )
        }
    }

    /// The answer is no longer wanted.
    pub fn over() -> Self {
        Self {
            fault: Fault::Over,
            ..Self::request("the answer took too long, or nobody waits for it")
        }
    }

    /// A fault of the program.
    pub fn engine(said: impl std::fmt::Display) -> Self {
        Self {
            fault: Fault::Engine,
            ..Self::request(format!("this is a fault of the program: {said}"))
        }
    }

    /// The same, about a number with this name.
    #[must_use]
    pub fn about(self, key: &str) -> Self {
        Self {
            key: Some(key.to_owned()),
            ..self
        }
    }

    /// The error as sent to pages.
    pub fn json(&self) -> String {
        let error = json!({
            "message": self.message,
            "key": self.key,
            "value": self.value,
            "allowed": self.allowed,
        });
        json!({ "error": error }).to_string()
    }
}

impl From<InputError> for Complaint {
    fn from(error: InputError) -> Self {
        let subject = error.subject();
        Self {
            key: subject.map(|subject| subject.key.clone()),
            value: subject.and_then(|subject| subject.value.clone()),
            allowed: subject.map(|subject| subject.allowed.clone()),
            ..Self::request(error.to_string())
        }
    }
}

/// A complaint about a table.
pub fn of_table(results: &Results, error: impl std::fmt::Display) -> Complaint {
    Complaint::request(format!("{}: {error}", results.file))
}
