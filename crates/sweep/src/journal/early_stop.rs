//! Decides early whether the landings of a sample computed so far, from the first on without a gap, are enough.
//!
//! Points arrive as they finish but count in order, so that the stop does not depend on threads or interruptions.

use std::collections::BTreeMap;

use touchdown_input::sweeps::sweep_file::{Job, Sweep};

use crate::journal::shard::Shard;
use crate::journal::{JournalError, Opened};
use crate::summary::findings::Finding;
use crate::summary::sweep_counts::SweepCounts;

/// The first landings without a gap.
#[derive(Debug)]
pub(crate) struct EarlyStop {
    /// True if the run ends once enough is known; a shard alone cannot decide that.
    ends_early: bool,
    pub(crate) is_enough: bool,
    counts: SweepCounts,
    /// Points after a gap.
    ahead: BTreeMap<usize, Finding>,
}

impl EarlyStop {
    /// Initializes it from the journal of a shard.
    pub(crate) fn of(sweep: &Sweep, shard: Shard, opened: &Opened) -> Result<Self, JournalError> {
        let ends_early =
            shard == Shard::WHOLE && matches!(sweep.job, Job::Outcome { enough: Some(_) });
        let mut known = Self {
            ends_early,
            is_enough: false,
            counts: SweepCounts::of(sweep),
            ahead: BTreeMap::new(),
        };
        if ends_early && !opened.done.is_empty() {
            let mut results = opened.journal.so_far(sweep.design.count())?;
            // Also points behind a gap, which is filled now.
            let points = 0..sweep.design.count();
            for point in points.filter(|point| opened.done.contains(*point)) {
                let bytes = results.result(point)?;
                let finding = bytes.as_deref().and_then(Finding::decode);
                if finding.is_some_and(|finding| known.is_enough_with(sweep, point, finding)) {
                    break;
                }
            }
        }
        Ok(known)
    }

    /// Adds a point; returns whether enough is known now.
    pub(crate) fn is_enough_with(&mut self, sweep: &Sweep, point: usize, finding: Finding) -> bool {
        if !self.ends_early || self.is_enough {
            return self.is_enough;
        }
        self.ahead.insert(point, finding);
        while let Some(finding) = self.ahead.remove(&self.counts.points) {
            self.counts.add(sweep, self.counts.points, &finding);
            if self.counts.is_enough(sweep) {
                self.is_enough = true;
                self.ahead.clear();
            }
        }
        self.is_enough
    }
}
