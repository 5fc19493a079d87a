//! Everything in the input that can vary over a sweep, by name.
//!
//! A parameter is a dotted key of the input: `vehicle.strut.compression_damping`, one leg's own
//! `vehicle.legs[2].strut.preload_lb`, `vehicle.footpad.profile.scale`, `solver.tolerance`. Keys of
//! the scene go by their short names too, and are always called by them in results.

use crate::document::Value;
use crate::input_error::InputError;
use crate::key_path::KeyPath;
use crate::method_input;
use crate::scene_input::NAMES;
use crate::{search_input, settings_input, vehicle_file};

/// A number (or one of a few words) of the input.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parameter {
    name: String,
    home: Home,
    path: KeyPath,
    words: &'static [&'static str],
}

/// The part of the input that a parameter belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Home {
    /// Touchdown conditions.
    Scene,
    /// The vehicle file.
    Vehicle,
    /// `[search]` or `[solver]` of the sweep file.
    Sweep,
}

impl Parameter {
    /// The parameter of a name, for vehicles with `legs` legs.
    pub fn named(name: &str, legs: usize) -> Option<Self> {
        let short = name.strip_prefix("scene.").unwrap_or(name);
        let (name, home, path) = if NAMES.contains(&short) {
            (short, Home::Scene, short)
        } else if let Some(path) = name.strip_prefix("vehicle.") {
            (name, Home::Vehicle, path)
        } else {
            (name, Home::Sweep, name)
        };
        if home != Home::Scene && !dotted_names(legs).iter().any(|known| known == name) {
            return None;
        }
        let words: &[&str] = match name {
            "solver.crush_rule" => &settings_input::CRUSH_RULES,
            "solver.friction_profile" => &settings_input::FRICTION_PROFILES,
            "solver.method" => &method_input::METHODS,
            _ => &[],
        };
        Some(Self {
            name: name.to_owned(),
            home,
            path: KeyPath::parse(path)?,
            words,
        })
    }

    /// Names most similar to a misspelt one, the most similar first.
    pub fn nearest(name: &str, legs: usize) -> Vec<String> {
        const SHOWN: usize = 3;
        const LEAST_LIKENESS: f64 = 0.75;
        const BELOW_BEST: f64 = 0.08;
        let scene = NAMES.iter().map(|name| (*name).to_owned());
        let full = NAMES.iter().map(|name| format!("scene.{name}"));
        let last = |name: &str| name.rsplit('.').next().unwrap_or(name).to_owned();
        let likeness = |known: &String| {
            let whole = strsim::jaro_winkler(name, known);
            // The right key in the wrong table, or in none, counts as similar.
            let key = strsim::jaro_winkler(&last(name), &last(known)) - 0.01;
            whole.max(key)
        };
        let all = scene.chain(full).chain(dotted_names(legs));
        let mut alike: Vec<(f64, String)> = all
            .map(|known| (likeness(&known), known))
            .filter(|(likeness, known)| {
                let short = !known.starts_with("scene.") || name.starts_with("scene.");
                *likeness > LEAST_LIKENESS && short
            })
            .collect();
        alike.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        let best = alike.first().map_or(0.0, |(likeness, _)| *likeness);
        alike.retain(|(likeness, _)| *likeness > best - BELOW_BEST);
        alike.truncate(SHOWN);
        alike.into_iter().map(|(_, known)| known).collect()
    }

    /// The message for an unknown name.
    pub(crate) fn unknown(name: &str, legs: usize) -> String {
        let guess = match Self::nearest(name, legs).as_slice() {
            [] => String::new(),
            names => format!("did you mean {}? ", names.join(" or ")),
        };
        format!(
            "unknown parameter; {guess}expected a key of the scene, or a dotted key of the vehicle, the \
             search or the solver, such as vehicle.strut.compression_damping"
        )
    }

    /// Its name, which heads its column in results.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The part of the input that it belongs to.
    pub fn home(&self) -> Home {
        self.home
    }

    /// Its key within that part.
    pub fn path(&self) -> &KeyPath {
        &self.path
    }

    /// Whether it is an angle or a rate of turn.
    pub fn is_angular(&self) -> bool {
        ["_deg", "_dps"]
            .iter()
            .any(|unit| self.name.ends_with(unit))
    }

