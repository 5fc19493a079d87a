//! The header of a journal: everything that determines its records, and the input files of a sweep, so that the results
//! can be written from the journal alone.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use touchdown_dynamics::land::land;
use touchdown_dynamics::model_version::MODEL_VERSION;
use touchdown_dynamics::scene::{Scene, Settings};
use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::documents::document::dotted;
use touchdown_input::documents::input_error::InputError;
use touchdown_input::sweeps::case::CaseFault;
use touchdown_input::sweeps::cases::CaseTable;
use touchdown_input::sweeps::origin::Origin;
use touchdown_input::sweeps::sweep_file::Sweep;

use crate::journal::shard::Shard;

/// Version of the journals written by this program.
const FORMAT: u32 = 9;

/// A landing: vehicle, scene and settings.
pub type Landed<'l> = (&'l Vehicle, &'l Scene, &'l Settings);

/// The header of a journal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Header {
    format: u32,
    /// Version of the program.
    pub program: String,
    model: u32,
    /// Result of one landing of the sweep, bit for bit: programs and machines that agree in it compute alike.
    probe: String,
    /// Number of points of the whole sweep, or of rows of a table of cases.
    pub points: usize,
    shard: [usize; 2],
    /// All input with defaults filled in.
    input: Value,
    /// `None` if the journal is not of a sweep.
    origin: Option<Origin>,
}

impl Header {
    /// Builds the header of a shard's journal.
    ///
    /// # Errors
    /// If the first point of the sweep has no valid input.
    pub fn new(sweep: &Sweep, program: &str, shard: Shard) -> Result<Self, CaseFault> {
        let case = sweep.case(0)?;
        Ok(Self {
            format: FORMAT,
            program: program.to_owned(),
            model: MODEL_VERSION,
            probe: probe((&case.vehicle, &case.scene, &case.settings)),
            points: sweep.design.count(),
            shard: [shard.number(), shard.count()],
            input: sweep.resolved(),
            origin: Some(Origin::of(sweep)),
        })
    }

    /// Builds the header of the journal of a table of cases.
    pub fn of_cases(table: &CaseTable, program: &str) -> Self {
        let first = table.first();
        Self {
            format: FORMAT,
            program: program.to_owned(),
            model: MODEL_VERSION,
            probe: probe((&first.vehicle, &first.scene, &first.settings)),
            points: table.len(),
            shard: [1, 1],
            input: table.input.clone(),
            origin: None,
        }
    }

    /// The shard of the sweep in the journal.
    pub fn shard(&self) -> Shard {
        Shard::new(self.shard[0], self.shard[1]).unwrap_or(Shard::WHOLE)
    }

    /// True if points are chosen from results, as in a map; then every shard may have any of them.
    fn is_map(&self) -> bool {
        self.input.get("map").is_some()
    }

    /// Greatest number of points in the journal.
    pub(crate) fn most_points(&self) -> usize {
        match self.is_map() {
            true => self.points,
            false => self.shard().len(self.points),
        }
    }

    /// Index of a point among these, if it is one.
    pub(crate) fn index(&self, point: usize) -> Option<usize> {
        match self.is_map() {
            true => Some(point),
            false => self.shard().index(point),
        }
    }

    pub(crate) fn to_bytes(&self) -> Vec<u8> {
        serde_json::json!(self).to_string().into_bytes()
    }

    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let header: Self = serde_json::from_slice(bytes).ok()?;
        Shard::new(header.shard[0], header.shard[1])?;
        Some(header)
    }

    /// Lists what determines results and differs between two headers, except the shard.
    pub fn differences(&self, other: &Self) -> Vec<String> {
        let facts = |header: &Self| {
            let mut facts = vec![
                ("journal format".to_owned(), header.format.to_string()),
                ("program".to_owned(), header.program.clone()),
                ("model version".to_owned(), header.model.to_string()),
                ("number of points".to_owned(), header.points.to_string()),
            ];
            flatten("", &header.input, &mut facts);
            // Listed last: often explained by a difference above.
            facts.push((
                "landing computed as a probe".to_owned(),
                header.probe.clone(),
            ));
            facts
        };
        let (here, there) = (facts(self), facts(other));
        let value = |facts: &[(String, String)], name: &str| {
            let found = facts.iter().find(|(known, _)| known == name);
            found.map_or("nothing".to_owned(), |(_, value)| value.clone())
        };
        let names = here.iter().chain(&there).map(|(name, _)| name.as_str());
        let mut seen = std::collections::HashSet::new();
        names
            .filter(|name| seen.insert(*name))
            .filter_map(|name| {
                let (mine, others) = (value(&here, name), value(&there, name));
                (mine != others).then(|| format!("{name}: {mine} here, {others} there"))
            })
            .collect()
    }

    /// The differences from the header of the same sample with fewer points, apart from its count.
    pub(crate) fn differences_but_count(&self, smaller: &Self) -> Vec<String> {
        let mut grown = smaller.clone();
        grown.points = self.points;
        if let Some(count) = grown.input.pointer_mut("/sample/count") {
            *count = self.points.into();
        }
        self.differences(&grown)
    }

    /// Reads the sweep of the journal from the copies of its files; `None` for a table of cases.
    ///
    /// # Errors
    /// If the copies were altered.
    pub fn sweep(&self) -> Result<Option<Sweep>, InputError> {
        self.origin.as_ref().map(Origin::sweep).transpose()
    }

    /// The sweep file, as named on the command line.
    pub fn sweep_file(&self) -> Option<&Path> {
        self.origin.as_ref().map(Origin::path)
    }
}

