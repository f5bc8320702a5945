//! The process's own memory as main memory: an effective address is an address in the process.
//!
//! Invariant: no access by the emulated MFC raises a signal that the program sees: the kernel
//! checks every address first, or [the library's handler](crate::fault_handler) ends an access that
//! faults. There are two exceptions. A program unmaps memory while its SPEs exchange lines in it.
//! Or it installs its own handler while an SPE runs, whose next transfer has a bad address: it gets
//! the signal of that transfer early. Such programs would fail anyway.

use std::ptr;
use std::sync::atomic::AtomicUsize;
use std::sync::atomic::Ordering::{Relaxed, SeqCst};
use std::sync::{Mutex, PoisonError};

use spu_emulator::memory::{LINE, MainMemory, MemoryFault, Place};

use crate::futex::{Writable, probe_write};
use crate::quick_copy;
use crate::scratch::Pool;
use crate::shared_mappings;

/// Of the smallest pages that Linux has.
const PAGE: usize = 4096;
/// Numbers of pages that were found writable, each at its remainder. A program that unmaps one of
/// them while its SPEs write there gets their faults later than they would occur.
static KNOWN_PAGES: [AtomicUsize; 8192] = [const { AtomicUsize::new(usize::MAX) }; 8192];

static POOL: Pool = Pool::new();
static EXCHANGE: Mutex<()> = Mutex::new(());

pub(crate) struct ProcessMemory;

impl ProcessMemory {
    /// Allocates in advance what accesses need, so that no access fails for lack of it.
    pub(crate) fn prepare() -> std::io::Result<()> {
        POOL.prepare()
    }
}

impl MainMemory for ProcessMemory {
    fn read(&self, ea: u64, into: &mut [u8]) -> Result<(), MemoryFault> {
        if quick_copy::fetch(ea, into) {
            return Ok(());
        }
        POOL.with(|scratch| scratch.fetch(ea, into)).map_err(|ea| MemoryFault { ea })
    }

    fn write(&self, ea: u64, from: &[u8]) -> Result<(), MemoryFault> {
        if quick_copy::store(ea, from) {
            return Ok(());
        }
        POOL.with(|scratch| scratch.store(ea, from)).map_err(|ea| MemoryFault { ea })
    }

    fn read_pieces(&self, pieces: &[(u64, usize)], into: &mut [u8]) -> Result<(), MemoryFault> {
        let mut rest = &mut *into;
        if pieces.iter().all(|&(ea, length)| {
            let (piece, others) = std::mem::take(&mut rest).split_at_mut(length);
            rest = others;
            quick_copy::fetch(ea, piece)
        }) {
            return Ok(());
        }
        POOL.with(|scratch| scratch.fetch_pieces(pieces, into)).map_err(|ea| MemoryFault { ea })
    }

    fn write_pieces(&self, pieces: &[(u64, usize)], from: &[u8]) -> Result<(), MemoryFault> {
        let mut rest = from;
        if pieces.iter().all(|&(ea, length)| {
            let (piece, others) = rest.split_at(length);
            rest = others;
            quick_copy::store(ea, piece)
        }) {
            return Ok(());
        }
        POOL.with(|scratch| scratch.store_pieces(pieces, from)).map_err(|ea| MemoryFault { ea })
    }

    fn accepts_write(&self, ea: u64, length: usize) -> bool {
        let start = usize::try_from(ea).ok();
        let Some((start, end)) = start.and_then(|start| Some((start, start.checked_add(length)?)))
        else {
            return false;
        };
        (start / PAGE..end.div_ceil(PAGE)).all(|page| {
            let known = &KNOWN_PAGES[page % KNOWN_PAGES.len()];
            if known.load(Relaxed) == page {
                return true;
            }
            let writable = probe_write((page * PAGE) as u64) == Writable::Yes;
            if writable {
                known.store(page, Relaxed);
            }
            writable
        })
    }

    fn place(&self, ea: u64) -> Option<Place> {
        shared_mappings::place(ea)
    }

