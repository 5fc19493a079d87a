//! Claims about single landings: Table 4-3, and the two azimuths compared under Figure 4-23.

use touchdown_dynamics::outcome::Class;
use touchdown_dynamics::vehicle::Vehicle;

use super::answer::{Answer, Verdict};
use super::flights::{self, AZIMUTH_SPEED, LandingRun};
use touchdown::terminal::Failure;

/// C11: the landing of Table 4-3.
pub fn table_4_3(vehicle: &Vehicle) -> Result<Answer, Failure> {
    let (run, greatest) = flights::against_table_4_3(vehicle)?;
    Ok(Answer {
        source: "landing (170, −10) at 12 ft/s",
        number: format!(
            "{}; velocities within {greatest:.3} ft/s of all printed ones (below)",
            run.landing.outcome
        ),
        verdict: Verdict::of(&[
            run.landing.outcome.class() == Class::Unstable,
            // The print has two to three digits, and the report's integration its own error.
            greatest <= 0.012,
        ]),
        why: "",
    })
}

/// C13: tipped toward 90 deg.
pub fn azimuth_90(vehicle: &Vehicle) -> Result<Answer, Failure> {
    let run = flights::tipped(vehicle, 90.0)?;
    Ok(Answer {
        source: "landing at 11 ft/s",
        number: in_words(&run),
        verdict: Verdict::of(&[run.landing.outcome.class() == Class::Stable]),
        why: "",
    })
}

/// C14: tipped toward 112.5 deg, which 1966 found unstable.
pub fn azimuth_112(vehicle: &Vehicle) -> Result<Answer, Failure> {
    let plus = flights::tipped(vehicle, 112.5)?;
    let minus = flights::tipped(vehicle, -112.5)?;
    Ok(Answer {
        source: "landings at 11 ft/s",
        number: format!(
            "{}; at azimuth −112.5 {}",
            in_words(&plus),
            in_words(&minus)
        ),
        verdict: Verdict::of(&[plus.landing.outcome.class() == Class::Unstable]),
        why: "at +112.5 it topples from 11.1 ft/s only; the printed pitch lies between those of \
              +112.5 and −112.5, and the report's tolerance calls 1 in 5 such runs unstable \
              (chapter 9 of [the model](../docs/model.md))",
    })
}

fn in_words(run: &LandingRun) -> String {
    let pitch = match run.longest_flight() {
        Some(flight) => format!(
            ", pitch at the end of free flight {:.1} deg",
            flight.end.pitch
        ),
        None => String::new(),
    };
    format!("{} at {AZIMUTH_SPEED} ft/s{pitch}", run.landing.outcome).replace(" -", " \u{2212}")
}
