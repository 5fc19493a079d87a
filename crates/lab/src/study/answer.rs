//! What the results say to a claim.

use touchdown_figures::boundary_table::Transition;

/// Whether a claim holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Agrees,
    InPart,
    Differs,
}

impl Verdict {
    /// `Agrees` where all of a claim holds, `InPart` where some of it does, else `Differs`.
    pub fn of(parts: &[bool]) -> Self {
        match (parts.iter().all(|holds| *holds), parts.contains(&true)) {
            (true, _) => Self::Agrees,
            (false, true) => Self::InPart,
            (false, false) => Self::Differs,
        }
    }

    pub fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::InPart => "in part",
            Self::Differs => "**differs**",
        }
    }
}

/// An answer to a claim.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Name of the result table or landing that it rests on.
    pub source: &'static str,
    /// Our number, with its conditions.
    pub number: String,
    pub verdict: Verdict,
    /// Why it is so.
    pub why: &'static str,
}

/// A transition as a number, or the word for none.
pub fn speed(transition: Option<Transition>) -> String {
    transition.map_or("none".to_owned(), |transition| {
        format!("{:.2}", transition.speed)
    })
}

/// A number with a true minus sign.
pub fn signed(number: f64) -> String {
    touchdown_figures::label(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_of_parts_may_hold_in_part() {
        assert_eq!(Verdict::of(&[true, true]), Verdict::Agrees);
        assert_eq!(Verdict::of(&[true, false]), Verdict::InPart);
        assert_eq!(Verdict::of(&[false]), Verdict::Differs);
    }
}
