//! Locates the crossing of an edge with the side of a cell.
//!
//! The side is halved towards the half with the greater difference. A jump stays in one half, so it shows in every
//! second difference. A slope spreads over both halves, and a bend fades with their length; either ends the search.

use touchdown_input::points::refined_grid::Place;

use crate::maps::cell::{half_way, steps};
use crate::maps::height::Height;

/// Steps between which an edge counts as located.
pub(crate) const BRACKET: usize = 2;

/// Halves a side until an edge on it is located or ruled out. Returns the places used, in order.
///
/// # Errors
/// The place that must be known first, and the steps within which the edge is not located.
pub(crate) fn located(
    ends: [(Place, Height); 2],
    jump: f64,
    height: impl Fn(Place) -> Option<Height>,
) -> Result<Vec<(Place, Height)>, (Place, usize)> {
    let [mut low, mut high] = ends;
    let (mut before, mut after) = (vec![low], vec![high]);
    while steps(low.0, high.0) > BRACKET {
        let place = half_way(low.0, high.0);
        let found = height(place).ok_or((place, steps(low.0, high.0)))?;
        let [below, above] = [low.1.leap(found), found.leap(high.1)];
        if below.is_finite() && above.is_finite() && second_difference(low.1, found, high.1) < jump
        {
            before.push((place, found));
            break;
        }
        match below >= above {
            true => {
                high = (place, found);
                after.push(high);
            }
            false => {
                low = (place, found);
                before.push(low);
            }
        }
    }
    before.extend(after.into_iter().rev());
    Ok(before)
}

fn second_difference(low: Height, middle: Height, high: Height) -> f64 {
    match (low.speed, middle.speed, high.speed) {
        (Some(low), Some(middle), Some(high)) => (low - 2.0 * middle + high).abs(),
        _ => 0.0,
    }
}

/// Finds edges between neighbours on a ring of places around a cell; returns the index of the place before each. If
/// transitions end between some, only those count.
pub(crate) fn edges(ring: &[(Place, Height)], jump: f64) -> Vec<usize> {
    let count = ring.len();
    let is_end = |index: &usize| {
        let (here, next) = (ring[*index].1, ring[(index + 1) % count].1);
        !here.is_like(next)
    };
    let ends: Vec<usize> = (0..count).filter(is_end).collect();
    match ends.is_empty() {
        true => jumps(ring, jump),
        false => ends,
    }
}

fn jumps(ring: &[(Place, Height)], jump: f64) -> Vec<usize> {
    let count = ring.len();
    let pair = |index: usize| [ring[index % count], ring[(index + 1) % count]];
    let is_jump = |index: &usize| {
        let [a, b] = pair(*index);
        let leap = a.1.leap(b.1);
        if leap < jump || steps(a.0, b.0) > BRACKET {
            return false;
        }
        // A jump is steeper than its neighbours on the same side of the cell.
        let slope = |[a, b]: [(Place, Height); 2]| a.1.leap(b.1) / steps(a.0, b.0) as f64;
        let beside = [pair(index + count - 1), pair(index + 1)];
        let mut beside = (beside.into_iter())
            .filter(|[c, d]| is_one_line([a.0, b.0, c.0, d.0]))
            .map(slope)
            .filter(|slope| slope.is_finite())
            .peekable();
        beside.peek().is_some() && beside.all(|other| slope([a, b]) > STEEPER * other)
    };
    (0..count).filter(is_jump).collect()
}

/// Least steepness of a jump as a multiple of that of its surroundings.
const STEEPER: f64 = 3.0;

fn is_one_line(places: [Place; 4]) -> bool {
    (0..2).any(|axis| places.iter().all(|place| place[axis] == places[0][axis]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The places of a side of 64 steps at which a function is computed.
    fn places(jump: f64, speed: impl Fn(f64) -> Option<f64>) -> Vec<usize> {
        let height = |place: Place| {
            let speed = speed(place[1] as f64);
            Some(Height { speed, bands: 0 })
        };
        let end = |place: Place| (place, height(place).unwrap());
        let found = located([end([5, 0]), end([5, 64])], jump, height).unwrap();
        found.into_iter().map(|(place, _)| place[1]).collect()
    }

    #[test]
    fn a_jump_is_followed_to_the_last_step_and_a_slope_is_not() {
        let jump = |x: f64| Some(0.01 * x + if x > 41.5 { 0.5 } else { 0.0 });
        assert_eq!(places(0.2, jump), [0, 32, 40, 42, 44, 48, 64]);
        assert_eq!(places(0.2, |x| Some(0.1 * x)), [0, 32, 64]);
        // A bend looks like a jump until the halves lie beyond it.
        let bend = |x: f64| Some((x - 40.0).max(0.0) * 0.05);
        assert_eq!(places(0.2, bend), [0, 32, 48, 56, 64]);
    }

    #[test]
    fn the_end_of_transitions_is_an_edge_however_small_the_step() {
        let ends = |x: f64| (x < 7.0).then_some(1.0);
        assert_eq!(places(0.2, ends), [0, 4, 6, 8, 16, 32, 64]);
    }

    #[test]
    fn a_jump_is_steeper_than_what_lies_beside_it() {
        let at = |step: usize, speed: f64| {
            let speed = Some(speed);
            ([0, step], Height { speed, bands: 0 })
        };
        let far = ([9, 4], at(0, 1.0).1);
        let jump = [at(0, 1.0), at(2, 1.1), at(4, 1.9), at(8, 2.0), far];
        assert_eq!(edges(&jump, 0.2), [1]);
        let slope = [at(0, 1.0), at(2, 1.5), at(4, 2.0), at(8, 3.0), far];
        assert_eq!(edges(&slope, 0.2), Vec::<usize>::new());
    }

    #[test]
    fn the_first_unknown_place_is_asked_for() {
        let height = Height {
            speed: None,
            bands: 0,
        };
        let other = Height {
            speed: Some(1.0),
            bands: 0,
        };
        let ends = [([0, 0], height), ([8, 0], other)];
        assert_eq!(located(ends, 0.1, |_| None), Err(([4, 0], 8)));
    }
}
