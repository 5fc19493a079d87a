//! Edges of a map over one axis: places where the bands over V_H change in class or jump.

use crate::maps::edge_lines::EdgeKind;
use crate::maps::located_side::BRACKET;
use crate::maps::rounds::Rounds;

/// An edge.
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

/// The edges of all maps, each with the number of its map.
pub(crate) fn all(rounds: &Rounds) -> impl Iterator<Item = (usize, ProfileEdge)> {
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
