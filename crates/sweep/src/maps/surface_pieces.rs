//! The surface of a map: pieces of planes between its points, cut along its edges.

use std::collections::{BTreeSet, HashMap};

use crate::cell::{Cell, Position};
use crate::pieces::{Around, Corner, Cut, Known, Piece};
use crate::refined_grid::{Place, RefinedGrid};
use crate::rounds::Rounds;

/// The surface of one map.
#[derive(Debug)]
pub struct MapSurface<'m> {
    pub(crate) grid: &'m RefinedGrid,
    /// Number of the map.
    pub(crate) map: usize,
    pub(crate) parts: Vec<CellSurface>,
}

/// The surface over a cell.
#[derive(Debug)]
pub(crate) struct CellSurface {
    pub(crate) cell: Cell,
    /// Estimated error of interpolation, ft/s, as far as anything tells it.
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
        let mut surfaces: Vec<Self> = (0..grid.maps())
            .map(|map| Self {
                grid,
                map,
                parts: Vec::new(),
            })
            .collect();
        for number in rounds.points() {
            known[grid.map_of(number)].insert(grid.place(number));
        }
        for (map, leaf) in rounds.leaves() {
            let height = |place: Place| Some((place, rounds.height(map, place)?));
            let ring: Vec<Known> = known[map].around(&leaf.cell).filter_map(height).collect();
            let bend = leaf.bend.and_then(|[a, b]| Some([height(a)?, height(b)?]));
            let around = Around {
                ring: &ring,
                centre: height(leaf.cell.centre()),
                bend,
            };
            let (pieces, cuts) = around.pieces(grid.rules.jump);
            surfaces[map].parts.push(CellSurface {
                cell: leaf.cell,
                error: leaf.error,
                pieces,
                cuts,
            });
        }
        surfaces
    }

    /// Coordinates of a position along the two refined axes.
    pub(crate) fn coordinates(&self, at: Position) -> [f64; 2] {
        [0, 1].map(|axis| self.grid.value(axis, at[axis]))
    }

    /// The triangles of which the surface consists.
    pub fn triangles(&self) -> impl Iterator<Item = Triangle> {
        let corner = |corner: Corner| (self.coordinates(corner.at), corner.speed);
        let pieces = self.parts.iter().flat_map(|part| &part.pieces);
        let triangles = pieces.flat_map(Piece::triangles);
        triangles.map(move |corners| corners.map(corner))
    }
}

/// The known places of a map by their lines along either axis.
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

    /// Known places between two on one line, the first included, the last not.
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

    /// Known places on the sides of a cell, around it.
    fn around(&self, cell: &Cell) -> impl Iterator<Item = Place> {
        let sides = cell.sides();
        sides.into_iter().flat_map(|[a, b]| self.between(a, b))
    }
}
