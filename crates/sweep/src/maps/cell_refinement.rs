//! Chooses the next wanted places of a first-level cell from its known ones.
//!
//! A cell whose centre lies in the plane of its corners is fine enough. Any other is searched for edges on its sides.
//! One edge through it is followed to its middle, and the surface is checked on both sides of it; if that does not fit,
//! the cell is quartered. The wanted places of a cell depend on its known places alone, so the order in which they
//! become known does not matter.

use std::collections::BTreeMap;

use touchdown_input::points::refined_grid::{MapRules, Place};

use crate::maps::cell::{Cell, middle, nearest, position};
use crate::maps::height::Height;
use crate::maps::located_side::{BRACKET, edges, located};
use crate::maps::pieces::{Around, Crossing, Known, Piece};

/// Weight of an unlocated end of transitions, compared with the square root of an error in ft/s, in choosing the most
/// urgent places.
pub(crate) const END: f64 = 0.3;
/// Assumed error of a first-level cell before its centre is known, ft/s.
pub(crate) const UNKNOWN: f64 = 1.0;
/// Least part of a cell on one side of its edge for that side to be checked separately.
const CHECKED: f64 = 0.125;

/// A cell that is not divided (or not yet).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Leaf {
    pub(crate) cell: Cell,
    /// Estimated error of interpolation, ft/s; `None` if not known yet.
    pub(crate) error: Option<f64>,
    /// Places on either side of an edge in the middle of the cell.
    pub(crate) bend: Option<[Place; 2]>,
    /// Place where the surface was checked beyond the edge, seen from the centre.
    pub(crate) check: Option<Place>,
}

/// A first-level cell as refined so far.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Refined {
    /// Wanted places with their urgencies.
    pub(crate) wanted: BTreeMap<Place, f64>,
    pub(crate) leaves: Vec<Leaf>,
}

/// Refines a first-level cell.
pub(crate) fn refined(
    cell: Cell,
    rules: &MapRules,
    height: &dyn Fn(Place) -> Option<Height>,
) -> Refined {
    let mut refinement = Refinement {
        rules,
        height,
        whole: cell,
        refined: Refined::default(),
    };
    if refinement.ask(&cell.corners(), f64::INFINITY).is_some() {
        refinement.visit(cell, None);
    }
    refinement.refined
}

struct Refinement<'r> {
    rules: &'r MapRules,
    height: &'r dyn Fn(Place) -> Option<Height>,
    whole: Cell,
    refined: Refined,
}

