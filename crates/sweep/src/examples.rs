//! Input for tests, and rows of tables as text.

use std::path::Path;

use touchdown_input::documents::column::{Cell, Heading};
use touchdown_input::documents::library::{Library, Source};
use touchdown_input::readers::vehicle_file::VehicleFile;
use touchdown_input::sweeps::sweep_file::Sweep;

const SURVEYOR: &str = "vehicles/surveyor-table-4-1.toml";

/// A file of those shipped with the program, copied.
fn shipped(name: &str) -> Source {
    let sweeps = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps"));
    Source {
        path: name.into(),
        text: Library::Disk.text(&sweeps.join(name)).unwrap(),
    }
}

/// The Surveyor of Table 4-1.
pub(crate) fn surveyor() -> VehicleFile {
    let copies = [shipped(SURVEYOR)];
    VehicleFile::read_from(Path::new(SURVEYOR), Library::Copies(&copies)).unwrap()
}

/// A sweep with this text, beside the vehicles that are shipped.
pub(crate) fn sweep(text: &str) -> Sweep {
    let path = Path::new("sweep.toml");
    let own = Source {
        path: path.to_owned(),
        text: text.to_owned(),
    };
    Sweep::read_from(path, Library::Copies(&[own, shipped(SURVEYOR)])).unwrap()
}

/// The sweep of Figure 4-9.
pub(crate) fn figure_4_09() -> Sweep {
    sweep(&shipped("figure-4-09.toml").text)
}

/// A row as text.
pub(crate) fn text(row: impl IntoIterator<Item = Cell>) -> String {
    let cells: Vec<String> = row.into_iter().map(|cell| cell.to_string()).collect();
    cells.join(",")
}

/// A heading as text.
pub(crate) fn names(heading: impl IntoIterator<Item = Heading>) -> String {
    let names: Vec<String> = heading.into_iter().map(|one| one.name).collect();
    names.join(",")
}
