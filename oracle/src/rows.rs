//! Work on the rows of a picture, on as many threads as there are processors.
//!
//! Invariant: each item is worked on once; the items must not depend on each other, so that which
//! thread takes which does not matter.

use std::iter;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Does `work` on each item.
pub(crate) fn each<I>(items: I, work: impl Fn(I::Item) + Sync)
where
    I: Iterator + Send,
{
    let items = Mutex::new(items);
    // Bound to its own statement, so that the lock is not held over the work.
    let next = || items.lock().unwrap_or_else(PoisonError::into_inner).next();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| iter::from_fn(next).for_each(&work));
        }
    });
}
