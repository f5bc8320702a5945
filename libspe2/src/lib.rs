//! The libspe2 C API (level 2.3, 38 functions) on the SPU emulator.
//!
//! Built as `libspe2.so.2` it takes the place of the console's library; as an rlib it is linked
//! into host programs. Effective addresses are addresses of the process, as on the console.
//!
//! Where it differs from the library on a PlayStation 3, and why:
//! - `SPE_MAP_PS` answers ENOTSUP: plain loads and stores can't reach emulated registers.
//! - A proxy DMA command is carried out whether or not the context runs; the console's waits until
//!   it does. `spe_mfcio_tag_status_read` with nothing outstanding stores 0 where the console's
//!   waits for ever.
//! - A caught signal interrupts no wait, and ends a run only if the run raised it.
//! - Any number of stop records may stay unread.
//! - Stop 0x2104 (a system call by the kernel) and the C99, POSIX.1 and LIBEA callbacks are not
//!   served: such a stop is a callback error unless the program registers a handler.
//!
//! Environment: `LIBSPE2_SPES`, 1 to 16, is the number of SPEs that `spe_cpu_info_get` tells (6);
//! `LIBSPE2_MFC` is `at-once` (the default) or `at-last`, which carries DMA commands out as late
//! and in as odd an order as the architecture allows, to show missing waits. `LIBSPE2_TIMING=1`
//! counts cycles: SPEs run in simulated time (see [`spu_emulator::simulated`]), decrementers count
//! it, and so do the time-outs of events; `LIBSPE2_REPORT` is the path of the JSON report that is
//! then written when a context is destroyed and when the process ends, `LIBSPE2_PROFILE` that of
//! the profile, which `spu profile` shows: which instructions the cycles were spent on.
//! `LIBSPE2_CHECK=1` counts the cycles a second time, instruction by instruction; where the two
//! differ first, a run says so and fails. All are read with the first context. Creating and loading
//! contexts takes no simulated time.

#[cfg(not(target_pointer_width = "64"))]
compile_error!("the C layouts here are those of 64-bit programs");

pub mod callback;
pub mod context;
pub mod cpu_info;
mod error;
pub mod event;
mod fault_signal;
mod futex;
pub mod image;
mod machine;
pub mod mailbox;
pub mod mfc;
mod process_memory;
mod report;
pub mod run;
mod scratch;
mod stop_record;
pub mod types;
