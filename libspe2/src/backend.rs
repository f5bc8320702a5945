//! What carries out a context's operations: the emulator, or the kernel's spufs with real SPEs.
//!
//! Invariant: the choice is made once and holds for the whole process.

use std::env;
use std::os::fd::RawFd;
use std::sync::{Arc, OnceLock};

use libc::{c_int, c_uint, c_void};
use spu_emulator::signal::SignalRegister;
use spu_emulator::simulated::Simulation;
use spu_emulator::spe::{TagWait, Watcher};

use crate::error::Errno;
use crate::machine::{debugger_port, timing};
use crate::mfc::Transfer;
use crate::run::{Ended, StartRegisters};
use crate::spufs;

const VARIABLE: &str = "LIBSPE2_BACKEND";

static CHOSEN: OnceLock<Choice> = OnceLock::new();

/// What carries out the operations of all contexts of the process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    Emulator,
    Spufs,
}

/// Returns the choice: the environment's, or else spufs where it is mounted and the kernel has its
/// calls. Simulated time and a debugger are only to be had from the emulator.
pub(crate) fn chosen() -> Result<Choice, Errno> {
    if let Some(choice) = CHOSEN.get() {
        return Ok(*choice);
    }
    let timing = timing()?;
    let debugged = debugger_port()?.is_some();
    let choice = match env::var_os(VARIABLE) {
        None if !timing && !debugged && spufs::is_there() => Choice::Spufs,
        None => Choice::Emulator,
        Some(name) if name == "emulator" => Choice::Emulator,
        Some(name) if name == "spufs" && timing => {
            messages::print!(
                "libspe2: {VARIABLE}=spufs does not go with simulated time (LIBSPE2_TIMING)"
            );
            return Err(Errno(libc::EINVAL));
        }
        Some(name) if name == "spufs" && debugged => {
            messages::print!("libspe2: {VARIABLE}=spufs does not go with a debugger (LIBSPE2_GDB)");
            return Err(Errno(libc::EINVAL));
        }
        Some(name) if name == "spufs" => {
            spufs::check()?;
            Choice::Spufs
        }
        Some(name) => {
            messages::print!("libspe2: {VARIABLE} is spufs or emulator, not {name:?}");
            return Err(Errno(libc::EINVAL));
        }
    };
    Ok(*CHOSEN.get_or_init(|| choice))
}

/// A context's SPE. Functions with a default concern only one of the two backends.
pub(crate) trait Backend: Send + Sync {
    /// The mapping of local store.
    fn local_store(&self) -> *mut u8;

    /// Writes to local store. The bytes must lie in it.
    fn write_local_store(&self, address: u32, bytes: &[u8]);

    /// A program has been loaded from this ELF file.
    fn loaded(&self, _image: &[u8]) {}

    /// Runs the SPU from an address, with the registers of a program's start if there are any.
    /// Returns the address to continue at, and why the SPU stopped.
    fn run(&self, at: u32, start: Option<&StartRegisters>) -> (u32, Ended);

    /// A run is over, and is reported with this status.
    fn stopped(&self, _status: c_int, _npc: u32) {}

    /// Takes a word from the outbound mailbox, if there is one.
    fn read_outbound(&self) -> Result<Option<u32>, Errno>;
    /// Number of words in the outbound mailbox.
    fn outbound_waiting(&self) -> Result<usize, Errno>;
    /// Puts a word into the inbound mailbox. Returns `false` if it is full and need not be waited
    /// for.
    fn write_inbound(&self, word: u32, wait: bool) -> Result<bool, Errno>;
    /// Number of words that fit into the inbound mailbox.
    fn inbound_free(&self) -> Result<usize, Errno>;
    /// Takes a word from the outbound interrupt mailbox. Returns `None` if there is none and it
    /// need not be waited for.
    fn read_outbound_interrupt(&self, wait: bool) -> Result<Option<u32>, Errno>;
    /// Number of words in the outbound interrupt mailbox.
    fn outbound_interrupt_waiting(&self) -> Result<usize, Errno>;
    fn signal(&self, register: SignalRegister, word: u32) -> Result<(), Errno>;

    /// Whether the problem state is mapped.
    fn maps_areas(&self) -> bool;
    /// The address of an area of the mapped problem state.
    fn area(&self, number: usize) -> Option<*mut c_void>;
    /// Starts a multisource synchronisation by the mapped problem state.
    fn synchronise(&self);
    /// The register of multisource synchronisation: 0 when it is over.
    fn synchronisation(&self) -> u32;

    /// Gives a proxy command. Its tag and classes are in their ranges.
    fn transfer(&self, transfer: &Transfer) -> Result<(), Errno>;
    /// Returns the complete tags, as `spe_mfcio_tag_status_read` documents it.
    fn tag_status(&self, mask: u32, wait: TagWait) -> Result<u32, Errno>;

    /// The file whose readiness is this event, on spufs.
    fn event_file(&self, _event: c_uint) -> Result<Option<RawFd>, Errno> {
        Ok(None)
    }
    /// Whether a tag is complete and has not been reported, on the emulator.
    fn tag_waiting(&self) -> bool {
        false
    }
    /// Rings `watcher` at each change, on the emulator.
    fn watch(&self, _watcher: Arc<dyn Watcher>) {}
    /// Cancels one [`watch`](Self::watch).
    fn unwatch(&self, _watcher: &Arc<dyn Watcher>) {}
    /// Makes a change that watchers must learn of, at a point of simulated time.
    fn change(&self, body: &mut dyn FnMut()) {
        body();
    }
    /// Reads what [`change`](Self::change) changes.
    fn act(&self, body: &mut dyn FnMut()) {
        body();
    }
    /// The simulation that the emulated SPE is part of.
    fn simulation(&self) -> Option<&Arc<Simulation>> {
        None
    }

    /// The descriptor of the context's directory, on spufs.
    fn directory(&self) -> Option<RawFd> {
        None
    }
}
