//! The columns of a landing; events that never happened are empty.

use touchdown_dynamics::landing::{Landing, LegWork};
use touchdown_dynamics::outcome::Outcome;
use touchdown_input::documents::column::Column;

/// Columns of tables of landings.
pub const COLUMNS: [Column<Landing>; 18] = [
    Column::word(
        "outcome",
        |landing| landing.outcome.to_string(),
        "how it ended; [words](guide.md#1-one-landing)",
    ),
    Column::number(
        "end_time_s",
        |landing| Some(landing.end_time),
        "when, after first contact",
    ),
    Column::number(
        "min_stability_angle_deg",
        |landing| Some(landing.min_stability_angle.to_degrees()),
        "least stability angle σ up to the verdict, or to rest where the landing waits for it; 0 where the vehicle \
         toppled, or was beyond its critical feet or the hull of its feet at any time",
    ),
    Column::number(
        "min_clearance_ft",
        |landing| Some(landing.min_clearance),
        "least height of a lower hardpoint over the surface (71), or over the ground of the block beside it; with \
         `stop = \"time\"` that of the whole landing",
    ),
    Column::number(
        "tilt_deg",
        |landing| Some(landing.tilt.to_degrees()),
        "inclination of the centreline to the vertical at the end",
    ),
    Column::number(
        "initial_kinetic_energy_ftlb",
        |landing| Some(landing.energies.initial_kinetic),
        "kinetic energy at first contact, body and lower links",
    ),
    Column::number(
        "potential_energy_change_ftlb",
        |landing| Some(landing.energies.potential_change),
        "potential energy released since first contact",
    ),
    Column::legs(
        "max_strut_force_#_lb",
        |landing, leg| landing.max_strut_force.get(leg).copied(),
        "largest magnitude of the strut force",
    ),
    Column::legs(
        "max_stroke_#_ft",
        |landing, leg| landing.max_stroke.get(leg).copied(),
        "greatest stroke of the strut",
    ),
    Column::legs(
        "max_stroke_share_#",
        |landing, leg| landing.max_stroke_share.get(leg).copied(),
        "the same as a share of the stroke at which the strut bottoms",
    ),
    Column::legs(
        "max_sinkage_#_ft",
        |landing, leg| landing.max_sinkage.get(leg).copied(),
        "greatest sinkage of the footpad into soil; 0 on rock",
    ),
    Column::legs(
        "pad_contact_#_s",
        |landing, leg| landing.pad_contact.get(leg).copied().flatten(),
        "first contact of the footpad; empty: never",
    ),
    Column::legs(
        "block_contact_#_s",
        |landing, leg| landing.block_contact.get(leg).copied().flatten(),
        "first contact of the body block; empty: never",
    ),
    Column::number(
        "given_by_contact_ftlb",
        |landing| Some(landing.energies.given_by_contact()),
        "energy that footpads, crush and friction together, and blocks gave to the motion, which no material does; 0 \
         under the contact rule `\"face\"`",
    ),
    Column::number(
        "energy_closure_ftlb",
        |landing| Some(landing.energies.closure()),
        "energy that the account does not explain; 0 but for integration error",
    ),
    Column::count(
        "steps",
        |landing| landing.steps,
        "accepted integration steps",
    ),
    Column::count(
        "derivative_evaluations",
        |landing| landing.evaluations,
        "evaluations of the equations of motion, event location included",
    ),
    Column::word(
        "failure",
        |landing| failure(&landing.outcome),
        "why a landing could not be computed to its end; empty otherwise",
    ),
];

