//! The points of a sweep: what it asks at each of them, one after another or round by round.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use touchdown_dynamics::vehicle::Vehicle;

use super::{Observer, RunError, SEARCHES, Stop, Workers};
use crate::case::{Case, CaseFault};
use crate::certainty::Variation;
use crate::early_stop::EarlyStop;
use crate::findings::Finding;
use crate::journal::Opened;
use crate::landing_queue::LandingQueue;
use crate::refined_grid::RefinedGrid;
use crate::rounds::Rounds;
use crate::scene_input::{self, SceneFault};
use crate::sensitivity;
use crate::shard::Shard;
use crate::sweep_file::{Job, Sweep};
use crate::trial::{Scales, Trial};

impl Workers {
    /// Finds what the sweep asks at every point of a shard that is not `done`, into the journal.
    ///
    /// # Errors
    /// When `cancel` became true, which is looked at before every landing, or a result cannot be
    /// kept. What was journaled until then stays good.
    pub fn sweep(
        &self,
        sweep: &Sweep,
        shard: Shard,
        opened: &mut Opened,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<(), RunError> {
        if let Some(map) = sweep.map() {
            return self.map(sweep, map, shard, opened, observer, cancel);
        }
        let mut known = EarlyStop::of(sweep, shard, opened).map_err(RunError::Journal)?;
        let Opened { journal, done, .. } = opened;
        let points = done.missing().map(|index| shard.point(index));
        let stop = Stop::on(cancel);
        if known.is_enough {
            return Ok(());
        }
        let search = async |point, landing_queue: &LandingQueue| {
            find_watched(sweep, point, landing_queue, observer, &stop).await
        };
        let found = self.search(points, SEARCHES, &stop, search, |finished| {
            if let Some((point, finding)) = finished {
                journal.add(point, &finding.encode())?;
                if known.is_enough_with(sweep, point, finding) {
                    stop.stop();
                }
            }
            journal.tick()
        });
        let found = match (known.is_enough, found) {
            (true, Err(RunError::Cancelled)) if !cancel.load(Ordering::Relaxed) => Ok(()),
            (_, found) => found,
        };
        // Also when the run was stopped, but not over the error that stopped it.
        found.and(journal.finish().map_err(RunError::Journal))
    }

    /// Finds what the sweep asks at the points of a map, or of a shard of it, round by round. Nothing is computed that the
    /// journal holds already.
    fn map(
        &self,
        sweep: &Sweep,
        map: &RefinedGrid,
        shard: Shard,
        opened: &mut Opened,
        observer: &impl Observer,
        cancel: &AtomicBool,
    ) -> Result<(), RunError> {
        let mut there = opened.findings(map.count()).map_err(RunError::Journal)?;
        let journal = &mut opened.journal;
        let stop = Stop::on(cancel);
        let search = async |point, landing_queue: &LandingQueue| {
            find_watched(sweep, point, landing_queue, observer, &stop).await
        };
        let mut rounds = Rounds::new(map, shard);
        let mut announced = 0;
        loop {
            let round = rounds.next_round();
            if round.is_empty() {
                return journal.finish().map_err(RunError::Journal);
            }
            let expected = rounds.expected(round.len());
            observer.more(expected.saturating_sub(announced));
            announced = announced.max(expected);
            let new: Vec<usize> = (round.iter().copied())
                .filter(|point| !there.contains_key(point))
                .collect();
            let searched = self.search(new.into_iter(), SEARCHES, &stop, search, |finished| {
                if let Some((point, finding)) = finished {
                    journal.add(point, &finding.encode())?;
                    there.insert(point, finding);
                }
                journal.tick()
            });
            if let Err(error) = searched {
                // The error that stopped the run comes first.
                let _ = journal.finish();
                return Err(error);
            }
            for point in round {
                if let Some(finding) = there.remove(&point) {
                    rounds.learn(point, &finding);
                }
            }
        }
    }

    /// Finds what the sweep asks at some points, in their order.
    ///
    /// # Errors
    /// When the input of one of them is not valid.
    pub fn points(&self, sweep: &Sweep, points: &[usize]) -> Result<Vec<Finding>, RunError> {
        let never = AtomicBool::new(false);
        let mut found: Vec<(usize, Finding)> = Vec::with_capacity(points.len());
        self.each_point(sweep, points, SEARCHES, &(), &never, |index, finding| {
            found.push((index, finding));
        })?;
        found.sort_by_key(|(index, _)| *index);
        Ok(found.into_iter().map(|(_, finding)| finding).collect())
    }

    /// Finds what the sweep asks at some points, and gives the index of each among `points`, with what it came to, to
    /// `keep` as soon as it is known: the first points first, so many at a time for each thread.
    ///
    /// # Errors
    /// When the input of one of them is not valid, or `cancel` became true.
    pub fn each_point(
        &self,
        sweep: &Sweep,
        points: &[usize],
        searches: usize,
        observer: &impl Observer,
        cancel: &AtomicBool,
        mut keep: impl FnMut(usize, Finding),
    ) -> Result<(), RunError> {
        let stop = Stop::on(cancel);
        let search = async |index: usize, landing_queue: &LandingQueue| {
            observer.begin(points[index]);
            let queue = SearchQueue {
                landing_queue,
                search: index,
            };
            find(sweep, points[index], queue, observer, &stop).await
        };
        let indices = 0..points.len();
        self.search(indices, searches, &stop, search, |finished| {
            if let Some((index, finding)) = finished {
                keep(index, finding);
            }
            Ok(())
        })
    }
}

/// Where a search asks for its landings.
#[derive(Clone, Copy)]
struct SearchQueue<'q> {
    landing_queue: &'q LandingQueue,
    /// Its number: those with lower ones get their landings first.
    search: usize,
}

