//! Landings that a search asks for.
//!
//! A search is given a function that lands. It knows neither the type of that function nor that of its errors, so it is compiled
//! once. A landing takes a thousand times as long as the box that it comes in.

use std::cell::RefCell;

use futures::future::LocalBoxFuture;
use futures::stream::{self, StreamExt, TryStreamExt};

use crate::trial::{Sample, Trial};
use crate::variation::Variation;

/// Parts in progress at a time: enough to fill the lanes of a few threads, few enough for the finest scan.
const PARTS: usize = 32;

/// A landing could not be computed. Only [`FirstError::keep`], which keeps the reason, makes one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stopped(());

/// Lands at a horizontal speed (ft/s), with a variation.
pub(crate) type Land<'a> =
    dyn Fn(f64, Variation) -> LocalBoxFuture<'a, Result<Trial, Stopped>> + 'a;

/// Lands at a horizontal speed (ft/s), in one way.
pub(crate) type LandAt<'a> = dyn Fn(f64) -> LocalBoxFuture<'a, Result<Sample, Stopped>> + 'a;

/// Awaits a landing at a speed (ft/s).
pub(crate) async fn sample(
    speed: f64,
    landing: impl Future<Output = Result<Trial, Stopped>>,
) -> Result<Sample, Stopped> {
    let trial = landing.await?;
    Ok(Sample {
        speed,
        trial,
        is_loose: false,
    })
}

/// Runs independent parts of a search, many at a time; returns their results in order.
///
/// # Errors
/// The first error of a part.
pub async fn join_all<T, Stop>(
    parts: impl Iterator<Item = impl Future<Output = Result<T, Stop>>>,
) -> Result<Vec<T>, Stop> {
    stream::iter(parts).buffered(PARTS).try_collect().await
}

/// The first error of a landing.
pub(crate) struct FirstError<E>(RefCell<Option<E>>);

impl<E> Default for FirstError<E> {
    fn default() -> Self {
        Self(RefCell::new(None))
    }
}

impl<E> FirstError<E> {
    /// Keeps the error of a landing.
    ///
    /// # Errors
    /// [`Stopped`] if there is one.
    pub(crate) fn keep<T>(&self, landed: Result<T, E>) -> Result<T, Stopped> {
        landed.map_err(|error| {
            self.0.borrow_mut().get_or_insert(error);
            Stopped(())
        })
    }

    /// The result of a search that asked for these landings.
    ///
    /// # Errors
    /// The first error of a landing.
    ///
    /// # Panics
    /// Never for a search of these landings: nothing else stops it.
    pub(crate) fn result<T>(self, searched: Result<T, Stopped>) -> Result<T, E> {
        searched.map_err(|Stopped(())| {
            (self.0.into_inner()).expect("a search stops with the error of a landing")
        })
    }
}

/// Lands at once.
#[cfg(test)]
pub(crate) fn at_once<'a>(
    land: impl Fn(f64) -> Sample + 'a,
) -> impl Fn(f64) -> LocalBoxFuture<'a, Result<Sample, Stopped>> {
    use futures::future::{FutureExt, ready};
    move |speed| ready(Ok(land(speed))).boxed_local()
}
