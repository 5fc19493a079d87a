//! The surface over a cell: one piece without edges, two on either side of an edge, more with several edges.
//!
//! A piece is a ring of corners around an apex; over each triangle of the apex and two neighbours on the ring the
//! surface is a plane. Adjacent cells share the places on their common side, so their pieces fit together.

use touchdown_input::points::refined_grid::Place;

use crate::maps::cell::{Position, middle, position};
use crate::maps::height::Height;
use crate::maps::located_side::edges;

/// A position and the first transition there, ft/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Corner {
    pub(crate) at: Position,
    pub(crate) speed: f64,
}

/// A part of the surface without edges inside.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piece {
    pub(crate) ring: Vec<Corner>,
    pub(crate) apex: Corner,
}

/// A place and its height.
pub(crate) type Known = (Place, Height);

/// A point where an edge crosses a side of a cell, or passes a place inside: the known places on either side.
pub(crate) type Crossing = [Known; 2];

/// An edge through a cell.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cut {
    /// Crossings from side to side; the first places of all lie on the same side of the edge.
    pub(crate) crossings: Vec<Crossing>,
}

impl Cut {
    /// Segments of its line with transitions on both sides.
    pub(crate) fn jumps(&self) -> Vec<[Position; 2]> {
        let at = |[a, b]: &Crossing| middle(position(a.0), position(b.0));
        let is_jump = |[a, b]: &Crossing| a.1.speed.is_some() && b.1.speed.is_some();
        let pairs = self.crossings.windows(2);
        let jumps = pairs.filter(|pair| pair.iter().any(is_jump));
        jumps.map(|pair| [at(&pair[0]), at(&pair[1])]).collect()
    }
}

/// Known places of a cell.
pub(crate) struct Around<'k> {
    /// Places on its sides, in order around it.
    pub(crate) ring: &'k [Known],
    /// Places inside: the centre first, then the check of the surface beyond an edge.
    pub(crate) within: &'k [Known],
    /// Places on either side of an edge at its middle, in the order of its first crossing on the ring.
    pub(crate) bend: Option<Crossing>,
}

impl Piece {
    fn new(ring: Vec<Corner>, centre: Option<Corner>) -> Self {
        let share = 1.0 / ring.len() as f64;
        let mean = |of: &dyn Fn(&Corner) -> f64| ring.iter().map(of).sum::<f64>() * share;
        let apex = centre.unwrap_or_else(|| Corner {
            at: [mean(&|corner| corner.at[0]), mean(&|corner| corner.at[1])],
            speed: mean(&|corner| corner.speed),
        });
        Self { ring, apex }
    }

    /// The triangles of the piece.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = [Corner; 3]> {
        let next = self.ring.iter().cycle().skip(1);
        let sides = self.ring.iter().zip(next);
        sides.map(|(a, b)| [self.apex, *a, *b])
    }

    /// Area in steps.
    pub(crate) fn area(&self) -> f64 {
        let next = self.ring.iter().cycle().skip(1);
        let sides = self.ring.iter().zip(next);
        let twice: f64 = sides
            .map(|(a, b)| a.at[0] * b.at[1] - a.at[1] * b.at[0])
            .sum();
        0.5 * twice.abs()
    }

    /// First transition at a position, ft/s, if the position is within the piece.
    pub(crate) fn speed_at(&self, at: Position) -> Option<f64> {
        self.triangles()
            .find_map(|corners| speed_within(&corners, at))
    }
}

/// Height of a triangle at a position, if the position is within it.
pub(crate) fn speed_within([a, b, c]: &[Corner; 3], at: Position) -> Option<f64> {
    const SLACK: f64 = 1e-9;
    let cross = |p: Position, q: Position, r: Position| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let area = cross(a.at, b.at, c.at);
    if area == 0.0 {
        return None;
    }
    let parts = [
        cross(b.at, c.at, at) / area,
        cross(c.at, a.at, at) / area,
        cross(a.at, b.at, at) / area,
    ];
    let is_within = parts.iter().all(|part| *part >= -SLACK);
    is_within.then(|| parts[0] * a.speed + parts[1] * b.speed + parts[2] * c.speed)
}

