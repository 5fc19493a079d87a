use super::*;
use crate::journal::shard::Shard;

const POINTS: usize = 6;

/// A folder with a journal in it.
struct Bench {
    folder: tempfile::TempDir,
    header: Header,
}

impl Bench {
    fn new() -> Self {
        Self {
            folder: tempfile::tempdir().unwrap(),
            header: Header::example(POINTS, Shard::WHOLE, 0.1),
        }
    }

    fn path(&self) -> PathBuf {
        self.folder.path().join("s.journal")
    }

    fn open(&self) -> Result<Opened, JournalError> {
        Journal::open(&self.path(), &self.header)
    }

    /// A journal with results of some points.
    fn with(points: &[usize]) -> Self {
        let bench = Self::new();
        let mut journal = bench.open().unwrap().journal;
        for &point in points {
            journal.add(point, &result(point)).unwrap();
        }
        journal.finish().unwrap();
        bench
    }

    fn bytes(&self) -> Vec<u8> {
        fs::read(self.path()).unwrap()
    }

    /// Results of all points, where present.
    fn results(&self) -> Vec<Option<Vec<u8>>> {
        let (records, _) = Records::open(&self.path(), Access::Alone).unwrap();
        let mut results = InOrder::new(vec![records], POINTS, self.folder.path()).unwrap();
        (0..POINTS).map(|p| results.result(p).unwrap()).collect()
    }
}

fn result(point: usize) -> Vec<u8> {
    format!("result {point}").repeat(point).into_bytes()
}

#[test]
fn a_result_takes_the_length_that_is_foretold() {
    let empty = Bench::with(&[]).bytes().len();
    for point in 0..POINTS {
        let taken = Bench::with(&[point]).bytes().len() - empty;
        assert_eq!(record_length(result(point).len()), taken);
    }
}

#[test]
fn results_are_read_in_the_order_of_points() {
    let bench = Bench::with(&[3, 0, 5, 1]);
    let opened = bench.open().unwrap();
    assert_eq!(opened.warnings, Vec::<String>::new());
    assert_eq!(opened.done.missing().collect::<Vec<_>>(), [2, 4]);
    drop(opened);
    let expected = [0, 1, 2, 3, 4, 5].map(|point| match point {
        2 | 4 => None,
        point => Some(result(point)),
    });
    assert_eq!(bench.results(), expected);
    let (records, header) = Records::open(&bench.path(), Access::Alone).unwrap();
    assert_eq!(header, bench.header);
    let mut results = InOrder::new(vec![records], POINTS, bench.folder.path()).unwrap();
    assert_eq!(
        (results.missing(), results.first_missing(9).unwrap()),
        (2, vec![2, 4])
    );
}

/// Checks that after damage the journal opens, reads correctly and can be completed.
fn survives(damaged: &[u8], most_lost: usize) {
    let bench = Bench::new();
    fs::write(bench.path(), damaged).unwrap();
    let Opened {
        journal,
        done,
        warnings,
    } = bench.open().unwrap();
    assert!(
        done.len() + most_lost >= POINTS,
        "{} points left",
        done.len()
    );
    // Nothing tells of records that are missing as a whole from the end.
    assert!(done.len() == POINTS || most_lost == POINTS || !warnings.is_empty());
    drop(journal);
    for (point, found) in bench.results().into_iter().enumerate() {
        assert_eq!(found, done.contains(point).then(|| result(point)));
    }
    let mut journal = bench.open().unwrap().journal;
    for point in done.missing() {
        journal.add(point, &result(point)).unwrap();
    }
    journal.finish().unwrap();
    assert!(matches!(
        Records::open(&bench.path(), Access::Alone),
        Err(JournalError::Locked(_))
    ));
    drop(journal);
    assert_eq!(bench.results(), [0, 1, 2, 3, 4, 5].map(|p| Some(result(p))));
    assert_eq!(bench.open().unwrap().done.len(), POINTS);
}

