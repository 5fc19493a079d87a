//! Events of a landing.

use serde::Serialize;
use touchdown_dynamics::landing::Landing;
use touchdown_dynamics::outcome::Outcome;
use touchdown_dynamics::per_leg::PerLeg;
use touchdown_sweep::output::landing_report::verdict_time;
use touchdown_sweep::output::landing_table::why;

/// A single event.
#[derive(Debug, Serialize)]
pub struct Event {
    time_s: f64,
    kind: &'static str,
    leg: Option<usize>,
    title: String,
}

/// The events of a landing in order of time.
pub fn of(landing: &Landing) -> Vec<Event> {
    let mut events = contacts("pad-contact", "footpad", &landing.pad_contact);
    events.extend(contacts("block-contact", "block", &landing.block_contact));
    events.push(Event {
        time_s: landing.min_stability_time,
        kind: "least-stability",
        leg: None,
        title: "least stability angle".to_owned(),
    });
    let outcome = &landing.outcome;
    let (kind, leg) = match outcome {
        Outcome::Bottomed { leg }
        | Outcome::BottomedPad { leg }
        | Outcome::BottomedBlock { leg } => ("bottomed", Some(leg + 1)),
        Outcome::Failure(_) => ("failure", None),
        _ => ("verdict", None),
    };
    events.push(Event {
        time_s: verdict_time(landing),
        kind,
        leg,
        title: format!("{outcome}: {}", why(outcome)),
    });
    if let Some(beyond) = &landing.beyond {
        events.push(Event {
            time_s: landing.end_time,
            kind: "end",
            leg: None,
            title: beyond.end.to_string(),
        });
    }
    events.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    events
}

fn contacts(kind: &'static str, part: &str, times: &PerLeg<Option<f64>>) -> Vec<Event> {
    let known = times.iter().enumerate();
    let contact = |(leg, time): (usize, &Option<f64>)| {
        Some(Event {
            time_s: (*time)?,
            kind,
            leg: Some(leg + 1),
            title: format!("{part} {} touches", leg + 1),
        })
    };
    known.filter_map(contact).collect()
}
