//! Bit-exact emulator of the SPU, the Cell Broadband Engine's synergistic processor, as a library.
//!
//! The library models the SPU alone: local store, registers, channels, MFC, and what an SPE shows
//! to the PPE. It depends neither on libspe2, which is one of its users, nor on any program. The
//! instruction set and the pipelines are in [`spu_isa`].
//!
//! | to | use |
//! |---|---|
//! | run instructions and nothing else | [`interp::Spu`] on a [`local_store::LocalStore`] |
//! | run a program that uses a PPE and moves data | [`spe::Spe`] on a [`machine::Machine`] |
//! | load an SPU program's ELF file | [`elf::Image`] |
//! | watch each instruction | [`interp::Observer`] |
//! | count the cycles of one SPU's code | [`timer::Timer`] |
//! | count the cycles of whole programs, DMA and SPEs | [`machine::Machine::simulated`] |
//! | find DMA that a program does not wait for | [`simulated::Simulation::on_race`] |
//! | compute as an SPU computes | [`float`] |
//! | choose whether code is interpreted or compiled | [`engine::Engine`] |
//! | run SPEs without threads | [`in_turn`] |
//! | serve an SPU program's PPE-assisted calls | [`ppe_call`] |
//!
//! Without features, this is the SPU alone, which needs neither an operating system nor threads:
//! the modules `interp`, `local_store`, `channel`, `float` and `timer`. The feature `elf` adds
//! [`elf`], `compiler` adds [`compiled`], and `machine` the others.
//!
//! A fault of the program is reported as a [`stop::Stop`]. It never panics.
//!
//! # Run an SPU program
//!
//! The program gets a quadword by DMA, adds 1 to its words, and sends the first one to the PPE.
//! The words below are an assembler's output. [`elf::Image::load`] loads a program from a file.
//!
//! ```
//! use std::sync::Arc;
//!
//! use spu_emulator::machine::Machine;
//! use spu_emulator::memory::{Access, RegisteredMemory};
//! use spu_emulator::spe::{Config, Spe};
//! use spu_emulator::stop::Stop;
//!
//! const PROGRAM: [u32; 20] = [
//!     0x4080_8003, // il $3,256        local-store address
//!     0x21a0_0803, // wrch $ch16,$3
//!     0x4080_0002, // il $2,0          upper half of the effective address
//!     0x21a0_0882, // wrch $ch17,$2
//!     0x4100_0084, // ilhu $4,1        its lower half
//!     0x21a0_0904, // wrch $ch18,$4
//!     0x4080_0805, // il $5,16         bytes
//!     0x21a0_0985, // wrch $ch19,$5
//!     0x21a0_0a02, // wrch $ch20,$2    tag
//!     0x4080_2006, // il $6,64         get
//!     0x21a0_0a86, // wrch $ch21,$6
//!     0x4080_0087, // il $7,1          wait for tag 0
//!     0x21a0_0b07, // wrch $ch22,$7
//!     0x4080_0108, // il $8,2
//!     0x21a0_0b88, // wrch $ch23,$8
//!     0x01a0_0c09, // rdch $9,$ch24
//!     0x3080_200a, // lqa $10,0x100
//!     0x1c00_450a, // ai $10,$10,1
//!     0x21a0_0e0a, // wrch $ch28,$10
//!     0x0000_2000, // stop
//! ];
//!
//! let memory = Arc::new(RegisteredMemory::new());
//! let values = [41_u32, 1, 2, 3].map(u32::to_be_bytes).concat();
//! memory.register(0x1_0000, values, Access::ReadOnly)?;
//!
//! let spe = Spe::new(&Machine::new(memory), Config::default());
//! for (address, word) in (0..).step_by(4).zip(PROGRAM) {
//!     spe.local_store().write(address, &word.to_be_bytes());
//! }
//! let stopped = spe.run(0);
//!
//! assert_eq!(stopped.reason, Stop::Signal(0x2000));
//! assert_eq!(spe.read_outbound(None), Some(42));
//! # Ok::<(), spu_emulator::memory::RegionError>(())
//! ```
//!
//! # With timing
//!
//! The same program on a machine with simulated time. Each cycle of the SPE's clock has one cause.
//! The latencies are the console's unless a [`simulated::Timing`] changes them.
//!
//! ```
//! # use std::sync::Arc;
//! # use spu_emulator::machine::Machine;
//! # use spu_emulator::memory::{Access, RegisteredMemory};
//! # use spu_emulator::spe::{Config, Spe};
//! use spu_emulator::simulated::{MemoryFigures, SpeReport, Timing};
//! # const PROGRAM: [u32; 20] = [
//! #     0x4080_8003, 0x21a0_0803, 0x4080_0002, 0x21a0_0882, 0x4100_0084,
//! #     0x21a0_0904, 0x4080_0805, 0x21a0_0985, 0x21a0_0a02, 0x4080_2006,
//! #     0x21a0_0a86, 0x4080_0087, 0x21a0_0b07, 0x4080_0108, 0x21a0_0b88,
//! #     0x01a0_0c09, 0x3080_200a, 0x1c00_450a, 0x21a0_0e0a, 0x0000_2000,
//! # ];
//!
//! fn time(timing: Timing) -> SpeReport {
//!     let memory = Arc::new(RegisteredMemory::new());
//!     memory.register(0x1_0000, vec![0; 16], Access::ReadOnly).expect("nothing else is there");
//!     let machine = Machine::simulated(memory, timing);
//!     let spe = Spe::new(&machine, Config::default());
//!     for (address, word) in (0..).step_by(4).zip(PROGRAM) {
//!         spe.local_store().write(address, &word.to_be_bytes());
//!     }
//!     spe.run(0);
//!     let simulation = machine.simulation().expect("it was made with one");
//!     simulation.report().spes.remove(0)
//! }
//!
//! let console = time(Timing::default());
//! assert_eq!(console.account.cycles(), console.busy() + console.waits.tag);
//! assert_eq!(console.commands.bytes_in, 16);
//!
//! // What if memory were 100 cycles farther away?
//! let mut slower = Timing::default();
//! slower.memory.get_latency = MemoryFigures::CONSOLE.get_latency + 100;
//! assert_eq!(time(slower).waits.tag, console.waits.tag + 100);
//! ```

