//! The memory of this program as main memory.

use spu_emulator::memory::{LINE, MainMemory, MemoryFault};

/// The memory of this program: effective addresses are its own.
#[derive(Clone, Copy, Debug, Default)]
pub struct HostMemory;

const PAGE: u64 = 65536;

/// The bytes of this program at `ea`.
fn at(ea: u64, length: usize) -> Result<*mut u8, MemoryFault> {
    let end = core::arch::wasm32::memory_size::<0>() as u64 * PAGE;
    match ea.checked_add(length as u64) {
        Some(last) if ea != 0 && last <= end => {
            Ok(std::ptr::with_exposed_provenance_mut(ea as usize))
        }
        _ => Err(MemoryFault { ea }),
    }
}

impl MainMemory for HostMemory {
    fn read(&self, ea: u64, into: &mut [u8]) -> Result<(), MemoryFault> {
        let from = at(ea, into.len())?;
        // SAFETY: the bytes are in the program's memory. The frame's records have their address
        // from memory that is never lent out while the SPUs run, and `into` is the emulator's.
        unsafe { from.copy_to_nonoverlapping(into.as_mut_ptr(), into.len()) };
        Ok(())
    }

    fn write(&self, ea: u64, from: &[u8]) -> Result<(), MemoryFault> {
        let into = at(ea, from.len())?;
        // SAFETY: as above; SPUs write to no other memory than such records and the frame, as on
        // a console.
        unsafe { into.copy_from_nonoverlapping(from.as_ptr(), from.len()) };
        Ok(())
    }

    fn accepts_write(&self, ea: u64, length: usize) -> bool {
        at(ea, length).is_ok()
    }

    fn compare_exchange_line(
        &self,
        ea: u64,
        expected: &[u8; LINE],
        new: &[u8; LINE],
    ) -> Result<bool, MemoryFault> {
        let mut current = [0; LINE];
        self.read(ea, &mut current)?;
        if current != *expected {
            return Ok(false);
        }
        self.write(ea, new)?;
        Ok(true)
    }
}
