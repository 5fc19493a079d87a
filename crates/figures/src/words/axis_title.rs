//! Titles of axes: names of touchdown conditions in words and symbols, with units.

/// The axis title of a column of a result table: its name in words, or else the name itself.
pub fn axis_title(column: &str) -> String {
    let title = match column {
        "vertical_velocity_fps" => "Vertical velocity V_V, ft/s",
        "horizontal_velocity_fps" => "Horizontal velocity V_H, ft/s",
        "cross_slope_deg" => "Cross-slope angle λ, deg",
        "slope_deg" => "Slope θ, deg",
        "friction" => "Friction coefficient μ",
        "block_friction" => "Friction coefficient of the blocks",
        "pitch_deg" => "Pitch angle Ψ, deg",
        "yaw_deg" => "Yaw angle Φ, deg",
        "roll_deg" => "Roll angle Ξ, deg",
        "tip_deg" => "Tip angle ν, deg",
        "tip_azimuth_deg" => "Tip azimuth Γ, deg",
        "nominal_roll_deg" => "Nominal roll angle K, deg",
        "x_rate_fps" => "Velocity across, ft/s",
        "y_rate_fps" => "Velocity up the slope, ft/s",
        "psi_deg" => "Pitch angle Ψ, deg",
        "omega_x_dps" | "angular_velocity_x_dps" => "Angular velocity about x, deg/s",
        "angular_velocity_y_dps" => "Angular velocity about y, deg/s",
        "angular_velocity_z_dps" => "Angular velocity about z, deg/s",
        other => other,
    };
    title.to_owned()
}
