//! Why a request has no answer.

use serde_json::json;
use touchdown_sweep::input_error::InputError;

/// What kind of complaint it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// The request cannot be used.
    Request,
    /// There is no request of that name.
    Unknown,
    /// Nobody waits for the answer any longer.
    Over,
    /// The program is to blame.
    Engine,
}

/// Why a request has no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    /// What kind it is.
    pub fault: Fault,
    /// What is wrong, in the words of the command line.
    pub message: String,
    /// The number that it is about, if it is about one.
    pub key: Option<String>,
    /// Its value.
    pub value: Option<String>,
    /// What is allowed.
    pub allowed: Option<String>,
}

impl Complaint {
    /// Anything that is wrong with a request.
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

    /// There is no request of that name.
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

    /// Nobody waits any longer.
    pub fn over() -> Self {
        Self {
            fault: Fault::Over,
            ..Self::request("the answer took too long, or nobody waits for it")
        }
    }

    /// The program is to blame.
    pub fn engine(said: impl std::fmt::Display) -> Self {
        Self {
            fault: Fault::Engine,
            ..Self::request(format!("this is a fault of the program: {said}"))
        }
    }

    /// The same about a number of this name.
    #[must_use]
    pub fn about(self, key: &str) -> Self {
        Self {
            key: Some(key.to_owned()),
            ..self
        }
    }

    /// The complaint as pages read it.
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