impl Around<'_> {
    /// The pieces of the surface over the cell, and the edges between them.
    pub(crate) fn pieces(&self, jump: f64) -> (Vec<Piece>, Vec<Cut>) {
        let count = self.ring.len();
        let pair = |index: usize| [self.ring[index % count], self.ring[(index + 1) % count]];
        let found = edges(self.ring, jump);
        match *found.as_slice() {
            [] | [_] => (self.whole(), Vec::new()),
            [one, other] => {
                let mut crossings = vec![pair(one)];
                crossings.extend(self.bend.map(|bend| turned(bend, pair(one))));
                let [a, b] = pair(other);
                crossings.push([b, a]);
                self.parted(one, other, crossings)
            }
            // Several jumps stem from adjacent cells, in which the surface was found to be smooth.
            _ if self
                .ring
                .iter()
                .all(|known| known.1.is_like(self.ring[0].1)) =>
            {
                (self.whole(), Vec::new())
            }
            ref many => {
                let Some((one, other)) = nearest_together(self.ring, many) else {
                    return (self.whole(), Vec::new());
                };
                let [a, b] = pair(other);
                let (mut pieces, mut cuts) = cut_off(self.arc(one + 1, other), [pair(one), [b, a]]);
                let rest = Around {
                    ring: &self.arc(other + 1, one + count),
                    ..*self
                };
                let (more, others) = rest.pieces(jump);
                pieces.extend(more);
                cuts.extend(others);
                (pieces, cuts)
            }
        }
    }

    fn whole(&self) -> Vec<Piece> {
        let centre = self.within.first().copied().and_then(corner);
        let ring = corners(self.ring).into_iter();
        ring.map(|ring| Piece::new(ring, centre)).collect()
    }

    /// The two pieces on either side of an edge.
    fn parted(&self, one: usize, other: usize, crossings: Vec<Crossing>) -> (Vec<Piece>, Vec<Cut>) {
        let mut pieces = Vec::new();
        // Seen from the ring, the places after the first crossing lie on its second side.
        for (arc, side) in [
            (self.arc(one + 1, other), 1),
            (self.arc(other + 1, one + self.ring.len()), 0),
        ] {
            let edge = crossings.iter().map(|crossing| {
                let at = middle(position(crossing[0].0), position(crossing[1].0));
                crossing[side].1.speed.map(|speed| Corner { at, speed })
            });
            let edge: Option<Vec<Corner>> = edge.collect();
            let (Some(mut ring), Some(mut edge)) = (corners(&arc), edge) else {
                continue;
            };
            // The ring of the second side runs from the first crossing to the last, so the edge leads back.
            if side == 1 {
                edge.reverse();
            }
            ring.extend(edge);
            let known = self.within.iter().copied().filter_map(corner);
            let within = { known }.find(|known| is_left_of_all(&ring, known.at));
            pieces.push(Piece::new(ring, within));
        }
        (pieces, vec![Cut { crossings }])
    }

    /// Places of the ring from one index to another; indices may exceed one turn.
    fn arc(&self, from: usize, to: usize) -> Vec<Known> {
        let count = self.ring.len();
        (from..=to).map(|index| self.ring[index % count]).collect()
    }
}

/// The pieces on either side of two edges close to each other, and the single edge made of both. The outer piece is the
/// strip between the edge and the places outside it, where the rest of the ring begins.
fn cut_off(arc: Vec<Known>, [from, to]: [Crossing; 2]) -> (Vec<Piece>, Vec<Cut>) {
    let on_edge = |crossing: Crossing, side: usize| {
        let at = middle(position(crossing[0].0), position(crossing[1].0));
        let speed = crossing[side].1.speed?;
        Some(Corner { at, speed })
    };
    let inner = || {
        let mut ring = corners(&arc)?;
        ring.extend([on_edge(to, 1)?, on_edge(from, 1)?]);
        Some(ring)
    };
    let outer = || {
        Some(vec![
            corner(from[0])?,
            on_edge(from, 0)?,
            on_edge(to, 0)?,
            corner(to[0])?,
        ])
    };
    let rings = [inner(), outer()].into_iter().flatten();
    let pieces = rings.map(|ring| Piece::new(ring, None)).collect();
    (
        pieces,
        vec![Cut {
            crossings: vec![from, to],
        }],
    )
}

