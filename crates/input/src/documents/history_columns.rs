//! Columns of the history of a landing: motion, loads and deformations, energies.

use touchdown_dynamics::landing::{Instant, LegInstant};

use crate::documents::column::Column;

/// Columns of the body.
pub const OF_BODY: [Column<Instant>; 18] = [
    Column::number("t_s", |at| Some(at.time), "time after first contact"),
    Column::number(
        "x_ft",
        |at: &Instant| Some(at.position.x),
        "CG, ground axis X (across the slope)",
    )
    .titled("Position across"),
    Column::number(
        "y_ft",
        |at: &Instant| Some(at.position.y),
        "CG, ground axis Y (horizontal, into the slope: uphill)",
    )
    .titled("Position up the slope"),
    Column::number(
        "z_ft",
        |at: &Instant| Some(at.position.z),
        "CG, ground axis Z (down along gravity)",
    )
    .titled("Position down"),
    Column::number(
        "x_rate_fps",
        |at: &Instant| Some(at.velocity.x),
        "velocity of the CG along X",
    )
    .titled("Velocity across"),
    Column::number(
        "y_rate_fps",
        |at: &Instant| Some(at.velocity.y),
        "velocity of the CG along Y",
    )
    .titled("Velocity up the slope"),
    Column::number(
        "z_rate_fps",
        |at: &Instant| Some(at.velocity.z),
        "velocity of the CG along Z",
    )
    .titled("Velocity down"),
    Column::number(
        "pitch_deg",
        |at| Some(at.attitude.euler().pitch.to_degrees()),
        "pitch Ψ",
    ),
    Column::number(
        "yaw_deg",
        |at| Some(at.attitude.euler().yaw.to_degrees()),
        "yaw Φ",
    ),
    Column::number(
        "roll_deg",
        |at| Some(at.attitude.euler().roll.to_degrees()),
        "roll Ξ",
    ),
    Column::number(
        "angular_velocity_x_dps",
        |at| Some(at.angular_velocity.x.to_degrees()),
        "angular velocity about the vehicle's x axis",
    ),
    Column::number(
        "angular_velocity_y_dps",
        |at| Some(at.angular_velocity.y.to_degrees()),
        "angular velocity about the vehicle's y axis",
    ),
    Column::number(
        "angular_velocity_z_dps",
        |at| Some(at.angular_velocity.z.to_degrees()),
        "angular velocity about the vehicle's z axis (centreline)",
    ),
    Column::number(
        "sigma_deg",
        |at: &Instant| Some(at.stability_angle.to_degrees()),
        "stability angle σ (79)",
    )
    .titled("Stability angle σ"),
    Column::number(
        "clearance_ft",
        |at| Some(at.clearance),
        "least height of the lower hardpoints over the surface",
    ),
    Column::number(
        "kinetic_energy_ftlb",
        |at| Some(at.kinetic_energy),
        "kinetic energy of body and lower links",
    ),
    Column::number(
        "potential_energy_change_ftlb",
        |at| Some(at.potential_change),
        "potential energy released since first contact",
    ),
    Column::number(
        "thrust_work_ftlb",
        |at| at.thrust_work,
        "work done by the thrust since first contact; only in scenes that have any",
    ),
];

