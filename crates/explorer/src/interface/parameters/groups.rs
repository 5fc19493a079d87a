//! Display groups of parameters.

/// All groups, in display order.
const ORDER: [&str; 13] = [
    "touchdown",
    "attitude",
    "ground",
    "thrust",
    "body",
    "inertia",
    "linkage",
    "strut",
    "footpad",
    "block",
    "azimuth",
    "footing",
    "solver",
];
const ATTITUDE: [&str; 9] = [
    "pitch_deg",
    "yaw_deg",
    "roll_deg",
    "tip_deg",
    "tip_azimuth_deg",
    "nominal_roll_deg",
    "angular_velocity_x_dps",
    "angular_velocity_y_dps",
    "angular_velocity_z_dps",
];
const GROUND: [&str; 4] = ["slope_deg", "friction", "block_friction", "gravity_fps2"];

/// Position of a group.
pub fn place(group: &str) -> usize {
    let place = ORDER.iter().position(|known| *known == group);
    place.unwrap_or(ORDER.len())
}

/// Group of a parameter, and the number of the leg if it is one leg's own.
pub fn of(name: &str) -> (&'static str, Option<usize>) {
    let leg = |rest: &str| {
        rest.split(']')
            .next()
            .and_then(|number| number.parse().ok())
    };
    if let Some(rest) = name.strip_prefix("footing[") {
        return ("footing", leg(rest));
    }
    if name.starts_with("thrust.") {
        return ("thrust", None);
    }
    let Some(path) = name.strip_prefix("vehicle.") else {
        let group = if ATTITUDE.contains(&name) {
            "attitude"
        } else if GROUND.contains(&name) {
            "ground"
        } else {
            "touchdown"
        };
        return (group, None);
    };
    let (path, leg) = match path
        .strip_prefix("legs[")
        .and_then(|rest| rest.split_once("]."))
    {
        Some((number, path)) => (path, number.parse().ok()),
        None => (path, None),
    };
    let group = match path.split('.').next().unwrap_or_default() {
        "inertia_slug_ft2" => "inertia",
        "linkage" => "linkage",
        "strut" => "strut",
        "footpad" => "footpad",
        "block" => "block",
        "azimuth_deg" => "azimuth",
        _ => "body",
    };
    (group, leg)
}
