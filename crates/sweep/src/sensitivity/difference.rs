//! The derivative from five transitions, and a check that it exists.
//!
//! V_H at p − h, p − h/2, p, p + h/2 and p + h gives two central differences, D(h) and D(h/2). The first is used, as
//! the scatter of transitions affects it least. Its error is estimated as ε/h, for brackets and solver, plus the
//! greater of:
//!
//! * 4/3 |D(h) − D(h/2)|, the error of D(h) where V_H''' makes the two differ; scatter, and small jumps of V_H such as
//!   those of one rebound more or less, show in it with more than their weight;
//! * |δ⁴|/2h with the fourth difference δ⁴, which is the distance of the slopes on either side from D(h) if V_H has a
//!   kink at p.
//!
//! A smooth V_H leaves only scatter in δ⁴. If |δ⁴| is more than a quarter of the path of V_H over both steps, and more
//! than 20 ε, V_H has a kink or jumps. It is a kink if the two halves of either side agree with each other, but not
//! with those of the other side.

use super::Dependence;

/// Greatest tolerable irregularity, as a part of the path of V_H.
const TOLERABLE: f64 = 0.25;
/// Irregularity below which it never matters, in units of ε.
const NOTICEABLE: f64 = 20.0;

/// Judges transitions (ft/s) at five inputs, half a `step` apart, known to `resolution` (ft/s).
pub fn judged(speeds: [f64; 5], step: f64, resolution: f64) -> Dependence {
    let [far_below, below, here, above, far_above] = speeds;
    let fourth = (far_below - 4.0 * below + 6.0 * here - 4.0 * above + far_above).abs();
    let way = (far_above - here).abs() + (here - far_below).abs();
    if fourth > (TOLERABLE * way).max(NOTICEABLE * resolution) {
        return if is_kinked(speeds) {
            Dependence::Kinked
        } else {
            Dependence::Jumps
        };
    }
    let whole = (far_above - far_below) / (2.0 * step);
    let half = (above - below) / step;
    let differs = 4.0 / 3.0 * (whole - half).abs();
    Dependence::Smooth {
        derivative: whole,
        error: resolution / step + differs.max(fourth / (2.0 * step)),
    }
}

/// True if V_H is even on either side but differs between the sides.
fn is_kinked(speeds: [f64; 5]) -> bool {
    let ways: Vec<f64> = speeds.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let bend = (ways[2] - ways[1]).abs();
    let uneven = (ways[1] - ways[0]).abs().max((ways[3] - ways[2]).abs());
    uneven < TOLERABLE * bend
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 0.1;
    const RESOLUTION: f64 = 1e-6;

    fn judge(speed: impl Fn(f64) -> f64) -> Dependence {
        let at = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|steps| speed(steps * STEP));
        judged(at, STEP, RESOLUTION)
    }

    /// Derivative and estimated error.
    fn smooth(speed: impl Fn(f64) -> f64) -> [f64; 2] {
        match judge(speed) {
            Dependence::Smooth { derivative, error } => [derivative, error],
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn lines_and_parabolas_have_their_slope_to_the_resolution() {
        for (slope, bend) in [(3.0, 0.0), (-0.5, 20.0), (0.0, 0.0), (0.0, 5.0)] {
            let [derivative, error] = smooth(|x| 11.0 + slope * x + bend * x * x);
            assert!((derivative - slope).abs() < 1e-12);
            assert!((error - RESOLUTION / STEP).abs() < 1e-10, "{error}");
        }
    }

    #[test]
    fn errors_are_estimated_not_below_what_they_are() {
        // A third derivative: the estimate is right to the digit.
        let [derivative, error] = smooth(|x| 11.0 + x + 2.0 * x * x * x);
        assert!((derivative - 1.0 - 0.02).abs() < 1e-12);
        assert!((error - 0.02 - RESOLUTION / STEP).abs() < 1e-12, "{error}");
        // Other curves, slight kinks, small jumps anywhere within the steps.
        type Curve = fn(f64) -> f64;
        let curves: [(f64, Curve); 8] = [
            (1.0, |x: f64| x.sin()),
            (1.0, |x: f64| (x + 0.5 * x * x).exp()),
            (1.0, |x: f64| x + 0.1 * x.abs()),
            (1.0, |x| x + 0.01 * f64::from(x > 0.02)),
            (1.0, |x| x + 0.01 * f64::from(x > 0.07)),
            (1.0, |x| x + 0.01 * f64::from(x > -0.02)),
            (1.0, |x| x - 0.01 * f64::from(x > -0.07)),
            (0.0, |x| 1e-6 * f64::from(x > 0.02)),
        ];
        for (index, (slope, curve)) in curves.into_iter().enumerate() {
            let [derivative, error] = smooth(curve);
            assert!(
                (derivative - slope).abs() <= error,
                "{index}: {derivative} {error}"
            );
            assert!(error < 0.2, "{index}: {error}");
        }
    }

    #[test]
    fn kinks_and_jumps_have_no_derivative() {
        assert_eq!(judge(|x| 11.0 - x.abs()), Dependence::Kinked);
        assert_eq!(judge(|x| 11.0 + x.max(0.0)), Dependence::Kinked);
        assert_eq!(judge(|x| 11.0 + x + x.abs()), Dependence::Kinked);
        for at in [-0.07, -0.02, 0.02, 0.07] {
            let jumping = |x| 11.0 + x + 0.5 * f64::from(x > at);
            assert_eq!(judge(jumping), Dependence::Jumps, "at {at}");
        }
    }
}
