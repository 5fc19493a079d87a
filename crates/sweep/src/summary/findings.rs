//! The result of a point, and its encoding in a journal.

use serde::{Deserialize, Serialize};
use touchdown_dynamics::landing::Landing;
use touchdown_search::boundary::Boundary;
use touchdown_search::contact_warnings::ContactWarnings;

use crate::sensitivity::Sensitivity;

/// The result of a point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Finding {
    /// Result of a search for the boundary of stable landings.
    Boundary(Boundary),
    /// One landing.
    Landing(Box<Landing>),
    /// Result of a search, with sensitivities of the transition.
    Sensitive {
        /// The search.
        boundary: Boundary,
        /// The sensitivities.
        sensitivity: Sensitivity,
    },
}

impl Finding {
    /// Result of the search, for boundary sweeps.
    pub fn boundary(&self) -> Option<&Boundary> {
        match self {
            Self::Boundary(boundary) | Self::Sensitive { boundary, .. } => Some(boundary),
            Self::Landing(_) => None,
        }
    }

    /// The landing, for outcome sweeps and cases.
    pub fn landing(self) -> Option<Landing> {
        match self {
            Self::Landing(landing) => Some(*landing),
            Self::Boundary(_) | Self::Sensitive { .. } => None,
        }
    }

    /// Contact warnings of its landings.
    pub fn warnings(&self) -> ContactWarnings {
        match self {
            Self::Boundary(boundary) | Self::Sensitive { boundary, .. } => boundary.warnings,
            Self::Landing(landing) => ContactWarnings::of(landing),
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
            Self::Landing(_) => 1,
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
            Self::Landing(landing) => landing.evaluations,
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
pub(crate) mod tests {
    use super::*;
    use touchdown_dynamics::landing::{Energies, FinalRates, LegWork};
    use touchdown_dynamics::outcome::{Class, Failure, Outcome};
    use touchdown_search::boundary::{Band, Skipped, Transition};
    use touchdown_search::certainty::Certainty;
    use touchdown_search::hidden_band_checks::{CheckCounts, HiddenBandChecks};

    /// A landing invented for tests of tables.
    pub fn example() -> Landing {
        Landing {
            beyond: None,
            outcome: Outcome::Failure(Failure::PadInclination { leg: 1 }),
            end_time: 1.5,
            min_stability_angle: std::f64::consts::PI / 6.0,
            min_stability_time: 1.0,
            min_clearance: 0.5,
            tilt: std::f64::consts::PI / 6.0,
            max_strut_force: [1.0, 2.0, 3.0].into(),
            max_stroke: [0.25, 0.5, 0.125].into(),
            max_stroke_share: [0.5, 1.0, 0.25].into(),
            max_stroke_table_share: [0.0; 3].into(),
            max_pad_crush: [0.0; 3].into(),
            max_pad_crush_share: [0.0; 3].into(),
            max_sinkage: [0.0, 0.0625, 0.0].into(),
            final_rates: FinalRates {
                stability_angle: None,
                strokes: [0.0; 3].into(),
                stroke_accelerations: [0.0; 3].into(),
            },
            pad_contact: [Some(0.0), None, Some(0.25)].into(),
            block_contact: [None; 3].into(),
            energies: Energies {
                initial_kinetic: 100.0,
                potential_change: 10.0,
                thrust: 0.0,
                legs: [LegWork::default(); 3].into(),
                final_kinetic: 109.5,
            },
            steps: 7,
            evaluations: 70,
            events: 3,
        }
    }

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
            patchy: None,
            stable_below: 3,
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
        let landing = Finding::Landing(Box::new(example()));
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
