//! What a point came to, as the bytes of a journal's record.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::Outcome;

use crate::boundary::Boundary;
use crate::landing_table::{self, Cell};
use crate::sensitivity::Sensitivity;

/// What a point came to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Finding {
    /// Where landings cease to be stable.
    Boundary(Boundary),
    /// How one landing ended.
    Landing {
        /// Its outcome.
        outcome: Outcome,
        /// All that is told of it, as [`crate::landing_table`] orders it.
        cells: Vec<Cell>,
    },
    /// Where landings cease to be stable, and what that depends on.
    Sensitive {
        /// Where.
        boundary: Boundary,
        /// What on.
        sensitivity: Sensitivity,
    },
}

impl Finding {
    /// How one landing ended.
    pub fn of(landing: &Landing) -> Self {
        let columns = landing_table::columns(landing).into_iter();
        Self::Landing {
            outcome: landing.outcome.clone(),
            cells: columns.map(|(_, cell)| cell).collect(),
        }
    }

    /// Where landings cease to be stable, if that was asked.
    pub fn boundary(&self) -> Option<&Boundary> {
        match self {
            Self::Boundary(boundary) | Self::Sensitive { boundary, .. } => Some(boundary),
            Self::Landing { .. } => None,
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

    /// Its bytes; numbers keep every bit.
    pub fn encode(&self) -> Vec<u8> {
        // Into memory, and of types that have a form: neither can fail.
        postcard::to_stdvec(self).unwrap_or_default()
    }

    /// What bytes say; `None` if they say nothing.
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
                certainty: Certainty::Disputed([1.0, 2.0]),
            }),
            searched_to: 25.0,
            bands: vec![Band {
                from: -0.0,
                to: 1.0 / 3.0,
                class: Class::Bottomed,
                outcome: Outcome::Failure(Failure::PadInclination { leg: 2 }),
                bracket_width: None,
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
            tests: 9,
            landings: 1 << 40,
            evaluations: u64::MAX,
        });
        let landing = Finding::Landing {
            outcome: Outcome::Bottomed { leg: 1 },
            cells: vec![
                Cell::Word("ä".to_owned()),
                Cell::Number(-0.0),
                Cell::Count(7),
            ],
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