// Without a machine or a compiler, nothing uses what the clock and the interpreter offer them.
#![cfg_attr(
    not(all(feature = "compiler", any(target_arch = "x86_64", target_arch = "wasm32"))),
    allow(dead_code, unused_imports)
)]

#[cfg(not(target_has_atomic = "64"))]
mod atomic_words;
pub mod channel;
#[cfg(feature = "machine")]
#[cfg_attr(
    not(all(feature = "compiler", any(target_arch = "x86_64", target_arch = "wasm32"))),
    path = "compiled/absent.rs"
)]
pub mod compiled;
#[cfg(feature = "machine")]
pub mod decrementer;
pub mod edges;
#[cfg(feature = "elf")]
pub mod elf;
#[cfg(feature = "machine")]
pub mod engine;
#[cfg(feature = "machine")]
mod event;
pub mod float;
#[cfg(feature = "machine")]
pub mod in_turn;
pub mod interp;
pub mod local_store;
#[cfg(feature = "machine")]
mod lock;
#[cfg(feature = "machine")]
pub mod machine;
#[cfg(feature = "machine")]
pub mod mailbox;
#[cfg(feature = "machine")]
pub mod memory;
pub mod mfc;
#[cfg(all(feature = "machine", unix))]
pub mod ppe_call;
#[cfg(feature = "machine")]
pub mod profile;
#[cfg(feature = "machine")]
pub mod signal;
#[cfg(feature = "machine")]
pub mod simulated;
#[cfg(feature = "machine")]
pub mod spe;
pub mod stop;
pub mod timer;

/// The examples of the readme.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
