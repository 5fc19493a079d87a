//! Whatever stands in a file, reading it ends with a result or a complaint. `PROPTEST_CASES` says
//! how many files are tried of each kind.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::fs;
use std::path::Path;

use proptest::prelude::*;
use touchdown_dynamics::scene::{CrushRule, Settings};
use touchdown_input::documents::document::Document;
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::cases;
use touchdown_input::sweeps::sweep_file::Sweep;
use touchdown_sweep::journal::header::Header;
use touchdown_sweep::journal::shard::Shard;
use touchdown_sweep::journal::{InOrder, Journal};

const SWEEPS: [&str; 3] = [
    include_str!("../../../../sweeps/figure-4-25.toml"),
    include_str!("../../../../sweeps/trade-damping-friction.toml"),
    include_str!("../../../../sweeps/stress/wild.toml"),
];
const SURVEYOR: &str = include_str!("../../../../sweeps/vehicles/surveyor-table-4-1.toml");
const CASES: &str = "case,vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,\
                     pitch_deg,yaw_deg,roll_deg,slope_deg,friction,vehicle.mass_slug\n\
                     1,14,2,180,0,0,0,15,1,20\n2,14,13,180,0,0,0,15,1,30\n";
/// What is put into files: things that mean something there, at the wrong place.
#[rustfmt::skip]
const WORDS: [&str; 27] = [
    "0", "-1", "1e308", "1e-320", "nan", "inf", "2.5", "[", "]", "{", "}", "\"", "=", "\n", ",", ".",
    "[[legs]]", "zip = \"a\"", "count = 3", "spacing = \"log\"", "scale = 2", "ä", "\0", "[axes]\n",
    "_kg", "_m", "_rad",
];

/// One change of a text: from where, how much is taken away, and what is put there.
type Change = (prop::sample::Index, usize, String);

fn change() -> impl Strategy<Value = Change> {
    let word = prop::sample::select(WORDS.to_vec()).prop_map(str::to_owned);
    let number = any::<f64>().prop_map(|number| number.to_string());
    let put = prop_oneof![word, number, ".{0,5}"];
    (any::<prop::sample::Index>(), 0usize..12, put)
}

fn changed(text: &str, changes: &[Change]) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for (index, taken, put) in changes {
        let begin = index.index(characters.len().max(1)).min(characters.len());
        let end = (begin + taken).min(characters.len());
        characters.splice(begin..end, put.chars());
    }
    characters.into_iter().collect()
}

proptest! {
    #[test]
    fn sweep_files(which in 0..SWEEPS.len(), changes in prop::collection::vec(change(), 1..4)) {
        let source = |path: &str, text: &str| Source {
            path: path.into(),
            text: text.to_owned(),
        };
        let sources = [
            source("sweeps/s.toml", &changed(SWEEPS[which], &changes)),
            source("sweeps/vehicles/surveyor-table-4-1.toml", SURVEYOR),
            source("sweeps/../vehicles/surveyor-table-4-1.toml", SURVEYOR),
        ];
        let library = Library::Copies(&sources);
        if let Ok(sweep) = Sweep::read_from(Path::new("sweeps/s.toml"), library) {
            let last = sweep.design.count() - 1;
            prop_assert_eq!(sweep.cells_of_point(last).len(), sweep.axes.len());
            // Not all points were looked at, and one may be at odds with itself; nothing worse.
            let _ = sweep.case(last);
        }
    }

    #[test]
    fn vehicle_files(changes in prop::collection::vec(change(), 1..4)) {
        let text = changed(SURVEYOR, &changes);
        let read = Document::parse(Path::new("v.toml"), &text);
        if let Ok(file) = read.and_then(VehicleFile::from_document) {
            prop_assert!(file.vehicle.mass() > 0.0);
        }
    }

    #[test]
    fn tables_of_cases(changes in prop::collection::vec(change(), 1..4)) {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("cases.csv");
        fs::write(&path, changed(CASES, &changes))?;
        let surveyor = Document::parse(Path::new("v.toml"), SURVEYOR).unwrap();
        let surveyor = VehicleFile::from_document(surveyor).unwrap();
        let settings = Settings::new(1e-6, 40.0, CrushRule::default()).unwrap();
        if let Ok(cases) = cases::read(&path, &surveyor, &settings) {
            prop_assert!((0..cases.len()).all(|row| cases.case(row).unwrap().vehicle.mass() > 0.0));
        }
    }

    /// Whatever became of a journal, the results that are read from it were written to it.
    #[test]
    fn journals(
        cut in any::<prop::sample::Index>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        more in prop::collection::vec(any::<u8>(), 0..40),
    ) {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/figure-4-09.toml");
        let sweep: Sweep = Sweep::read(Path::new(path)).unwrap();
        let header = Header::new(&sweep, "0", Shard::WHOLE).unwrap();
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("s.journal");
        let result = |point: usize| vec![point as u8; point];
        let mut journal = Journal::open(&path, &header).unwrap().journal;
        for point in 0..header.points {
            journal.add(point, &result(point)).unwrap();
        }
        drop(journal);
        let mut bytes = fs::read(&path)?;
        bytes.truncate(bytes.len() / 2 + cut.index(bytes.len()));
        for (index, byte) in &changes {
            let place = index.index(bytes.len());
            bytes[place] = *byte;
        }
        bytes.extend(more);
        fs::write(&path, bytes)?;
        // A head that was changed into another's is refused; any other damage is overcome.
        if let Ok(opened) = Journal::open(&path, &header) {
            let done = opened.done.clone();
            let records = vec![opened.journal.into_records().unwrap()];
            let mut results = InOrder::new(records, header.points, folder.path()).unwrap();
            for point in 0..header.points {
                let found = results.result(point).unwrap();
                prop_assert_eq!(found, done.contains(point).then(|| result(point)));
            }
        }
    }
}
