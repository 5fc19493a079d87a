//! The table of work and precision, as CSV and for reading.

use std::fmt::Write;

use super::landings::Measured;

/// A tolerance.
pub struct Row {
    /// The tolerance.
    pub tolerance: f64,
    /// Its landings.
    pub landings: Measured,
    /// Number and error of its transitions.
    pub transitions: (usize, [f64; 2]),
}

/// Comma-separated values, a row for each tolerance.
pub fn csv(rows: &[Row]) -> String {
    let mut text =
        "tolerance,median_us_per_landing,mean_us_per_landing,mean_us_per_landing_abreast,\
                    share_of_lanes_taken,mean_steps,\
                    mean_derivative_evaluations,mean_events,\
                    median_position_error_at_0.3s_ft,worst_position_error_at_0.3s_ft,\
                    median_position_error_at_1s_ft,worst_position_error_at_1s_ft,\
                    median_pitch_error_at_0.3s_deg,worst_pitch_error_at_0.3s_deg,\
                    median_pitch_error_at_1s_deg,worst_pitch_error_at_1s_deg,\
                    median_least_angle_error_deg,worst_least_angle_error_deg,\
                    transitions,median_transition_error_fps,worst_transition_error_fps\n"
            .to_owned();
    for row in rows {
        let m = &row.landings;
        let mut cells = vec![
            format!("{:e}", row.tolerance),
            format!("{:.0}", m.time[0]),
            format!("{:.0}", m.time[1]),
            format!("{:.0}", m.time_in_lanes),
            format!("{:.3}", m.occupancy),
            format!("{:.0}", m.steps),
            format!("{:.0}", m.evaluations),
            format!("{:.0}", m.events),
        ];
        let (count, transition) = row.transitions;
        let errors = m.position.iter().chain(&m.pitch).chain([&m.least_angle]);
        cells.extend(errors.flatten().map(|error| format!("{error:.1e}")));
        cells.push(count.to_string());
        cells.extend(transition.map(|error| format!("{error:.1e}")));
        text += &cells.join(",");
        text.push('\n');
    }
    text
}

/// What matters most, in columns.
pub fn text(rows: &[Row]) -> String {
    let mut text = format!(
        "{:>9}  {:>12}  {:>8}  {:>7}  {:>12}  {:>12}  {:>14}  {:>20}\n{:>9}  {:>12}  {:>8}  {:>7}  {:>12}  \
         {:>12}  {:>14}  {:>20}\n",
        "",
        "us/landing",
        "in lanes",
        "evalua-",
        "position",
        "pitch",
        "least angle",
        "V_H, ft/s",
        "tolerance",
        "mean",
        "mean",
        "tions",
        "at 1 s, ft",
        "at 1 s, deg",
        "deg, worst",
        "median / worst",
    );
    for row in rows {
        let m = &row.landings;
        let [median, worst] = row.transitions.1;
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{:>9.0e}  {:>12.0}  {:>8.0}  {:>7.0}  {:>12.1e}  {:>12.1e}  {:>14.1e}  {:>20}",
            row.tolerance,
            m.time[1],
            m.time_in_lanes,
            m.evaluations,
            m.position[1][1],
            m.pitch[1][1],
            m.least_angle[1],
            format!("{median:.1e} / {worst:.1e}"),
        );
    }
    text
}
