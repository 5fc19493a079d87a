//! Tables of the surface and edges of a map.

use touchdown_input::documents::column::{Cell, Column, Heading, cells, headings};
use touchdown_input::points::refined_grid::RefinedGrid;
use touchdown_input::sweeps::sweep_file::Sweep;

use crate::maps::edges::{self, EdgeKind, EdgeLine, ProfileEdge};
use crate::maps::resampled::Resampled;
use crate::maps::rounds::Rounds;
use crate::maps::surface_pieces::MapSurface;

/// Columns of the regular table after the axes.
pub const GRID_COLUMNS: [Column<Resampled>; 2] = [
    Column::number(
        "first_transition_fps",
        |place| place.speed,
        "interpolated V_H; empty where there is no transition",
    ),
    Column::number(
        "estimated_error_fps",
        |place| place.error,
        "estimated error of interpolation by planes: by how much the centre of the cell was off, and on the other side \
         of an edge a place amid that side; empty where a budget ended before anything could tell",
    ),
];

/// A corner of a triangle of the surface.
#[derive(Debug, Clone, Copy)]
pub struct Corner {
    /// Number of its triangle, from 1.
    triangle: u64,
    speed: f64,
}

/// Columns of the table of triangles after the axes.
pub const SURFACE_COLUMNS: [Column<Corner>; 2] = [
    Column::count(
        "triangle",
        |corner| corner.triangle,
        "number of the triangle, from 1",
    ),
    Column::number(
        "first_transition_fps",
        |corner| Some(corner.speed),
        "V_H at this corner",
    ),
];

/// A point of an edge.
#[derive(Debug, Clone, Copy)]
pub struct OfEdge {
    /// Number of the edge, from 1.
    number: u64,
    kind: EdgeKind,
    /// First transitions on either side, ft/s, the lower one first.
    speeds: [Option<f64>; 2],
}

/// Columns of the table of edges after the axes, without the widths.
pub const EDGE_COLUMNS: [Column<OfEdge>; 4] = [
    Column::count("edge", |at| at.number, "number of the line, from 1"),
    Column::word(
        "edge_kind",
        |at| at.kind.name().to_owned(),
        "`end`: V_H has a value on one side only; `jump`: V_H differs, over one axis any transition; `bands`: the number \
         of bands differs, over one axis also how they end",
    ),
    Column::number(
        "lower_transition_fps",
        |at| at.speeds[0],
        "V_H at the nearest point on the side where it is lower, or the only one; empty without a transition",
    ),
    Column::number(
        "higher_transition_fps",
        |at| at.speeds[1],
        "V_H at the nearest point on the other side; empty without a transition",
    ),
];

/// A table of a map.
pub(crate) struct MapTable {
    /// Suffix of its name after that of the sweep.
    pub(crate) end: &'static str,
    pub(crate) heading: Vec<Heading>,
    pub(crate) rows: Vec<Vec<Cell>>,
}

/// The tables of a map: edges, and over two axes also the regular table and the triangles.
pub(crate) fn all(sweep: &Sweep, rounds: &Rounds) -> Vec<MapTable> {
    let legs = sweep.leg_count();
    let within = rounds.map().axes().iter();
    let within = within.map(|&axis| Heading::number(format!("within_{}", sweep.axes[axis].name())));
    let of_edges = sweep.headings(headings(&EDGE_COLUMNS, legs).chain(within));
    let edges = |rows| MapTable {
        end: "-edges",
        heading: of_edges,
        rows,
    };
    if rounds.map().axes().len() == 1 {
        return vec![edges(edges_of_profiles(sweep, rounds))];
    }
    let surfaces = MapSurface::all(rounds);
    vec![
        edges(edges_of_surfaces(sweep, &surfaces)),
        MapTable {
            end: "-grid",
            heading: sweep.headings(headings(&GRID_COLUMNS, legs)),
            rows: grid(sweep, &surfaces),
        },
        MapTable {
            end: "-surface",
            heading: sweep.headings(headings(&SURFACE_COLUMNS, legs)),
            rows: triangles(sweep, &surfaces),
        },
    ]
}

fn edges_of_surfaces(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<Cell>> {
    let all = surfaces.iter().flat_map(|surface| {
        let lines = surface.edges().into_iter();
        lines.map(move |line| (surface, line))
    });
    let mut rows = Vec::new();
    for (number, (surface, EdgeLine { kind, points })) in (1..).zip(all) {
        for point in points {
            let speeds = point.speeds;
            let at = OfEdge {
                number,
                kind,
                speeds,
            };
            let mut row = coordinates(sweep, surface.grid, surface.map, &point.at);
            row.extend(cells(&EDGE_COLUMNS, &at, sweep.leg_count()));
            row.extend(point.within.map(Cell::Number));
            rows.push(row);
        }
    }
    rows
}

fn edges_of_profiles(sweep: &Sweep, rounds: &Rounds) -> Vec<Vec<Cell>> {
    let numbered = (1..).zip(edges::of_profiles(rounds));
    let row = |(number, (map, edge)): (u64, (usize, ProfileEdge))| {
        let at = OfEdge {
            number,
            kind: edge.kind,
            speeds: edge.speeds,
        };
        let mut row = coordinates(sweep, rounds.map(), map, &[edge.at]);
        row.extend(cells(&EDGE_COLUMNS, &at, sweep.leg_count()));
        row.push(Cell::Number(edge.within));
        row
    };
    numbered.map(row).collect()
}

fn grid(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<Cell>> {
    let rows = |surface: &MapSurface| -> Vec<Vec<Cell>> {
        let row = |place: &Resampled| {
            let mut row = coordinates(sweep, surface.grid, surface.map, &place.at);
            row.extend(cells(&GRID_COLUMNS, place, sweep.leg_count()));
            row
        };
        surface.resampled().iter().map(row).collect()
    };
    surfaces.iter().flat_map(rows).collect()
}

fn triangles(sweep: &Sweep, surfaces: &[MapSurface]) -> Vec<Vec<Cell>> {
    let all = surfaces.iter().flat_map(|surface| {
        let triangles = surface.triangles();
        triangles.map(move |triangle| (surface, triangle))
    });
    let mut rows = Vec::new();
    for (triangle, (surface, corners)) in (1..).zip(all) {
        for (at, speed) in corners {
            let corner = Corner { triangle, speed };
            let mut row = coordinates(sweep, surface.grid, surface.map, &at);
            row.extend(cells(&SURFACE_COLUMNS, &corner, sweep.leg_count()));
            rows.push(row);
        }
    }
    rows
}

/// Cells of all coordinates of a place on a map.
fn coordinates(sweep: &Sweep, grid: &RefinedGrid, map: usize, at: &[f64]) -> Vec<Cell> {
    let mut all = grid.coordinates(grid.number(map, [0, 0]));
    for (axis, value) in grid.axes().iter().zip(at) {
        all[*axis] = *value;
    }
    sweep.cells(&all)
}
