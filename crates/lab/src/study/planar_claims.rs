//! Claims about Figures 4-5 to 4-8: uphill and around at 20 ft/s, downhill over vertical velocity.

use touchdown_figures::boundary_table::Kind;
use touchdown_input::documents::input_error::InputError;

use super::answer::{Answer, Verdict, signed, speed};
use super::results::{Results, with_kind};

/// C01: uphill nothing topples, bottoming is the limit.
pub fn uphill(results: &Results) -> Result<Answer, InputError> {
    let bands = results.bands("figure-4-05")?;
    let transitions = results.transitions("figure-4-05")?;
    let topples = with_kind(&bands, Kind::Unstable).len();
    let bottoms = transitions
        .points()
        .all(|(_, first)| first.is_some_and(|t| t.kind == Kind::Bottomed));
    let (place, lowest) = transitions.lowest()?;
    let number = format!(
        "a strut bottoms first at every roll, lowest {lowest:.2} at roll {}; {topples} of {} rolls \
         topple at any speed up to 25 ft/s",
        signed(place[0]),
        bands.points.len()
    );
    Ok(Answer {
        source: "figure-4-05",
        number,
        verdict: Verdict::of(&[topples == 0, bottoms]),
        why: "",
    })
}

/// C02: around the compass at roll 0.
pub fn around(results: &Results) -> Result<Answer, InputError> {
    let bands = results.bands("figure-4-06")?;
    let transitions = results.transitions("figure-4-06")?;
    let topples = with_kind(&bands, Kind::Unstable);
    let least = topples
        .iter()
        .map(|place| place[0])
        .fold(f64::INFINITY, f64::min);
    let first: Vec<String> = transitions
        .points()
        .filter(|(_, first)| first.is_some_and(|t| t.kind == Kind::Unstable))
        .map(|(place, first)| format!("{}: {}", signed(place[0]), speed(first)))
        .collect();
    let number = if topples.is_empty() {
        "no toppling at any cross-slope".to_owned()
    } else {
        format!(
            "no toppling at any speed for cross-slopes below {} deg; toppling before bottoming at \
             {}",
            signed(least),
            first.join(", ")
        )
    };
    Ok(Answer {
        source: "figure-4-06",
        number,
        verdict: Verdict::of(&[least > 60.0, topples.is_empty()]),
        why: "which cross-slopes were plotted in 1966 is lost; the claim holds toward uphill, where \
              4.2.4 makes it, and not downhill",
    })
}

/// C03: downhill over the vertical velocity.
pub fn downhill(results: &Results) -> Result<Answer, InputError> {
    let transitions = results.transitions("figure-4-07")?;
    let none: Vec<f64> = transitions
        .points()
        .filter(|(_, first)| first.is_none())
        .map(|(place, _)| place[0])
        .collect();
    let highest_none = none.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let at_14 = transitions.at(&[14.0])?;
    let here = at_14.map_or(f64::NAN, |t| t.speed);
    let lower: Vec<String> = transitions
        .points()
        .filter(|(_, first)| first.is_some_and(|t| t.speed < here))
        .map(|(place, first)| format!("{} ({})", signed(place[0]), speed(first)))
        .collect();
    let toppling = transitions
        .points()
        .all(|(_, first)| first.is_none_or(|t| t.kind == Kind::Unstable));
    let number = format!(
        "no transition for V_V ≤ {}; {} at V_V 14; lower at V_V {}",
        signed(highest_none),
        speed(at_14),
        lower.join(", ")
    );
    Ok(Answer {
        source: "figure-4-07",
        number,
        verdict: Verdict::of(&[toppling, highest_none >= 10.0, here < 11.5]),
        why: "one of the lowest holds among neighbours; from V_V 20 the transition drops below it",
    })
}

/// C04: downhill with a roll of 60 deg.
pub fn downhill_rolled(results: &Results) -> Result<Answer, InputError> {
    let bands = results.bands("figure-4-08")?;
    let transitions = results.transitions("figure-4-08")?;
    let topples = with_kind(&bands, Kind::Unstable);
    let bottoms: Vec<String> = transitions
        .points()
        .filter_map(|(place, first)| Some((place, first?)))
        .map(|(place, first)| format!("{} ({:.2})", signed(place[0]), first.speed))
        .collect();
    let number = format!(
        "first transitions, all to bottoming, at V_V {}; {} of {} vertical velocities topple at any \
         speed",
        bottoms.join(", "),
        topples.len(),
        bands.points.len()
    );
    let kinds = transitions
        .points()
        .all(|(_, first)| first.is_none_or(|t| t.kind == Kind::Bottomed));
    Ok(Answer {
        source: "figure-4-08",
        number,
        verdict: Verdict::of(&[topples.is_empty(), kinds]),
        why: "",
    })
}
