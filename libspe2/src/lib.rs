//! The libspe2 C API (level 2.3, 38 functions) on the SPU emulator, or on real SPEs by the kernel's
//! spufs.
//!
//! Built as `libspe2.so.2`, it replaces the console's library. As an rlib, it is linked into host
//! programs. Effective addresses are addresses of the process, as on the console.
//!
//! On the emulator, it differs from the library on a PlayStation 3 in these ways:
//! - An access to a problem-state area doesn't wait until the context runs, and must be a plain
//!   load or store of 32 bits. `SPE_MAP_PS` needs a processor of PowerPC or x86-64.
//! - A proxy DMA command is carried out whether or not the context runs; the console's waits until
//!   it runs. If no tag is outstanding, `spe_mfcio_tag_status_read` stores 0, where the console's
//!   waits for ever.
//! - A caught signal interrupts no wait, and it ends a run only if the run raised it.
//! - Any number of stop records may stay unread.
//! - On x86-64, the library handles SIGSEGV and SIGBUS from the first context on, for transfers
//!   with bad addresses. Other faults go to the handler that the program had before. A program may
//!   install its own handlers later: those transfers then take a system call each.
//! - Of the system calls that a console's kernel carries out for stop 0x2104, the common ones are
//!   served, and the others fail with ENOSYS.
//!
//! On spufs, it differs from that library in these ways:
//! - If no tag is outstanding, `spe_mfcio_tag_status_read` stores 0 there, too. `SPE_TAG_ALL` waits
//!   for all tags.
//! - With `SPE_MAP_PS`, mailboxes and signals still go by the files.
//! - `spe_cpu_info_get` counts only SPEs.
//! - Any number of stop records may stay unread.
//!
//! These environment variables are read when the first context is created:
//! - `LIBSPE2_BACKEND` is `emulator` or `spufs`. The default is `spufs` where it is mounted on
//!   `/spu` and the kernel has its system calls, and otherwise `emulator`.
//! - `LIBSPE2_SPES`, 1 to 16, is the number of SPEs that `spe_cpu_info_get` returns. The default
//!   is 6, or on spufs the kernel's number.
//! - `LIBSPE2_MFC` is `at-once` (the default) or `at-last`. `at-last` carries out DMA commands as
//!   late and in as unexpected an order as the architecture allows, which exposes missing waits.
//! - `LIBSPE2_ENGINE` is `compiler` (the default, where the host has one) or `interpreter`.
//! - `LIBSPE2_TIMING=1` counts cycles. SPEs then run in simulated time (see
//!   [`spu_emulator::simulated`]), which decrementers and the time-outs of events count too.
//!   Creating contexts and loading programs takes no simulated time. A warning on standard error
//!   names each use of local store that races with the SPU's own DMA.
//! - `LIBSPE2_MACHINE` is the path of a file with the latencies and rates of simulated time. It
//!   needs `LIBSPE2_TIMING=1`.
//! - `LIBSPE2_REPORT` is the path of the JSON report, which is written when a context is destroyed
//!   and when the process ends. It needs `LIBSPE2_TIMING=1`.
//! - `LIBSPE2_PROFILE` is the path of the profile, which records the instructions that the cycles
//!   were spent on. It is written at the same times and needs `LIBSPE2_TIMING=1`; `spu profile`
//!   shows it.
//! - `LIBSPE2_TIMELINE` is the path of the timeline, which records when each SPE slept and when its
//!   MFC moved data. It is written at the same times and needs `LIBSPE2_TIMING=1`;
//!   `cellray render --inspect` draws it.
//! - `LIBSPE2_GDB` is a port of the loopback interface, or 0 for any free one. The emulated SPEs
//!   wait there for a debugger and obey it ([`spu_debugger`]).
//! - `LIBSPE2_CHECK=1` compares the compiled code with the interpreter as it runs. In simulated
//!   time it also counts the cycles a second time, instruction by instruction. At the first
//!   difference, the run reports it and fails.

mod backend;
mod builtin;
pub mod callback;
pub mod context;
pub mod cpu_info;
mod emulated;
mod error;
pub mod event;
mod fault_handler;
mod fault_signal;
mod futex;
pub mod image;
mod machine;
pub mod mailbox;
pub mod mfc;
mod problem_state;
mod process_memory;
mod quick_copy;
mod report;
pub mod run;
mod scratch;
mod shared_mappings;
mod spufs;
mod stop_record;
pub mod types;
