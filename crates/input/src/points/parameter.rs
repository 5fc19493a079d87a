//! The parameters of a sweep: every input that can vary, by name.
//!
//! A parameter is a dotted key of the input: `vehicle.strut.compression_damping`, one leg's own
//! `vehicle.legs[2].strut.preload_lb`, `vehicle.footpad.profile.scale`, `solver.tolerance`. Keys of the scene also have
//! short names, which results always use. A parameter named in an SI unit has its values and result columns in that
//! unit.

use std::sync::OnceLock;

use touchdown_dynamics::per_leg::MOST_LEGS;
use touchdown_dynamics::quantity::Quantity;

use crate::documents::column::{Cell, Heading, Kind};
use crate::documents::document::Value;
use crate::documents::input_error::InputError;
use crate::documents::key_path::KeyPath;
use crate::documents::spelling::{
    Conversion, did_you_mean, differ_in_unit, dotted_conversion, spellings, with_unit_of,
};
use crate::readers::scene_input::{self, FaultyValue, SceneFault};
use crate::readers::{search_input, settings_input, vehicle_file};

/// A number of the input, or one of a few words.
#[derive(Debug, Clone)]
pub struct Parameter {
    name: String,
    program_name: String,
    conversion: Conversion,
    home: Home,
    path: KeyPath,
    words: Vec<&'static str>,
    quantity: Option<&'static Quantity>,
}

/// Parameters are equal if they are the same quantity, in whatever unit.
impl PartialEq for Parameter {
    fn eq(&self, other: &Self) -> bool {
        self.program_name == other.program_name
    }
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
    /// Finds the parameter with a name, in any of its units, for vehicles with `legs` legs.
    pub fn named(name: &str, legs: usize) -> Option<Self> {
        let short = name.strip_prefix("scene.").unwrap_or(name);
        let of_scene = scene_input::conditions(legs).iter().find_map(|known| {
            let conversion = dotted_conversion(short, &known.name)?;
            Some((short, known.name.clone(), conversion, Some(known.quantity)))
        });
        let others = || {
            dotted(legs).iter().find_map(|(known, quantity)| {
                let conversion = dotted_conversion(name, known)?;
                Some((name, known.clone(), conversion, *quantity))
            })
        };
        let is_scene = of_scene.is_some();
        let (name, program_name, conversion, quantity) = of_scene.or_else(others)?;
        let (home, path) = match program_name.strip_prefix("vehicle.") {
            _ if is_scene => (Home::Scene, program_name.as_str()),
            Some(path) => (Home::Vehicle, path),
            None => (Home::Sweep, program_name.as_str()),
        };
        let words = word_keys().find(|(key, _)| program_name == *key);
        let words = words.map_or(Vec::new(), |(_, words)| words);
        Some(Self {
            name: name.to_owned(),
            path: KeyPath::parse(path)?,
            program_name,
            conversion,
            home,
            words,
            quantity,
        })
    }

    /// Names most similar to a misspelt one, most similar first.
    pub fn nearest(name: &str, legs: usize) -> Vec<String> {
        const SHOWN: usize = 3;
        const LEAST_LIKENESS: f64 = 0.75;
        const BELOW_BEST: f64 = 0.08;
        let scene = scene_input::names(legs).map(str::to_owned);
        let full = scene_input::names(legs).map(|name| format!("scene.{name}"));
        let last = |name: &str| name.rsplit('.').next().unwrap_or(name).to_owned();
        let likeness = |known: &String| {
            let whole = strsim::jaro_winkler(name, known);
            // The right key in the wrong table, or in none, counts as similar.
            let key = strsim::jaro_winkler(&last(name), &last(known)) - 0.01;
            whole.max(key)
        };
        let all = scene
            .chain(full)
            .chain(dotted(legs).iter().map(|(name, _)| name.clone()));
        let all: Vec<String> = all
            .filter(|known| !known.starts_with("scene.") || name.starts_with("scene."))
            .collect();
        if let Some(known) = all.iter().find(|known| differ_in_unit(name, known)) {
            return spellings(known);
        }
        let mut alike: Vec<(f64, String)> = all
            .iter()
            .map(|known| with_unit_of(name, known))
            .map(|known| (likeness(&known), known))
            .filter(|(likeness, _)| *likeness > LEAST_LIKENESS)
            .collect();
        alike.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        let best = alike.first().map_or(0.0, |(likeness, _)| *likeness);
        alike.retain(|(likeness, _)| *likeness > best - BELOW_BEST);
        alike.truncate(SHOWN);
        alike.into_iter().map(|(_, known)| known).collect()
    }

