//! The common imports of these tests.

pub use std::sync::Arc;
pub use std::thread;
pub use std::time::{Duration, Instant};

pub use randomness::{Random, rounds};
pub use spu_emulator::float::estimate;
pub use spu_emulator::float::fpscr::{Flags, Fpscr};
pub use spu_emulator::interp::{Quad, Spu};
pub use spu_emulator::local_store::{LocalStore, SIZE};
pub use spu_emulator::machine;
pub use spu_emulator::memory::{Access, RegisteredMemory};
pub use spu_emulator::mfc::Policy;
pub use spu_emulator::signal::SignalRegister;
pub use spu_emulator::simulated::{Method, SimulationOptions, SpeReport, Timing};
pub use spu_emulator::spe::{Config, Spe};
pub use spu_emulator::stop::{ChannelAccess, Stop, Stopped};
pub use spu_isa::{Instruction, Op};

pub use crate::support::{BASE, Machine, assemble, register, run_to_stop, soon, start};
