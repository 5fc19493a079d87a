//! The table of claims: the report's words in brief, our figure and number, verdict and reason.

use std::fmt::Write;

use touchdown_dynamics::vehicle::Vehicle;

use super::answer::Answer;
use super::results::Results;
use super::{judged_landings, level_claims, planar_claims, tipped_claims};
use touchdown::terminal::Failure;

/// The claims of Section 4.2, embedded so that the program and the list cannot drift apart.
const CLAIMS: &str = include_str!("../../../dynamics/tests/reference/claims-1966.csv");

/// The section with a row for every claim of the list.
///
/// # Errors
/// When a result is missing, or the list has a claim that nothing here answers.
pub fn section(results: &Results, vehicle: &Vehicle) -> Result<String, Failure> {
    let mut text = "\
## Claim by claim

| claim | figure | condition | 1966 | ours | our number | verdict | why |
|---|---|---|---|---|---|---|---|
"
    .to_owned();
    let mut reader = csv::Reader::from_reader(CLAIMS.as_bytes());
    for record in reader.records() {
        let record = record.map_err(Failure::running)?;
        let [id, figure, conditions, claim] = [0, 1, 2, 3].map(|column| &record[column]);
        let Answer {
            source,
            number,
            verdict,
            why,
        } = answer(id, results, vehicle)?;
        let verdict = verdict.word();
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "| {id} | {figure} | {conditions} | {claim} | {source} | {number} | {verdict} | {why} |"
        );
    }
    Ok(text)
}

fn answer(id: &str, results: &Results, vehicle: &Vehicle) -> Result<Answer, Failure> {
    Ok(match id {
        "C01" => planar_claims::uphill(results)?,
        "C02" => planar_claims::around(results)?,
        "C03" => planar_claims::downhill(results)?,
        "C04" => planar_claims::downhill_rolled(results)?,
        "C05" => level_claims::baseline(results)?,
        "C06" => level_claims::rises_with_roll(results)?,
        "C07" => level_claims::valley(results)?,
        "C08" => level_claims::across(results)?,
        "C09" => level_claims::below_the_baseline(results)?,
        "C10" => level_claims::jump(results)?,
        "C11" => judged_landings::table_4_3(vehicle)?,
        "C12" => tipped_claims::most_critical(results)?,
        "C13" => judged_landings::azimuth_90(vehicle)?,
        "C14" => judged_landings::azimuth_112(vehicle)?,
        "C15" => tipped_claims::less_tip(results)?,
        "C16" => tipped_claims::pure_pitch(results)?,
        "C17" => tipped_claims::across(results)?,
        other => {
            let complaint = format!("claims-1966.csv: nothing answers the claim {other}");
            return Err(Failure::running(complaint));
        }
    })
}