    /// Error message for an unknown name.
    pub(crate) fn unknown(name: &str, legs: usize) -> String {
        let guess = did_you_mean(&Self::nearest(name, legs));
        format!(
            "unknown parameter; {guess}expected a key of the scene, or a dotted key of the vehicle, the \
             search or the solver, such as vehicle.strut.compression_damping"
        )
    }

    /// Name as given, which heads its column in results.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Name in program units.
    pub fn program_name(&self) -> &str {
        &self.program_name
    }

    /// Converts a coordinate to program units.
    pub fn to_program(&self, coordinate: f64) -> f64 {
        self.conversion.to_program(coordinate)
    }

    /// Converts a number from program units to the unit of the parameter's name.
    pub fn in_own_unit(&self, number: f64) -> f64 {
        self.conversion.in_own_unit(number)
    }

    /// Text of the allowed values, converted from program units to those of a coordinate.
    pub fn explain(&self, allowed: &str, coordinate: f64) -> String {
        self.conversion.explain(allowed, coordinate)
    }

    /// Text of what is allowed in place of a fault under this parameter.
    pub(crate) fn allowed(&self, fault: &SceneFault) -> String {
        match fault.value {
            Some(FaultyValue::Number(number)) => {
                self.explain(&fault.allowed, self.in_own_unit(number))
            }
            _ => fault.allowed.clone(),
        }
    }

    /// Part of the input that the parameter belongs to.
    pub fn home(&self) -> Home {
        self.home
    }

    /// Key within that part.
    pub fn path(&self) -> &KeyPath {
        &self.path
    }

    /// Its entry in the catalogue; `None` for words.
    pub fn quantity(&self) -> Option<&'static Quantity> {
        self.quantity
    }

    /// True for an angle or a rate of turn.
    pub fn is_angular(&self) -> bool {
        self.quantity.is_some_and(Quantity::is_angular)
    }

    /// Allowed words; empty for a number.
    pub fn words(&self) -> &[&'static str] {
        &self.words
    }

    /// Word of a coordinate, which is its index.
    pub fn word(&self, coordinate: f64) -> Option<&'static str> {
        self.words.get(coordinate as usize).copied()
    }

    /// Converts a number from the parameter's unit to a value in program units.
    ///
    /// # Errors
    /// If it is not finite, or if the parameter takes words.
    pub(crate) fn number(&self, number: f64) -> Result<Value, InputError> {
        let allowed = match self.words.as_slice() {
            [] if self.to_program(number).is_finite() => {
                return Ok(Value::Number(self.to_program(number)));
            }
            [] => "a finite number".to_owned(),
            words => format!("one of {}", words.join(", ")),
        };
        Err(InputError::value(&self.name, number, &allowed))
    }

    /// Parses a text as a value in program units.
    ///
    /// # Errors
    /// If it is not a finite number or, for a parameter with words, not one of them.
    pub(crate) fn value(&self, text: &str) -> Result<Value, InputError> {
        match self.words.as_slice() {
            [] => match text.parse::<f64>() {
                Ok(number) => self.number(number),
                Err(_) => Err(InputError::value(&self.name, text, "a finite number")),
            },
            words if words.contains(&text) => Ok(Value::Text(text.to_owned())),
            words => {
                let allowed = format!("one of {}", words.join(", "));
                Err(InputError::value(&self.name, text, &allowed))
            }
        }
    }

    /// Heading of its column in results.
    pub fn heading(&self) -> Heading {
        Heading {
            name: self.name.clone(),
            kind: match self.words.is_empty() {
                true => Kind::Number,
                false => Kind::Word,
            },
        }
    }

    /// Cell of a coordinate in results: a number or a word.
    pub fn cell(&self, coordinate: f64) -> Cell {
        match self.word(coordinate) {
            Some(word) => Cell::Word(word.to_owned()),
            None => Cell::Number(coordinate),
        }
    }
}

