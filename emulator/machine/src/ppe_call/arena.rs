//! A heap in a region of emulated main memory.
//!
//! Invariant: `used` and `free` together cover the region without gaps or overlaps, and no two
//! free pieces are adjacent.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::host::Heap;
use crate::memory::{Access, MainMemory, RegionError, RegisteredMemory};

/// The size of the smallest allocation: a quadword, so that every allocation can be transferred.
const GRAIN: u64 = 16;

/// First-fit allocation in one registered region.
pub struct Arena {
    memory: Arc<RegisteredMemory>,
    free: BTreeMap<u64, u64>,
    used: BTreeMap<u64, Allocation>,
}

#[derive(Clone, Copy)]
struct Allocation {
    asked: u64,
    taken: u64,
}

impl Arena {
    /// Registers `size` bytes at `ea` and allocates from them.
    pub fn new(memory: &Arc<RegisteredMemory>, ea: u64, size: usize) -> Result<Self, RegionError> {
        memory.register(ea, vec![0; size], Access::ReadWrite)?;
        Ok(Self {
            memory: Arc::clone(memory),
            free: BTreeMap::from([(ea, size as u64)]),
            used: BTreeMap::new(),
        })
    }

    fn zero(&self, ea: u64, size: u64) -> bool {
        const PIECE: usize = 64 << 10;
        let zeros = vec![0; size.min(PIECE as u64) as usize];
        (0..size).step_by(PIECE).all(|done| {
            let now = (size - done).min(PIECE as u64) as usize;
            self.write(ea + done, &zeros[..now])
        })
    }
}

impl Heap for Arena {
    fn allocate(&mut self, size: u64, alignment: u64) -> Option<u64> {
        let taken = size.max(1).checked_next_multiple_of(GRAIN)?;
        let alignment = alignment.max(GRAIN);
        let (start, length, ea) = self.free.iter().find_map(|(&start, &length)| {
            let ea = start.checked_next_multiple_of(alignment)?;
            let end = ea.checked_add(taken)?;
            (end - start <= length).then_some((start, length, ea))
        })?;
        self.free.remove(&start);
        if ea > start {
            self.free.insert(start, ea - start);
        }
        let rest = start + length - (ea + taken);
        if rest > 0 {
            self.free.insert(ea + taken, rest);
        }
        self.used.insert(ea, Allocation { asked: size, taken });
        self.zero(ea, taken).then_some(ea)
    }

    fn release(&mut self, ea: u64) -> bool {
        let Some(Allocation { taken, .. }) = self.used.remove(&ea) else {
            return false;
        };
        let (mut start, mut length) = (ea, taken);
        if let Some((&before, &size)) = self.free.range(..ea).next_back()
            && before + size == ea
        {
            self.free.remove(&before);
            start = before;
            length += size;
        }
        if let Some(size) = self.free.remove(&(ea + taken)) {
            length += size;
        }
        self.free.insert(start, length);
        true
    }

    fn size_of(&self, ea: u64) -> Option<u64> {
        self.used.get(&ea).map(|allocation| allocation.asked)
    }

    fn read(&self, ea: u64, into: &mut [u8]) -> bool {
        self.memory.read(ea, into).is_ok()
    }

    fn write(&self, ea: u64, from: &[u8]) -> bool {
        self.memory.write(ea, from).is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BASE: u64 = 0x1010;

    fn arena(size: usize) -> Arena {
        Arena::new(&Arc::new(RegisteredMemory::new()), BASE, size).unwrap()
    }

    #[test]
    fn released_memory_can_be_allocated_whole() {
        let mut arena = arena(256);
        let all: Vec<u64> = (0..16).map(|_| arena.allocate(16, 1).unwrap()).collect();
        assert_eq!(arena.allocate(1, 1), None);
        // The odd ones go first, so that pieces are joined on both sides.
        for ea in all.iter().skip(1).step_by(2).chain(all.iter().step_by(2)) {
            assert!(arena.release(*ea));
        }
        assert_eq!(arena.allocate(256, 1), Some(BASE));
    }

    #[test]
    fn allocations_are_aligned_and_zero() {
        let mut arena = arena(1024);
        let first = arena.allocate(5, 128).unwrap();
        assert_eq!(first % 128, 0);
        assert_eq!(arena.size_of(first), Some(5));
        assert!(arena.write(first, &[9; 5]));
        assert!(arena.release(first));
        assert!(!arena.release(first), "twice");
        let again = arena.allocate(5, 128).unwrap();
        let mut bytes = [1; 5];
        assert!(arena.read(again, &mut bytes));
        assert_eq!((again, bytes), (first, [0; 5]));
    }

    #[test]
    fn impossible_sizes_are_refused() {
        let mut arena = arena(64);
        assert_eq!(arena.allocate(u64::MAX, 1), None);
        assert_eq!(arena.allocate(u64::MAX - 20, 16), None);
        assert_eq!(arena.allocate(1, 1 << 63), None);
        assert_eq!(arena.allocate(0, 1), Some(BASE));
    }
}
