//! Runs many parts of a search concurrently.

use futures::stream::{self, StreamExt, TryStreamExt};

use crate::landings_on_request::Stopped;

/// Parts in progress at a time: enough to fill the lanes of a few threads, few enough for the finest scan.
const PARTS: usize = 32;

/// Runs independent parts of a search, many at a time; returns their results in order.
///
/// # Errors
/// The first error of a part.
pub(crate) async fn join_all<T>(
    parts: impl Iterator<Item = impl Future<Output = Result<T, Stopped>>>,
) -> Result<Vec<T>, Stopped> {
    stream::iter(parts).buffered(PARTS).try_collect().await
}
