//! Allowed values of parameters, and sensible ranges of sliders.

use serde::Serialize;

/// A range of allowed values.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Allowed {
    /// Lower end.
    pub lower: f64,
    /// Upper end.
    pub upper: f64,
    /// True if the lower end is excluded.
    pub is_lower_open: bool,
    /// True if the upper end is excluded.
    pub is_upper_open: bool,
    /// The range in words, in program units.
    pub text: &'static str,
}

impl Allowed {
    fn within(lower: f64, upper: f64, text: &'static str) -> Self {
        Self {
            lower,
            upper,
            is_lower_open: text.contains("< value"),
            is_upper_open: text.contains("value <"),
            text,
        }
    }

    /// The same range in another unit.
    pub fn in_unit(&self, convert: impl Fn(f64) -> f64) -> Self {
        Self {
            lower: convert(self.lower),
            upper: convert(self.upper),
            ..self.clone()
        }
    }
}

/// Last key of a dotted name, with the part it belongs to.
fn bare(name: &str) -> &str {
    match name.rsplit_once("].") {
        Some((_, key)) => key,
        None => name.strip_prefix("vehicle.").unwrap_or(name),
    }
}

/// Allowed values of a parameter, by its name in program units, regardless of other parameters.
pub fn of(name: &str) -> Allowed {
    match bare(name) {
        "vertical_velocity_fps" | "horizontal_velocity_fps" => {
            Allowed::within(0.0, 1e4, "0 ≤ value ≤ 10000")
        }
        "slope_deg" => Allowed::within(-90.0, 90.0, "-90 < value < 90"),
        "friction" | "block_friction" => Allowed::within(0.0, 1000.0, "0 ≤ value ≤ 1000"),
        "tip_deg" => Allowed::within(0.0, 180.0, "0 ≤ value ≤ 180"),
        "height_ft" | "block_height_ft" if name.starts_with("footing") => {
            Allowed::within(-1000.0, 1000.0, "-1000 ≤ value ≤ 1000")
        }
        "tilt_along_deg" | "tilt_across_deg" | "block_tilt_along_deg" | "block_tilt_across_deg" => {
            Allowed::within(-60.0, 60.0, "-60 ≤ value ≤ 60")
        }
        "linkage.hardpoint_angle_deg" => Allowed::within(0.0, 90.0, "between 0 and 90"),
        "strut.friction_fraction" => Allowed::within(0.0, 1.0, "0 ≤ value < 1"),
        "footpad.edge_angle_deg" => Allowed::within(30.0, 84.0, "30 ≤ value < 84"),
        "footpad.minimum_angle_deg" | "footpad.maximum_angle_deg" => {
            Allowed::within(-90.0, 90.0, "-90 < value < 90")
        }
        "solver.tolerance" => Allowed::within(1e-12, 1e-2, "1e-12 ≤ value ≤ 1e-2"),
        "solver.time_limit_s" => Allowed::within(0.0, 1000.0, "0 < value ≤ 1000"),
        "azimuth_deg"
        | "center_of_gravity_height_ft"
        | "center_of_gravity_offset_x_ft"
        | "center_of_gravity_offset_y_ft"
        | "inertia_slug_ft2.xy"
        | "inertia_slug_ft2.xz"
        | "inertia_slug_ft2.yz"
        | "block.height_ft" => Allowed::within(-1e9, 1e9, "-1e9 ≤ value ≤ 1e9"),
        "strut.spring_constant_lb_per_ft"
        | "strut.compression_damping"
        | "strut.rebound_damping"
        | "strut.rebound_growth_per_ft" => Allowed::within(0.0, 1e9, "0 ≤ value ≤ 1e9"),
        "thrust.scale" => Allowed::within(0.0, 1e9, "0 ≤ value ≤ 1e9"),
        "thrust.offset_x_ft" | "thrust.offset_y_ft" => {
            Allowed::within(-1000.0, 1000.0, "-1000 ≤ value ≤ 1000")
        }
        key if key.ends_with("_deg") || key.ends_with("_dps") => {
            Allowed::within(-36_000.0, 36_000.0, "-36000 ≤ value ≤ 36000")
        }
        key if key.starts_with("solver.") => Allowed::within(-1e9, 1e9, "-1e9 ≤ value ≤ 1e9"),
        _ => Allowed::within(0.0, 1e9, "0 < value ≤ 1e9"),
    }
}

/// Ends of the slider of a parameter with a value, in program units.
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
