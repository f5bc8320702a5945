//! A memory allocator for tests that records which code allocates memory. Programs that depend on
//! this crate use it as their allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::backtrace::Backtrace;
use std::cell::{Cell, RefCell};

struct Watching;

thread_local! {
    /// Whether this thread is watched. It is not while an allocation is being recorded.
    static WATCHED: Cell<bool> = const { Cell::new(false) };
    static ASKED: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

#[global_allocator]
static ALLOCATOR: Watching = Watching;

/// Records a backtrace of an allocation, unless it comes from the emulated SPEs' library, which is
/// not part of the program on a console.
fn asked() {
    // A thread that is ending can't access the variable and is not watched.
    if !WATCHED.try_with(|watched| watched.replace(false)).unwrap_or(false) {
        return;
    }
    let trace = Backtrace::force_capture().to_string();
    if !trace.contains("spe2::") {
        ASKED.with_borrow_mut(|asked| asked.push(trace));
    }
    WATCHED.set(true);
}

// SAFETY: all requests go to the system's allocator. The recording code also allocates, but it
// records nothing then.
unsafe impl GlobalAlloc for Watching {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        asked();
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the contract of `dealloc`.
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        asked();
        // SAFETY: the caller keeps the contract of `realloc`.
        unsafe { System.realloc(block, layout, size) }
    }
}

/// Returns a backtrace for each allocation that this thread makes during `work`.
pub fn during(work: impl FnOnce()) -> Vec<String> {
    WATCHED.set(true);
    work();
    WATCHED.set(false);
    ASKED.take()
}

#[test]
fn allocations_name_their_function() {
    let mut list: Vec<u8> = Vec::new();
    let asked = during(|| list.reserve(10));
    assert_eq!(asked.len(), 1);
    assert!(asked[0].contains("allocations_name_their_function"), "{}", asked[0]);
    assert!(during(|| list.push(1)).is_empty());
    assert_eq!(during(|| list.reserve(1000)).len(), 1);
    drop(list);
}