#[test]
fn cut_at_any_offset_it_holds_what_stands_before() {
    let whole = Bench::with(&[0, 1, 2, 3, 4, 5]).bytes();
    for length in 0..whole.len() {
        survives(&whole[..length], POINTS);
    }
}

#[test]
fn a_flipped_bit_at_any_offset_costs_one_point_at_most() {
    let whole = Bench::with(&[0, 1, 2, 3, 4, 5]).bytes();
    for position in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[position] ^= 1 << (position % 8);
        survives(&bytes, 1);
    }
}

#[test]
fn zeros_at_the_end_and_anything_in_the_middle_are_no_records() {
    let whole = Bench::with(&[0, 1, 2, 3, 4, 5]).bytes();
    survives(&[&whole[..], &[0; 5000]].concat(), 0);
    let begin = whole.len() - 60;
    let middle = [&whole[..begin], &[0xAB; 100], &whole[begin..]].concat();
    survives(&middle, 1);
}

#[test]
fn damage_is_told_with_its_offset() {
    let bench = Bench::with(&[0, 1, 2, 3, 4, 5]);
    let mut bytes = bench.bytes();
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    let second = bytes.windows(8).position(|w| w == b"result 1").unwrap();
    bytes[second] ^= 1;
    fs::write(bench.path(), &bytes).unwrap();
    let opened = bench.open().unwrap();
    let begin = second - 8 - frame::OVERHEAD;
    assert!(
        opened.warnings[0].contains(&format!("28 bytes at offset {begin} are damaged")),
        "{:?}",
        opened.warnings
    );
    assert!(
        opened.warnings[1].contains("cut off"),
        "{:?}",
        opened.warnings
    );
    assert_eq!(opened.done.missing().collect::<Vec<_>>(), [1, 5]);
}

#[test]
fn a_file_of_another_kind_is_moved_aside() {
    let bench = Bench::new();
    let other = vec![b'x'; 10_000];
    fs::write(bench.path(), &other).unwrap();
    let opened = bench.open().unwrap();
    assert!(opened.done.is_empty() && opened.warnings[0].contains("moved to"));
    let aside = bench.folder.path().join("s.journal.damaged");
    assert_eq!(fs::read(aside).unwrap(), other);
}

#[test]
fn another_sweep_or_shard_is_refused_with_what_differs() {
    let mut bench = Bench::with(&[0]);
    let before = bench.bytes();
    let mut refused = |header| {
        bench.header = header;
        bench.open().unwrap_err().to_string()
    };
    let said = refused(Header::example(POINTS, Shard::WHOLE, 0.2));
    assert!(said.contains("friction: 0.2 here, 0.1 there"), "{said}");
    let said = refused(Header::example(POINTS, Shard::new(1, 2).unwrap(), 0.1));
    assert!(said.contains("shard: 1/2 here, 1/1 there"), "{said}");
    assert_eq!(bench.bytes(), before);
}

#[test]
fn two_cannot_write_one_journal() {
    let bench = Bench::new();
    let first = bench.open().unwrap();
    assert!(matches!(bench.open(), Err(JournalError::Locked(_))));
    drop(first);
    assert!(bench.open().is_ok());
}

#[test]
fn a_journal_that_disappears_is_noticed() {
    let bench = Bench::new();
    let mut journal = bench.open().unwrap().journal;
    journal.add(0, b"x").unwrap();
    fs::remove_file(bench.path()).unwrap();
    assert!(matches!(journal.finish(), Err(JournalError::Gone(_))));
    // Also when another stands in its place.
    let other = bench.open().unwrap().journal;
    assert!(matches!(journal.finish(), Err(JournalError::Gone(_))));
    let records = vec![other.into_records().unwrap()];
    let results = InOrder::new(records, POINTS, bench.folder.path()).unwrap();
    results.remove_journals().unwrap();
    assert!(!bench.path().exists());
}
