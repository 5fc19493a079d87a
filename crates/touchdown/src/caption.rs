//! The lines above a picture: what is shown and under which conditions.

use touchdown_dynamics::scene::CrushRule;
use touchdown_figures::boundary_profile::Caption;
use touchdown_sweep::sweep_file::Sweep;

/// Caption of the picture of a sweep.
pub fn caption<const LEGS: usize>(sweep: &Sweep<LEGS>) -> Caption {
    let mut parts = vec![sweep.vehicle.name.clone()];
    for (name, value) in sweep.fixed.resolved() {
        // Defaults that follow from an axis or from nothing need no mention.
        if sweep.fixed.get(name).is_some()
            && let Some(part) = in_words(name, value)
        {
            parts.push(part);
        }
    }
    if sweep.settings.crush_rule() == CrushRule::Section {
        parts.push("section crush rule".to_owned());
    }
    Caption {
        title: sweep.title.clone(),
        conditions: parts.join(" · "),
        searched_to: Some(sweep.search.to),
    }
}

/// A fixed condition in words, unless it is zero where that is the rule.
fn in_words(name: &str, value: f64) -> Option<String> {
    let words = match name {
        "vertical_velocity_fps" => format!("vertical velocity {value} ft/s"),
        "cross_slope_deg" => format!("cross-slope {value} deg"),
        "slope_deg" => format!("slope {value} deg"),
        "friction" => format!("friction {value}"),
        "block_friction" => format!("block friction {value}"),
        _ if value == 0.0 => return None,
        _ => {
            let bare = name
                .trim_end_matches("_deg")
                .trim_end_matches("_dps")
                .replace('_', " ");
            let unit = if name.ends_with("_dps") {
                "deg/s"
            } else {
                "deg"
            };
            format!("{bare} {value} {unit}")
        }
    };
    Some(words.replace(" -", " \u{2212}"))
}
