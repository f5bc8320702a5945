//! A stand-in for the kernel's spufs: the system calls `spu_create` and `spu_run` and the files of
//! contexts, as spufs(7), spu_create(2) and spu_run(2) describe them, with emulated SPEs. It
//! replaces the C library's functions, either preloaded into a program or linked into it.
//!
//! The directories exist only for `spu_create` and for `openat` with a context's descriptor. A
//! file's descriptor is an eventfd that is ready when the file would be, so that every kind of
//! waiting for readiness works.
//!
//! It differs from the kernel in these ways: there are as many SPEs as contexts, a mapped register
//! is accessed whether or not the context is loaded, only a signal that a run raises ends the run,
//! and any caught signal ends a wait for a mailbox, even with `SA_RESTART`.
//!
//! The variable `SPUFS` makes it fail (`fault.rs`).
//!
//! Invariant: what is not of spufs goes to the C library untouched.

mod context;
mod error;
mod fault;
#[path = "../../../../libspe2/src/fault_handler.rs"]
mod fault_handler;
#[path = "../../../../libspe2/src/fault_signal.rs"]
mod fault_signal;
mod file;
#[path = "../../../../libspe2/src/futex.rs"]
mod futex;
mod interpose;
mod next;
#[path = "../../../../libspe2/src/problem_state/mod.rs"]
mod problem_state;
#[path = "../../../../libspe2/src/process_memory.rs"]
mod process_memory;
#[path = "../../../../libspe2/src/quick_copy.rs"]
mod quick_copy;
mod readiness;
mod run;
#[path = "../../../../libspe2/src/scratch.rs"]
mod scratch;
#[path = "../../../../libspe2/src/shared_mappings.rs"]
mod shared_mappings;
mod system_call;
mod table;

pub use interpose::linked;