/// Columns of each leg.
pub const OF_LEG: [Column<LegInstant>; 28] = [
    Column::number(
        "gamma_#_deg",
        |leg| leg.hinged().map(|posture| posture.link_angle.to_degrees()),
        "lower-link angle γ; grows as the strut extends",
    ),
    Column::number(
        "gamma_rate_#_dps",
        |leg| leg.hinged().map(|posture| posture.link_rate.to_degrees()),
        "its rate γ̇",
    ),
    Column::number(
        "alpha_#_deg",
        |leg| leg.hinged().map(|posture| posture.pad_angle.to_degrees()),
        "footpad angle α",
    ),
    Column::number(
        "alpha_rate_#_dps",
        |leg| leg.hinged().map(|posture| posture.pad_rate.to_degrees()),
        "its rate state α̇, which goes on integrating while the pad presses on a stop",
    ),
    Column::number(
        "foot_x_#_ft",
        |leg| leg.three_strut().map(|posture| posture.foot.x),
        "foot from the CG, along x of vehicle axes; legs of three struts only, as the next six",
    ),
    Column::number(
        "foot_y_#_ft",
        |leg| leg.three_strut().map(|posture| posture.foot.y),
        "the same along y",
    ),
    Column::number(
        "foot_z_#_ft",
        |leg| leg.three_strut().map(|posture| posture.foot.z),
        "the same along z (down the centreline)",
    ),
    Column::number(
        "stroke_a_#_ft",
        |leg| {
            leg.three_strut()
                .map(|posture| posture.secondary_strokes[0])
        },
        "stroke of the secondary strut at the lesser azimuth; shorter is positive",
    ),
    Column::number(
        "stroke_b_#_ft",
        |leg| {
            leg.three_strut()
                .map(|posture| posture.secondary_strokes[1])
        },
        "stroke of the other secondary strut",
    ),
    Column::number(
        "strut_force_a_#_lb",
        |leg| leg.three_strut().map(|posture| posture.secondary_forces[0]),
        "load of the secondary strut at the lesser azimuth, compression positive",
    ),
    Column::number(
        "strut_force_b_#_lb",
        |leg| leg.three_strut().map(|posture| posture.secondary_forces[1]),
        "load of the other secondary strut",
    ),
    Column::number(
        "stroke_#_ft",
        |leg| Some(leg.stroke),
        "strut stroke δ; of the primary strut of three",
    ),
    Column::number(
        "strut_force_#_lb",
        |leg| Some(leg.strut_force),
        "strut force F, compression positive; 0 off the surface and on the extension stop",
    ),
    Column::number(
        "pad_normal_#_lb",
        |leg| Some(leg.pad_normal),
        "normal force of the surface on the footpad",
    ),
    Column::number(
        "pad_friction_#_lb",
        |leg| Some(leg.pad_friction),
        "friction force on the footpad",
    ),
    Column::number(
        "block_normal_#_lb",
        |leg| Some(leg.block_normal),
        "normal force of the surface on the body block",
    ),
    Column::number(
        "block_friction_#_lb",
        |leg| Some(leg.block_friction),
        "friction force on the body block",
    ),
    Column::number(
        "pad_set_#_outboard_ft",
        |leg| Some(leg.pad_sets[0]),
        "plastic set P of the outboard pad section",
    ),
    Column::number(
        "pad_set_#_inboard_ft",
        |leg| Some(leg.pad_sets[1]),
        "plastic set P of the inboard pad section",
    ),
    Column::number(
        "pad_sinkage_#_ft",
        |leg| leg.sinkages.map(|sunk| sunk.pad[0].max(sunk.pad[1])),
        "greatest sinkage of the footpad so far; only in scenes on soil",
    ),
    Column::number(
        "block_set_#_ft",
        |leg| Some(leg.block_set),
        "plastic set P of the block",
    ),
    Column::number(
        "block_sinkage_#_ft",
        |leg| leg.sinkages.map(|sunk| sunk.block),
        "greatest sinkage of the block so far; only in scenes on soil",
    ),
    Column::number(
        "strut_work_#_ftlb",
        |leg| Some(leg.work.strut),
        "work done on the strut since first contact, what it stores included",
    ),
    Column::number(
        "pad_crush_work_#_ftlb",
        |leg| Some(leg.work.pad_crush),
        "work done on the footpad normal to the surface, what it stores included",
    ),
    Column::number(
        "pad_friction_work_#_ftlb",
        |leg| Some(leg.work.pad_friction),
        "work of sliding of the footpad",
    ),
    Column::number(
        "block_crush_work_#_ftlb",
        |leg| Some(leg.work.block_crush),
        "work done on the block normal to the surface",
    ),
    Column::number(
        "block_friction_work_#_ftlb",
        |leg| Some(leg.work.block_friction),
        "work of sliding of the block",
    ),
    Column::number(
        "stop_work_#_ftlb",
        |leg| Some(leg.work.stop),
        "energy of link motion that the extension stop ended, or that was frozen off the surface",
    ),
];

/// Names of the columns in program units: those of the body, then those of each leg.
pub fn names(instant: &Instant) -> Vec<String> {
    let of_body = OF_BODY
        .iter()
        .filter(|column| column.number_of(instant).is_some());
    let of_body = of_body.map(|column| column.name().to_owned());
    let legs = 1..=instant.legs.len();
    let of_legs = instant.legs.iter().zip(legs).flat_map(|(leg, number)| {
        let of_leg = OF_LEG.iter();
        let of_leg = of_leg.filter(|column| column.number_of(leg).is_some());
        of_leg.map(move |column| column.name_of_leg(number))
    });
    of_body.chain(of_legs).collect()
}

/// Their values in program units.
pub fn values(instant: &Instant) -> Vec<f64> {
    let of_body = OF_BODY
        .iter()
        .filter_map(|column| column.number_of(instant));
    let of_leg = |leg| {
        OF_LEG
            .iter()
            .filter_map(move |column| column.number_of(leg))
    };
    let of_legs = instant.legs.iter().flat_map(of_leg);
    of_body.chain(of_legs).collect()
}
