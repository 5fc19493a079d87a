//! All keys of all input files, by table; `docs/reference.md` is checked against them.

use crate::choice::words;
use crate::sensitivity_input::SENSITIVITY;
use crate::sweep::SWEEP;
use crate::{
    axis_input, cases, joint_normal, map_input, method_input, sample_input, scene_file,
    scene_input, search_input, settings_input, vehicle_file, vehicle_tables,
};

/// A table of an input file and its allowed keys.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyTable {
    /// Name: the file, then the table within it.
    pub name: &'static str,
    /// Its keys.
    pub keys: Vec<&'static str>,
}

/// A key of an input file with a fixed set of words as values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WordChoice {
    /// The key.
    pub key: &'static str,
    /// The words.
    pub words: Vec<&'static str>,
}

/// All tables of all input files. Besides the keys listed, a case may have every parameter of scene, vehicle and
/// solver.
pub fn tables() -> Vec<KeyTable> {
    let table = |name, keys: &[&'static str]| KeyTable {
        name,
        keys: keys.to_vec(),
    };
    let solver = [&settings_input::SOLVER[..], &method_input::KEYS].concat();
    let of_cases = [&cases::OWN[..], &scene_input::REQUIRED].concat();
    vec![
        table("vehicle", &vehicle_file::VEHICLE),
        table("vehicle.inertia_slug_ft2", &vehicle_file::INERTIA),
        table("vehicle.linkage", &vehicle_file::LINKAGE),
        table("vehicle.strut", &vehicle_file::strut_keys()),
        table("vehicle.strut.profile", &vehicle_tables::MULTIPLIER),
        table("vehicle.strut.crush_load", &vehicle_tables::LOAD),
        table("vehicle.footpad", &vehicle_file::FOOTPAD),
        table("vehicle.block", &vehicle_file::BLOCK),
        table("vehicle.profile", &vehicle_tables::PRESSURE),
        table("vehicle.legs", &vehicle_file::LEG),
        table("sweep", &SWEEP),
        table("scene", &scene_input::scene_keys()),
        table("scene.thrust", &scene_input::THRUST_KEYS),
        table("scene.footing", &scene_input::FOOTING_KEYS),
        table("axis", &axis_input::FORM),
        table("sample", &sample_input::SAMPLE),
        table("sampled axis", &sample_input::FORM),
        table("sample.covariance", &joint_normal::COVARIANCE),
        table("map", &map_input::MAP),
        table("search", &search_input::SEARCH),
        table("sensitivity", &SENSITIVITY),
        table("solver", &solver),
        table("solver.error_per_second", &method_input::LIMITS),
        table("scene file", &scene_file::SCENE_FILE),
        table("case", &scene_file::CASE),
        table("table of cases", &of_cases),
    ]
}

/// All keys whose values are words.
pub fn word_choices() -> Vec<WordChoice> {
    let choice = |key, words| WordChoice { key, words };
    let mut choices = vec![
        choice("kind", words(&vehicle_file::STRUT_KINDS)),
        choice("distribution", words(&sample_input::DISTRIBUTIONS)),
    ];
    let of_search = search_input::word_keys().into_iter();
    let more = of_search.chain(settings_input::word_keys());
    choices.extend(more.map(|(key, words)| choice(key, words)));
    choices
}
