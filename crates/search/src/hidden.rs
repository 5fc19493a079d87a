//! Detects intervals between two like landings that may hide a band narrower than the scan step.
//!
//! A vehicle that topples in a narrow band of speeds comes close to toppling on both sides of it: the least stability
//! angle σ falls toward the band from below and from above. The vehicle turns back where its energy is spent. Near the
//! tipping point that energy falls short of toppling by an amount proportional to σ², so σ² runs straight to zero where
//! toppling begins. So does the remaining stroke of a strut where bottoming begins, and so does, from the other side,
//! the excess of toppled and bottomed landings ([`crate::trial::Margins`]). Draw lines twice as steep as those through
//! the two landings on either side of an interval. If they meet at or below zero inside it, the interval is searched
//! for the least margin. The factor of two allows for a new contact that bends the course of a margin within a scan
//! step.
//!
//! `docs/notes/skips.md` lists the bands found and those missed. Missed bands show in no margin: all margins run
//! smoothly from one side of the band to the other.

use touchdown_dynamics::outcome::Class;

use crate::landings_on_request::{LandAt, Stopped};
use crate::trial::Sample;

/// Steepness of a margin assumed inside an interval, as a multiple of that around it.
const STEEPER: f64 = 2.0;
/// Widest interval between scan landings that is checked, in scan steps.
const WIDEST: f64 = 4.5;
/// Landings per look: they narrow the place of the least margin to 1/29 of the interval.
const LANDINGS: usize = 8;

/// An interval that may hide a band.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Suspect {
    /// Index of the sample at its lower end.
    pub(crate) index: usize,
    /// Class of the landings in the suspected band.
    pub(crate) otherwise: Class,
}

/// Returns the intervals between scan landings that may hide a band; none where the scan skipped many steps.
pub(crate) fn suspects(samples: &[Sample], scan_step: f64) -> Vec<Suspect> {
    let are_near = |pair: &[Sample]| pair[1].speed - pair[0].speed < WIDEST * scan_step;
    let mut suspects = Vec::new();
    for (index, around) in samples.windows(4).enumerate() {
        let class = around[0].class();
        let is_alike = around.iter().all(|sample| sample.class() == class);
        if !is_alike || !around.windows(2).all(are_near) {
            continue;
        }
        let hides = |otherwise| {
            dips(around, |sample| coordinates(sample, otherwise)).is_some_and(|least| least <= 0.0)
        };
        let hidden = others(class).iter().filter(|otherwise| hides(**otherwise));
        suspects.extend(hidden.map(|&otherwise| Suspect {
            index: index + 1,
            otherwise,
        }));
    }
    suspects
}

/// Classes of band that can hide between landings of this class.
fn others(class: Class) -> &'static [Class] {
    match class {
        Class::Stable => &[Class::Unstable, Class::Bottomed],
        Class::Unstable => &[Class::Stable, Class::Bottomed],
        Class::Bottomed => &[Class::Stable],
        Class::Failure | Class::Undecided => &[],
    }
}

/// Speed and the margin against ending as `otherwise`, if there is one.
fn coordinates(sample: &Sample, otherwise: Class) -> Option<[f64; 2]> {
    let margin = match otherwise {
        // The excess of such a landing.
        Class::Stable => -sample.trial.margin([Class::Stable, sample.class()])?,
        _ => sample.trial.margin([Class::Stable, otherwise])?,
    };
    Some([sample.speed, margin])
}

/// Margin at which lines [`STEEPER`] than those through the two landings below an interval and through the two above it
/// meet; `None` unless the margin falls from below and rises toward above.
fn dips(around: &[Sample], coordinates: impl Fn(&Sample) -> Option<[f64; 2]>) -> Option<f64> {
    let [before, low, high, after] = around else {
        return None;
    };
    let [a, b] = [coordinates(before)?, coordinates(low)?];
    let [c, d] = [coordinates(high)?, coordinates(after)?];
    let slope = |[x, y]: [f64; 2], [u, v]: [f64; 2]| STEEPER * (v - y) / (u - x);
    let (fall, rise) = (slope(a, b), slope(c, d));
    if !(fall < 0.0 && rise > 0.0) {
        return None;
    }
    let x = (c[1] - b[1] + fall * b[0] - rise * c[0]) / (fall - rise);
    // Lines that meet outside of the interval do not speak of a dip inside.
    (b[0]..=c[0]).contains(&x).then(|| b[1] + fall * (x - b[0]))
}

