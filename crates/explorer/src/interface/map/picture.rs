//! Drawing data of a map: grid or triangles, jumps, edges, coloured levels, and words.

use serde_json::{Value, json};
use touchdown_figures::boundary_table::{
    BoundaryTable, Kind, Point as TablePoint, Transition as TableTransition,
};
use touchdown_figures::caption::Caption;
use touchdown_figures::leading_feet;
use touchdown_figures::legend::Mark;
use touchdown_figures::levels::Levels;
use touchdown_figures::map_legend;
use touchdown_figures::map_table::{self, Edge, EdgeKind, MapTable};
use touchdown_figures::palette;
use touchdown_figures::refined_map;
use touchdown_figures::surface::{Cell, Surface};
use touchdown_sweep::output::results::LEVEL;

use super::table::{Point, Transitions};
use crate::interface::complaint::{Complaint, of_table};
use crate::interface::request::hex;
use crate::named::Results;

/// A map over two axes; empty otherwise.
#[derive(Default)]
pub struct Picture {
    /// Velocities on a grid.
    surface: Option<Surface>,
    /// Triangles.
    refined: Option<MapTable>,
    /// Edges of a refined map.
    edges: Vec<Edge>,
    /// Levels drawn.
    levels: Option<Levels>,
    /// Words for jumps.
    jump_words: Option<String>,
    /// Lines where V_H bisects the leading feet, as places.
    bisector: Vec<Vec<[f64; 2]>>,
    /// Note on a refined map without triangles.
    missing: Option<String>,
    /// Words for points without a transition.
    gap_words: String,
}

impl Picture {
    /// Picture of points over two axes.
    pub fn of(
        results: &Results,
        all: &Transitions,
        [slow, fast]: [usize; 2],
        points: &[&Point],
        caption: &Caption,
    ) -> Result<Self, Complaint> {
        let gap_words = caption.without_transition();
        if let (Some(surface), 2, [0, 1]) = (&results.surface, all.axes.len(), [slow, fast]) {
            let refined = MapTable::parse(surface, results.edges.as_deref(), None, None)
                .map_err(|error| of_table(results, error))?;
            return Ok(Self {
                levels: Some(refined_map::levels(&refined)),
                edges: refined.edges.clone(),
                refined: Some(refined),
                gap_words,
                ..Self::default()
            });
        }
        let names = [slow, fast].map(|axis| all.axes[axis].name.clone());
        let surface =
            table(points, [slow, fast], &names).and_then(|table| Surface::of(&table, |_| true));
        let jump_words = surface.as_ref().and_then(|surface| {
            let entries = map_legend::of_map(surface, caption);
            let jump = entries.into_iter().find(|(mark, _)| *mark == Mark::Jump);
            jump.map(|(_, words)| words)
        });
        let with_feet = surface
            .as_ref()
            .filter(|it| map_legend::has_leading_feet(it, caption));
        let bisector = with_feet.map(|it| leading_feet::lines(&it.slow, &it.fast));
        let missing = missing(results);
        let edges = match (&results.edges, &missing, [slow, fast]) {
            (Some(edges), Some(_), [0, 1]) if all.axes.len() == 2 => {
                map_table::edges_of(edges).map_err(|error| of_table(results, error))?
            }
            _ => Vec::new(),
        };
        let speeds: Vec<f64> = (points.iter())
            .filter_map(|point| Some(point.transition.as_ref()?.speed))
            .collect();
        Ok(Self {
            bisector: bisector.unwrap_or_default(),
            missing,
            levels: Some(match &surface {
                Some(surface) => Levels::of(surface),
                None => Levels::through(&speeds),
            }),
            surface,
            edges,
            refined: None,
            jump_words,
            gap_words,
        })
    }

