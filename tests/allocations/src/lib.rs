//! A memory allocator for tests that knows who asked for memory. A program that depends on this
//! crate has it as its allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::backtrace::Backtrace;
use std::cell::{Cell, RefCell};

struct Watching;

thread_local! {
    /// Whether this thread is watched; not while it takes down who asked.
    static WATCHED: Cell<bool> = const { Cell::new(false) };
    static ASKED: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

#[global_allocator]
static ALLOCATOR: Watching = Watching;

/// Takes down who asks for memory, unless it is the emulated SPEs' library: it is none of the
/// program's on a console.
fn asked() {
    // A thread that is ending has nobody who watches it.
    if !WATCHED
        .try_with(|watched| watched.replace(false))
        .unwrap_or(false)
    {
        return;
    }
    let trace = Backtrace::force_capture().to_string();
    if !trace.contains("spe2::") {
        ASKED.with_borrow_mut(|asked| asked.push(trace));
    }
    WATCHED.set(true);
}

// SAFETY: all is the system's allocator; while what is added asks for memory itself, it adds
// nothing.
unsafe impl GlobalAlloc for Watching {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        asked();
        // SAFETY: the caller's promise.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise.
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        asked();
        // SAFETY: the caller's promise.
        unsafe { System.realloc(block, layout, size) }
    }
}

/// Who in this thread has asked for memory while something was done, as backtraces.
pub fn during(work: impl FnOnce()) -> Vec<String> {
    WATCHED.set(true);
    work();
    WATCHED.set(false);
    ASKED.take()
}

#[test]
fn who_asks_is_known() {
    let mut list: Vec<u8> = Vec::new();
    let asked = during(|| list.reserve(10));
    assert_eq!(asked.len(), 1);
    assert!(asked[0].contains("who_asks_is_known"), "{}", asked[0]);
    assert!(during(|| list.push(1)).is_empty());
    assert_eq!(during(|| list.reserve(1000)).len(), 1);
    drop(list);
}
