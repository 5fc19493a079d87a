//! Reads the surface of a map, as triangles, and its edges; of tables over more axes than a map has, the map for each value
//! of the others.

use crate::boundary_table::{BoundaryTable, Point};
use crate::division::Division;
use crate::tables::{Cells, Row, Table, has_column};
use crate::words::FigureError;

/// The column after the axes of a table of triangles.
const TRIANGLE: &str = "triangle";
const SPEED: &str = "first_transition_fps";
const EDGE: &str = "edge";
const KIND: &str = "edge_kind";
const ERROR: &str = "estimated_error_fps";

/// A place on a map, along the slower and the faster axis, and the first transition there.
pub type Corner = ([f64; 2], f64);

/// Kind of an edge of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeKind {
    /// A transition on one side only.
    End,
    /// A jump of the first transition.
    Jump,
    /// More bands on one side.
    Bands,
}

impl EdgeKind {
    /// All of them, in the order of legends.
    pub const ALL: [Self; 3] = [Self::End, Self::Jump, Self::Bands];

    /// Its word in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::End => "end",
            Self::Jump => "jump",
            Self::Bands => "bands",
        }
    }
}

/// An edge of a map from end to end.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Its kind.
    pub kind: EdgeKind,
    /// Its places, in order.
    pub places: Vec<[f64; 2]>,
}

/// A map over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct MapTable {
    /// Names of the slower and the faster axis.
    pub axes: [String; 2],
    /// The triangles of its surface.
    pub triangles: Vec<[Corner; 3]>,
    /// Its edges.
    pub edges: Vec<Edge>,
    /// Its points above which stable landings and others alternate.
    pub patchy: Vec<[f64; 2]>,
    /// Its regular table, if there is one.
    pub grid: Option<Grid>,
}

/// Estimated errors of a map at even steps.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Coordinates along the slower and the faster axis, at least one each.
    pub coordinates: [Vec<f64>; 2],
    /// Estimated errors of the first transitions, row by row of the slower axis, where they are known.
    pub errors: Vec<Option<f64>>,
}

/// Returns whether a table is one of triangles.
pub fn is_one(csv: &str) -> bool {
    has_column(csv, &[TRIANGLE])
}

impl MapTable {
    /// Reads the table of triangles, and those of edges, of points and of even steps, if there are.
    ///
    /// # Errors
    /// When they are not as the program writes them, or not over two axes.
    pub fn parse(
        triangles: &str,
        edges: Option<&str>,
        points: Option<&str>,
        grid: Option<&str>,
    ) -> Result<Self, FigureError> {
        let parse = |csv: Option<&str>| csv.map(Table::parse).transpose();
        let triangles = Table::parse(triangles)?;
        let (edges, points, grid) = (parse(edges)?, parse(points)?, parse(grid)?);
        Self::of(&triangles, edges.as_ref(), points.as_ref(), grid.as_ref())
    }

    /// As [`MapTable::parse`].
    pub(crate) fn of(
        triangles: &Table,
        edges: Option<&Table>,
        points: Option<&Table>,
        grid: Option<&Table>,
    ) -> Result<Self, FigureError> {
        let (triangle, speed) = (triangles.column(TRIANGLE)?, triangles.column(SPEED)?);
        let [slow, fast] = triangles.names()[..triangle] else {
            return Err(FigureError::NoPicture(
                "a map is drawn over two axes".to_owned(),
            ));
        };
        let axes = [slow.to_owned(), fast.to_owned()];
        let corners = triangles
            .rows()
            .map(|row| Ok((place(row)?, row.number(speed)?)));
        let corners = corners.collect::<Result<Vec<Corner>, FigureError>>()?;
        let (triangles, _) = corners.as_chunks::<3>();
        let points = points.map(|points| BoundaryTable::worst_of(points, &axes));
        Ok(Self {
            axes,
            triangles: triangles.to_vec(),
            edges: edges.map(read_edges).transpose()?.unwrap_or_default(),
            patchy: points.transpose()?.as_ref().map_or_else(Vec::new, patchy),
            grid: grid.map(read_grid).transpose()?,
        })
    }

    /// The map with positions along axes of these divisions instead of their values.
    pub(crate) fn placed(mut self, divisions: [Division; 2]) -> Self {
        let triangles = self.triangles.iter_mut().flatten().map(|(place, _)| place);
        let edges = self.edges.iter_mut().flat_map(|edge| &mut edge.places);
        for place in triangles.chain(edges).chain(&mut self.patchy) {
            for (value, division) in place.iter_mut().zip(divisions) {
                *value = division.place(*value);
            }
        }
        let grid = self.grid.iter_mut().flat_map(|grid| &mut grid.coordinates);
        for (values, division) in grid.zip(divisions) {
            for value in values {
                *value = division.place(*value);
            }
        }
        self
    }
}