/// What a sweep asks at a point, told to an observer.
async fn find_watched(
    sweep: &Sweep,
    point: usize,
    landing_queue: &LandingQueue,
    observer: &impl Observer,
    stop: &Stop<'_>,
) -> Result<Finding, RunError> {
    observer.begin(point);
    let queue = SearchQueue {
        landing_queue,
        search: point,
    };
    let finding = find(sweep, point, queue, observer, stop).await?;
    observer.point(point);
    Ok(finding)
}

/// What a sweep asks at a point.
async fn find(
    sweep: &Sweep,
    point: usize,
    queue: SearchQueue<'_>,
    observer: &impl Observer,
    stop: &Stop<'_>,
) -> Result<Finding, RunError> {
    let invalid = |fault| RunError::Point {
        place: sweep.place(point),
        fault,
    };
    let case = sweep.case(point).map_err(invalid)?;
    let landed = async |vehicle: &Arc<Vehicle>, scene, settings| {
        stop.go_on()?;
        let vehicle = Arc::clone(vehicle);
        let landing = (queue.landing_queue)
            .landing(queue.search, vehicle, scene, settings)
            .await;
        let landing = landing.ok_or(RunError::Cancelled)?;
        observer.landing();
        Ok(landing)
    };
    let Job::Boundary(search) = case.job else {
        let landing = landed(&case.vehicle, case.scene, case.settings).await?;
        return Ok(Finding::of(&landing));
    };
    let trial = async |case: &Case, speed, variation: Variation| {
        let varied = case
            .scene
            .with_horizontal_velocity(speed)
            .and_then(|faster| variation.of(&faster, &case.settings));
        let (varied, settings) = varied.map_err(|fault| {
            invalid(CaseFault::Scene(SceneFault {
                name: scene_input::HORIZONTAL_VELOCITY,
                value: Some(fault.value),
                allowed: fault.allowed,
            }))
        })?;
        let landing = landed(&case.vehicle, varied, settings).await?;
        let scales = Scales::of(&case.vehicle, &case.scene);
        Ok(Trial::of(
            landing,
            &scales,
            settings.tolerance(),
            search.kept,
        ))
    };
    let boundary = search
        .boundary(async |speed, variation| trial(&case, speed, variation).await)
        .await?;
    if sweep.sensitivity.is_empty() {
        return Ok(Finding::Boundary(boundary));
    }
    let searched = (&case, &search);
    let sensitivity = sensitivity::of_point(sweep, point, searched, &boundary, &trial).await?;
    Ok(Finding::Sensitive {
        boundary,
        sensitivity,
    })
}
