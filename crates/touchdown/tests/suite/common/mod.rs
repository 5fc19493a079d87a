//! A folder with input files, and the program run in it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// The Surveyor of Table 4-1, as it comes with the program.
pub const SURVEYOR: &str = include_str!("../../../../../sweeps/vehicles/surveyor-table-4-1.toml");

/// A small sweep that takes a second at most.
pub const SWEEP: &str = r#"title = "Roll at cross-slope 180 deg"
vehicle = "surveyor.toml"
[scene]
vertical_velocity_fps = 14
cross_slope_deg = 180
slope_deg = 15
friction = 1.0
[axes]
roll_deg = { from = -10, to = 10, step = 10 }
[search]
from_fps = 10
to_fps = 12.5
scan_step_fps = 1.25
tolerance_fps = 0.1
"#;

/// Options of the baseline landing.
pub const BASELINE: [&str; 12] = [
    "land",
    "--vehicle",
    "surveyor.toml",
    "--vertical-velocity=14",
    "--horizontal-velocity",
    "11.25",
    "--cross-slope",
    "180",
    "--slope",
    "15",
    "--friction",
    "1.0",
];

/// Options of the landings of `cases.csv`, but for where their results go.
pub const LAND_CASES: [&str; 6] = [
    "land",
    "--vehicle",
    "surveyor.toml",
    "--cases",
    "cases.csv",
    "--out",
];

/// A row of a table by the names of its columns.
pub type Row = BTreeMap<String, String>;

/// The rows of a table.
pub fn rows(text: &str) -> Vec<Row> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.deserialize().map(Result::unwrap).collect()
}

/// What the program did.
pub struct Done {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// A folder of its own for every test.
pub struct Bench {
    folder: TempDir,
}

impl Bench {
    /// With the Surveyor and the small sweep in it.
    pub fn new() -> Self {
        let bench = Self {
            folder: tempfile::tempdir().unwrap(),
        };
        bench.write("surveyor.toml", SURVEYOR);
        bench.write("sweep.toml", SWEEP);
        bench
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// Names of the files in a folder; none if it is not there.
    pub fn list(&self, folder: &str) -> Vec<String> {
        let Ok(entries) = fs::read_dir(self.path(folder)) else {
            return Vec::new();
        };
        let name = |entry: std::io::Result<fs::DirEntry>| {
            let path = entry.unwrap().path();
            Path::new(path.file_name().unwrap()).display().to_string()
        };
        let mut names: Vec<String> = entries.map(name).collect();
        names.sort();
        names
    }

    /// The program, ready to be run in the folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(crate::PROGRAM);
        command.args(arguments).current_dir(self.folder.path());
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Done {
        Done::from(self.command(arguments).output().unwrap())
    }

    /// The landings of `cases.csv` into this file, and more options.
    pub fn land_cases(&self, out: &[&str]) -> Done {
        self.run(&[&LAND_CASES[..], out].concat())
    }

    /// Lands cases again at a tolerance: their rows.
    pub fn land_again(&self, vehicle: &str, cases: &str, tolerance: &str) -> Vec<Row> {
        let input = ["land", "--vehicle", vehicle, "--cases", cases];
        let rest = ["--tolerance", tolerance, "--out", "again.csv", "--quiet"];
        let done = self.run(&[&input[..], &rest[..]].concat());
        assert_eq!(done.code, Some(0), "{}", done.err);
        rows(&self.read("again.csv"))
    }
}

impl From<Output> for Done {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Done {
    /// Input refused: exit code 2 and a message with all fragments, on one line.
    pub fn refused(&self, fragments: &[&str]) {
        assert_eq!(self.code, Some(2), "{fragments:?}: {}", self.err);
        for fragment in fragments {
            assert!(
                self.err.contains(fragment),
                "{fragment} is not in: {}",
                self.err
            );
        }
        assert!(!self.err.contains("panicked"), "{}", self.err);
    }
}
