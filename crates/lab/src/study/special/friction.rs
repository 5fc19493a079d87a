//! 4.1.5: how friction sets in, and whether footpads chatter.

use std::fmt::Write;

use touchdown_dynamics::friction::FrictionProfile;
use touchdown_dynamics::landing::Instant;
use touchdown_dynamics::methods::{ErrorControl, ErrorLimits, Method};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_figures::line_chart::{Axis, Curve, Panel, Stroke};

use super::chapter::{Chapter, chart};
use super::runs::{Run, control, sample_run, settings};
use touchdown::terminal::Failure;

/// Least intervals of the report's program, before and after 4.1.5, s.
const LEAST: [f64; 2] = [1e-6, 1e-5];
/// Time between looks at contacts, s.
const LOOKS: f64 = 0.001;
/// Time that Figure 4-4 shows, s.
const SHOWN: f64 = 0.5;
const PROFILES: [(FrictionProfile, &str); 3] = [
    (FrictionProfile::A, "A"),
    (FrictionProfile::B, "B"),
    (FrictionProfile::C, "C"),
];

/// Stretches of footpad contact within [`SHOWN`], all legs together.
fn contacts(moments: &[Instant]) -> usize {
    let shown: Vec<&Instant> = moments.iter().filter(|m| m.time <= SHOWN).collect();
    (0..moments[0].legs.len())
        .map(|leg| {
            let touches = |m: &&Instant| m.legs[leg].pad_normal > 0.0;
            let runs = shown.chunk_by(|a, b| touches(a) == touches(b));
            runs.filter(|run| touches(&run[0])).count()
        })
        .sum()
}

/// The chapter.
pub fn chapter(vehicle: &Vehicle) -> Result<Chapter, Failure> {
    let mut text = "\
## 4.1.5 Sliding friction

![Pitch under three friction profiles](study-4-1-5.svg)

| friction | profile | located: evaluations | contacts | least σ, deg | report, least interval 1e-6 s: evaluations | at the least | report, 1e-5 s: evaluations | at the least |
|---:|---|---:|---:|---:|---:|---:|---:|---:|
"
    .to_owned();
    let mut curves = Vec::new();
    let mut pitches: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut least_angles = Vec::new();
    for friction in [1.4, 0.8] {
        let scene = sample_run(Some(friction))?;
        for (profile, letter) in PROFILES {
            let located = settings(Method::Located).with_friction_profile(profile);
            let run = Run::of(vehicle, &scene, &located, LOOKS);
            let mut row = format!(
                "| {friction} | {letter} | {} | {} | {:.2} |",
                run.landing.evaluations,
                contacts(&run.moments),
                run.landing.min_stability_angle.to_degrees()
            );
            for least in LEAST {
                let limits = ErrorLimits::default();
                let method = control(limits, ErrorControl::FIRST_INTERVAL, least)?;
                let settings = settings(Method::Report(method)).with_friction_profile(profile);
                let by_report = Run::of(vehicle, &scene, &settings, f64::INFINITY);
                let _ = write!(
                    row,
                    " {} | {} of {} |",
                    by_report.landing.evaluations,
                    by_report.integration.bypassed,
                    by_report.integration.intervals
                );
            }
            let _ = writeln!(text, "{row}");
            let pitch: Vec<(f64, f64)> = run
                .pitch()
                .into_iter()
                .filter(|(time, _)| *time <= SHOWN)
                .collect();
            if friction == 1.4 {
                least_angles.push(run.landing.min_stability_angle.to_degrees());
                pitches.push(pitch.clone());
            }
            if friction == 1.4 || letter == "C" {
                let name = format!("friction {friction}, profile {letter}");
                let stroke = if letter == "C" {
                    Stroke::Line
                } else {
                    Stroke::Dashes
                };
                curves.push(Curve::new(&name, stroke, pitch));
            }
        }
    }
    let apart = pitches[..2]
        .iter()
        .flat_map(|other| other.iter().zip(&pitches[2]))
        .map(|(a, c)| (a.1 - c.1).abs())
        .fold(0.0, f64::max);
    let _ = writeln!(
        text,
        "\nProfile C is viscous up to 0.05 ft/s, B up to {} and A, which stands for a step, up to {}; the \
         picture that defined A and B is lost, so that B is our reading of \"in between\". At friction 1.4 \
         the pitch of A and B stays within {apart:.3} deg of that of C through the first half second, and \
         the footpads make and lose contact as often under all three: no profile makes them chatter, and C \
         is adequate, as the report found. What differs is the cost: a steep onset is stiff, under A the \
         report's program spends most intervals at the least one with errors unchecked, as it describes, \
         and a least interval of 1e-5 s instead of 1e-6 s makes that cheaper, not better.",
        FrictionProfile::B.viscous_limit(),
        FrictionProfile::A.viscous_limit()
    );
    let picture = chart(
        "4.1.5: pitch under three onsets of friction",
        "sample run, every event located; Figure 4-4 of the report",
        Axis::linear("time, s"),
        vec![Panel::new(Axis::linear("pitch, deg"), curves)],
    );
    Ok(Chapter {
        text,
        pictures: vec![("study-4-1-5", picture)],
    })
}
