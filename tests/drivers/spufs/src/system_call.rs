//! Stop 0x2104: a system call that the kernel carries out for the SPU program.

use std::sync::OnceLock;

use spu_emulator::local_store::LocalStore;
use spu_emulator::memory::MainMemory;
use spu_emulator::ppe_call::{Heap, Library, Process, SYSTEM_CALL};

use crate::process_memory::ProcessMemory;

static LIBRARY: OnceLock<Library> = OnceLock::new();

/// The process's memory, in which a system call allocates nothing.
struct Memory;

impl Heap for Memory {
    fn is_process(&self) -> bool {
        true
    }

    fn allocate(&mut self, _size: u64, _alignment: u64) -> Option<u64> {
        None
    }

    fn release(&mut self, _ea: u64) -> bool {
        false
    }

    fn size_of(&self, _ea: u64) -> Option<u64> {
        None
    }

    fn read(&self, ea: u64, into: &mut [u8]) -> bool {
        ProcessMemory.read(ea, into).is_ok()
    }

    fn write(&self, ea: u64, from: &[u8]) -> bool {
        ProcessMemory.write(ea, from).is_ok()
    }
}

/// Carries out the call whose address is in the word at `npc`. Returns whether it did: if the
/// call's block does not lie in local store, the stop is reported.
pub(crate) fn serve(store: &LocalStore, npc: u32) -> bool {
    let library = LIBRARY.get_or_init(|| Library::new(Box::new(Process), Box::new(Memory)));
    library.serve(SYSTEM_CALL, store, npc).is_ok()
}
