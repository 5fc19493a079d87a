//! The points of a map, round by round: each round is what the results of all rounds before it call for.

use std::collections::{BTreeMap, HashMap};

use touchdown_input::points::refined_grid::{Place, RefinedGrid};

use crate::journal::shard::Shard;
use crate::maps::cell::Cell;
use crate::maps::cell_refinement::{self, Leaf};
use crate::maps::height::{Height, SpeedBands};
use crate::maps::interval_refinement;
use crate::summary::findings::Finding;
use crate::summary::sweep_counts::CoarseCells;

/// Of the places that are wanted, the part that a round takes where a budget leaves some undone, and the least number
/// of them.
const PART_OF_WANTED: usize = 4;
const LEAST_ROUND: usize = 64;

/// A map under way.
#[derive(Debug)]
pub struct Rounds<'m> {
    map: &'m RefinedGrid,
    known: HashMap<usize, Height>,
    /// Bands of the points, where a map over one axis follows them.
    bands: HashMap<usize, SpeedBands>,
    landings: u64,
    cells: Vec<FirstLevelCell>,
}

/// A first-level cell and what became of it.
#[derive(Debug)]
struct FirstLevelCell {
    map: usize,
    cell: Cell,
    leaves: Vec<Leaf>,
    is_fine: bool,
}

impl<'m> Rounds<'m> {
    /// Before the first round of a map, or of a shard of it, which has whole first-level cells.
    pub fn new(map: &'m RefinedGrid, shard: Shard) -> Self {
        let ([rows, columns], size) = (map.cells(), map.parts());
        let all = (0..map.maps() * rows * columns).filter(|index| shard.index(*index).is_some());
        let cell = |index: usize| FirstLevelCell {
            map: index / (rows * columns),
            cell: Cell {
                low: [index / columns % rows * size[0], index % columns * size[1]],
                size,
            },
            leaves: Vec::new(),
            is_fine: false,
        };
        Self {
            map,
            known: HashMap::new(),
            bands: HashMap::new(),
            landings: 0,
            cells: all.map(cell).collect(),
        }
    }

    /// The points of the next round, in the order of their numbers; none when the map is fine enough or the budget is
    /// spent.
    pub fn next_round(&mut self) -> Vec<usize> {
        let mut wanted: BTreeMap<usize, f64> = BTreeMap::new();
        let (map, known, bands) = (self.map, &self.known, &self.bands);
        for first in self.cells.iter_mut().filter(|first| !first.is_fine) {
            let number = |place: Place| map.number(first.map, place);
            let found = if map.axes().len() == 1 {
                let bands = |place: usize| bands.get(&number([place, 0]));
                interval_refinement::refined(first.cell, &map.rules, bands)
            } else {
                let height = |place: Place| known.get(&number(place)).copied();
                cell_refinement::refined(first.cell, &map.rules, &height)
            };
            first.leaves = found.leaves;
            first.is_fine = found.wanted.is_empty();
            for (place, urgency) in found.wanted {
                let most = wanted.entry(number(place)).or_insert(urgency);
                *most = most.max(urgency);
            }
        }
        let Some(budget) = self.map.rules.budget else {
            return wanted.into_keys().collect();
        };
        if self.known.is_empty() {
            return wanted.into_keys().collect();
        }
        let left = self.points_left(budget);
        let share = (wanted.len() / PART_OF_WANTED).max(LEAST_ROUND);
        let mut chosen: Vec<(usize, f64)> = wanted.into_iter().collect();
        chosen.sort_by(|(_, a), (_, b)| b.total_cmp(a));
        chosen.truncate(share.min(left));
        let mut chosen: Vec<usize> = chosen.into_iter().map(|(number, _)| number).collect();
        chosen.sort_unstable();
        chosen
    }

    /// Points that a budget still allows, should they take as many landings as those before.
    fn points_left(&self, budget: u64) -> usize {
        let left = budget.saturating_sub(self.landings);
        let points = left.saturating_mul(self.known.len() as u64) / self.landings.max(1);
        usize::try_from(points).unwrap_or(usize::MAX)
    }

    /// How many points there will be in all, as far as a round of so many points, or the budget, tells.
    pub fn expected(&self, round: usize) -> usize {
        let left = self
            .map
            .rules
            .budget
            .map_or(0, |budget| self.points_left(budget));
        self.known.len() + round.max(left)
    }

    /// Adds what a point of the round came to.
    pub fn learn(&mut self, point: usize, finding: &Finding) {
        if let (Some(height), Some(boundary)) = (Height::of(finding), finding.boundary()) {
            self.learn_height(point, height, finding.landings());
            if self.map.axes().len() == 1 {
                self.learn_bands(point, SpeedBands::of(boundary));
            }
        }
    }

    /// Adds what is known of a point of the round, and the landings that it took.
    pub fn learn_height(&mut self, point: usize, height: Height, landings: u64) {
        if self.known.insert(point, height).is_none() {
            self.landings += landings;
        }
    }

    /// Adds the bands of a point of a map over one axis.
    pub(crate) fn learn_bands(&mut self, point: usize, bands: SpeedBands) {
        self.bands.insert(point, bands);
    }

    /// The map that results make, and the points that are missing, as far as the others call for them.
    ///
    /// # Errors
    /// Whatever `result` gives up with.
    pub fn of_results<E>(
        map: &'m RefinedGrid,
        mut result: impl FnMut(usize) -> Result<Option<Finding>, E>,
    ) -> Result<(Self, Vec<usize>), E> {
        let mut rounds = Self::new(map, Shard::WHOLE);
        loop {
            let round = rounds.next_round();
            let mut missing = Vec::new();
            for point in &round {
                match result(*point)? {
                    Some(finding) => rounds.learn(*point, &finding),
                    None => missing.push(*point),
                }
            }
            if missing.len() == round.len() {
                return Ok((rounds, missing));
            }
        }
    }

    /// The points that are known, in the order of their numbers.
    pub fn points(&self) -> Vec<usize> {
        let mut points: Vec<usize> = self.known.keys().copied().collect();
        points.sort_unstable();
        points
    }

    /// Landings of all points.
    pub fn landings(&self) -> u64 {
        self.landings
    }

    /// The map whose points these are.
    pub fn map(&self) -> &'m RefinedGrid {
        self.map
    }

    /// How many cells are coarser than was asked for; none where no error was.
    pub fn coarse_cells(&self) -> CoarseCells {
        let sought = self.map.rules.error;
        let mut found = CoarseCells::default();
        for first in self.cells.iter().filter(|_| sought > 0.0) {
            found.cells += first.leaves.len();
            let open = first.leaves.iter().filter(|_| !first.is_fine);
            for leaf in open.filter(|leaf| leaf.error.is_none_or(|error| error > sought)) {
                found.coarse += 1;
                found.worst = found.worst.max(leaf.error.unwrap_or(0.0));
            }
        }
        found
    }

    pub(crate) fn height(&self, map: usize, place: Place) -> Option<Height> {
        self.known.get(&self.map.number(map, place)).copied()
    }

    pub(crate) fn bands(&self, map: usize, place: Place) -> Option<&SpeedBands> {
        self.bands.get(&self.map.number(map, place))
    }

    /// All cells that are not divided, with the number of the map that they belong to.
    pub(crate) fn leaves(&self) -> impl Iterator<Item = (usize, &Leaf)> {
        let of_first = |first: &'_ FirstLevelCell| first.map;
        self.cells
            .iter()
            .flat_map(move |first| first.leaves.iter().map(move |leaf| (of_first(first), leaf)))
    }
}