fn patchy(points: &BoundaryTable) -> Vec<[f64; 2]> {
    let place = |point: &Point| match (point.transition?.patchy_to, &point.coordinates[..]) {
        (Some(_), [slow, fast]) => Some([*slow, *fast]),
        _ => None,
    };
    points.points.iter().filter_map(place).collect()
}

fn place(row: Row) -> Result<[f64; 2], FigureError> {
    Ok([row.number(0)?, row.number(1)?])
}

fn read_grid(table: &Table) -> Result<Grid, FigureError> {
    let error = table.column(ERROR)?;
    let places = table.nonempty_rows()?.map(place);
    let places = places.collect::<Result<Vec<_>, FigureError>>()?;
    let errors = table.rows().map(|row| row.optional_number(error));
    let errors = errors.collect::<Result<Vec<_>, FigureError>>()?;
    let first_row = places.iter().take_while(|place| place[0] == places[0][0]);
    let fast: Vec<f64> = first_row.map(|place| place[1]).collect();
    let slow: Vec<f64> = places
        .iter()
        .step_by(fast.len())
        .map(|place| place[0])
        .collect();
    let coordinates = [slow, fast];
    match coordinates.iter().map(Vec::len).product::<usize>() == errors.len() {
        true => Ok(Grid {
            coordinates,
            errors,
        }),
        false => Err(FigureError::Table(
            "its rows are not those of a regular table".to_owned(),
        )),
    }
}

/// Reads the table of the edges of a map.
///
/// # Errors
/// When it is not as the program writes it.
pub fn edges_of(csv: &str) -> Result<Vec<Edge>, FigureError> {
    read_edges(&Table::parse(csv)?)
}

fn read_edges(table: &Table) -> Result<Vec<Edge>, FigureError> {
    let (edge, kind) = (table.column(EDGE)?, table.column(KIND)?);
    let mut edges: Vec<Edge> = Vec::new();
    let mut last = "";
    for row in table.rows() {
        if row.text(edge) != last {
            last = row.text(edge);
            let known = |one: &EdgeKind| one.name() == row.text(kind);
            let found = EdgeKind::ALL.into_iter().find(known);
            let kind = found.ok_or_else(|| row.error(kind, "end, jump or bands"))?;
            let places = Vec::new();
            edges.push(Edge { kind, places });
        }
        if let Some(edge) = edges.last_mut() {
            edge.places.push(place(row)?);
        }
    }
    Ok(edges)
}

/// Reads refined maps from a table of triangles, and those of edges, of points and of even steps, if there are; each with
/// its values on the other axes.
///
/// # Errors
/// When they are not as the program writes them, or there are no triangles.
pub fn family(
    triangles: &str,
    beside: [Option<&str>; 3],
) -> Result<Vec<(Cells, MapTable)>, FigureError> {
    let triangles = Table::parse(triangles)?;
    let others = others(&triangles)?;
    let parse = |csv: Option<&str>| csv.map(Table::parse).transpose();
    let [edges, points, grid] = beside.map(parse);
    let beside = [edges?, points?, grid?];
    // A map without a transition has even steps, but no triangles.
    let members = beside[2]
        .as_ref()
        .unwrap_or(&triangles)
        .different(&others)?;
    let read = |member: Cells| {
        let of = |table: &Table| table.with(&member);
        let [edges, points, grid] = beside
            .each_ref()
            .map(|table| table.as_ref().map(of).transpose());
        let map = MapTable::of(
            &of(&triangles)?,
            edges?.as_ref(),
            points?.as_ref(),
            grid?.as_ref(),
        )?;
        Ok((member, map))
    };
    members.into_iter().map(read).collect()
}

/// The axes that tell the maps of a table of triangles apart: no triangle has corners that differ in them.
fn others(triangles: &Table) -> Result<Vec<String>, FigureError> {
    let axes = triangles.column(TRIANGLE)?;
    let corners: Vec<Row> = triangles.nonempty_rows()?.collect();
    let (all, _) = corners.as_chunks::<3>();
    let is_other = |axis: &usize| {
        let is_same = |corners: &[Row; 3]| {
            let texts = corners.map(|corner| corner.text(*axis));
            texts[1..] == [texts[0]; 2]
        };
        axes > 2 && all.iter().all(is_same)
    };
    let names = triangles.names();
    Ok((0..axes)
        .filter(is_other)
        .map(|axis| names[axis].to_owned())
        .collect())
}
