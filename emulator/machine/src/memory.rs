//! Main memory as the MFC sees it: a trait, and an implementation in which only registered regions
//! can be accessed.
//!
//! Effective addresses are plain 64-bit numbers. This module does not handle reservations: the
//! interconnect decides who may write a line while another SPE has it reserved.

use std::collections::BTreeMap;
use std::sync::{Arc, RwLock};

use thiserror::Error;

use crate::local_store::{LocalStore, SIZE};
use crate::lock::{read_lock, write_lock};

/// Bytes of a line, the unit of reservations and atomic commands.
pub const LINE: usize = 128;

/// Addresses of one [`Place`] differ by a multiple of this.
pub const PLACE_PAGE: u64 = 4096;

/// Where bytes are that may have several addresses, because a program maps them more than once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The device and the number of the file that is mapped.
    pub file: (u64, u64),
    /// Where in the file.
    pub offset: u64,
}

/// An effective address that does not exist, or does not allow this access.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("no main memory for this access at effective address {ea:#x}")]
pub struct MemoryFault {
    /// The first address that could not be accessed, if that is known.
    pub ea: u64,
}

/// The memory that `get` reads and `put` writes.
///
/// Several threads may access the same bytes at once. An implementation must be memory-safe then,
/// but its accesses need not be atomic, except for
/// [`compare_exchange_line`](MainMemory::compare_exchange_line).
pub trait MainMemory: Send + Sync {
    /// Copies `into.len()` bytes from `ea`.
    fn read(&self, ea: u64, into: &mut [u8]) -> Result<(), MemoryFault>;
    /// Copies `from` to `ea`. If it fails, a part may have been written.
    fn write(&self, ea: u64, from: &[u8]) -> Result<(), MemoryFault>;
    /// Copies to the pieces of `into`, each from the address that `pieces` has for it beside its
    /// length.
    fn read_pieces(&self, pieces: &[(u64, usize)], into: &mut [u8]) -> Result<(), MemoryFault> {
        let mut rest = into;
        for &(ea, length) in pieces {
            let (piece, others) = rest.split_at_mut(length);
            self.read(ea, piece)?;
            rest = others;
        }
        Ok(())
    }
    /// Copies the pieces of `from` in their order, each to the address that `pieces` has for it
    /// beside its length. If it fails, a part may have been written.
    fn write_pieces(&self, pieces: &[(u64, usize)], from: &[u8]) -> Result<(), MemoryFault> {
        let mut rest = from;
        for &(ea, length) in pieces {
            let (piece, others) = rest.split_at(length);
            self.write(ea, piece)?;
            rest = others;
        }
        Ok(())
    }
    /// Whether a write of these bytes that follows soon will not fail. It may return `false` if
    /// that is unknown.
    fn accepts_write(&self, _ea: u64, _length: usize) -> bool {
        false
    }
    /// Where the byte at `ea` is, if it may have other addresses, too.
    fn place(&self, _ea: u64) -> Option<Place> {
        None
    }
    /// Writes `new` to the line at `ea` (a multiple of [`LINE`]) if the line equals `expected`.
    /// Returns whether it did.
    fn compare_exchange_line(
        &self,
        ea: u64,
        expected: &[u8; LINE],
        new: &[u8; LINE],
    ) -> Result<bool, MemoryFault>;
}

/// Whether a region may be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// A `put` to the region is a storage fault.
    ReadOnly,
    /// The region can be read and written.
    ReadWrite,
}

/// Why a region could not be registered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RegionError {
    /// The region has no bytes.
    #[error("a region at {0:#x} has no bytes")]
    Empty(u64),
    /// The region runs past the last effective address.
    #[error("a region at {0:#x} runs past the end of the address space")]
    PastEnd(u64),
    /// The region overlaps another one.
    #[error("a region at {0:#x} overlaps the one at {1:#x}")]
    Overlap(u64, u64),
}

enum Backing {
    Bytes(RwLock<Vec<u8>>, Access),
    LocalStore(Arc<LocalStore>),
}

impl Backing {
    fn length(&self) -> u64 {
        match self {
            Self::Bytes(bytes, _) => read_lock(bytes).len() as u64,
            Self::LocalStore(_) => u64::from(SIZE),
        }
    }

    fn read(&self, offset: u64, into: &mut [u8]) {
        match self {
            Self::Bytes(bytes, _) => {
                into.copy_from_slice(&read_lock(bytes)[offset as usize..][..into.len()]);
            }
            Self::LocalStore(store) => store.read(offset as u32, into),
        }
    }

    fn write(&self, offset: u64, from: &[u8]) -> bool {
        match self {
            Self::Bytes(_, Access::ReadOnly) => return false,
            Self::Bytes(bytes, Access::ReadWrite) => {
                write_lock(bytes)[offset as usize..][..from.len()].copy_from_slice(from);
            }
            Self::LocalStore(store) => store.write(offset as u32, from),
        }
        true
    }
}

/// Main memory that consists of registered regions, for tests and fuzzing.
#[derive(Default)]
pub struct RegisteredMemory {
    regions: RwLock<BTreeMap<u64, Backing>>,
    exchange: std::sync::Mutex<()>,
}

impl RegisteredMemory {
    /// Memory without regions.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Maps `bytes` at `ea`.
    pub fn register(&self, ea: u64, bytes: Vec<u8>, access: Access) -> Result<(), RegionError> {
        self.insert(ea, Backing::Bytes(RwLock::new(bytes), access))
    }