/// Names of all parameters of vehicles with `legs` legs, in program units.
pub fn names(legs: usize) -> impl Iterator<Item = String> {
    let scene = scene_input::names(legs).map(str::to_owned);
    scene.chain(dotted(legs).iter().map(|(name, _)| name.clone()))
}

/// Parameters that take words, and their words.
fn word_keys() -> impl Iterator<Item = (String, Vec<&'static str>)> {
    let search = search_input::word_keys().into_iter();
    let solver = settings_input::word_keys().into_iter();
    search
        .map(|(key, words)| (format!("search.{key}"), words))
        .chain(solver.map(|(key, words)| (format!("solver.{key}"), words)))
}

/// A name in program units, and its entry in the catalogue; `None` for words.
type NamedQuantity = (String, Option<&'static Quantity>);

/// All parameters outside the scene of vehicles with `legs` legs.
fn dotted(legs: usize) -> &'static [NamedQuantity] {
    static BY_LEGS: [OnceLock<Vec<NamedQuantity>>; MOST_LEGS + 1] =
        [const { OnceLock::new() }; MOST_LEGS + 1];
    BY_LEGS[legs].get_or_init(|| all_dotted(legs))
}

fn all_dotted(legs: usize) -> Vec<NamedQuantity> {
    let vehicle = vehicle_file::numbers(legs).into_iter();
    let search = const { &search_input::NUMBERS }.iter();
    let words = word_keys().map(|(key, _)| (key, None));
    let in_table = |table: &'static str| {
        move |quantity: &'static Quantity| (format!("{table}.{}", quantity.key), Some(quantity))
    };
    vehicle
        .map(|(name, quantity)| (format!("vehicle.{name}"), Some(quantity)))
        .chain(search.map(in_table("search")))
        .chain(settings_input::numbers().map(in_table("solver")))
        .chain(words)
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
    fn any_unit_names_the_same_parameter() {
        for (name, program_name, coordinate, number) in [
            ("slope_rad", "slope_deg", std::f64::consts::PI, 180.0),
            (
                "scene.vertical_velocity_mps",
                "vertical_velocity_fps",
                0.3048,
                1.0,
            ),
            (
                "vehicle.mass_kg",
                "vehicle.mass_slug",
                14.593902937206364,
                1.0,
            ),
            (
                "vehicle.inertia_kg_m2.xx",
                "vehicle.inertia_slug_ft2.xx",
                13.558179483314004,
                10.0,
            ),
            (
                "vehicle.legs[2].strut.preload_n",
                "vehicle.legs[2].strut.preload_lb",
                44.482216152605,
                10.0,
            ),
            ("search.to_mps", "search.to_fps", 3.048, 10.0),
        ] {
            let [asked, known] =
                [name, program_name].map(|name| Parameter::named(name, 3).unwrap());
            assert_eq!(asked, known);
            assert_eq!(asked.name(), name.trim_start_matches("scene."));
            assert_eq!(asked.program_name(), program_name);
            assert_eq!(asked.path(), known.path());
            assert_eq!(asked.to_program(coordinate), number, "{name}");
            assert_eq!(known.to_program(coordinate), coordinate);
        }
        let nearest = Parameter::nearest("vehicle.mass_lb", 3);
        assert_eq!(nearest, ["vehicle.mass_slug", "vehicle.mass_kg"]);
        let nearest = Parameter::nearest("vehicle.strut.prelaod_n", 3);
        assert_eq!(nearest[0], "vehicle.strut.preload_n");
    }

    #[test]
    fn words_are_written_as_words() {
        let rule = Parameter::named("solver.crush_rule", 3).unwrap();
        let word = |word: &str| Cell::Word(word.to_owned());
        assert_eq!(
            (rule.cell(0.0), rule.cell(1.0)),
            (word("pivot-rate"), word("section"))
        );
        assert_eq!(rule.heading().kind, Kind::Word);
        let slope = Parameter::named("slope_deg", 3).unwrap();
        assert_eq!(slope.cell(0.1), Cell::Number(0.1));
        assert_eq!(slope.heading(), Heading::number("slope_deg".to_owned()));
    }
}
