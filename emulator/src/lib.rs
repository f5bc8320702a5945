//! Bit-exact emulator of the Cell Broadband Engine's SPU.
//!
//! The crate knows the SPU alone: its instruction set, local store, channels and MFC. It knows
//! nothing of ray tracing or of libspe2.

pub mod channel;
pub mod decrementer;
pub mod elf;
pub mod event;
pub mod float;
pub mod interp;
pub mod isa;
pub mod local_store;
pub mod mailbox;
pub mod memory;
pub mod mfc;
pub mod ppe_call;
pub mod schedule;
pub mod signal;
pub mod simulated;
pub mod spe;
pub mod stop;
pub mod timing;