impl Refinement<'_> {
    /// Known places with their heights; `None` if some must be known first.
    fn ask(&mut self, places: &[Place], urgency: f64) -> Option<Vec<Known>> {
        let known = places.iter().map(|place| {
            let height = (self.height)(*place);
            if height.is_none() {
                let wanted = self.refined.wanted.entry(*place).or_insert(urgency);
                *wanted = wanted.max(urgency);
            }
            Some((*place, height?))
        });
        // Asks for all of them, so that missing ones are wanted at once.
        let known: Vec<Option<Known>> = known.collect();
        known.into_iter().collect()
    }

    fn leaf(&mut self, cell: Cell, error: Option<f64>) {
        self.refined.leaves.push(Leaf {
            cell,
            error,
            bend: None,
            check: None,
        });
    }

    /// Visits a cell with known corners; `parent` is the error of the cell it is a quarter of. Returns the steps within
    /// which ends of transitions on its sides are not located.
    fn visit(&mut self, cell: Cell, parent: Option<f64>) -> usize {
        let side = cell.size[0].max(cell.size[1]);
        let Some(corners) = self.ask(&cell.corners(), 0.0) else {
            return side;
        };
        let are_alike = corners.iter().all(|known| known.1.is_like(corners[0].1));
        let share = self.share(cell);
        // Errors weigh between the cell's parts of length and of area, unlocated ends its part of the length. The root
        // keeps steps of V_H, which hardly shrink with the cells, from attracting all points.
        let urgency = |error: f64| error.sqrt() * share * share.sqrt();
        // A smooth surface is four times closer to the planes of quarters. Cells without a known transition come last.
        let expected = match corners.iter().all(|(_, height)| height.speed.is_none()) {
            true => 0.0,
            false => parent.map_or(UNKNOWN, |error| 0.5 * error),
        };
        let Some(centre) = self.ask(&[cell.centre()], urgency(expected)) else {
            self.leaf(cell, parent);
            return if are_alike { 0 } else { side };
        };
        let all = [&corners[..], &centre[..]].concat();
        let is_alike = all.iter().all(|(_, height)| height.is_like(all[0].1));
        let error = match is_alike {
            true => off_the_plane(&corners, centre[0].1),
            false => spread(&all),
        };
        if is_alike && error <= self.rules.error {
            self.leaf(cell, Some(error));
            return 0;
        }
        let urgency = match is_alike {
            true => urgency(error),
            false => END * share,
        };
        let ring = match self.ring(&corners, is_alike, urgency) {
            Ok(ring) => ring,
            Err(gap) => {
                self.leaf(cell, Some(error));
                return gap;
            }
        };
        let undivided = match self.follow(cell, &ring, centre[0], urgency) {
            Followed::Fits { error, bend, check } => {
                self.refined.leaves.push(Leaf {
                    cell,
                    error,
                    bend,
                    check,
                });
                return 0;
            }
            Followed::Unknown => {
                self.leaf(cell, Some(error));
                return 0;
            }
            Followed::DoesNotFit(bend) => Leaf {
                cell,
                error: Some(error),
                bend,
                check: None,
            },
        };
        let before = self.refined.leaves.len();
        let is_divided = match cell.quarters() {
            Some(quarters) if self.ask(&cell.side_middles(), urgency).is_some() => {
                // All of them, so that missing places are wanted at once.
                let gaps = quarters.map(|quarter| self.visit(quarter, Some(error)));
                // The edge is known on the sides of the undivided cell, and usually in its middle.
                let known_to = match undivided.bend {
                    Some(_) => BRACKET,
                    None => side / 4,
                };
                is_alike || gaps.into_iter().all(|gap| gap <= known_to)
            }
            _ => false,
        };
        if !is_divided {
            // Its own sides locate an edge better than what is known of some quarters.
            self.refined.leaves.truncate(before);
            self.refined.leaves.push(undivided);
        }
        0
    }

    /// Length of a cell as a part of that of a first-level cell.
    fn share(&self, cell: Cell) -> f64 {
        let part = |axis: usize| cell.size[axis] as f64 / self.whole.size[axis] as f64;
        (part(0) * part(1)).sqrt()
    }

    /// The places around a cell, once its sides have been searched for edges. If ends of transitions cross the cell,
    /// other sides are not searched.
    ///
    /// # Errors
    /// The greatest number of steps within which an end is not located yet.
    fn ring(
        &mut self,
        corners: &[Known],
        is_alike: bool,
        urgency: f64,
    ) -> Result<Vec<Known>, usize> {
        let mut ring = Vec::new();
        let mut is_known = true;
        let mut widest = 0;
        for (index, corner) in corners.iter().enumerate() {
            let next = corners[(index + 1) % corners.len()];
            let side = [*corner, next];
            if !is_alike && corner.1.is_like(next.1) {
                ring.push(*corner);
                continue;
            }
            match located(side, self.rules.jump, self.height) {
                Ok(mut places) => {
                    places.pop();
                    ring.extend(places);
                }
                Err((place, gap)) => {
                    is_known = false;
                    // An apparent jump may be a slope.
                    if !corner.1.is_like(next.1) {
                        widest = widest.max(gap);
                    }
                    let _ = self.ask(&[place], urgency);
                }
            }
        }
        match is_known {
            true => Ok(ring),
            false => Err(widest),
        }
    }

    /// Follows one edge through a cell to its middle.
    fn follow(&mut self, cell: Cell, ring: &[Known], centre: Known, urgency: f64) -> Followed {
        let jump = self.rules.jump;
        let &[one, other] = edges(ring, jump).as_slice() else {
            return Followed::DoesNotFit(None);
        };
        let after = |index: usize| ring[(index + 1) % ring.len()];
        let ends = [[ring[one], after(one)], [after(other), ring[other]]];
        let bend = match middle_of_edge(ends, &cell, self.height) {
            Middle::At(bend) => bend,
            Middle::Wanted(place) => {
                let _ = self.ask(&[place], urgency);
                return Followed::Unknown;
            }
            Middle::Elsewhere => return Followed::DoesNotFit(None),
        };
        let around = Around {
            ring,
            within: &[],
            bend,
        };
        let (pieces, _) = around.pieces(jump);
        let expected = pieces
            .iter()
            .find_map(|piece: &Piece| piece.speed_at(position(centre.0)));
        let places = |crossing: Crossing| crossing.map(|(place, _)| place);
        let error = match (expected, centre.1.speed) {
            (Some(expected), Some(found)) => Some((expected - found).abs()),
            (None, None) => None,
            _ => return Followed::DoesNotFit(bend.map(places)),
        };
        if error.is_some_and(|error| error > self.rules.error) {
            return Followed::DoesNotFit(bend.map(places));
        }
        let bend = bend.map(places);
        // The centre checks only its own side of the edge.
        let beyond = pieces
            .iter()
            .filter(|piece| piece.speed_at(position(centre.0)).is_none())
            .filter(|piece| piece.area() > CHECKED * cell.area())
            .find_map(|piece| {
                let place = nearest(piece.apex.at);
                let expected = piece.speed_at(position(place))?;
                cell.encloses(place).then_some((place, expected))
            });
        let Some((place, expected)) = beyond else {
            return Followed::Fits {
                error,
                bend,
                check: None,
            };
        };
        let Some(found) = self.ask(&[place], urgency) else {
            return Followed::Unknown;
        };
        let off = found[0].1.speed.map(|found| (expected - found).abs());
        match off.filter(|off| *off <= self.rules.error) {
            Some(off) => Followed::Fits {
                error: Some(error.map_or(off, |error| error.max(off))),
                bend,
                check: Some(place),
            },
            None => Followed::DoesNotFit(bend),
        }
    }
}