    /// Adds the picture to an answer.
    pub fn tell(&self, answer: &mut Value) {
        let surface = self.surface.as_ref();
        answer["grid"] = json!(surface.map(|surface| json!({"speeds": surface.speeds})));
        answer["jump"] = json!(surface.map(|surface| surface.jump));
        answer["jump_bars"] = json!(surface.map(Surface::jump_bars).unwrap_or_default());
        answer["jump_cells"] = json!(surface.map(jump_cells).unwrap_or_default());
        answer["lowest"] = json!(surface.map(Surface::lowest_in_rows).unwrap_or_default());
        answer["triangles"] = json!(self.refined.as_ref().map(triangles));
        answer["edges"] = edges(&self.edges);
        answer["levels"] = json!(self.levels.as_ref().map(levels).unwrap_or_default());
        answer["bisector"] = json!(self.bisector);
        answer["words"] = json!({
            "bisector": map_legend::BISECTOR_WORDS,
            "missing": self.missing,
            "gap": self.gap_words,
            "jump": self.jump_words,
            "jump_cell": "not interpolated across a jump",
            "end": refined_map::words(EdgeKind::End),
            "bands": refined_map::words(EdgeKind::Bands),
            "edge_jump": refined_map::words(EdgeKind::Jump),
        });
        answer["colours"] = json!({
            "jump": hex(palette::JUMP),
            "jump_cell": hex(palette::JUMP_CELL),
            "gap": hex(palette::NONE),
            "line": hex(palette::LINE),
            "lowest": hex(palette::LOWEST),
            "end": hex(palette::NONE),
            "bands": hex(palette::BISECTOR),
            "bisector": hex(palette::BISECTOR),
        });
    }
}

/// Note on a refined map with points only: contours need its surface, which a sweep writes from its journal.
fn missing(results: &Results) -> Option<String> {
    let heading = results.table.lines().next().unwrap_or_default();
    let is_refined = heading.split(',').any(|column| column == LEVEL);
    (is_refined && results.surface.is_none()).then(|| {
        let name = &results.name;
        format!(
            "points only: contours need {name}-surface.csv beside the table, which touchdown sweep writes"
        )
    })
}

/// The points as a table over two axes; `None` if an axis has words.
fn table(points: &[&Point], axes: [usize; 2], names: &[String; 2]) -> Option<BoundaryTable> {
    let points: Option<Vec<TablePoint>> = (points.iter())
        .map(|point| {
            let place = axes.map(|axis| point.place[axis].as_f64());
            Some(TablePoint {
                coordinates: vec![place[0]?, place[1]?],
                transition: match &point.transition {
                    None => None,
                    Some(found) => Some(TableTransition {
                        kind: Kind::from_name(&found.to)?,
                        speed: found.speed,
                        low: found.low,
                        high: found.high,
                        patchy_to: found.patchy_to,
                    }),
                },
            })
        })
        .collect();
    Some(BoundaryTable {
        axes: names.to_vec(),
        points: points?,
        others: Vec::new(),
    })
}

fn jump_cells(surface: &Surface) -> Vec<[usize; 2]> {
    let cells = surface.cells().filter(|(_, cell)| *cell == Cell::Jump);
    cells.map(|(place, _)| place).collect()
}

fn triangles(map: &MapTable) -> Vec<[[f64; 3]; 3]> {
    let corners =
        |triangle: &[([f64; 2], f64); 3]| triangle.map(|([slow, fast], speed)| [slow, fast, speed]);
    map.triangles.iter().map(corners).collect()
}

fn edges(edges: &[Edge]) -> Value {
    let edges = edges
        .iter()
        .map(|edge| json!({"kind": edge.kind.name(), "places": edge.places}));
    edges.collect()
}

/// Colour bands, lowest first, each with its upper speed.
fn levels(levels: &Levels) -> Vec<Value> {
    let bands = levels.bands().into_iter().map(|[low, high]| {
        let speed = high.is_finite().then_some(high);
        json!({"speed": speed, "colour": hex(levels.colour(low))})
    });
    bands.collect()
}
