//! The surface over a cell: one piece without edges, two on either side of an edge, more where edges meet.
//!
//! A piece is a ring of corners around an apex; over each triangle of the apex and two neighbours on the ring the
//! surface is a plane. Cells side by side share the places on their common side, so that pieces fit each other.

use crate::cell::{Position, middle, position};
use crate::height::Height;
use crate::located_side::edges;
use crate::refined_grid::Place;

/// A position and the first transition there, ft/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Corner {
    pub(crate) at: Position,
    pub(crate) speed: f64,
}

/// A part of the surface without edges.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piece {
    pub(crate) ring: Vec<Corner>,
    pub(crate) apex: Corner,
}

/// A place and what was found there.
pub(crate) type Known = (Place, Height);

/// Where an edge leaves a cell, or passes a place within it: the known places on either side of it.
pub(crate) type Crossing = [Known; 2];

/// An edge through a cell.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cut {
    /// From side to side; the first of each crossing lies on the same side of the edge.
    pub(crate) crossings: Vec<Crossing>,
}

/// What is known of a cell.
pub(crate) struct Around<'k> {
    /// Places on its sides, around it.
    pub(crate) ring: &'k [Known],
    pub(crate) centre: Option<Known>,
    /// Places on either side of an edge half-way through the cell, in the order of its first crossing on the ring.
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

    /// The first transition at a position, ft/s, if the piece lies there.
    pub(crate) fn speed_at(&self, at: Position) -> Option<f64> {
        self.triangles()
            .find_map(|corners| speed_within(&corners, at))
    }
}

/// The height of a triangle at a position, if it lies there.
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
        let pair = |index: usize| [self.ring[index], self.ring[(index + 1) % count]];
        let cuts = edges(self.ring, jump);
        match *cuts.as_slice() {
            [] | [_] => (self.whole().into_iter().collect(), Vec::new()),
            [one, other] => {
                let mut crossings = vec![pair(one)];
                crossings.extend(self.bend);
                let [a, b] = pair(other);
                crossings.push([b, a]);
                self.parted(one, other, crossings)
            }
            ref many => self.meeting(many),
        }
    }

    fn whole(&self) -> Option<Piece> {
        let ring = corners(self.ring)?;
        let centre = self.centre.and_then(corner);
        Some(Piece::new(ring, centre))
    }

    /// The two pieces on either side of an edge.
    fn parted(&self, one: usize, other: usize, crossings: Vec<Crossing>) -> (Vec<Piece>, Vec<Cut>) {
        let mut centre = self.centre.and_then(corner);
        let mut pieces = Vec::new();
        // Seen from the ring, what follows the first crossing lies on the second side of it.
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
            let within = centre.filter(|known| is_left_of_all(&ring, known.at));
            if within.is_some() {
                centre = None;
            }
            pieces.push(Piece::new(ring, within));
        }
        (pieces, vec![Cut { crossings }])
    }

    /// The pieces between three edges or more, which meet in the middle of the cell.
    fn meeting(&self, cuts: &[usize]) -> (Vec<Piece>, Vec<Cut>) {
        let count = self.ring.len();
        let crossing = |index: usize| [self.ring[index % count], self.ring[(index + 1) % count]];
        let share = 1.0 / count as f64;
        let sum = |axis: usize| -> f64 {
            let all = self.ring.iter();
            all.map(|(place, _)| place[axis] as f64 * share).sum()
        };
        let meeting = match self.centre {
            Some((place, _)) => position(place),
            None => [sum(0), sum(1)],
        };
        let mut pieces = Vec::new();
        for (index, cut) in cuts.iter().enumerate() {
            let next = match cuts.get(index + 1) {
                Some(next) => *next,
                None => cuts[0] + count,
            };
            let Some(mut ring) = corners(&self.arc(cut + 1, next)) else {
                continue;
            };
            let mean = ring.iter().map(|corner| corner.speed).sum::<f64>() / ring.len() as f64;
            let at = |crossing: Crossing| middle(position(crossing[0].0), position(crossing[1].0));
            let [first, last] = [ring[0].speed, ring[ring.len() - 1].speed];
            ring.push(Corner {
                at: at(crossing(next)),
                speed: last,
            });
            ring.push(Corner {
                at: meeting,
                speed: mean,
            });
            ring.push(Corner {
                at: at(crossing(*cut)),
                speed: first,
            });
            pieces.push(Piece::new(ring, None));
        }
        let cuts = cuts.iter().map(|cut| Cut {
            crossings: vec![crossing(*cut)],
        });
        (pieces, cuts.collect())
    }

    /// The places of the ring from one index to another, which may lie a turn further on.
    fn arc(&self, from: usize, to: usize) -> Vec<Known> {
        let count = self.ring.len();
        (from..=to).map(|index| self.ring[index % count]).collect()
    }
}

fn corner((place, height): Known) -> Option<Corner> {
    let at = position(place);
    height.speed.map(|speed| Corner { at, speed })
}

/// Corners at places, if all of them have a transition.
fn corners(places: &[Known]) -> Option<Vec<Corner>> {
    places.iter().copied().map(corner).collect()
}

/// Whether a position is seen from all sides of a ring that runs as the corners of cells do.
fn is_left_of_all(ring: &[Corner], at: Position) -> bool {
    let next = ring.iter().cycle().skip(1);
    ring.iter().zip(next).all(|(a, b)| {
        let (p, q) = (a.at, b.at);
        (q[1] - p[1]) * (at[0] - p[0]) - (q[0] - p[0]) * (at[1] - p[1]) > 0.0
    })
}
