//! The C API as programs call it, in the sets of the library's own test-suite. Every wait ends:
//! what could sleep for ever runs on another thread, and the test gives up on it.

#![expect(
    clippy::undocumented_unsafe_blocks,
    reason = "each block calls the C API, with NULL or with pointers that live to the end of their test"
)]

mod basic;
mod event;
mod exports;
mod images;
mod mfc;
mod run;
mod support;
