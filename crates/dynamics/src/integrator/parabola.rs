//! Least values of smooth quantities within a step, located by parabolas.

/// The parabola through three points (θ, value) in order of θ.
#[derive(Debug, Clone, Copy)]
pub struct Parabola([(f64, f64); 3]);

impl Parabola {
    /// The parabola through three points in order of θ.
    pub fn through(points: [(f64, f64); 3]) -> Self {
        Self(points)
    }

    /// Its lowest point, if that lies between the outer points and below `least`.
    pub fn lowest(&self, least: f64) -> Option<f64> {
        let [(t0, a), (t1, b), (t2, c)] = self.0;
        let (first, second) = ((b - a) / (t1 - t0), (c - b) / (t2 - t1));
        let bend = (second - first) / (t2 - t0);
        let theta = 0.5 * (t0 + t1) - 0.5 * first / bend;
        let value = a + (theta - t0) * (first + bend * (theta - t1));
        let is_between = theta > t0 && theta < t2 && theta != t1;
        (bend > 0.0 && is_between && value < least).then_some(theta)
    }

    /// The parabola through a point found between the outer ones and its two neighbours.
    pub fn about(&self, found: (f64, f64)) -> Self {
        let [first, middle, last] = self.0;
        Self(if found.0 < middle.0 {
            [first, found, middle]
        } else {
            [middle, found, last]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn through(f: impl Fn(f64) -> f64, thetas: [f64; 3]) -> Parabola {
        Parabola::through(thetas.map(|theta| (theta, f(theta))))
    }

    #[test]
    fn a_parabola_is_lowest_where_its_slope_vanishes() {
        for bottom in [0.1, 0.3, 0.77, 0.9] {
            let parabola = through(|u| 2.0 + 3.0 * (u - bottom) * (u - bottom), [0.0, 0.6, 1.0]);
            let theta = parabola.lowest(2.1).unwrap();
            assert!((theta - bottom).abs() < 1e-14, "{theta}");
            assert_eq!(parabola.lowest(1.9), None, "least was lower before");
        }
    }

    #[test]
    fn nothing_is_lowest_within_where_it_only_falls_or_bulges_or_is_not_one() {
        let thetas = [0.0, 0.5, 1.0];
        assert_eq!(through(|u| (u - 1.2) * (u - 1.2), thetas).lowest(9.0), None);
        assert_eq!(through(|u| u - u * u, thetas).lowest(9.0), None);
        assert_eq!(through(|u| -u, thetas).lowest(9.0), None);
        assert_eq!(through(|u| u * u, [0.5; 3]).lowest(9.0), None);
        assert_eq!(through(|_| f64::NAN, thetas).lowest(9.0), None);
    }

    #[test]
    fn four_looks_close_in_on_the_bottom_of_a_dip() {
        for phase in [0.9, 1.3, 1.9] {
            let wave = |u: f64| (phase + 3.0 * u).cos();
            let mut parabola = through(wave, [0.0, 0.5, 1.0]);
            let mut least = f64::INFINITY;
            for _ in 0..4 {
                let Some(theta) = parabola.lowest(least) else {
                    break;
                };
                let found = (theta, wave(theta));
                least = least.min(found.1);
                parabola = parabola.about(found);
            }
            assert!(least + 1.0 < 1e-6, "{least} from {phase}");
        }
    }
}