/// Additional results in reports of single landings.
pub const OF_REPORTS: [Column<Landing>; 10] = [
    Column::number(
        "min_stability_time_s",
        |landing| Some(landing.min_stability_time),
        "when the stability angle was least",
    ),
    Column::number(
        "thrust_work_ftlb",
        |landing| Some(landing.energies.thrust),
        "work done by the thrust",
    ),
    Column::number(
        "final_kinetic_energy_ftlb",
        |landing| Some(landing.energies.final_kinetic),
        "kinetic energy at the end, body and lower links",
    ),
    Column::legs(
        "strut_work_#_ftlb",
        |landing, leg| work(landing, leg, |work| work.strut),
        "work done on the strut, what it stores included",
    ),
    Column::legs(
        "pad_crush_work_#_ftlb",
        |landing, leg| work(landing, leg, |work| work.pad_crush),
        "work done on the footpad normal to the surface, what it stores included",
    ),
    Column::legs(
        "pad_friction_work_#_ftlb",
        |landing, leg| work(landing, leg, |work| work.pad_friction),
        "work of sliding of the footpad",
    ),
    Column::legs(
        "block_crush_work_#_ftlb",
        |landing, leg| work(landing, leg, |work| work.block_crush),
        "work done on the block normal to the surface",
    ),
    Column::legs(
        "block_friction_work_#_ftlb",
        |landing, leg| work(landing, leg, |work| work.block_friction),
        "work of sliding of the block",
    ),
    Column::legs(
        "stop_work_#_ftlb",
        |landing, leg| work(landing, leg, |work| work.stop),
        "energy of link motion that the extension stop ended, or that was frozen off the surface",
    ),
    Column::count(
        "events",
        |landing| landing.events,
        "located changes of a law",
    ),
];

fn work(landing: &Landing, leg: usize, of: fn(&LegWork) -> f64) -> Option<f64> {
    landing.energies.legs.get(leg).map(of)
}

/// An outcome in words.
pub fn why(outcome: &Outcome) -> String {
    match outcome {
        Outcome::StableRockback => "it tipped up, stopped and fell back".to_owned(),
        Outcome::StableSubsided => "its motion died out near the ground".to_owned(),
        Outcome::UnstablePitch => {
            "its CG passed over the line through the critical feet".to_owned()
        }
        Outcome::UnstableToppled => "its CG passed beyond the hull of its feet".to_owned(),
        Outcome::UnstableYaw => "all feet are on one side of the plane of motion".to_owned(),
        Outcome::Bottomed { leg } => format!("strut {} used up its stroke", leg + 1),
        Outcome::BottomedPad { leg } => {
            format!("footpad {} was crushed by its whole height", leg + 1)
        }
        Outcome::BottomedBlock { leg } => {
            format!("block {} was crushed by its whole height", leg + 1)
        }
        Outcome::TimeExpired => "it was still moving at the time limit".to_owned(),
        Outcome::Failure(reason) => reason.to_string(),
        Outcome::Sliding => {
            "it slides steadily down a slope on which friction cannot stop it".to_owned()
        }
        Outcome::StableSteady => "it was steady and far from toppling".to_owned(),
    }
}

/// Reason why a landing could not be computed; otherwise empty.
fn failure(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Failure(reason) => reason.to_string(),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::{names, text};
    use crate::summary::findings::tests::example;
    use touchdown_input::documents::column::{cells, headings};

    #[test]
    fn columns_have_the_names_of_the_contract() {
        assert_eq!(
            names(headings(&COLUMNS, 3)),
            "outcome,end_time_s,min_stability_angle_deg,min_clearance_ft,tilt_deg,\
             initial_kinetic_energy_ftlb,potential_energy_change_ftlb,\
             max_strut_force_1_lb,max_strut_force_2_lb,max_strut_force_3_lb,\
             max_stroke_1_ft,max_stroke_2_ft,max_stroke_3_ft,\
             max_stroke_share_1,max_stroke_share_2,max_stroke_share_3,\
             max_sinkage_1_ft,max_sinkage_2_ft,max_sinkage_3_ft,\
             pad_contact_1_s,pad_contact_2_s,pad_contact_3_s,\
             block_contact_1_s,block_contact_2_s,block_contact_3_s,\
             given_by_contact_ftlb,energy_closure_ftlb,steps,derivative_evaluations,failure"
        );
        let expected = "failure,1.5,29.999999999999996,0.5,29.999999999999996,100,10,1,2,3,\
                        0.25,0.5,0.125,0.5,1,0.25,0,0.0625,0,0,,0.25,,,,0,0.5,7,70,loaded footpad 2 inclined more than 65 deg";
        let written = |legs| text(cells(&COLUMNS, &example(), legs));
        assert_eq!(written(3), expected);
        // A table for four legs has an empty cell for the leg that is not there.
        assert_eq!(
            written(4),
            expected.replace("1,2,3,", "1,2,3,,").replace(
                "0.125,0.5,1,0.25,0,0.0625,0,0,,0.25,,,,",
                "0.125,,0.5,1,0.25,,0,0.0625,0,,0,,0.25,,,,,,"
            )
        );
    }
}