/// Result of following an edge through a cell.
enum Followed {
    /// It passes the middle where expected, and the centre fits the surface beside it within this error, or has no
    /// transition either.
    Fits {
        error: Option<f64>,
        bend: Option<[Place; 2]>,
        check: Option<Place>,
    },
    /// There is no edge, there are several, or it passes elsewhere; or the surface beside it is off: then with the
    /// places on either side of the edge in the middle.
    DoesNotFit(Option<[Place; 2]>),
    /// Some places must be known first.
    Unknown,
}

/// Passage of an edge half-way between two crossings.
enum Middle {
    /// Between these places; `None` if the crossings are too close.
    At(Option<Crossing>),
    /// This place must be known first.
    Wanted(Place),
    /// Too far from the line between the crossings.
    Elsewhere,
}

/// Searches for an edge half-way between two crossings, whose first places lie on the same side of it. It may be off
/// the line between them by so much that two lines via the middle are off by a quarter of that.
fn middle_of_edge(
    ends: [Crossing; 2],
    cell: &Cell,
    height: &dyn Fn(Place) -> Option<Height>,
) -> Middle {
    const FARTHEST: usize = 2 * BRACKET;
    let at = |[a, b]: Crossing| middle(position(a.0), position(b.0));
    let (one, other) = (at(ends[0]), at(ends[1]));
    let along = [0, 1].map(|axis: usize| (other[axis] - one[axis]).abs());
    if along[0].max(along[1]) <= 2.0 * BRACKET as f64 {
        return Middle::At(None);
    }
    let across = usize::from(along[0] >= along[1]);
    // True if the second side lies above the line, seen across it.
    let second = position(ends[0][1].0);
    let slope = (other[across] - one[across]) / (other[1 - across] - one[1 - across]);
    let rises = second[across] - one[across] > slope * (second[1 - across] - one[1 - across]);
    let side = |height: Height| {
        let off = |side: usize| {
            let leaps = ends.iter().map(|end| end[side].1.leap(height));
            leaps.fold(0.0, f64::max)
        };
        usize::from(off(1) < off(0))
    };
    let halfway = nearest(middle(one, other));
    let mut last: Option<Known> = None;
    let mut offset = 0;
    let mut upward = true;
    while offset <= FARTHEST {
        let mut place = halfway;
        place[across] = match upward {
            true => halfway[across] + offset,
            false => halfway[across].saturating_sub(offset),
        };
        if !cell.encloses(place) {
            return Middle::Elsewhere;
        }
        let Some(found) = height(place) else {
            return Middle::Wanted(place);
        };
        match last {
            None => upward = (side(found) == 0) == rises,
            Some(before) if side(before.1) != side(found) => {
                let mut crossing = [before, (place, found)];
                if side(before.1) == 1 {
                    crossing.reverse();
                }
                return Middle::At(Some(crossing));
            }
            Some(_) => {}
        }
        last = Some((place, found));
        offset += BRACKET;
    }
    Middle::Elsewhere
}

