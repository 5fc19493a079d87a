//! The histories behind Table 4-3 and behind the two azimuths compared under Figure 4-23, as tables
//! with their pictures.

use std::fmt::Write;

use serde_json::{Value, json};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_figures::picture::{self, Choices, Source};

use super::flights::{self, AZIMUTH_SPEED, INTERVAL, Moment};
use touchdown::terminal::Failure;

/// Tip azimuths shown, deg: those that the report compares and their mirror images.
const AZIMUTHS: [f64; 4] = [90.0, -90.0, 112.5, -112.5];

/// Files by name: each table, its record and its pictures.
///
/// # Errors
/// When a landing cannot be computed or drawn.
pub fn files(vehicle: &Vehicle) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    for (stem, table, record) in [
        (
            "history-table-4-3",
            table_4_3(vehicle)?,
            json!({
                "title": "Table 4-3: horizontal velocities of a landing that topples",
                "statement": "1966: the velocities printed in Table 4-3",
                "input": conditions(json!({
                    "horizontal_velocity_fps": 12, "cross_slope_deg": 170, "roll_deg": -10,
                })),
            }),
        ),
        (
            "history-tip-azimuth",
            azimuths(vehicle)?,
            json!({
                "title": "Tip azimuth 90 against 112.5 deg: pitch and pitch rate",
                "statement": "1966: pitch at the end of free flight \u{2212}34.2 deg at 90, stable; \
                              \u{2212}36.8 deg at 112.5, unstable",
                "input": conditions(json!({
                    "horizontal_velocity_fps": AZIMUTH_SPEED, "cross_slope_deg": 180, "tip_deg": 9,
                })),
            }),
        ),
    ] {
        let record = format!("{record:#}\n");
        let source = Source {
            name: stem,
            table: &table,
            record: Some(&record),
            ..Source::default()
        };
        let pictures = picture::draw(&source, &Choices::default()).map_err(Failure::running)?;
        files.extend(crate::as_files(stem, pictures));
        files.push((format!("{stem}.csv"), table.into_bytes()));
        files.push((format!("{stem}.json"), record.into_bytes()));
    }
    Ok(files)
}

/// The input of a record: what all these landings have in common, and what is given.
fn conditions(given: Value) -> Value {
    let mut scene = json!({ "vertical_velocity_fps": 14, "slope_deg": 15, "friction": 1 });
    if let (Some(scene), Value::Object(given)) = (scene.as_object_mut(), given) {
        scene.extend(given);
    }
    json!({ "scene": scene })
}

fn table_4_3(vehicle: &Vehicle) -> Result<String, Failure> {
    let run = flights::table_4_3_landing(vehicle)?;
    let printed = flights::printed()?;
    let mut text = "t_s,x_rate_fps,x_rate_1966_fps,y_rate_fps,y_rate_1966_fps,touches\n".to_owned();
    for moment in run.moments {
        let Moment {
            time,
            velocity: [x, y],
            ..
        } = moment;
        let print = printed
            .iter()
            .find(|(at, _)| (at - time).abs() < 0.1 * INTERVAL);
        let [px, py] = print.map_or([String::new(), String::new()], |(_, print)| {
            print.map(|value| value.to_string())
        });
        let touches = u8::from(!moment.is_free);
        let _ = writeln!(text, "{time:.4},{x:.4},{px},{y:.4},{py},{touches}");
    }
    Ok(text)
}

fn azimuths(vehicle: &Vehicle) -> Result<String, Failure> {
    let mut text = "tip_azimuth_deg,t_s,pitch_deg,angular_velocity_x_dps,touches\n".to_owned();
    for azimuth in AZIMUTHS {
        for moment in flights::tipped(vehicle, azimuth)?.moments {
            let Moment {
                time,
                pitch,
                pitch_rate,
                ..
            } = moment;
            let touches = u8::from(!moment.is_free);
            let _ = writeln!(
                text,
                "{azimuth},{time:.4},{pitch:.3},{pitch_rate:.3},{touches}"
            );
        }
    }
    Ok(text)
}