    /// Atomic with respect to the PPE's own atomic instructions if the change is within one
    /// aligned word of the process's width, as it is for locks and counters. The change is then
    /// one compare-and-exchange.
    fn compare_exchange_line(
        &self,
        ea: u64,
        expected: &[u8; LINE],
        new: &[u8; LINE],
    ) -> Result<bool, MemoryFault> {
        let _one_at_a_time = EXCHANGE.lock().unwrap_or_else(PoisonError::into_inner);
        let mut current = [0; LINE];
        self.read(ea, &mut current)?;
        if current != *expected {
            return Ok(false);
        }
        let changed = |at: &usize| expected[*at] != new[*at];
        let Some(first) = (0..LINE).find(changed) else {
            // The hardware writes the line even if nothing changed, so a line that can't be
            // written is a fault.
            return self.write(ea, new).map(|()| true);
        };
        let last = (0..LINE).rfind(changed).unwrap_or(first);
        const WIDTH: usize = size_of::<usize>();
        let word = first & !(WIDTH - 1);
        if last & !(WIDTH - 1) != word {
            let changed = first..last + 1;
            return self.write(ea + first as u64, &new[changed]).map(|()| true);
        }
        let at = ea + word as u64;
        match probe_write(at) {
            Writable::No => Err(MemoryFault { ea: at }),
            Writable::Unknown => self.write(at, &new[word..word + WIDTH]).map(|()| true),
            Writable::Yes => {
                let value = |line: &[u8; LINE]| {
                    usize::from_ne_bytes(std::array::from_fn(|n| line[word + n]))
                };
                let address = ptr::with_exposed_provenance_mut(at as usize);
                // SAFETY: the address is a multiple of the width, and the kernel has just found it
                // mapped and writable. Other threads that use the line use it atomically, as they
                // must for a lock shared with an SPE.
                let shared = unsafe { AtomicUsize::from_ptr(address) };
                Ok(shared.compare_exchange(value(expected), value(new), SeqCst, SeqCst).is_ok())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[repr(align(128))]
    struct Line([u8; LINE]);

    fn address(line: &mut Line) -> u64 {
        line.0.as_mut_ptr().expose_provenance() as u64
    }

    #[test]
    fn transfers_of_any_length_arrive() {
        let mut there = vec![0_u8; 40_000];
        let ea = there.as_mut_ptr().expose_provenance() as u64;
        let sent: Vec<u8> = (0..40_000_u32).map(|n| (n * 7) as u8).collect();
        ProcessMemory.write(ea, &sent).unwrap();
        assert!(there == sent);
        let mut back = vec![0; 40_000];
        ProcessMemory.read(ea, &mut back).unwrap();
        assert!(back == sent);
    }

    #[test]
    fn pieces_arrive_at_their_addresses() {
        let sent: Vec<u8> = (0..40_000_u32).map(|n| (n * 7) as u8).collect();
        for length in [1, 16, 256, 16_384, 20_000] {
            let mut there = vec![0_u8; 80_000];
            let ea = there.as_mut_ptr().expose_provenance() as u64;
            let pieces: Vec<_> = sent
                .chunks(length)
                .enumerate()
                .map(|(at, piece)| (ea + (2 * at * length) as u64, piece.len()))
                .collect();
            ProcessMemory.write_pieces(&pieces, &sent).unwrap();
            let mut back = vec![0; sent.len()];
            ProcessMemory.read_pieces(&pieces, &mut back).unwrap();
            assert!(back == sent, "{length}");
            let found: Vec<u8> = there
                .chunks(2 * length)
                .flat_map(|part| &part[..length.min(part.len())])
                .copied()
                .collect();
            assert!(found[..sent.len()] == sent, "{length}");
        }
    }

    #[test]
    fn pieces_end_at_a_bad_address() {
        let mut there = [0_u8; 32];
        let ea = there.as_mut_ptr().expose_provenance() as u64;
        let pieces = [(ea, 16), (8, 16), (ea + 16, 16)];
        let fault = ProcessMemory.write_pieces(&pieces, &[1; 48]).unwrap_err();
        assert_eq!(fault.ea, 8);
        assert_eq!(there[..16], [1; 16]);
        let fault = ProcessMemory.read_pieces(&pieces, &mut [0; 48]).unwrap_err();
        assert_eq!(fault.ea, 8);
    }

    #[test]
    fn write_is_accepted_if_all_of_its_pages_can_be_written() {
        // SAFETY: a new private mapping overlaps nothing.
        let pages = unsafe {
            libc::mmap(
                ptr::null_mut(),
                3 * PAGE,
                libc::PROT_READ | libc::PROT_WRITE,
                libc::MAP_PRIVATE | libc::MAP_ANONYMOUS,
                -1,
                0,
            )
        };
        assert_ne!(pages, libc::MAP_FAILED);
        let ea = pages.expose_provenance() as u64;
        // SAFETY: the last of the three pages is this test's own.
        unsafe { libc::mprotect(pages.byte_add(2 * PAGE), PAGE, libc::PROT_READ) };
        for _ in 0..2 {
            assert!(ProcessMemory.accepts_write(ea + 1, 2 * PAGE - 1));
            assert!(!ProcessMemory.accepts_write(ea + 1, 2 * PAGE));
            assert!(!ProcessMemory.accepts_write(0, 16));
            assert!(!ProcessMemory.accepts_write(u64::MAX - 15, 32));
        }
        // SAFETY: the pages are this test's own.
        unsafe { libc::munmap(pages, 3 * PAGE) };
    }

    #[test]
    fn bad_addresses_are_faults() {
        for ea in [0, 8, u64::MAX - 15, 1 << 62] {
            assert!(ProcessMemory.read(ea, &mut [0; 16]).is_err(), "{ea:#x}");
            assert!(ProcessMemory.write(ea, &[0; 16]).is_err(), "{ea:#x}");
        }
        assert!(ProcessMemory.compare_exchange_line(0, &[0; LINE], &[0; LINE]).is_err());
    }

    #[test]
    fn read_only_memory_can_be_read_but_neither_written_nor_exchanged() {
        // SAFETY: a new private mapping overlaps nothing.
        let page = unsafe {
            libc::mmap(
                ptr::null_mut(),
                4096,
                libc::PROT_READ,
                libc::MAP_PRIVATE | libc::MAP_ANONYMOUS,
                -1,
                0,
            )
        };
        assert_ne!(page, libc::MAP_FAILED);
        let ea = page.expose_provenance() as u64;
        ProcessMemory.read(ea, &mut [0; LINE]).unwrap();
        assert!(ProcessMemory.write(ea, &[1]).is_err());
        assert!(!ProcessMemory.accepts_write(ea, 1));
        let mut new = [0; LINE];
        for at in [0, 8, 127] {
            new[at] = 1;
            let exchanged = ProcessMemory.compare_exchange_line(ea, &[0; LINE], &new);
            assert!(exchanged.is_err(), "{at}");
        }
        assert!(ProcessMemory.compare_exchange_line(ea, &[0; LINE], &[0; LINE]).is_err());
        // SAFETY: the page is this test's own.
        unsafe { libc::munmap(page, 4096) };
    }

    #[test]
    fn lines_are_exchanged_whole_and_by_doubleword() {
        let mut line = Line([0; LINE]);
        let ea = address(&mut line);
        let mut one = [0; LINE];
        one[7] = 1;
        let mut many = one;
        many[0] = 5;
        many[127] = 6;
        let exchange = |old, new| ProcessMemory.compare_exchange_line(ea, old, new);
        assert_eq!(exchange(&[0; LINE], &one), Ok(true));
        assert_eq!(exchange(&[0; LINE], &many), Ok(false));
        assert_eq!(exchange(&one, &many), Ok(true));
        assert_eq!(exchange(&many, &many), Ok(true));
        assert_eq!(line.0, many);
    }
}
