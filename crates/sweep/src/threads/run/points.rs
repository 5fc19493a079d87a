//! The points of a sweep, computed one after another or round by round.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use touchdown_dynamics::vehicle::Vehicle;
use touchdown_input::points::refined_grid::RefinedGrid;
use touchdown_input::readers::scene_input::{self, SceneFault};
use touchdown_input::sweeps::case::{Case, CaseFault};
use touchdown_input::sweeps::sweep_file::{Job, Sweep};
use touchdown_search::trial::{Scales, Trial};
use touchdown_search::variation::Variation;

use super::{Observer, RunError, SEARCHES, Stop, Workers};
use crate::journal::Opened;
use crate::journal::early_stop::EarlyStop;
use crate::journal::shard::Shard;
use crate::maps::rounds::Rounds;
use crate::sensitivity;
use crate::summary::findings::Finding;
use crate::threads::landing_queue::LandingQueue;

impl Workers {
    /// Computes every point of a shard that is not `done`, and adds it to the journal.
    ///
    /// # Errors
    /// If `cancel` became true, which is checked before every landing, or a result cannot be stored. Results already in
    /// the journal stay valid.
    pub fn sweep(
        &self,
        sweep: &Sweep,
        shard: Shard,
        opened: &mut Opened,
        observer: &dyn Observer,
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
        // Finishes the journal even after a stop, but the error that caused the stop takes precedence.
        found.and(journal.finish().map_err(RunError::Journal))
    }

    /// Computes the points of a map, or of a shard of it, round by round. Skips those already in the journal.
    fn map(
        &self,
        sweep: &Sweep,
        map: &RefinedGrid,
        shard: Shard,
        opened: &mut Opened,
        observer: &dyn Observer,
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
                // The error that stopped the run takes precedence.
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

    /// Computes some points, returned in their order.
    ///
    /// # Errors
    /// If the input of one of them is invalid.
    pub fn points(&self, sweep: &Sweep, points: &[usize]) -> Result<Vec<Finding>, RunError> {
        let never = AtomicBool::new(false);
        let mut found: Vec<(usize, Finding)> = Vec::with_capacity(points.len());
        self.each_point(
            sweep,
            points,
            SEARCHES,
            &(),
            &never,
            &mut |index, finding| {
                found.push((index, finding));
            },
        )?;
        found.sort_by_key(|(index, _)| *index);
        Ok(found.into_iter().map(|(_, finding)| finding).collect())
    }

    /// Computes some points and passes the index of each among `points`, with its result, to `keep` as soon as known.
    /// Starts with the first points, `searches` at a time per thread.
    ///
    /// # Errors
    /// If the input of one of them is invalid, or `cancel` became true.
    pub fn each_point(
        &self,
        sweep: &Sweep,
        points: &[usize],
        searches: usize,
        observer: &dyn Observer,
        cancel: &AtomicBool,
        keep: &mut dyn FnMut(usize, Finding),
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

/// Queue for the landings of a search.
#[derive(Clone, Copy)]
struct SearchQueue<'q> {
    landing_queue: &'q LandingQueue,
    /// Number of the search; lower ones get their landings first.
    search: usize,
}

/// Computes a point and reports it to an observer.
async fn find_watched(
    sweep: &Sweep,
    point: usize,
    landing_queue: &LandingQueue,
    observer: &dyn Observer,
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

/// Computes a point.
async fn find(
    sweep: &Sweep,
    point: usize,
    queue: SearchQueue<'_>,
    observer: &dyn Observer,
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
        return Ok(Finding::Landing(Box::new(landing)));
    };
    let trial = async |case: &Case, speed, variation: Variation| {
        let varied = case
            .scene
            .with_horizontal_velocity(speed)
            .and_then(|faster| variation.of(&faster, &case.settings));
        let (varied, settings) = varied.map_err(|fault| {
            invalid(CaseFault::Scene(SceneFault {
                name: scene_input::HORIZONTAL_VELOCITY,
                value: Some(fault.value.into()),
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