/// The two consecutive edges on a ring that are closest to each other.
fn nearest_together(ring: &[Known], edges: &[usize]) -> Option<(usize, usize)> {
    let count = ring.len();
    let at = |index: usize| {
        let [a, b] = [ring[index % count], ring[(index + 1) % count]];
        middle(position(a.0), position(b.0))
    };
    let next = edges.iter().skip(1).copied();
    let next = next.chain(edges.first().map(|first| first + count));
    let square = |one: usize, other: usize| {
        let (p, q) = (at(one), at(other));
        (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1])
    };
    let pairs = edges.iter().copied().zip(next);
    pairs.min_by(|a, b| square(a.0, a.1).total_cmp(&square(b.0, b.1)))
}

/// Orients a crossing so that its first place is like the first of another.
fn turned(crossing: Crossing, like: Crossing) -> Crossing {
    let [a, b] = crossing;
    let apart = |one: Known, other: Known| one.1.leap(other.1);
    let straight = apart(a, like[0]).max(apart(b, like[1]));
    let crossed = apart(b, like[0]).max(apart(a, like[1]));
    if straight <= crossed { [a, b] } else { [b, a] }
}

fn corner((place, height): Known) -> Option<Corner> {
    let at = position(place);
    height.speed.map(|speed| Corner { at, speed })
}

/// Corners at places, if all have a transition.
fn corners(places: &[Known]) -> Option<Vec<Corner>> {
    places.iter().copied().map(corner).collect()
}

/// True if a position is seen from all sides of a ring with the orientation of cell corners.
fn is_left_of_all(ring: &[Corner], at: Position) -> bool {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).all(|(a, b)| {
        let (p, q) = (a.at, b.at);
        (q[1] - p[1]) * (at[0] - p[0]) - (q[0] - p[0]) * (at[1] - p[1]) > 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two corners of a cell have one band more. The edges around each are longer than the way from one to the other is
    /// wide or high.
    #[test]
    fn of_four_edges_those_around_a_corner_are_joined() {
        let is_in_corner = |[i, j]: Place| (i < 5 && j > 5) || (i > 3 && j < 3);
        let up = (0..8)
            .map(|step| [0, step])
            .chain((0..8).map(|step| [step, 8]));
        let round: Vec<Place> = up.clone().chain(up.map(|[i, j]| [8 - i, 8 - j])).collect();
        let transposed = round.iter().rev().map(|[i, j]| [*j, *i]).collect();
        for (places, turn) in [(round, false), (transposed, true)] {
            let height = |[i, j]: Place| {
                let is_other = is_in_corner(if turn { [j, i] } else { [i, j] });
                let height = Height {
                    speed: Some(if is_other { 20.0 } else { 10.0 }),
                    bands: usize::from(is_other),
                };
                ([i, j], height)
            };
            let ring: Vec<Known> = places.into_iter().map(height).collect();
            let around = Around {
                ring: &ring,
                within: &[],
                bend: None,
            };
            let (pieces, cuts) = around.pieces(0.2);
            assert_eq!((pieces.len(), cuts.len()), (4, 2));
            let corners: Vec<f64> = (pieces.iter())
                .filter(|piece| piece.ring.iter().all(|corner| corner.speed == 20.0))
                .map(Piece::area)
                .collect();
            // Half of the steps from the edges to the corner, 4.5 by 2.5.
            assert_eq!(corners, [0.5 * 4.5 * 2.5; 2]);
            let whole: f64 = pieces.iter().map(Piece::area).sum();
            assert_eq!(whole, 64.0, "the pieces cover the cell");
        }
    }
}
