//! Processes the rows of a picture on as many threads as there are processors.
//!
//! Invariant: each item is processed once. The items must be independent, so it doesn't matter
//! which thread takes which.

use std::iter;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Calls `work` with each item.
pub(crate) fn each<I>(items: I, work: impl Fn(I::Item) + Sync)
where
    I: Iterator + Send,
{
    let items = Mutex::new(items);
    // A statement of its own, so that the lock isn't held during the work.
    let next = || items.lock().unwrap_or_else(PoisonError::into_inner).next();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| iter::from_fn(next).for_each(&work));
        }
    });
}