/// Distance of a centre from the mean of its corners, ft/s.
fn off_the_plane(corners: &[Known], centre: Height) -> f64 {
    let speeds: Option<Vec<f64>> = corners.iter().map(|(_, height)| height.speed).collect();
    match (speeds, centre.speed) {
        (Some(speeds), Some(speed)) => {
            (speed - speeds.iter().sum::<f64>() / speeds.len() as f64).abs()
        }
        _ => 0.0,
    }
}

/// Greatest difference of first transitions, ft/s.
fn spread(places: &[Known]) -> f64 {
    let speeds = || places.iter().filter_map(|(_, height)| height.speed);
    let (least, greatest) = (speeds().reduce(f64::min), speeds().reduce(f64::max));
    least
        .zip(greatest)
        .map_or(0.0, |(least, greatest)| greatest - least)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two surfaces meet at a step, one higher than the other; both are planes but for a bump.
    #[test]
    fn the_error_of_a_cell_is_the_greater_one_of_those_beside_its_edge() {
        let rules = MapRules {
            error: 0.05,
            jump: 0.3,
            budget: None,
            grid_steps: 16,
        };
        let cell = Cell {
            low: [0, 0],
            size: [64, 64],
        };
        let leaf_of = |bumps: [f64; 2]| {
            let height = |[i, j]: Place| {
                let is_on_edge = i == 0 || i == 64 || j == 0 || j == 64;
                let side = usize::from(i > 40);
                let bump = if is_on_edge { 0.0 } else { bumps[side] };
                let speed = Some(10.0 + 0.01 * j as f64 + side as f64 + bump);
                Some(Height { speed, bands: 0 })
            };
            let refined = refined(cell, &rules, &height);
            assert_eq!(refined.leaves.len(), 1, "{refined:?}");
            assert!(refined.leaves[0].check.is_some());
            refined.leaves[0].error.unwrap()
        };
        // Planes through the step's places, some of which share the bump, take off a part of it.
        for bumps in [[0.04, 0.0], [0.0, 0.04]] {
            let error = leaf_of(bumps);
            assert!((0.02..0.04).contains(&error), "{bumps:?}: {error}");
        }
        assert!(leaf_of([0.0; 2]) < 1e-12);
    }
}
