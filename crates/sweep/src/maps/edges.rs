//! Edges of a map, where transitions end or jump, or the number of bands changes: lines over two axes, places over one.

use std::collections::HashMap;

use touchdown_input::points::refined_grid::Place;

use crate::maps::cell::{Position, middle, position};
use crate::maps::located_side::BRACKET;
use crate::maps::pieces::{Crossing, Known};
use crate::maps::rounds::Rounds;
use crate::maps::surface_pieces::MapSurface;

/// Kind of an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum EdgeKind {
    /// A transition on one side only.
    End,
    /// Different first transitions.
    Jump,
    /// More bands on one side.
    Bands,
}

impl EdgeKind {
    /// Word in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::End => "end",
            Self::Jump => "jump",
            Self::Bands => "bands",
        }
    }

    fn of([a, b]: Crossing) -> Self {
        match (a.1.speed, b.1.speed) {
            (Some(_), Some(_)) if a.1.is_like(b.1) => Self::Jump,
            (Some(_), Some(_)) => Self::Bands,
            _ => Self::End,
        }
    }
}

/// A point of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Coordinates along the two refined axes.
    pub at: [f64; 2],
    /// Half the distance along each axis between the points on either side of the edge.
    pub within: [f64; 2],
    /// First transitions of these points, ft/s, lower first; `None` without one.
    pub speeds: [Option<f64>; 2],
}

/// An edge from end to end.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeLine {
    /// Kind.
    pub kind: EdgeKind,
    /// Points in order.
    pub points: Vec<EdgePoint>,
}

/// The places between which an edge passes.
type Key = [Place; 2];

impl MapSurface<'_> {
    /// The edges of the map.
    pub fn edges(&self) -> Vec<EdgeLine> {
        let mut pieces: Vec<(EdgeKind, Vec<Crossing>)> = Vec::new();
        for cut in self.parts.iter().flat_map(|part| &part.cuts) {
            let kinds = cut.crossings.iter().map(|crossing| EdgeKind::of(*crossing));
            // If ends of transitions and jumps meet in one cell, the first point decides the kind of the line.
            if let Some(kind) = kinds.into_iter().next() {
                pieces.push((kind, cut.crossings.clone()));
            }
        }
        let mut at_ends: HashMap<Key, Vec<usize>> = HashMap::new();
        for (index, (_, crossings)) in pieces.iter().enumerate() {
            for end in ends(crossings) {
                at_ends.entry(end).or_default().push(index);
            }
        }
        let mut is_used = vec![false; pieces.len()];
        let mut lines = Vec::new();
        for index in 0..pieces.len() {
            if is_used[index] {
                continue;
            }
            is_used[index] = true;
            let (kind, mut line) = pieces[index].clone();
            for _ in 0..2 {
                while let Some(next) = continued(&line, kind, &pieces, &at_ends, &mut is_used) {
                    line.extend(next);
                }
                line.reverse();
            }
            let points: Vec<EdgePoint> = line
                .into_iter()
                .map(|crossing| self.point(crossing))
                .collect();
            if points.len() > 1 {
                lines.push(EdgeLine { kind, points });
            }
        }
        lines
    }

    fn point(&self, [a, b]: Crossing) -> EdgePoint {
        let places = [position(a.0), position(b.0)];
        let ends = places.map(|place: Position| self.coordinates(place));
        let at = self.coordinates(middle(places[0], places[1]));
        let within = [0, 1].map(|axis: usize| 0.5 * (ends[1][axis] - ends[0][axis]).abs());
        let mut speeds = [a.1.speed, b.1.speed];
        if speeds[0].is_none() || speeds[1].is_some() && speeds[1] < speeds[0] {
            speeds.reverse();
        }
        EdgePoint { at, within, speeds }
    }
}

fn key([a, b]: [Known; 2]) -> Key {
    let mut places = [a.0, b.0];
    places.sort_unstable();
    places
}

fn ends(crossings: &[Crossing]) -> Vec<Key> {
    let mut ends: Vec<Key> = [crossings.first(), crossings.last()]
        .into_iter()
        .flatten()
        .map(|crossing| key(*crossing))
        .collect();
    ends.dedup();
    ends
}

/// Continues a line at its end by the points of another piece.
fn continued(
    line: &[Crossing],
    kind: EdgeKind,
    pieces: &[(EdgeKind, Vec<Crossing>)],
    at_ends: &HashMap<Key, Vec<usize>>,
    is_used: &mut [bool],
) -> Option<Vec<Crossing>> {
    let end = key(*line.last()?);
    let next = at_ends.get(&end)?.iter().copied();
    let next = next
        .into_iter()
        .find(|index| !is_used[*index] && pieces[*index].0 == kind)?;
    is_used[next] = true;
    let mut crossings = pieces[next].1.clone();
    if key(*crossings.first()?) != end {
        crossings.reverse();
    }
    crossings.remove(0);
    Some(crossings)
}

/// An edge of a map over one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ProfileEdge {
    /// Value of the axis.
    pub(crate) at: f64,
    /// Half the distance between the points on either side.
    pub(crate) within: f64,
    /// Kind.
    pub(crate) kind: EdgeKind,
    /// First transitions of these points, ft/s, lower first; `None` without one.
    pub(crate) speeds: [Option<f64>; 2],
}

/// The edges of all maps over one axis, each with the number of its map.
pub(crate) fn of_profiles(rounds: &Rounds) -> impl Iterator<Item = (usize, ProfileEdge)> {
    let grid = rounds.map();
    rounds.leaves().filter_map(move |(map, leaf)| {
        let ends = [leaf.cell.low[0], leaf.cell.low[0] + leaf.cell.size[0]];
        let bands = |place| rounds.bands(map, [place, 0]);
        let leap = bands(ends[0])?.leap(bands(ends[1])?);
        let is_jump = leap > grid.rules.jump && leaf.cell.size[0] <= BRACKET;
        if leap.is_finite() && !is_jump {
            return None;
        }
        let first = |place| Some(rounds.height(map, [place, 0])?.speed);
        let mut speeds = [first(ends[0])?, first(ends[1])?];
        let kind = match speeds {
            _ if leap.is_finite() => EdgeKind::Jump,
            [Some(_), Some(_)] | [None, None] => EdgeKind::Bands,
            _ => EdgeKind::End,
        };
        if speeds[0].is_none() || speeds[1].is_some() && speeds[1] < speeds[0] {
            speeds.reverse();
        }
        let [low, high] = ends.map(|place| grid.value(0, place as f64));
        let edge = ProfileEdge {
            at: 0.5 * (low + high),
            within: 0.5 * (high - low).abs(),
            kind,
            speeds,
        };
        Some((map, edge))
    })
}
