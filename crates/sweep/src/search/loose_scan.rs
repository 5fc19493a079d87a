//! A scan at a looser tolerance, confirmed where it matters.
//!
//! Landings near a change take long, landings far from one end alike at any tolerance. So the scan may
//! be computed at several times the solver's tolerance, and both ends of every change it finds are
//! landed at again at the tolerance itself, before the change is narrowed down at that. Should one of
//! them end otherwise, the whole scan is made again at the tolerance itself.

use touchdown_dynamics::outcome::Class;

use crate::certainty::Variation;
use crate::join_all::join_all;
use crate::search_range::Search;
use crate::trial::{Sample, Trial};

/// A scan whose changes hold at the solver's tolerance.
pub(crate) struct Scanned {
    /// The landings from below.
    pub samples: Vec<Sample>,
    /// Landings, and evaluations, whose results were replaced by tighter ones.
    pub spent: [u64; 2],
    /// Landings at a looser tolerance, replaced ones among them.
    pub loose: u64,
}

impl Search {
    /// Scans the range, or as much of it as lies below the first change away from a stable landing.
    pub(crate) async fn confirmed_scan<Stop>(
        &self,
        to_first: bool,
        land: &impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Scanned, Stop> {
        if self.scan_looseness == 1.0 {
            return Ok(Scanned {
                samples: self.scan_at(Variation::Unchanged, to_first, land).await?,
                spent: [0; 2],
                loose: 0,
            });
        }
        let looser = Variation::Tolerance(self.scan_looseness);
        let mut samples = self.scan_at(looser, to_first, land).await?;
        let loose = samples.len() as u64;
        let mut spent = [0; 2];
        let mut is_confirmed = true;
        let ends = ends_of_changes(&samples);
        let again = (ends.iter()).map(|index| land(samples[*index].speed, Variation::Unchanged));
        let again = join_all(again).await?;
        for (index, trial) in ends.into_iter().zip(again) {
            let speed = samples[index].speed;
            is_confirmed &= trial.outcome.class() == samples[index].class();
            let replaced = std::mem::replace(&mut samples[index], Sample { speed, trial });
            count(&mut spent, &replaced);
        }
        if !is_confirmed {
            samples.iter().for_each(|sample| count(&mut spent, sample));
            samples = self.scan_at(Variation::Unchanged, to_first, land).await?;
        }
        Ok(Scanned {
            samples,
            spent,
            loose,
        })
    }

    async fn scan_at<Stop>(
        &self,
        variation: Variation,
        to_first: bool,
        land: &impl AsyncFn(f64, Variation) -> Result<Trial, Stop>,
    ) -> Result<Vec<Sample>, Stop> {
        let sample = async |speed| Sample::at(speed, land(speed, variation)).await;
        self.scanned(to_first, &sample).await
    }
}

fn count(spent: &mut [u64; 2], sample: &Sample) {
    spent[0] += 1;
    spent[1] += sample.trial.evaluations;
}

/// Indices of the landings next to one that ended otherwise, and of the lowest unless it is stable.
fn ends_of_changes(samples: &[Sample]) -> Vec<usize> {
    let differs = |a: usize, b: usize| match (samples.get(a), samples.get(b)) {
        (Some(a), Some(b)) => a.class() != b.class(),
        _ => false,
    };
    (0..samples.len())
        .filter(|&i| {
            i == 0 && samples[0].class() != Class::Stable
                || i > 0 && differs(i - 1, i)
                || differs(i, i + 1)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::*;
    use crate::boundary::{Boundary, Extent};
    use crate::first_transition::tests::SEARCH;
    use futures::executor::block_on;

    const LOOSE: Search = Search {
        extent: Extent::All,
        scan_looseness: 10.0,
        ..SEARCH
    };

    /// Searches where landings topple from `true_speed` on, at a looser tolerance from `loose_speed`.
    fn find(search: Search, true_speed: f64, loose_speed: f64) -> Boundary {
        let found: Result<_, Infallible> = block_on(search.boundary(async |speed, variation| {
            let from = match variation {
                Variation::Tolerance(_) => loose_speed,
                _ => true_speed,
            };
            let class = if speed < from {
                Class::Stable
            } else {
                Class::Unstable
            };
            Ok(Trial::example(
                class,
                if variation == Variation::Unchanged {
                    10
                } else {
                    1
                },
            ))
        }));
        let Ok(boundary) = found;
        boundary
    }

    #[test]
    fn what_is_found_holds_at_the_tolerance_itself() {
        for extent in [Extent::First, Extent::All] {
            let loose = Search { extent, ..LOOSE };
            let tight = Search {
                scan_looseness: 1.0,
                ..loose
            };
            // Alike in the scan; off by less than a step of it; off by more.
            for loose_speed in [11.4, 11.45, 11.55, 11.2, 9.0] {
                let (found, expected) = (find(loose, 11.4, loose_speed), find(tight, 11.4, 11.4));
                assert_eq!(found.transition, expected.transition, "{loose_speed}");
                assert_eq!(found.bands, expected.bands, "{loose_speed}");
            }
        }
    }

    #[test]
    fn loose_landings_are_counted_where_they_are_replaced_too() {
        let tight = Search {
            scan_looseness: 1.0,
            ..LOOSE
        };
        let (found, tight) = (find(LOOSE, 11.4, 11.4), find(tight, 11.4, 11.4));
        assert_eq!(found.landings, tight.landings + 2);
        assert_eq!(
            found.evaluations,
            tight.evaluations - 9 * LOOSE.scan_count() + 10 * 2
        );
        assert_eq!(
            (found.skipped.loose, found.skipped.replaced),
            (LOOSE.scan_count(), 2)
        );
        let again = find(LOOSE, 11.4, 9.0).skipped;
        assert_eq!(again.replaced, again.loose + 2);
    }
}
