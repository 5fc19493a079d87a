//! Many parts of a search at a time.

use futures::stream::{self, StreamExt, TryStreamExt};

/// Parts that go on at a time: as many as fill the lanes of a few threads, and few enough for the finest scan.
const PARTS: usize = 32;

/// Goes through parts of a search that do not depend on one another, many at a time; what each came to, in their order.
///
/// # Errors
/// The first that a part gives up with.
pub(crate) async fn join_all<T, Stop>(
    parts: impl Iterator<Item = impl Future<Output = Result<T, Stop>>>,
) -> Result<Vec<T>, Stop> {
    stream::iter(parts).buffered(PARTS).try_collect().await
}
