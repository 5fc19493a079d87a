//! Claims about the tipped vehicle: Figures 4-23 to 4-25.

use touchdown_input::documents::input_error::InputError;

use super::answer::{Answer, Verdict, signed, speed};
use super::results::Results;

/// C12: the lowest transitions of all, on both sides.
pub fn most_critical(results: &Results) -> Result<Answer, InputError> {
    let transitions = results.transitions("figure-4-23")?;
    let mut pairs = Vec::new();
    let (mut about, mut alike) = (Vec::new(), true);
    for azimuth in [112.5, 135.0, 157.5] {
        let [plus, minus] = [transitions.at(&[azimuth])?, transitions.at(&[-azimuth])?];
        pairs.push(format!("±{azimuth}: {} and {}", speed(plus), speed(minus)));
        let speeds = [plus, minus].map(|first| first.map_or(f64::NAN, |first| first.speed));
        about.extend(speeds.map(|speed| (10.25..=10.75).contains(&speed)));
        alike &= (speeds[0] - speeds[1]).abs() < 0.1;
    }
    let near = about.iter().filter(|near| **near).count();
    Ok(Answer {
        source: "figure-4-23",
        number: format!(
            "{}; {near} of 6 within a quarter foot of 10-1/2",
            pairs.join("; ")
        ),
        verdict: Verdict::of(&[near > 0, near == 6, alike]),
        why: "the products of inertia break the symmetry that 1966 took for granted (below)",
    })
}

/// C15: Figure 4-24 against 4-23.
pub fn less_tip(results: &Results) -> Result<Answer, InputError> {
    let [more, less] = [
        results.transitions("figure-4-23")?,
        results.transitions("figure-4-24")?,
    ];
    let unstable_at_11 = |azimuth: f64| -> Result<bool, InputError> {
        Ok(less.at(&[azimuth])?.is_some_and(|first| first.speed < 11.0))
    };
    let topples = unstable_at_11(90.0)? && unstable_at_11(-90.0)?;
    let mut greatest: (f64, f64) = (0.0, 0.0);
    for (place, first) in more.points() {
        let (Some(a), Some(b)) = (first, less.at(place)?) else {
            continue;
        };
        let apart = (a.speed - b.speed).abs();
        if place[0].abs() != 90.0 && apart > greatest.1 {
            greatest = (place[0], apart);
        }
    }
    Ok(Answer {
        source: "figure-4-24, figure-4-23",
        number: format!(
            "tip 5: {} at 90, {} at −90 (tip 9: {}, {}); elsewhere the two differ by up to {:.2} \
             ft/s, at {}",
            speed(less.at(&[90.0])?),
            speed(less.at(&[-90.0])?),
            speed(more.at(&[90.0])?),
            speed(more.at(&[-90.0])?),
            greatest.1,
            signed(greatest.0)
        ),
        verdict: Verdict::of(&[topples, greatest.1 < 0.5]),
        why: "differences below half a foot per second did not show in 1966",
    })
}

/// C16: pure pitch.
pub fn pure_pitch(results: &Results) -> Result<Answer, InputError> {
    let mut cells = Vec::new();
    let mut within = Vec::new();
    for (stem, tip) in [("figure-4-23", 9), ("figure-4-24", 5)] {
        let transitions = results.transitions(stem)?;
        for azimuth in [0.0, 180.0] {
            let first = transitions.at(&[azimuth])?;
            cells.push(format!("tip {tip}, azimuth {azimuth}: {}", speed(first)));
            within.push(first.is_some_and(|first| (11.0..=12.0).contains(&first.speed)));
        }
    }
    Ok(Answer {
        source: "figure-4-23, figure-4-24",
        number: cells.join("; "),
        verdict: Verdict::of(&within),
        why: "",
    })
}

/// C17: the tipped vehicle at a cross-slope of 150 deg.
pub fn across(results: &Results) -> Result<Answer, InputError> {
    let transitions = results.transitions("figure-4-25")?;
    let (place, lowest) = transitions.lowest()?;
    let below: Vec<f64> = transitions
        .points()
        .filter(|(_, first)| first.is_some_and(|first| first.speed < 11.5))
        .map(|(place, _)| place[0])
        .collect();
    let highest = transitions
        .points()
        .filter_map(|(_, first)| Some(first?.speed))
        .fold(f64::NEG_INFINITY, f64::max);
    Ok(Answer {
        source: "figure-4-25",
        number: format!(
            "{lowest:.2} at azimuth {} to {highest:.2}; {} of {} azimuths below 11.5",
            signed(place[0]),
            below.len(),
            transitions.points().count()
        ),
        verdict: Verdict::of(&[below.is_empty()]),
        why: "lower by up to half a foot per second at positive azimuths; that the transitions lie \
              above the lowest of Figure 4-23 holds",
    })
}
