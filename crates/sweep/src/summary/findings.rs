//! The result of a point, and its encoding in a journal.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::Outcome;

use crate::boundary::Boundary;
use crate::contact_warnings::ContactWarnings;
use crate::landing_table::{self, Cell};
use crate::sensitivity::Sensitivity;

/// The result of a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Finding {
    /// Result of a search for the boundary of stable landings.
    Boundary(Boundary),
    /// One landing.
    Landing {
        /// Outcome.
        outcome: Outcome,
        /// Results in the order of [`crate::landing_table`].
        cells: Vec<Cell>,
        /// Contact warnings.
        warnings: ContactWarnings,
    },
    /// Result of a search, with sensitivities of the transition.
    Sensitive {
        /// The search.
        boundary: Boundary,
        /// The sensitivities.
        sensitivity: Sensitivity,
    },
}

impl Finding {
    /// The result of one landing.
    pub fn of(landing: &Landing) -> Self {
        let columns = landing_table::columns(landing).into_iter();
        Self::Landing {
            outcome: landing.outcome.clone(),
            cells: columns.map(|(_, cell)| cell).collect(),
            warnings: ContactWarnings::of(landing),
        }
    }

    /// Result of the search, for boundary sweeps.
    pub fn boundary(&self) -> Option<&Boundary> {
        match self {
            Self::Boundary(boundary) | Self::Sensitive { boundary, .. } => Some(boundary),
            Self::Landing { .. } => None,
        }
    }

    /// Contact warnings of its landings.
    pub fn warnings(&self) -> ContactWarnings {
        match self {
            Self::Boundary(boundary) | Self::Sensitive { boundary, .. } => boundary.warnings,
            Self::Landing { warnings, .. } => *warnings,
        }
    }

    /// Landings computed for it.
    pub fn landings(&self) -> u64 {
        match self {
            Self::Boundary(boundary) => boundary.landings,
            Self::Sensitive {
                boundary,
                sensitivity,
            } => boundary.landings + sensitivity.landings,
            Self::Landing { .. } => 1,
        }
    }

    /// Evaluations of the equations of motion for it.
    pub fn evaluations(&self) -> u64 {
        match self {
            Self::Boundary(boundary) => boundary.evaluations,
            Self::Sensitive {
                boundary,
                sensitivity,
            } => boundary.evaluations + sensitivity.evaluations,
            // The last count of a row, after the steps.
            Self::Landing { cells, .. } => {
                let count = |cell: &Cell| match cell {
                    Cell::Count(count) => Some(*count),
                    _ => None,
                };
                cells.iter().rev().find_map(count).unwrap_or(0)
            }
        }
    }

    /// Encodes it as the bytes of a record; numbers keep every bit.
    pub fn encode(&self) -> Vec<u8> {
        // Encoding these types in memory cannot fail.
        postcard::to_stdvec(self).unwrap_or_default()
    }

    /// Decodes the bytes of a record; `None` if they are not a result.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        match postcard::take_from_bytes(bytes) {
            Ok((finding, [])) => Some(finding),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bands::Band;
    use crate::boundary::Transition;
    use crate::certainty::Certainty;
    use crate::hidden_band_checks::{CheckCounts, HiddenBandChecks};
    use crate::skipped::Skipped;
    use touchdown_dynamics::outcome::{Class, Failure};

    #[test]
    fn every_bit_survives() {
        let boundary = Finding::Boundary(Boundary {
            transition: Some(Transition {
                to: Class::Failure,
                low: Some(0.1 + 0.2),
                high: f64::MIN_POSITIVE,
                tolerance: 1e-9,
                certainty: Certainty::Disputed([1.0, 2.0]),
            }),
            searched_to: 25.0,
            bands: vec![Band {
                from: -0.0,
                to: 1.0 / 3.0,
                class: Class::Bottomed,
                outcome: Outcome::Failure(Failure::PadInclination { leg: 2 }),
                bracket: None,
                certainty: Certainty::Certain,
            }],
            checks: HiddenBandChecks {
                stroke: CheckCounts {
                    checks: 3,
                    finds: 1,
                },
                ..HiddenBandChecks::default()
            },
            skipped: Skipped {
                left_out: -1,
                interpolated: i64::MIN,
                ..Skipped::default()
            },
            searched_again: 2,
            disputed: 1,
            tests: 9,
            landings: 1 << 40,
            evaluations: u64::MAX,
            warnings: ContactWarnings::default(),
        });
        let landing = Finding::Landing {
            outcome: Outcome::Bottomed { leg: 1 },
            cells: vec![
                Cell::Word("ä".to_owned()),
                Cell::Number(-0.0),
                Cell::Count(7),
            ],
            warnings: ContactWarnings {
                given: 1.0 / 3.0,
                is_crushed_through: true,
            },
        };
        for finding in [boundary, landing] {
            let bytes = finding.encode();
            assert_eq!(
                format!("{:?}", Finding::decode(&bytes)),
                format!("{:?}", Some(finding))
            );
            assert_eq!(Finding::decode(&bytes[..bytes.len() - 1]), None);
            assert_eq!(Finding::decode(&[bytes, vec![0]].concat()), None);
        }
    }
}
