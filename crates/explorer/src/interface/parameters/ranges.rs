//! Over which values a slider of a parameter makes sense. What is allowed at all only the engine knows: it refuses the rest.

/// The last key of a dotted name, with the part that it belongs to.
fn bare(name: &str) -> &str {
    match name.rsplit_once("].") {
        Some((_, key)) => key,
        None => name.strip_prefix("vehicle.").unwrap_or(name),
    }
}

/// Ends of a slider of a parameter that has a value, both in the unit of the program.
pub fn shown(name: &str, value: f64) -> [f64; 2] {
    let about = |least: f64| {
        let reach = value.abs().max(least);
        [value - reach, value + reach]
    };
    match bare(name) {
        "vertical_velocity_fps" | "horizontal_velocity_fps" => [0.0, 30.0],
        "slope_deg" => [-30.0, 45.0],
        "friction" | "block_friction" => [0.0, 2.0],
        "pitch_deg" | "yaw_deg" => [-45.0, 45.0],
        "tip_deg" => [0.0, 45.0],
        "cross_slope_deg" | "roll_deg" | "tip_azimuth_deg" | "nominal_roll_deg" => [-180.0, 180.0],
        "gravity_fps2" => [0.5, 35.0],
        "height_ft" | "block_height_ft" if name.starts_with("footing") => [-2.0, 2.0],
        "thrust.scale" => [0.0, 2.0],
        "thrust.offset_x_ft" | "thrust.offset_y_ft" => [-1.0, 1.0],
        "center_of_gravity_offset_x_ft" | "center_of_gravity_offset_y_ft" => [-1.0, 1.0],
        "center_of_gravity_height_ft" | "block.height_ft" => about(1.0),
        "inertia_slug_ft2.xy" | "inertia_slug_ft2.xz" | "inertia_slug_ft2.yz" => about(20.0),
        "linkage.hardpoint_angle_deg" => [0.0, 90.0],
        "linkage.lower_hardpoint_radius_ft" | "linkage.lower_link_length_ft" => {
            [0.75 * value, 1.25 * value]
        }
        "linkage.hardpoint_distance_ft" => [0.9 * value, 1.1 * value],
        "strut.extended_length_ft" | "strut.minimum_length_ft" => [0.95 * value, 1.05 * value],
        "strut.friction_fraction" => [0.0, 0.9],
        "footpad.edge_angle_deg" => [30.0, 80.0],
        "footpad.minimum_angle_deg" => [-45.0, value.max(0.0)],
        "footpad.maximum_angle_deg" => [value.min(45.0), 85.0],
        "solver.time_limit_s" => [1.0, 60.0],
        "azimuth_deg" => [value - 20.0, value + 20.0],
        key if key.contains("tilt_") => [-30.0, 30.0],
        key if key.ends_with("_dps") => [-60.0, 60.0],
        _ if value == 0.0 => [0.0, 1.0],
        _ => [0.25 * value, 2.0 * value],
    }
}
