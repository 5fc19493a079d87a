//! Finds the transition of a slightly different input near a known one.

use futures::future::FutureExt;
use touchdown_dynamics::outcome::Class;

use crate::landings_on_request::{self, FirstError, LandAt, Stopped};
use crate::refine::{Narrowing, Refinement};
use crate::trial::{Trial, first_unstable};

/// Range in which a transition is sought; speeds in ft/s.
#[derive(Debug, Clone, Copy)]
pub struct Near {
    /// Expected speed.
    pub around: f64,
    /// Distance searched first.
    pub within: f64,
    /// Greatest distance searched.
    pub reach: f64,
    /// Class above the transition.
    pub to: Class,
    /// Width of the bracket.
    pub width: f64,
}

impl Near {
    /// Middle of the bracket between a stable landing and one of class `to`, both computed; `None` if there is no such
    /// change within reach.
    ///
    /// # Errors
    /// Returns at once with the first error of `land`, which computes the landing at a horizontal speed.
    pub async fn follow<Stop>(
        &self,
        land: impl AsyncFn(f64) -> Result<Trial, Stop>,
    ) -> Result<Option<f64>, Stop> {
        let first_error = FirstError::default();
        let (land, kept) = (&land, &first_error);
        let landed = |speed| async move { kept.keep(land(speed).await) };
        let found = self
            .followed(&|speed| landings_on_request::sample(speed, landed(speed)).boxed_local())
            .await;
        first_error.result(found)
    }

    async fn followed(&self, sample: &LandAt<'_>) -> Result<Option<f64>, Stopped> {
        let lowest = (self.around - self.reach).max(0.0);
        let highest = self.around + self.reach;
        let below = (self.around - self.within).clamp(lowest, highest);
        let above = (self.around + self.within).clamp(lowest, highest);
        let mut low = sample(below).await?;
        let mut beyond = None;
        let mut stride = 2.0 * self.within;
        while low.class() != Class::Stable {
            if low.speed <= lowest {
                return Ok(None);
            }
            let next = sample((low.speed - stride).max(lowest)).await?;
            beyond = Some(std::mem::replace(&mut low, next));
            stride *= 2.0;
        }
        let mut high = match beyond {
            Some(sample) => sample,
            None => sample(above).await?,
        };
        stride = 2.0 * self.within;
        while high.class() == Class::Stable {
            if high.speed >= highest {
                return Ok(None);
            }
            let next = sample((high.speed + stride).min(highest)).await?;
            low = std::mem::replace(&mut high, next);
            stride *= 2.0;
        }
        let narrowing = Narrowing {
            refinement: Refinement::Margin,
            tolerance: self.width,
            to_all: false,
        };
        let mut samples = narrowing.between(&low, &high, sample).await?.samples;
        samples.extend([low, high]);
        samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        let change = first_unstable(&samples).filter(|index| *index > 0);
        Ok(change
            .filter(|index| samples[*index].class() == self.to)
            .map(|index| 0.5 * (samples[index - 1].speed + samples[index].speed)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trial::Sample;
    use futures::executor::block_on;
    use std::convert::Infallible;

    /// Topples from 11.4 ft/s on, with a margin that runs through zero there, and bottoms from 12.5 on.
    fn land(speed: f64) -> Trial {
        match speed {
            speed if speed < 12.5 => Sample::example(speed, 0.3 * (11.4 - speed)).trial,
            _ => Trial::example(Class::Bottomed, 1),
        }
    }

    fn follow(around: f64, within: f64, to: Class) -> (Option<f64>, usize) {
        let landings = std::cell::Cell::new(0);
        let near = Near {
            around,
            within,
            reach: 1.0,
            to,
            width: 1e-4,
        };
        let Ok(speed) = block_on(near.follow(async |speed| {
            landings.set(landings.get() + 1);
            Ok::<_, Infallible>(land(speed))
        }));
        (speed, landings.get())
    }

    #[test]
    fn a_transition_is_found_on_either_side_of_where_it_is_expected() {
        for around in [10.45, 11.0, 11.39, 11.4, 11.5, 12.3] {
            let (speed, landings) = follow(around, 0.01, Class::Unstable);
            assert!(
                (speed.unwrap() - 11.4).abs() <= 0.5e-4,
                "{around}: {speed:?}"
            );
            assert!(landings < 20, "{landings} landings around {around}");
        }
    }

    #[test]
    fn what_is_too_far_away_or_ends_otherwise_is_not_taken_for_it() {
        assert_eq!(follow(10.0, 0.01, Class::Unstable).0, None);
        assert_eq!(follow(13.0, 0.01, Class::Unstable).0, None);
        assert_eq!(follow(11.4, 0.01, Class::Bottomed).0, None);
        // Speeds are never negative.
        assert_eq!(follow(0.5, 0.4, Class::Unstable).0, None);
    }
}
