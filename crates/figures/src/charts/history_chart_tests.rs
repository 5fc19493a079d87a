use super::*;

fn drawn(tables: &[(&str, &str)], columns: &[&str]) -> String {
    let tables = tables.iter().map(|(name, text)| {
        let table = HistoryTable::parse(text).unwrap();
        ((*name).to_owned(), table)
    });
    let columns: Vec<String> = columns.iter().map(|name| (*name).to_owned()).collect();
    draw(&tables.collect::<Vec<_>>(), &columns, &Caption::default()).unwrap()
}

#[test]
fn every_quantity_has_a_panel_and_free_flight_is_thick() {
    let text = "tip_azimuth_deg,t_s,pitch_deg,angular_velocity_x_dps,touches\n\
                90,0,1,-3,1\n90,0.5,2,-2,0\n90,1,2,-2,0\n-90,0,3,1,1\n-90,1,3,2,1\n";
    let svg = drawn(&[("", text)], &[]);
    assert!(svg.contains("Pitch angle") && svg.contains("Angular velocity about x"));
    assert!(svg.contains("Γ = 90 deg") && svg.contains("Γ = \u{2212}90 deg"));
    // One stretch in each panel, and the legend's.
    assert_eq!(svg.matches("stroke-width=\"4\"").count(), 3);
    assert!(svg.contains("free flight"));
}

#[test]
fn printed_values_are_circles() {
    let text = "t_s,y_rate_fps,y_rate_1966_fps\n0,1,1.1\n0.5,2,\n1,3,3\n";
    let svg = drawn(&[("", text)], &[]);
    // Two values, and the legend's.
    assert_eq!(svg.matches("<circle").count(), 3);
    assert!(svg.contains("printed in 1966"));
}

#[test]
fn several_tables_lie_over_each_other_each_with_its_dashes() {
    let one = "t_s,pitch_deg,roll_deg\n0,1,2\n1,2,3\n";
    let other = "t_s,pitch_deg\n0,1\n2,4\n";
    let svg = drawn(
        &[("one", one), ("other", other)],
        &["pitch_deg", "roll_deg"],
    );
    assert!(svg.contains(">one</text>") && svg.contains(">other</text>"));
    assert!(svg.contains("Angle, deg") && svg.contains(">pitch angle Ψ</text>"));
    // Pitch of the other landing, and the legend's sample.
    assert_eq!(svg.matches("stroke-dasharray").count(), 2);
    // Time goes on to the end of the longer.
    assert!(svg.contains(">2</text>"));
}
