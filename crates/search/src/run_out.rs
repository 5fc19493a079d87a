//! Follows margins that run out between two stable landings.
//!
//! The margin (σ²) of a lander that begins to topple runs straight to zero with the speed; so does the stroke that is left
//! of a strut that begins to bottom. Beyond a narrow band of such landings a foot meets the ground in another order, and the
//! margin starts anew from above. Neither landing beside the band is near to toppling then, and their margins do not
//! dip toward it from both sides. But the line through the two landings on one side of the interval tells: it runs
//! through zero inside. The landing there decides, or tells better where the margin runs out.

use touchdown_dynamics::outcome::Class;

use crate::landings_on_request::{LandAt, Stopped};
use crate::trial::Sample;

/// Most landings in an interval.
const LANDINGS: usize = 4;

/// A margin that runs out between two stable landings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RunOut {
    /// Class of a landing without that margin.
    otherwise: Class,
    /// Speed and margin of the two landings that the line goes through, the nearer one last.
    line: [[f64; 2]; 2],
    /// Speed of the landing on the other side of the interval, ft/s.
    beyond: f64,
}

impl RunOut {
    /// Speed at which the margin runs out, ft/s, if that is inside the interval.
    fn place(&self) -> Option<f64> {
        let [[x, y], [u, v]] = self.line;
        let place = u + v * (u - x) / (y - v);
        let [low, high] = [u.min(self.beyond), u.max(self.beyond)];
        (y > v && v > 0.0 && low < place && place < high).then_some(place)
    }

    /// Lands where the margin runs out, and again where it does then. Stops when a landing is not stable, or when the
    /// margin has started anew; returns all landings.
    pub(crate) async fn follow(mut self, sample: &LandAt<'_>) -> Result<Vec<Sample>, Stopped> {
        let mut landings = Vec::new();
        while let Some(place) = self.place()
            && landings.len() < LANDINGS
        {
            let landing = sample(place).await?;
            let found = point(&landing, self.otherwise);
            let is_over = landing.class() != Class::Stable;
            landings.push(landing);
            match found {
                Some(found) if !is_over && found[1] < self.line[1][1] => {
                    self.line = [self.line[1], found];
                }
                _ => break,
            }
        }
        Ok(landings)
    }
}

/// Speed and margin of a landing.
fn point(sample: &Sample, otherwise: Class) -> Option<[f64; 2]> {
    Some([
        sample.speed,
        sample.trial.margin([Class::Stable, otherwise])?,
    ])
}

/// Margins that run out between stable landings, given in order.
pub(crate) fn run_outs(samples: &[Sample]) -> Vec<RunOut> {
    let mut found = Vec::new();
    let stable = samples.chunk_by(|a, b| a.class() == b.class());
    for run in stable.filter(|run| run[0].class() == Class::Stable) {
        for four in run.windows(4) {
            for otherwise in [Class::Unstable, Class::Bottomed] {
                let points = [0, 1, 2, 3].map(|index| point(&four[index], otherwise));
                let [Some(a), Some(b), Some(c), Some(d)] = points else {
                    continue;
                };
                // A third landing tells a margin that falls from one that has jumped.
                for [far, near, nearest, beyond] in [[a, b, c, d], [d, c, b, a]] {
                    let run_out = RunOut {
                        otherwise,
                        line: [near, nearest],
                        beyond: beyond[0],
                    };
                    if far[1] > near[1] && run_out.place().is_some() {
                        found.push(run_out);
                    }
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use futures::executor::block_on;

    use super::*;
    use crate::landings_on_request::at_once;

    /// A landing whose margin runs to zero at `zero` with a slope of 1, and topples from there on over a band; beyond
    /// it the margin starts anew at 0.5.
    fn beside_a_band(speed: f64, zero: f64, width: f64) -> Sample {
        let margin = match speed {
            speed if speed < zero => zero - speed,
            speed if speed < zero + width => -0.1,
            _ => 0.5 - (speed - zero),
        };
        Sample::example(speed, margin)
    }

    fn followed(samples: &[Sample], land: impl Fn(f64) -> Sample) -> Vec<Vec<Sample>> {
        let land = at_once(land);
        let follow = |run_out: RunOut| block_on(run_out.follow(&land)).unwrap();
        run_outs(samples).into_iter().map(follow).collect()
    }

    #[test]
    fn a_band_between_falling_margins_is_met_at_once() {
        // Mirrored, the margin falls toward lower speeds.
        for mirror in [1.0, -1.0] {
            let land = |speed: f64| Sample {
                speed,
                ..beside_a_band(mirror * speed, 0.62, 0.02)
            };
            let mut samples = [0.0, 0.25, 0.5, 0.75, 1.0].map(|speed| land(mirror * speed));
            samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
            let [landings] = &followed(&samples, land)[..] else {
                panic!("one margin runs out");
            };
            let [landing] = &landings[..] else {
                panic!("one landing is enough: {landings:?}");
            };
            assert!((landing.speed - mirror * 0.62).abs() < 1e-12);
            assert_eq!(landing.class(), Class::Unstable);
        }
    }

    #[test]
    fn a_curved_margin_is_followed_to_its_zero_and_one_that_starts_anew_is_left() {
        let curved = |speed: f64| Sample::example(speed, (0.7 - speed) * (1.7 - speed));
        let samples = [0.0, 0.25, 0.5].map(curved);
        let beyond = Sample::example(1.0, 0.3);
        let landings = followed(&[&samples[..], &[beyond]].concat(), curved);
        let [landings] = &landings[..] else {
            panic!("one margin runs out");
        };
        let last = landings.last().unwrap();
        assert!(
            landings.len() <= LANDINGS && (last.speed - 0.7).abs() < 0.01,
            "{landings:?}"
        );
        // At the zero of the line the landing is as stable as beyond.
        let anew =
            |speed: f64| Sample::example(speed, if speed < 0.55 { 0.7 - speed } else { 0.4 });
        let landings = followed(&[0.0, 0.25, 0.5, 1.0].map(anew), anew);
        assert_eq!(landings.iter().map(Vec::len).collect::<Vec<_>>(), [1]);
    }

    #[test]
    fn margins_that_last_to_the_next_landing_are_left() {
        let rises = |speed: f64| Sample::example(speed, 1.0 + speed);
        assert_eq!(run_outs(&[0.0, 0.25, 0.5, 0.75].map(rises)), []);
        let lasts = |speed: f64| Sample::example(speed, 1.0 - speed);
        assert_eq!(run_outs(&[0.0, 0.25, 0.5, 0.75].map(lasts)), []);
        // To the very speed of the next landing, upward and downward.
        for mirror in [1.0, -1.0] {
            let mut samples = [0.25, 0.5, 0.75].map(lasts).to_vec();
            samples.push(Sample::example(1.0, 0.5));
            samples.iter_mut().for_each(|one| one.speed *= mirror);
            samples.sort_by(|a, b| a.speed.total_cmp(&b.speed));
            assert_eq!(run_outs(&samples), []);
        }
        // Landings that topple are no side of such an interval.
        assert_eq!(run_outs(&[0.0, 0.4, 0.8, 1.2].map(lasts)), []);
    }
}