/// Computes a landing, of the first point at the lowest speed or of the first case, and writes every digit that
/// distinguishes it.
fn probe((vehicle, scene, settings): Landed) -> String {
    let landing = land(vehicle, scene, settings);
    format!(
        "{} at {} s, least stability angle {} rad, {} derivative evaluations",
        landing.outcome, landing.end_time, landing.min_stability_angle, landing.evaluations
    )
}

/// Collects all leaves of a tree with their dotted names.
fn flatten(path: &str, value: &Value, leaves: &mut Vec<(String, String)>) {
    match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                flatten(&dotted(path, key), value, leaves);
            }
        }
        leaf => leaves.push((path.to_owned(), leaf.to_string())),
    }
}

#[cfg(test)]
impl Header {
    /// A short header for `points` points of a sweep over `friction`.
    pub(crate) fn example(points: usize, shard: Shard, friction: f64) -> Self {
        Self {
            format: FORMAT,
            program: "0".to_owned(),
            model: MODEL_VERSION,
            probe: "stable".to_owned(),
            points,
            shard: [shard.number(), shard.count()],
            input: serde_json::json!({"friction": friction}),
            origin: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(file: &str) -> Header {
        let path = format!("{}/../../sweeps/{file}.toml", env!("CARGO_MANIFEST_DIR"));
        let sweep: Sweep = Sweep::read(Path::new(&path)).unwrap();
        Header::new(&sweep, "1.0", Shard::WHOLE).unwrap()
    }

    #[test]
    fn a_header_survives_its_bytes_and_gives_the_sweep_back() {
        let header = header("figure-4-25");
        let read = Header::from_bytes(&header.to_bytes()).unwrap();
        assert_eq!(read, header);
        assert_eq!(read.differences(&header), Vec::<String>::new());
        let again = Header::new(&read.sweep().unwrap().unwrap(), "1.0", Shard::WHOLE).unwrap();
        assert_eq!(again, header);
    }

    #[test]
    fn what_differs_is_named_with_both_values() {
        let (one, mut other) = (header("figure-4-24"), header("figure-4-25"));
        let said = one.differences(&other);
        assert_eq!(
            said[0], "scene.cross_slope_deg: 180.0 here, 150.0 there",
            "{said:?}"
        );
        other = one.clone();
        other.program = "1.1".to_owned();
        other.probe = String::new();
        let said = one.differences(&other).join("; ");
        assert!(said.starts_with("program: 1.0 here, 1.1 there; landing computed as a probe"));
    }

    #[test]
    fn a_grown_sample_differs_from_a_smaller_one_by_its_count_only() {
        let smaller = header("landers/six-legs-dispersions");
        let mut grown = smaller.clone();
        grown.points += 500;
        grown.input["sample"]["count"] = grown.points.into();
        assert_eq!(grown.differences(&smaller).len(), 2);
        assert_eq!(grown.differences_but_count(&smaller), Vec::<String>::new());
        grown.input["sample"]["seed"] = 2.into();
        grown.model += 1;
        let said = grown.differences_but_count(&smaller).join("; ");
        assert!(
            said.contains("model version") && said.contains("sample.seed: 2 here"),
            "{said}"
        );
    }

    #[test]
    fn whatever_is_no_header_is_none() {
        for text in ["", "{}", "[1]", "\u{7f}"] {
            assert_eq!(Header::from_bytes(text.as_bytes()), None);
        }
    }
}
