//! Outcomes of landings (model chapter 7).

use std::fmt;

/// The end of a landing. Feet and legs are counted from 0 here and from 1 in every output.
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// The vehicle rocked up, did not topple, and came back onto other feet.
    StableRockback,
    /// Motion subsided near the ground.
    StableSubsided,
    /// The CG passed outboard of the critical feet.
    UnstablePitch,
    /// All feet came to one side of the plane of motion.
    UnstableYaw,
    /// The strut of this leg reached its least length.
    Bottomed {
        /// Index of the leg, from 0.
        leg: usize,
    },
    /// The footpad of this leg was crushed by its whole height ([`crate::rules::ContactRule::Face`]).
    BottomedPad {
        /// Index of the leg, from 0.
        leg: usize,
    },
    /// The block of this leg was crushed by its whole height ([`crate::rules::ContactRule::Face`]).
    BottomedBlock {
        /// Index of the leg, from 0.
        leg: usize,
    },
    /// None of these came before the time limit.
    TimeExpired,
    /// The landing could not be computed to its end.
    Failure(Failure),
    /// It slides steadily down a slope on which friction cannot stop it.
    Sliding,
    /// It stood or slid steadily and upright, far from toppling: a landing of a scan goes no further.
    StableSteady,
    /// The vertical through the CG left the convex hull of all feet in plan.
    UnstableToppled,
}

/// Why a landing could not be computed to its end.
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Failure {
    /// A loaded footpad inclined more than 65 deg, where the model has no law.
    PadInclination {
        /// Index of the leg, from 0.
        leg: usize,
    },
    /// The step size fell below what the time can resolve.
    StepCollapse,
    /// More steps than any landing needs.
    StepLimit,
    /// A number left the representable range.
    NonFinite,
    /// The laws kept switching without time advancing.
    Chattering,
    /// At first contact the ground under a leg reaches above its lower hardpoint, into the body.
    GroundInBody {
        /// Index of the leg, from 0.
        leg: usize,
    },
}

/// Coarse class of an outcome: the classes that a boundary search distinguishes.
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Class {
    /// Came back onto its feet or came to rest.
    Stable,
    /// Toppled, in pitch or in yaw.
    Unstable,
    /// A strut, a footpad or a block used up its travel.
    Bottomed,
    /// Could not be computed.
    Failure,
    /// Still moved at the time limit, or slides without end: neither stable nor toppled.
    Undecided,
}

impl Outcome {
    /// All outcomes of vehicles with up to `legs` legs; of failures, whose word is the same, one.
    pub fn all(legs: usize) -> Vec<Self> {
        let of_a_leg = |leg| {
            [
                Self::Bottomed { leg },
                Self::BottomedPad { leg },
                Self::BottomedBlock { leg },
            ]
        };
        let others = [
            Self::StableRockback,
            Self::StableSubsided,
            Self::StableSteady,
            Self::UnstablePitch,
            Self::UnstableYaw,
            Self::UnstableToppled,
            Self::Sliding,
            Self::TimeExpired,
            Self::Failure(Failure::NonFinite),
        ];
        let of_legs = (0..legs).flat_map(of_a_leg);
        others.into_iter().chain(of_legs).collect()
    }

    /// The class of this outcome.
    pub fn class(&self) -> Class {
        match self {
            Self::StableRockback | Self::StableSubsided | Self::StableSteady => Class::Stable,
            Self::TimeExpired | Self::Sliding => Class::Undecided,
            Self::UnstablePitch | Self::UnstableYaw | Self::UnstableToppled => Class::Unstable,
            Self::Bottomed { .. } | Self::BottomedPad { .. } | Self::BottomedBlock { .. } => {
                Class::Bottomed
            }
            Self::Failure(_) => Class::Failure,
        }
    }
}

impl Class {
    /// All classes.
    pub const ALL: [Self; 5] = [
        Self::Stable,
        Self::Unstable,
        Self::Bottomed,
        Self::Failure,
        Self::Undecided,
    ];

    /// The class of an outcome known only by its word; `None` for other words.
    pub fn of_outcome(word: &str) -> Option<Self> {
        let undecided = [Outcome::TimeExpired, Outcome::Sliding];
        if undecided.iter().any(|outcome| outcome.to_string() == word) {
            return Some(Self::Undecided);
        }
        // The word of any other outcome begins with that of its class.
        let first = word.split('-').next()?;
        Self::ALL
            .into_iter()
            .find(|class| class.to_string() == first)
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StableRockback => f.write_str("stable-rockback"),
            Self::StableSubsided => f.write_str("stable-subsided"),
            Self::UnstablePitch => f.write_str("unstable-pitch"),
            Self::UnstableYaw => f.write_str("unstable-yaw"),
            Self::Bottomed { leg } => write!(f, "bottomed-leg-{}", leg + 1),
            Self::BottomedPad { leg } => write!(f, "bottomed-pad-{}", leg + 1),
            Self::BottomedBlock { leg } => write!(f, "bottomed-block-{}", leg + 1),
            Self::TimeExpired => f.write_str("time-expired"),
            Self::Failure(_) => f.write_str("failure"),
            Self::Sliding => f.write_str("sliding"),
            Self::StableSteady => f.write_str("stable-steady"),
            Self::UnstableToppled => f.write_str("unstable-toppled"),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::PadInclination { leg } => {
                write!(f, "loaded footpad {} inclined more than 65 deg", leg + 1)
            }
            Self::StepCollapse => f.write_str("integration step collapsed"),
            Self::StepLimit => f.write_str("too many integration steps"),
            Self::NonFinite => f.write_str("a state is no longer finite"),
            Self::GroundInBody { leg } => write!(
                f,
                "ground under leg {} reaches into the body at first contact",
                leg + 1
            ),
            Self::Chattering => f.write_str("contact laws chatter without advancing in time"),
        }
    }
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable",
            Self::Bottomed => "bottomed",
            Self::Failure => "failure",
            Self::Undecided => "undecided",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::per_leg::MOST_LEGS;

    #[test]
    fn words_of_outcomes_tell_their_classes() {
        for outcome in Outcome::all(MOST_LEGS) {
            let class = Class::of_outcome(&outcome.to_string());
            assert_eq!(class, Some(outcome.class()), "{outcome}");
        }
        assert_eq!(Class::of_outcome("upside-down"), None);
    }
}