/// Searches for the least margin against ending as `otherwise` between two like landings, by golden section. Stops when
/// a landing ends in another class or the landings are spent; returns them all.
pub(crate) async fn look(
    [low, high]: [&Sample; 2],
    otherwise: Class,
    sample: &LandAt<'_>,
) -> Result<Vec<Sample>, Stopped> {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut a, mut b) = (low.speed, high.speed);
    let mut landings: Vec<Sample> = Vec::with_capacity(LANDINGS);
    let mut inner: [Option<[f64; 2]>; 2] = [None, None];
    while landings.len() < LANDINGS {
        // After the first round one of the two inner points is known.
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
        let landing = sample(speed).await?;
        inner[index] = coordinates(&landing, otherwise);
        let is_over = landing.class() != low.class() || inner[index].is_none();
        landings.push(landing);
        if is_over {
            break;
        }
    }
    Ok(landings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::landings_on_request::at_once;
    use crate::trial::Trial;
    use futures::executor::block_on;

    fn at(speed: f64, least_angle: f64) -> Sample {
        let class = if least_angle > 0.0 {
            Class::Stable
        } else {
            Class::Unstable
        };
        let least_angle = least_angle.max(0.0);
        let mut trial = Trial {
            least_angle,
            ..Trial::example(class, 1)
        };
        trial.margins.toppling = Some(least_angle * least_angle);
        Sample {
            speed,
            trial,
            is_loose: false,
        }
    }

    /// A landing with this stroke left that ends in `class`, or bottoms a strut if none is left.
    fn leaving(class: Class, speed: f64, stroke: f64) -> Sample {
        let class = if stroke > 0.0 { class } else { Class::Bottomed };
        let mut trial = Trial::example(class, 1);
        trial.margins.bottoming = Some(stroke);
        Sample {
            speed,
            trial,
            is_loose: false,
        }
    }

    fn suspected(samples: impl Fn(f64) -> Sample) -> Vec<(usize, Class)> {
        let samples: Vec<Sample> = (0..8).map(|i| samples(f64::from(i))).collect();
        let suspects = suspects(&samples, 1.0).into_iter();
        suspects.map(|s| (s.index, s.otherwise)).collect()
    }

    #[test]
    fn dips_toward_zero_are_suspected_and_others_are_not() {
        let scan = |angle: fn(f64) -> f64| suspected(|v| at(v, angle(v)));
        assert_eq!(scan(|v| (v - 3.5).abs() - 0.2), [(3, Class::Unstable)]);
        assert_eq!(scan(|v| (v - 3.5).abs() + 2.0), []);
        assert_eq!(scan(|v| 9.0 - v), []);
    }

    #[test]
    fn struts_near_their_stops_are_suspected_whether_a_vehicle_topples_or_not() {
        let stroke = |v: f64| 0.1 * (v - 3.5).abs() - 0.02;
        for class in [Class::Stable, Class::Unstable] {
            let found = suspected(|v| leaving(class, v, stroke(v)));
            assert_eq!(found, [(3, Class::Bottomed)]);
        }
        let far = suspected(|v| leaving(Class::Stable, v, stroke(v) + 0.3));
        assert_eq!(far, []);
    }

    #[test]
    fn landings_that_hardly_topple_or_bottom_are_suspected_of_a_stable_band() {
        let excess = |v: f64| 0.1 * (v - 3.5).abs() + 0.01;
        let topples = suspected(|v| Sample::example(v, -excess(v)));
        assert_eq!(topples, [(3, Class::Stable)]);
        let bottoms = suspected(|v| leaving(Class::Stable, v, -excess(v)));
        assert_eq!(bottoms, [(3, Class::Stable)]);
        assert_eq!(suspected(|v| Sample::example(v, -excess(v) - 0.3)), []);
    }

    #[test]
    fn a_look_finds_a_band_much_narrower_than_the_step() {
        let topples = |speed: f64| at(speed, (speed - 0.3).abs() - 0.01);
        let bottoms = |speed: f64| leaving(Class::Stable, speed, (speed - 0.3).abs() - 0.01);
        let find = |land: &dyn Fn(f64) -> Sample, class| {
            let at_once = at_once(land);
            let ends = [land(0.0), land(1.0)];
            let landings = block_on(look(ends.each_ref(), class, &at_once)).unwrap();
            assert!(landings.iter().any(|l| l.class() == class));
            assert!(landings.len() <= LANDINGS);
        };
        find(&topples, Class::Unstable);
        find(&bottoms, Class::Bottomed);
    }
}
