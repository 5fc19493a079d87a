//! Cases: single landings without a search.

use std::cell::Cell;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use touchdown_dynamics::batch::{Request, land_many};
use touchdown_dynamics::landing::Landing;
use touchdown_input::points::parameter::Home;
use touchdown_input::sweeps::case::CaseFault;
use touchdown_input::sweeps::cases::CaseTable;

use super::{Observer, RunError, SEARCHES, Stop, Workers};
use crate::journal::{JournalError, Opened};
use crate::summary::findings::Finding;
use crate::threads::landing_queue::LandingQueue;

impl Workers {
    /// Computes the cases of a table that are not `done`, and adds them to the journal.
    ///
    /// # Errors
    /// As [`Workers::sweep`].
    pub fn case_table(
        &self,
        table: &CaseTable,
        opened: &mut Opened,
        observer: &dyn Observer,
        cancel: &AtomicBool,
    ) -> Result<(), RunError> {
        let Opened { journal, done, .. } = opened;
        let rows = done.missing();
        let landed = self.each_case(table, rows, observer, cancel, |finished| {
            if let Some((row, landing)) = finished {
                journal.add(row, &Finding::Landing(Box::new(landing)).encode())?;
            }
            journal.tick()
        });
        landed.and(journal.finish().map_err(RunError::Journal))
    }

    /// Computes some rows of a table and passes each landing, with its row, to `keep`. Also calls `keep` from time to
    /// time without a new landing.
    ///
    /// # Errors
    /// The error of `keep`, or that the run was stopped.
    pub fn each_case(
        &self,
        table: &CaseTable,
        rows: impl Iterator<Item = usize>,
        observer: &dyn Observer,
        cancel: &AtomicBool,
        keep: impl FnMut(Option<(usize, Landing)>) -> Result<(), JournalError>,
    ) -> Result<(), RunError> {
        let stop = Stop::on(cancel);
        let land = async |row: usize, landing_queue: &LandingQueue| {
            let case = table.case(row).map_err(|error| RunError::Point {
                place: table.name(row),
                fault: CaseFault::Input {
                    part: Home::Scene,
                    error,
                },
            })?;
            let landing = landing_queue.landing(row, case.vehicle, case.scene, case.settings);
            let landing = landing.await.ok_or(RunError::Cancelled)?;
            observer.landing();
            observer.point(row);
            Ok(landing)
        };
        self.search(rows, SEARCHES, &stop, land, keep)
    }

    /// Computes `count` landings, several at a time on each thread. `request` gives the landing of an index, which is
    /// also its key.
    ///
    /// # Errors
    /// If `cancel` became true; it is checked before every landing.
    pub fn cases(
        &self,
        count: usize,
        request: impl Fn(usize) -> Request + Sync,
        observer: &dyn Observer,
        cancel: &AtomicBool,
    ) -> Result<Vec<Landing>, RunError> {
        let stop = Stop::on(cancel);
        let unasked = AtomicUsize::new(0);
        let found = Mutex::new(vec![None; count]);
        // No thread takes so many at once that another has none.
        let share = count.div_ceil(self.threads());
        self.pool.broadcast(|_| {
            let under_way = Cell::new(0);
            let mut next = || {
                if under_way.get() == share || stop.go_on().is_err() {
                    return None;
                }
                let key = unasked.fetch_add(1, Ordering::Relaxed);
                if key >= count {
                    return None;
                }
                under_way.set(under_way.get() + 1);
                Some(request(key))
            };
            land_many(&mut next, &mut |key, landing| {
                under_way.set(under_way.get() - 1);
                observer.landing();
                observer.point(key);
                found.lock().unwrap_or_else(PoisonError::into_inner)[key] = Some(landing);
            });
        });
        let found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        found
            .into_iter()
            .collect::<Option<_>>()
            .ok_or(RunError::Cancelled)
    }
}
