//! The critical feet: the pair over which a vehicle would topple (2.7, model chapter 7).

/// Two feet astride the plane, between which the vehicle would topple.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CriticalFeet {
    /// The foot on the negative side.
    pub negative: usize,
    /// Its ring neighbour on the positive side.
    pub positive: usize,
}

/// The report's rule for the critical feet: the foot alone on its side and its neighbour, which is the one before it if
/// it stands on the positive side and the one after it if on the negative. Both cases are the step from a negative foot
/// to the next positive one. In this form the rule serves any `ring` of feet. `None`: all feet on one side, toppling in
/// yaw.
pub fn critical_feet(ring: &[usize], is_positive: impl Fn(usize) -> bool) -> Option<CriticalFeet> {
    let next = ring.iter().cycle().skip(1);
    ring.iter()
        .zip(next)
        .map(|(&negative, &positive)| CriticalFeet { negative, positive })
        .find(|feet| !is_positive(feet.negative) && is_positive(feet.positive))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule in the report's own words, for three feet.
    fn report(positive: [bool; 3]) -> Option<[usize; 2]> {
        let alone = (0..3).find(|&foot| {
            let others = [(foot + 1) % 3, (foot + 2) % 3];
            others
                .iter()
                .all(|&other| positive[other] != positive[foot])
        })?;
        let neighbour = if positive[alone] {
            (alone + 2) % 3
        } else {
            (alone + 1) % 3
        };
        Some([alone, neighbour])
    }

    #[test]
    fn three_feet_follow_the_report() {
        for sides in 0..8 {
            let positive = [sides & 1 != 0, sides & 2 != 0, sides & 4 != 0];
            let feet = critical_feet(&[0, 1, 2], |foot| positive[foot]);
            match report(positive) {
                None => assert_eq!(feet, None),
                Some(pair) => {
                    let feet = feet.unwrap();
                    assert!(pair.contains(&feet.negative) && pair.contains(&feet.positive));
                    assert!(!positive[feet.negative] && positive[feet.positive]);
                }
            }
        }
    }

    #[test]
    fn six_feet_have_one_leading_pair() {
        let positive = [true, true, false, false, false, true];
        let feet = critical_feet(&[0, 1, 2, 3, 4, 5], |foot| positive[foot]);
        assert_eq!(
            feet,
            Some(CriticalFeet {
                negative: 4,
                positive: 5
            })
        );
        assert_eq!(critical_feet(&[0, 1, 2, 3, 4, 5], |_| true), None);
    }
}
