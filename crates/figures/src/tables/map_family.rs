//! Families of maps: tables over more axes than a map has are those of a map for each value of the others.

use crate::figure_error::FigureError;
use crate::map_table::{MapTable, TRIANGLE};
use crate::table::{Cells, Row, Table};

/// Reads refined maps from a table of triangles, and those of edges, of points and of even steps, if there are; each with
/// its values on the other axes.
///
/// # Errors
/// When they are not as the program writes them, or there are no triangles.
pub fn refined(
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
