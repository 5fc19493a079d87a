//! All keys of all input files, by table; `docs/reference.md` is checked against them.

use touchdown_dynamics::method::ERROR_LIMITS;
use touchdown_dynamics::quantities;
use touchdown_dynamics::quantity::Quantity;

use crate::points::sensitivity_input::SENSITIVITY;
use crate::points::{axis_input, joint_normal, map_input, sample_input};
use crate::readers::choice::words;
use crate::readers::numbers::quantities as numbers;
use crate::readers::{
    method_input, scene_input, search_input, settings_input, vehicle_file, vehicle_tables,
};
use crate::sweeps::sweep::SWEEP;
use crate::sweeps::{cases, scene_file};

/// A table of an input file and its allowed keys.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyTable {
    /// Name: the file, then the table within it.
    pub name: &'static str,
    /// Its keys.
    pub keys: Vec<&'static str>,
    /// Those that are numbers of the catalogue.
    pub numbers: Vec<&'static Quantity>,
}

impl KeyTable {
    fn new(name: &'static str, keys: &[&'static str]) -> Self {
        Self {
            name,
            keys: keys.to_vec(),
            numbers: Vec::new(),
        }
    }

    /// The same table with these numbers among its keys.
    fn with(mut self, numbers: impl IntoIterator<Item = &'static Quantity>) -> Self {
        self.numbers.extend(numbers);
        self
    }
}

/// A key of an input file with a fixed set of words as values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WordChoice {
    /// Name of the table in which it is.
    pub table: &'static str,
    /// The key.
    pub key: &'static str,
    /// The words.
    pub words: Vec<&'static str>,
}

/// All tables of all input files. Besides the keys listed, a case may have every parameter of scene, vehicle and
/// solver.
pub fn tables() -> Vec<KeyTable> {
    let table = KeyTable::new;
    let required = || scene_input::required();
    let of_cases: Vec<&str> = (cases::OWN.into_iter())
        .chain(required().map(|quantity| quantity.key))
        .collect();
    let scale = [&quantities::TABLE_SCALE];
    vec![
        table("vehicle", &vehicle_file::VEHICLE)
            .with(numbers(&quantities::BODY))
            .with(numbers(&quantities::OFFSET)),
        table("vehicle.inertia_slug_ft2", &vehicle_file::INERTIA)
            .with(numbers(&quantities::INERTIA)),
        table("vehicle.linkage", &vehicle_file::ANY_LINKAGE)
            .with(numbers(&quantities::LINKAGE))
            .with(numbers(&quantities::FOOT))
            .with(numbers(&quantities::TELESCOPE)),
        table("vehicle.strut", &vehicle_file::strut_keys())
            .with(numbers(&quantities::STRUT))
            .with(numbers(&quantities::DAMPER))
            .with(numbers(&quantities::HONEYCOMB)),
        table("vehicle.strut.profile", &vehicle_tables::MULTIPLIER).with(scale),
        table("vehicle.strut.crush_load", &vehicle_tables::LOAD).with(scale),
        table("vehicle.secondary", &vehicle_file::SECONDARY)
            .with(numbers(&quantities::LEG_STRUT))
            .with(const { [&quantities::SPREAD] }),
        table("vehicle.footpad", &vehicle_file::FOOTPAD)
            .with(numbers(&quantities::FOOTPAD))
            .with(numbers(&quantities::EDGE)),
        table("vehicle.block", &vehicle_file::BLOCK).with(numbers(&quantities::BLOCK)),
        table("vehicle.profile", &vehicle_tables::PRESSURE).with(scale),
        table("vehicle.legs", &vehicle_file::LEG).with(numbers(&quantities::LEG)),
        table("sweep", &SWEEP),
        table("scene", &scene_input::scene_keys()).with(quantities::CONDITIONS),
        table("scene.thrust", &scene_input::THRUST_KEYS).with(quantities::THRUST),
        table("scene.soil", &scene_input::SOIL_KEYS).with(quantities::SOIL),
        table("scene.footing", &scene_input::FOOTING_KEYS).with(quantities::FOOTING),
        table("axis", &axis_input::FORM),
        table("sample", &sample_input::SAMPLE),
        table("sampled axis", &sample_input::FORM),
        table("sample.covariance", &joint_normal::COVARIANCE),
        table("map", &map_input::MAP),
        table("search", &search_input::SEARCH).with(const { &search_input::NUMBERS }),
        table("sensitivity", &SENSITIVITY),
        table("solver", &settings_input::solver_keys()).with(settings_input::numbers()),
        table("solver.error_per_second", &method_input::LIMITS).with(numbers(&ERROR_LIMITS)),
        table("scene file", &scene_file::SCENE_FILE),
        table("case", &scene_file::CASE),
        table("table of cases", &of_cases),
    ]
}

/// All keys whose values are words.
pub fn word_choices() -> Vec<WordChoice> {
    let choice = |table| move |(key, words)| WordChoice { table, key, words };
    let mut choices = vec![
        choice("vehicle.linkage")(("kind", words(&vehicle_file::LEG_KINDS))),
        choice("vehicle.strut")(("kind", words(&vehicle_file::STRUT_KINDS))),
        choice("sampled axis")(("distribution", words(&sample_input::DISTRIBUTIONS))),
    ];
    choices.extend(search_input::word_keys().map(choice("search")));
    choices.extend(settings_input::word_keys().map(choice("solver")));
    choices
}
