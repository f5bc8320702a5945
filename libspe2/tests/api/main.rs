//! The C API as programs call it, in the groups of the original library's test suite. No test can
//! hang: a call that could sleep for ever runs on another thread, and the test gives up on it.

#![expect(
    clippy::undocumented_unsafe_blocks,
    reason = "each block calls the C API with NULL or with pointers that are valid until their test ends"
)]

mod basic;
mod event;
mod exports;
mod images;
mod lines;
mod machine;
mod mfc;
mod problem_state;
mod run;
mod support;
