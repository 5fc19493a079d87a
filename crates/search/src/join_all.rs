//! Runs many parts of a search concurrently.

use futures::stream::{self, StreamExt, TryStreamExt};

/// Parts in progress at a time: enough to fill the lanes of a few threads, few enough for the finest scan.
const PARTS: usize = 32;

/// Runs independent parts of a search, many at a time; returns their results in order.
///
/// # Errors
/// The first error of a part.
pub async fn join_all<T, Stop>(
    parts: impl Iterator<Item = impl Future<Output = Result<T, Stop>>>,
) -> Result<Vec<T>, Stop> {
    stream::iter(parts).buffered(PARTS).try_collect().await
}
