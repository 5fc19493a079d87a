//! The surface of a map: pieces between its points, cut along its edges, made of triangles that follow its curvature.

use std::collections::{BTreeSet, HashMap};

use touchdown_input::points::refined_grid::{Place, RefinedGrid};

use crate::maps::cell::{Cell, Position, position};
use crate::maps::curved::CurvedSurface;
use crate::maps::pieces::{Around, Corner, Cut, Known, Piece};
use crate::maps::rounds::Rounds;

/// The surface of one map.
#[derive(Debug)]
pub struct MapSurface<'m> {
    pub(crate) grid: &'m RefinedGrid,
    /// Number of the map.
    pub(crate) map: usize,
    pub(crate) parts: Vec<CellSurface>,
    curved: CurvedSurface,
}

/// The surface over a cell.
#[derive(Debug)]
pub(crate) struct CellSurface {
    pub(crate) cell: Cell,
    /// Estimated error of interpolation, ft/s, if known.
    pub(crate) error: Option<f64>,
    pub(crate) pieces: Vec<Piece>,
    pub(crate) cuts: Vec<Cut>,
}

/// A triangle of the surface: coordinates along the two refined axes and first transition (ft/s) of its corners.
pub type Triangle = [([f64; 2], f64); 3];

impl<'m> MapSurface<'m> {
    /// The surfaces of all maps.
    pub fn all(rounds: &Rounds<'m>) -> Vec<Self> {
        let grid = rounds.map();
        let mut known: Vec<KnownPlaces> =
            (0..grid.maps()).map(|_| KnownPlaces::default()).collect();
        for number in rounds.points() {
            known[grid.map_of(number)].insert(grid.place(number));
        }
        let mut parts: Vec<Vec<CellSurface>> = (0..grid.maps()).map(|_| Vec::new()).collect();
        for (map, leaf) in rounds.leaves() {
            let height = |place: Place| Some((place, rounds.height(map, place)?));
            let ring: Vec<Known> = known[map].around(&leaf.cell).filter_map(height).collect();
            let bend = leaf.bend.and_then(|[a, b]| Some([height(a)?, height(b)?]));
            let within = [Some(leaf.cell.centre()), leaf.check];
            let within: Vec<Known> = within.into_iter().flatten().filter_map(height).collect();
            let around = Around {
                ring: &ring,
                within: &within,
                bend,
            };
            let (pieces, cuts) = around.pieces(grid.rules.jump);
            parts[map].push(CellSurface {
                cell: leaf.cell,
                error: leaf.error,
                pieces,
                cuts,
            });
        }
        let surface = |(map, (parts, known)): (usize, (Vec<CellSurface>, &KnownPlaces))| {
            let corners = known.all().filter_map(|place| {
                let speed = rounds.height(map, place)?.speed?;
                let at = position(place);
                Some(Corner { at, speed })
            });
            let jumps = parts.iter().flat_map(|part| &part.cuts);
            let jumps = jumps.flat_map(Cut::jumps).collect();
            Self {
                grid,
                map,
                curved: CurvedSurface::new(corners, jumps, grid.parts()),
                parts,
            }
        };
        parts
            .into_iter()
            .zip(&known)
            .enumerate()
            .map(surface)
            .collect()
    }

    /// Coordinates of a position along the two refined axes.
    pub(crate) fn coordinates(&self, at: Position) -> [f64; 2] {
        [0, 1].map(|axis| self.grid.value(axis, at[axis]))
    }

    /// The triangles of the surface.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        let corner = |corner: Corner| (self.coordinates(corner.at), corner.speed);
        let triangles = self.parts.iter().flat_map(|part| self.triangles_of(part));
        triangles.map(move |corners| corners.map(corner))
    }

    /// The triangles over a cell.
    pub(crate) fn triangles_of(&self, part: &CellSurface) -> impl Iterator<Item = [Corner; 3]> {
        let triangles = part.pieces.iter().flat_map(Piece::triangles);
        triangles.flat_map(|corners| self.curved.triangles(corners))
    }
}

/// The known places of a map, sorted into lines along either axis.
#[derive(Default)]
struct KnownPlaces {
    lines: [HashMap<usize, BTreeSet<usize>>; 2],
}

impl KnownPlaces {
    fn insert(&mut self, place: Place) {
        for axis in 0..2 {
            let line = self.lines[axis].entry(place[1 - axis]).or_default();
            line.insert(place[axis]);
        }
    }

    /// All known places.
    fn all(&self) -> impl Iterator<Item = Place> {
        let [_, rows] = &self.lines;
        let row = |(slow, line): (&usize, &BTreeSet<usize>)| -> Vec<Place> {
            line.iter().map(|fast| [*slow, *fast]).collect()
        };
        rows.iter().flat_map(row)
    }

    /// Known places between two on one line, including the first but not the last.
    fn between(&self, from: Place, to: Place) -> Vec<Place> {
        let axis = usize::from(from[0] == to[0]);
        let (a, b) = (from[axis], to[axis]);
        let at = |step: &usize| {
            let mut place = from;
            place[axis] = *step;
            place
        };
        let Some(line) = self.lines[axis].get(&from[1 - axis]) else {
            return Vec::new();
        };
        match a < b {
            true => line.range(a..b).map(at).collect(),
            false => line.range(b + 1..=a).rev().map(at).collect(),
        }
    }

    /// Known places on the sides of a cell, in order around it.
    fn around(&self, cell: &Cell) -> impl Iterator<Item = Place> {
        let sides = cell.sides();
        sides.into_iter().flat_map(|[a, b]| self.between(a, b))
    }
}
