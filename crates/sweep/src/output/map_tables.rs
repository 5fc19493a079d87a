//! The surface and the edges of a map as tables.

use crate::edge_lines::EdgeLine;
use crate::results::optional;
use crate::rounds::Rounds;
use crate::surface_pieces::MapSurface;
use crate::sweep_file::Sweep;

/// Columns of the regular table after those of the axes.
pub const GRID_COLUMNS: [&str; 2] = ["first_transition_fps", "estimated_error_fps"];
/// Columns of the table of triangles after those of the axes.
pub const SURFACE_COLUMNS: [&str; 2] = ["triangle", "first_transition_fps"];
/// Columns of the table of edges after those of the axes, but for the widths.
pub const EDGE_COLUMNS: [&str; 4] = [
    "edge",
    "edge_kind",
    "lower_transition_fps",
    "higher_transition_fps",
];

/// A table of a map.
pub(crate) struct MapTable {
    /// What follows the sweep's name in its name.
    pub(crate) end: &'static str,
    pub(crate) heading: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

/// The tables of a map: edges, regular table, triangles.
pub(crate) fn all(sweep: &Sweep, rounds: &Rounds) -> [MapTable; 3] {
    let surfaces = MapSurface::all(rounds);
    let within = rounds.map().axes();
    let within = within.map(|axis| format!("within_{}", sweep.axes[axis].name()));
    let edge_columns = EDGE_COLUMNS.map(str::to_owned).into_iter().chain(within);
    [
        MapTable {
            end: "-edges",
            heading: sweep.heading(edge_columns),
            rows: edges(sweep, &surfaces),
        },
        MapTable {
            end: "-grid",
            heading: sweep.heading(GRID_COLUMNS),
            rows: grid(sweep, &surfaces),
        },
        MapTable {
            end: "-surface",
            heading: sweep.heading(SURFACE_COLUMNS),
            rows: triangles(sweep, &surfaces),
        },
    ]
}

fn edges(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<String>> {
    let all = surfaces.iter().flat_map(|surface| {
        let lines = surface.edges().into_iter();
        lines.map(move |line| (surface, line))
    });
    let mut rows = Vec::new();
    for (index, (surface, EdgeLine { kind, points })) in all.enumerate() {
        for point in points {
            let mut row = coordinates(sweep, surface, point.at);
            row.extend([(index + 1).to_string(), kind.name().to_owned()]);
            row.extend(point.speeds.map(optional));
            row.extend(point.within.map(|width| width.to_string()));
            rows.push(row);
        }
    }
    rows
}

fn grid(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<String>> {
    let row = |surface: &MapSurface| -> Vec<Vec<String>> {
        let places = surface.resampled().into_iter();
        let row = |place: crate::resampled::Resampled| {
            let mut row = coordinates(sweep, surface, place.at);
            row.extend([optional(place.speed), optional(place.error)]);
            row
        };
        places.map(row).collect()
    };
    surfaces.iter().flat_map(row).collect()
}

fn triangles(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<String>> {
    let all = surfaces.iter().flat_map(|surface| {
        let triangles = surface.triangles();
        triangles.map(move |triangle| (surface, triangle))
    });
    let mut rows = Vec::new();
    for (index, (surface, corners)) in all.enumerate() {
        for (at, speed) in corners {
            let mut row = coordinates(sweep, surface, at);
            row.extend([(index + 1).to_string(), speed.to_string()]);
            rows.push(row);
        }
    }
    rows
}

/// All coordinates of a place on a map, as results write them.
fn coordinates(sweep: &Sweep, surface: &MapSurface, at: [f64; 2]) -> Vec<String> {
    let mut all = surface
        .grid
        .coordinates(surface.grid.number(surface.map, [0, 0]));
    for (axis, value) in surface.grid.axes().into_iter().zip(at) {
        all[axis] = value;
    }
    let varied = sweep.axes.iter().zip(all);
    varied.map(|(axis, value)| axis.written(value)).collect()
}
