//! Tables of the surface and edges of a map.

use crate::edge_lines::EdgeLine;
use crate::profile_edges::{self, ProfileEdge};
use crate::refined_grid::RefinedGrid;
use crate::results::optional;
use crate::rounds::Rounds;
use crate::surface_pieces::MapSurface;
use crate::sweep_file::Sweep;

/// Columns of the regular table after the axes.
pub const GRID_COLUMNS: [&str; 2] = ["first_transition_fps", "estimated_error_fps"];
/// Columns of the table of triangles after the axes.
pub const SURFACE_COLUMNS: [&str; 2] = ["triangle", "first_transition_fps"];
/// Columns of the table of edges after the axes, without the widths.
pub const EDGE_COLUMNS: [&str; 4] = [
    "edge",
    "edge_kind",
    "lower_transition_fps",
    "higher_transition_fps",
];

/// A table of a map.
pub(crate) struct MapTable {
    /// Suffix of its name after that of the sweep.
    pub(crate) end: &'static str,
    pub(crate) heading: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

/// The tables of a map: edges, and over two axes also the regular table and the triangles.
pub(crate) fn all(sweep: &Sweep, rounds: &Rounds) -> Vec<MapTable> {
    let within = rounds.map().axes().iter();
    let within = within.map(|&axis| format!("within_{}", sweep.axes[axis].name()));
    let edge_columns = EDGE_COLUMNS.map(str::to_owned).into_iter().chain(within);
    if rounds.map().axes().len() == 1 {
        return vec![MapTable {
            end: "-edges",
            heading: sweep.heading(edge_columns),
            rows: profile_edges(sweep, rounds),
        }];
    }
    let surfaces = MapSurface::all(rounds);
    vec![
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
            let mut row = coordinates(sweep, surface.grid, surface.map, &point.at);
            row.extend([(index + 1).to_string(), kind.name().to_owned()]);
            row.extend(point.speeds.map(optional));
            row.extend(point.within.map(|width| width.to_string()));
            rows.push(row);
        }
    }
    rows
}

fn profile_edges(sweep: &Sweep, rounds: &Rounds) -> Vec<Vec<String>> {
    let row = |(index, (map, edge)): (usize, (usize, ProfileEdge))| {
        let mut row = coordinates(sweep, rounds.map(), map, &[edge.at]);
        row.extend([(index + 1).to_string(), edge.kind.name().to_owned()]);
        row.extend(edge.speeds.map(optional));
        row.push(edge.within.to_string());
        row
    };
    profile_edges::all(rounds).enumerate().map(row).collect()
}

fn grid(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<String>> {
    let row = |surface: &MapSurface| -> Vec<Vec<String>> {
        let places = surface.resampled().into_iter();
        let row = |place: crate::resampled::Resampled| {
            let mut row = coordinates(sweep, surface.grid, surface.map, &place.at);
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
            let mut row = coordinates(sweep, surface.grid, surface.map, &at);
            row.extend([(index + 1).to_string(), speed.to_string()]);
            rows.push(row);
        }
    }
    rows
}

/// All coordinates of a place on a map, as written in results.
fn coordinates(sweep: &Sweep, grid: &RefinedGrid, map: usize, at: &[f64]) -> Vec<String> {
    let mut all = grid.coordinates(grid.number(map, [0, 0]));
    for (axis, value) in grid.axes().iter().zip(at) {
        all[*axis] = *value;
    }
    let varied = sweep.axes.iter().zip(all);
    varied.map(|(axis, value)| axis.written(value)).collect()
}
