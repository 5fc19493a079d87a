//! Where a band narrower than the scan step may hide between two stable landings.
//!
//! A vehicle that topples in a narrow band of speeds comes close to toppling on both sides of it:
//! the least stability angle σ falls toward the band from below and from above. The vehicle turns
//! back where its energy is spent, and near the tipping point that energy falls short of toppling by
//! an amount proportional to σ²: it is σ² that runs straight to zero where toppling begins. Where
//! lines twice as steep as those through the landings on either side of an interval meet at or below
//! zero in it, the interval is searched for the least angle itself. Twice, because a new contact
//! bends the course of σ² within a scan step.
//!
//! Measured on the level-vehicle grid (143 points, `scripts/missed-bands.sh`): of the 293 bands that a
//! scan by 0.02 ft/s finds (`results/fine-bands.csv`), `scripts/level-grid.toml` misses 6, all narrower than
//! the step of 0.25: one of a single failed landing, one of a single stable one, a stable one of 0.2
//! ft/s and three toppling ones of 0.08 ft/s between bouncing landings. Of these neither σ nor strut
//! travel tells: both run on smoothly from one side of the band to the other.

use touchdown_dynamics::outcome::Class;

use crate::trial::Sample;

/// How much steeper than around it the course of σ² may be inside an interval.
const STEEPER: f64 = 2.0;
/// Landings spent on one look: they narrow the place of the least angle to 1/29 of the interval.
const LANDINGS: usize = 8;

/// Indices of the samples above which an interval between stable landings may hide a band. Where
/// the scan skipped steps it saw no dip.
pub(crate) fn suspects(samples: &[Sample], scan_step: f64) -> Vec<usize> {
    let is_step = |pair: &[Sample]| pair[1].speed - pair[0].speed < 1.5 * scan_step;
    let hides = |around: &[Sample]| match around {
        [before, low, high, after] => {
            around.iter().all(|sample| sample.class() == Class::Stable)
                && around.windows(2).all(is_step)
                && predicted_least(
                    [before, low].map(coordinates),
                    [high, after].map(coordinates),
                )
                .is_some_and(|angle| angle <= 0.0)
        }
        _ => false,
    };
    samples
        .windows(4)
        .enumerate()
        .filter(|(_, around)| hides(around))
        .map(|(index, _)| index + 1)
        .collect()
}

fn coordinates(sample: &Sample) -> [f64; 2] {
    let angle = sample.trial.least_angle;
    [sample.speed, angle * angle]
}

/// Squared angle at which lines [`STEEPER`] than those through the two landings below an interval and
/// through the two above it meet; `None` unless the angle falls from below and rises to above.
fn predicted_least([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> Option<f64> {
    let slope = |[x, y]: [f64; 2], [u, v]: [f64; 2]| STEEPER * (v - y) / (u - x);
    let (fall, rise) = (slope(a, b), slope(c, d));
    if !(fall < 0.0 && rise > 0.0) {
        return None;
    }
    let x = (c[1] - b[1] + fall * b[0] - rise * c[0]) / (fall - rise);
    // Lines that meet outside of the interval do not speak of a dip inside.
    (b[0]..=c[0]).contains(&x).then(|| b[1] + fall * (x - b[0]))
}

/// Searches the least angle between two stable landings by golden section, until a landing is no
/// longer stable or the landings are spent; returns them all.
pub(crate) fn look<Stop>(
    low: &Sample,
    high: &Sample,
    sample: &mut impl FnMut(f64) -> Result<Sample, Stop>,
) -> Result<Vec<Sample>, Stop> {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (low.speed, high.speed);
    let mut landings: Vec<Sample> = Vec::with_capacity(LANDINGS);
    let mut inner: [Option<[f64; 2]>; 2] = [None, None];
    while landings.len() < LANDINGS {
        // Of the two inner points of the interval, one is known after the first round.
        let (index, speed) = match inner {
            [None, _] => (0, b - golden * (b - a)),
            [_, None] => (1, a + golden * (b - a)),
            [Some(left), Some(right)] => {
                if left[1] <= right[1] {
                    b = right[0];
                    inner = [None, Some(left)];
                } else {
                    a = left[0];
                    inner = [Some(right), None];
                }
                continue;
            }
        };
        let landing = sample(speed)?;
        inner[index] = Some(coordinates(&landing));
        let over = landing.class() != Class::Stable;
        landings.push(landing);
        if over {
            break;
        }
    }
    Ok(landings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trial::Trial;
    use std::convert::Infallible;

    fn at(speed: f64, least_angle: f64) -> Sample {
        let class = if least_angle > 0.0 {
            Class::Stable
        } else {
            Class::Unstable
        };
        let trial = Trial {
            least_angle: least_angle.max(0.0),
            ..Trial::example(class, 1)
        };
        Sample { speed, trial }
    }

    #[test]
    fn dips_toward_zero_are_suspected_and_others_are_not() {
        let scan = |angle: fn(f64) -> f64| -> Vec<usize> {
            let samples: Vec<Sample> = (0..8)
                .map(|i| at(f64::from(i), angle(f64::from(i))))
                .collect();
            suspects(&samples, 1.0)
        };
        assert_eq!(scan(|v| (v - 3.5).abs() - 0.2), [3]);
        assert_eq!(scan(|v| (v - 3.5).abs() + 2.0), [] as [usize; 0]);
        assert_eq!(scan(|v| 9.0 - v), [] as [usize; 0]);
    }

    #[test]
    fn a_look_finds_a_band_much_narrower_than_the_step() {
        let land = |speed: f64| at(speed, (speed - 0.3).abs() - 0.01);
        let mut sample = |speed| Ok::<_, Infallible>(land(speed));
        let Ok(landings) = look(&land(0.0), &land(1.0), &mut sample);
        assert!(landings.iter().any(|l| l.class() == Class::Unstable));
        assert!(landings.len() <= LANDINGS);
    }
}