    /// The words that it can be; none for a number.
    pub fn words(&self) -> &'static [&'static str] {
        self.words
    }

    /// The word of a coordinate, which is its index.
    pub fn word(&self, coordinate: f64) -> Option<&'static str> {
        self.words.get(coordinate as usize).copied()
    }

    /// The value in a text.
    ///
    /// # Errors
    /// When it is neither a finite number nor, of a parameter that has words, one of them.
    pub(crate) fn value(&self, text: &str) -> Result<Value, InputError> {
        match self.words {
            [] => match text.parse::<f64>() {
                Ok(number) if number.is_finite() => Ok(Value::Number(number)),
                _ => Err(InputError::value(&self.name, text, "a finite number")),
            },
            words if words.contains(&text) => Ok(Value::Text(text.to_owned())),
            words => Err(InputError::value(&self.name, text, &words.join(" or "))),
        }
    }

    /// A coordinate as results write it: with as many digits as it takes to read the same number
    /// back, or the word that it stands for.
    pub fn written(&self, coordinate: f64) -> String {
        match self.word(coordinate) {
            Some(word) => word.to_owned(),
            None => coordinate.to_string(),
        }
    }
}

/// Names of all parameters outside of the scene.
fn dotted_names(legs: usize) -> Vec<String> {
    let vehicle = vehicle_file::numbers(legs).into_iter();
    let search = search_input::NUMBERS.iter();
    let solver = settings_input::SOLVER.iter().chain(&method_input::KEYS);
    vehicle
        .map(|name| format!("vehicle.{name}"))
        .chain(search.map(|name| format!("search.{name}")))
        .chain(solver.map(|name| format!("solver.{name}")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn home(name: &str) -> Option<Home> {
        Parameter::named(name, 3).map(|parameter| parameter.home())
    }

    #[test]
    fn names_reach_into_all_of_the_input() {
        for name in ["slope_deg", "scene.slope_deg"] {
            let parameter = Parameter::named(name, 3).unwrap();
            assert_eq!(
                (parameter.name(), parameter.home()),
                ("slope_deg", Home::Scene)
            );
        }
        for name in [
            "vehicle.mass_slug",
            "vehicle.inertia_slug_ft2.xx",
            "vehicle.center_of_gravity_height_ft",
            "vehicle.strut.compression_damping",
            "vehicle.footpad.profile.scale",
            "vehicle.strut.damping_profile.scale",
            "vehicle.legs[3].azimuth_deg",
            "vehicle.legs[2].block.crush_pressure_psf",
            "vehicle.legs[1].strut.spring_profile.scale",
        ] {
            assert_eq!(home(name), Some(Home::Vehicle), "{name}");
        }
        for name in [
            "solver.tolerance",
            "solver.crush_rule",
            "search.tolerance_fps",
        ] {
            assert_eq!(home(name), Some(Home::Sweep), "{name}");
        }
        for name in [
            "vehicle.name",
            "vehicle.legs[4].azimuth_deg",
            "vehicle.legs[1].mass_slug",
            "title",
        ] {
            assert_eq!(home(name), None, "{name}");
        }
    }

    #[test]
    fn misspelt_names_bring_the_nearest_to_mind() {
        let first = |name| Parameter::nearest(name, 3).first().cloned();
        assert_eq!(first("rol_deg").as_deref(), Some("roll_deg"));
        assert_eq!(first("scene.slop_deg").as_deref(), Some("scene.slope_deg"));
        assert_eq!(
            first("vehicle.strut.compresion_damping").as_deref(),
            Some("vehicle.strut.compression_damping")
        );
        assert_eq!(
            first("compression_damping").as_deref(),
            Some("vehicle.strut.compression_damping")
        );
        assert_eq!(Parameter::nearest("wobble", 3), Vec::<String>::new());
    }

    #[test]
    fn words_are_written_as_words() {
        let rule = Parameter::named("solver.crush_rule", 3).unwrap();
        assert_eq!(
            (rule.written(0.0), rule.written(1.0)),
            ("pivot-rate".into(), "section".into())
        );
        let slope = Parameter::named("slope_deg", 3).unwrap();
        assert_eq!(slope.written(0.1), "0.1");
    }
}
