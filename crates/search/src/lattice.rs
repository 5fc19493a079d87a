//! The speeds that repeated halving of an interval can reach.

/// An interval of speeds, halved until its parts are narrow enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lattice {
    low: f64,
    high: f64,
    halvings: u32,
}

impl Lattice {
    /// Halves the interval between two speeds (ft/s) until its parts are at most `tolerance` wide.
    pub fn new(low: f64, high: f64, tolerance: f64) -> Self {
        let mut halvings = 0;
        let mut width = high - low;
        // Beyond this, neighbouring parts would share the same floating-point number.
        while width > tolerance && halvings < f64::MANTISSA_DIGITS {
            width *= 0.5;
            halvings += 1;
        }
        Self {
            low,
            high,
            halvings,
        }
    }

    /// Number of halvings from the whole interval to its parts.
    pub fn halvings(&self) -> u64 {
        u64::from(self.halvings)
    }

    /// Number of parts.
    pub fn parts(&self) -> u64 {
        1 << self.halvings
    }

    /// The speed between part `index` and the one below it, ft/s: bit for bit the one that halving reaches.
    pub fn speed(&self, index: u64) -> f64 {
        let (mut low, mut high) = (self.low, self.high);
        let (mut start, mut span) = (0, self.parts());
        loop {
            if index == start {
                return low;
            }
            if index == start + span {
                return high;
            }
            let middle = 0.5 * (low + high);
            span /= 2;
            if index < start + span {
                high = middle;
            } else {
                low = middle;
                start += span;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_are_those_of_halving() {
        let lattice = Lattice::new(11.3, 11.6, 0.001);
        assert_eq!(lattice.parts(), 512);
        let middle = 0.5 * (11.3 + 11.6);
        let quarter = 0.5 * (11.3 + middle);
        assert_eq!(lattice.speed(0), 11.3);
        assert_eq!(lattice.speed(512), 11.6);
        assert_eq!(lattice.speed(256), middle);
        assert_eq!(lattice.speed(128), quarter);
        assert_eq!(lattice.speed(192), 0.5 * (quarter + middle));
        let speeds: Vec<f64> = (0..=512).map(|index| lattice.speed(index)).collect();
        assert!(speeds.windows(2).all(|pair| pair[0] < pair[1]));
        assert!(speeds.windows(2).all(|pair| pair[1] - pair[0] <= 0.001));
    }

    #[test]
    fn a_narrow_interval_has_one_part() {
        assert_eq!(Lattice::new(1.0, 1.001, 0.01).parts(), 1);
        assert_eq!(Lattice::new(0.0, 1e300, 1e-9).parts(), 1 << 53);
    }
}