    /// Maps an SPE's local store at `ea`, as Linux maps it into a process.
    pub fn register_local_store(&self, ea: u64, store: Arc<LocalStore>) -> Result<(), RegionError> {
        self.insert(ea, Backing::LocalStore(store))
    }

    fn insert(&self, ea: u64, backing: Backing) -> Result<(), RegionError> {
        let length = backing.length();
        if length == 0 {
            return Err(RegionError::Empty(ea));
        }
        let last = ea.checked_add(length - 1).ok_or(RegionError::PastEnd(ea))?;
        let mut regions = write_lock(&self.regions);
        if let Some((&other, there)) = regions.range(..=last).next_back()
            && other + (there.length() - 1) >= ea
        {
            return Err(RegionError::Overlap(ea, other));
        }
        regions.insert(ea, backing);
        Ok(())
    }

    /// Calls `each` for every piece of the `length` bytes at `ea`, with the piece's backing, its
    /// offset in the backing, and its range in the caller's slice. `each` returns whether the
    /// access is allowed.
    fn pieces(
        &self,
        ea: u64,
        length: usize,
        mut each: impl FnMut(&Backing, u64, std::ops::Range<usize>) -> bool,
    ) -> Result<(), MemoryFault> {
        let regions = read_lock(&self.regions);
        let mut done = 0;
        while done < length {
            let at = ea.checked_add(done as u64).ok_or(MemoryFault { ea: u64::MAX })?;
            let fault = MemoryFault { ea: at };
            let (start, backing) = regions.range(..=at).next_back().ok_or(fault)?;
            let offset = at - start;
            let here = backing.length().saturating_sub(offset);
            if here == 0 {
                return Err(fault);
            }
            let n = here.min((length - done) as u64) as usize;
            if !each(backing, offset, done..done + n) {
                return Err(fault);
            }
            done += n;
        }
        Ok(())
    }
}

impl MainMemory for RegisteredMemory {
    fn read(&self, ea: u64, into: &mut [u8]) -> Result<(), MemoryFault> {
        self.pieces(ea, into.len(), |backing, offset, range| {
            backing.read(offset, &mut into[range]);
            true
        })
    }

    fn write(&self, ea: u64, from: &[u8]) -> Result<(), MemoryFault> {
        self.pieces(ea, from.len(), |backing, offset, range| backing.write(offset, &from[range]))
    }

    fn accepts_write(&self, ea: u64, length: usize) -> bool {
        let accepts = |backing: &Backing| matches!(backing, Backing::Bytes(_, Access::ReadWrite));
        let pieces = self.pieces(ea, length, |backing, _, _| accepts(backing));
        pieces.is_ok()
    }

    fn compare_exchange_line(
        &self,
        ea: u64,
        expected: &[u8; LINE],
        new: &[u8; LINE],
    ) -> Result<bool, MemoryFault> {
        let _one_at_a_time = crate::lock::lock(&self.exchange);
        let mut current = [0; LINE];
        self.read(ea, &mut current)?;
        if current != *expected {
            return Ok(false);
        }
        self.write(ea, new)?;
        Ok(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_registered_bytes_are_reached() {
        let memory = RegisteredMemory::new();
        memory.register(0x1000, vec![1; 16], Access::ReadWrite).unwrap();
        memory.register(0x1010, vec![2; 16], Access::ReadOnly).unwrap();
        let mut both = [0; 32];
        memory.read(0x1000, &mut both).unwrap();
        assert_eq!(both[15..17], [1, 2]);
        assert_eq!(memory.read(0x1001, &mut both), Err(MemoryFault { ea: 0x1020 }));
        assert_eq!(memory.read(0xfff, &mut [0]), Err(MemoryFault { ea: 0xfff }));
        assert_eq!(memory.write(0x100f, &[9, 9]), Err(MemoryFault { ea: 0x1010 }));
        assert_eq!(memory.read(u64::MAX, &mut [0, 0]), Err(MemoryFault { ea: u64::MAX }));
    }

    #[test]
    fn regions_neither_overlap_nor_wrap() {
        let memory = RegisteredMemory::new();
        memory.register(0x1000, vec![0; 16], Access::ReadWrite).unwrap();
        let register = |ea, n| memory.register(ea, vec![0; n], Access::ReadWrite);
        assert_eq!(register(0x100f, 1), Err(RegionError::Overlap(0x100f, 0x1000)));
        assert_eq!(register(0xfff, 64), Err(RegionError::Overlap(0xfff, 0x1000)));
        assert_eq!(register(0x2000, 0), Err(RegionError::Empty(0x2000)));
        assert_eq!(register(u64::MAX, 2), Err(RegionError::PastEnd(u64::MAX)));
        assert_eq!(register(u64::MAX, 1), Ok(()));
        assert_eq!(register(0x1010, 1), Ok(()));
    }

    #[test]
    fn a_line_is_exchanged_only_if_it_is_as_expected() {
        let memory = RegisteredMemory::new();
        memory.register(0x1000, vec![7; LINE], Access::ReadWrite).unwrap();
        let exchange = |e, n| memory.compare_exchange_line(0x1000, &[e; LINE], &[n; LINE]);
        assert_eq!(exchange(6, 1), Ok(false));
        assert_eq!(exchange(7, 8), Ok(true));
        assert_eq!(exchange(7, 9), Ok(false));
        let mut line = [0; LINE];
        memory.read(0x1000, &mut line).unwrap();
        assert_eq!(line, [8; LINE]);
    }
}
