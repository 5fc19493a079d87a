//! Claims about the level vehicle: Figures 4-9 to 4-21.

use touchdown_input::documents::input_error::InputError;

use super::answer::{Answer, Verdict, signed, speed};
use super::results::Results;

/// Figures 4-9 to 4-18 and their cross-slopes, deg.
const FIGURES: [(&str, f64); 10] = [
    ("figure-4-09", 180.0),
    ("figure-4-10", 170.0),
    ("figure-4-11", 160.0),
    ("figure-4-12", 150.0),
    ("figure-4-13", 140.0),
    ("figure-4-14", 130.0),
    ("figure-4-15", 120.0),
    ("figure-4-16", 110.0),
    ("figure-4-17", 100.0),
    ("figure-4-18", 90.0),
];

/// C05: the baseline.
pub fn baseline(results: &Results) -> Result<Answer, InputError> {
    let transitions = results.transitions("figure-4-09")?.at(&[0.0])?;
    Ok(Answer {
        source: "figure-4-09",
        number: speed(transitions),
        verdict: Verdict::of(&[transitions.is_some_and(|t| (11.0..=11.5).contains(&t.speed))]),
        why: "",
    })
}

/// C06: the transition rises with the roll angle.
pub fn rises_with_roll(results: &Results) -> Result<Answer, InputError> {
    let transitions = results.transitions("figure-4-09")?;
    let side = |sign: f64| -> Result<Vec<f64>, InputError> {
        let mut speeds = Vec::new();
        for step in 0..=12 {
            match transitions.at(&[sign * 5.0 * f64::from(step) + 0.0])? {
                Some(first) => speeds.push(first.speed),
                None => break,
            }
        }
        Ok(speeds)
    };
    let rises = |speeds: &[f64]| speeds.windows(2).all(|pair| pair[0] < pair[1]);
    let sides = [side(1.0)?, side(-1.0)?];
    let (place, lowest) = transitions.lowest()?;
    let number = format!(
        "lowest {lowest:.2} at roll {}, {} at 0, {} and {} at ±20; no transition from ±40",
        signed(place[0]),
        speed(transitions.at(&[0.0])?),
        speed(transitions.at(&[-20.0])?),
        speed(transitions.at(&[20.0])?),
    );
    let outward = sides.iter().all(|speeds| rises(&speeds[1..]));
    let everywhere = sides.iter().all(|speeds| rises(speeds));
    Ok(Answer {
        source: "figure-4-09",
        number,
        verdict: Verdict::of(&[outward, everywhere]),
        why: "true from rolls of 5 deg outward; on both sides of 0 the boundary dips below the \
              planar case, finer than the half foot of 1966",
    })
}

/// C07: concave profiles whose minimum rises and moves to negative roll.
pub fn valley(results: &Results) -> Result<Answer, InputError> {
    let mut minima = Vec::new();
    for (stem, cross_slope) in FIGURES {
        let transitions = results.transitions(stem)?;
        let (place, lowest) = transitions.lowest()?;
        minima.push((cross_slope, lowest, place[0]));
    }
    let rising = minima.windows(2).all(|pair| pair[0].1 < pair[1].1);
    let moving = minima.windows(2).all(|pair| pair[0].2 >= pair[1].2);
    let list: Vec<String> = minima
        .iter()
        .map(|(cross_slope, lowest, roll)| {
            format!("{}: {lowest:.2} at {}", signed(*cross_slope), signed(*roll))
        })
        .collect();
    Ok(Answer {
        source: "figure-4-09 to figure-4-18",
        number: format!("lowest by cross-slope, at roll: {}", list.join("; ")),
        verdict: Verdict::of(&[rising, moving]),
        why: "",
    })
}

/// C08: nothing at a cross-slope of 80 deg.
pub fn across(results: &Results) -> Result<Answer, InputError> {
    let transitions = results.transitions("figure-4-19")?;
    let none: Vec<f64> = transitions
        .points()
        .filter(|(_, first)| first.is_none())
        .map(|(place, _)| place[0])
        .collect();
    let (place, lowest) = transitions.lowest()?;
    let least = none.iter().copied().fold(f64::INFINITY, f64::min);
    let most = none.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let number = format!(
        "none for {} of {} rolls, between {} and {}; elsewhere from {lowest:.2} at roll {} up",
        none.len(),
        transitions.points().count(),
        signed(least),
        signed(most),
        signed(place[0])
    );
    Ok(Answer {
        source: "figure-4-19",
        number,
        verdict: Verdict::of(&[!none.is_empty(), none.len() == transitions.points().count()]),
        why: "how high and at which rolls 1966 searched is lost; toppling begins at speeds well \
              above all other transitions",
    })
}

/// C09: no level case below the baseline.
pub fn below_the_baseline(results: &Results) -> Result<Answer, InputError> {
    let surface = results.transitions("surface-4-20")?;
    let baseline = surface
        .at(&[180.0, 0.0])?
        .map_or(f64::NAN, |first| first.speed);
    let mut below: Vec<(&[f64], f64)> = surface
        .points()
        .filter_map(|(place, first)| Some((place, first?.speed)))
        .filter(|(_, speed)| *speed < baseline)
        .collect();
    below.sort_by(|(_, a), (_, b)| a.total_cmp(b));
    let on_tens = |place: &[f64]| place.iter().all(|value| value % 10.0 == 0.0);
    let positive = |place: &[f64]| place[0] > 0.0;
    let list: Vec<String> = below
        .iter()
        .filter(|(place, _)| on_tens(place) && positive(place))
        .map(|(place, speed)| format!("({}, {}) {speed:.2}", signed(place[0]), signed(place[1])))
        .collect();
    let (place, lowest) = surface.lowest()?;
    let number = format!(
        "{} points of the grid of 5 deg lie below {baseline:.2}, the lowest ({}, {}) at {lowest:.2}; \
         of the grid of 10 deg at positive cross-slopes: {}",
        below.len(),
        signed(place[0]),
        signed(place[1]),
        list.join(", ")
    );
    Ok(Answer {
        source: "surface-4-20",
        number,
        verdict: Verdict::of(&[below.is_empty()]),
        why: "they lie within half a foot per second of the baseline, which the grid of 1966 could \
              not tell apart",
    })
}

/// C10: the jump.
pub fn jump(results: &Results) -> Result<Answer, InputError> {
    let surface = results.transitions("surface-4-20")?;
    let mut parts = Vec::new();
    let mut jumps = Vec::new();
    for cross_slope in [160.0, 165.0, 170.0] {
        let mut row = Vec::new();
        for roll in [20.0, 25.0, 30.0, 35.0, 40.0] {
            row.push(surface.at(&[cross_slope, roll])?.map(|first| first.speed));
        }
        // Ten degrees are two steps of the grid.
        let within_ten = row.windows(3).any(|three| match (three[0], three[2]) {
            (Some(low), high) => low < 15.0 && high.is_none_or(|high| high > 20.0),
            (None, _) => false,
        });
        jumps.push(within_ten);
        let cells: Vec<String> = row
            .iter()
            .map(|speed| speed.map_or("none".to_owned(), |speed| format!("{speed:.2}")))
            .collect();
        parts.push(format!("{}: {}", signed(cross_slope), cells.join(", ")));
    }
    Ok(Answer {
        source: "surface-4-20",
        number: format!(
            "by cross-slope at rolls 20 to 40 by 5: {}",
            parts.join("; ")
        ),
        verdict: Verdict::of(&jumps),
        why: "beyond the jump no first transition is left up to 25 ft/s",
    })
}
