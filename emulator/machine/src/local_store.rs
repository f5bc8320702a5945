//! The 256 KB local store.
//!
//! Other threads access it while the SPU runs: another SPE's MFC, and the PPE through its mapping.
//! So it consists of relaxed 64-bit atomics. They cost as much as plain loads and stores, and a
//! race between a guest and its peers is only a bug of the guest, never undefined behaviour of the
//! host. The bytes are stored in the guest's order (big-endian), so that the mapping shows the
//! same bytes as the SPU sees. On a host without 64-bit atomics, a doubleword is two words, and a
//! thread may see one of them changed and the other not yet.

use std::sync::atomic::Ordering::Relaxed;

#[cfg(not(target_has_atomic = "64"))]
use crate::atomic_words::AtomicWords as AtomicU64;
#[cfg(target_has_atomic = "64")]
use std::sync::atomic::AtomicU64;

use spu_isa::LOCAL_STORE_SIZE;

/// Size of local store in bytes.
pub const SIZE: u32 = LOCAL_STORE_SIZE;

/// Size in bytes of the lines in which local stores are compared.
#[cfg(all(feature = "compiler", any(target_arch = "x86_64", target_arch = "wasm32")))]
pub(crate) const DIFFERENCE_LINE: usize = 64;

const DOUBLEWORDS: usize = SIZE as usize / 8;
const DOUBLEWORD_MASK: usize = DOUBLEWORDS - 1;

#[repr(C, align(4096))]
struct Doublewords([AtomicU64; DOUBLEWORDS]);

/// One SPE's local store.
pub struct LocalStore(Box<Doublewords>);

impl Default for LocalStore {
    fn default() -> Self {
        Self::new()
    }
}

impl LocalStore {
    /// A local store that is filled with zeros.
    #[must_use]
    pub fn new() -> Self {
        // SAFETY: all-zero bytes are valid `AtomicU64`s, and `Doublewords` holds nothing else.
        Self(unsafe { Box::<Doublewords>::new_zeroed().assume_init() })
    }

    #[inline]
    fn doubleword(&self, address: u32) -> &AtomicU64 {
        &self.0.0[(address as usize >> 3) & DOUBLEWORD_MASK]
    }

    /// The quadword at `address` as four words, beginning with the preferred one. The low bits of
    /// the address are ignored.
    #[inline]
    #[must_use]
    pub fn load_quadword(&self, address: u32) -> [u32; 4] {
        let high = u64::from_be(self.doubleword(address & !15).load(Relaxed));
        let low = u64::from_be(self.doubleword(address | 8).load(Relaxed));
        [(high >> 32) as u32, high as u32, (low >> 32) as u32, low as u32]
    }

    /// Replaces the quadword at `address`.
    #[inline]
    pub fn store_quadword(&self, address: u32, words: [u32; 4]) {
        let high = u64::from(words[0]) << 32 | u64::from(words[1]);
        let low = u64::from(words[2]) << 32 | u64::from(words[3]);
        self.doubleword(address & !15).store(high.to_be(), Relaxed);
        self.doubleword(address | 8).store(low.to_be(), Relaxed);
    }

    /// The word at `address`: an instruction, or a word of a stop's parameters.
    #[inline]
    #[must_use]
    pub fn load_word(&self, address: u32) -> u32 {
        // One word's bytes are swapped, because some hosts have no instruction for it.
        let doubleword = self.doubleword(address).load(Relaxed);
        let after = (address & 4) * 8;
        let shift = if cfg!(target_endian = "big") { 32 - after } else { after };
        u32::from_be((doubleword >> shift) as u32)
    }

    /// Copies bytes out of local store. The address wraps at the limit.
    pub fn read(&self, address: u32, into: &mut [u8]) {
        let mut at = address;
        let mut rest = into;
        while !rest.is_empty() {
            let bytes = self.doubleword(at).load(Relaxed).to_ne_bytes();
            let skip = at as usize & 7;
            let n = rest.len().min(8 - skip);
            let (now, later) = rest.split_at_mut(n);
            if n == 8 {
                now.copy_from_slice(&bytes);
            } else {
                now.copy_from_slice(&bytes[skip..skip + n]);
            }
            rest = later;
            at = at.wrapping_add(n as u32);
        }
    }

    /// Copies bytes into local store. The address wraps at the limit.
    ///
    /// A doubleword that is only partly written is read, changed and written back. So a partial
    /// transfer and a store of the SPU to the same doubleword are not atomic, and neither are they
    /// in hardware.
    pub fn write(&self, address: u32, from: &[u8]) {
        let mut at = address;
        let mut rest = from;
        while !rest.is_empty() {
            let cell = self.doubleword(at);
            let skip = at as usize & 7;
            let n = rest.len().min(8 - skip);
            let (now, later) = rest.split_at(n);
            let mut bytes = [0; 8];
            if n == 8 {
                bytes.copy_from_slice(now);
            } else {
                bytes = cell.load(Relaxed).to_ne_bytes();
                bytes[skip..skip + n].copy_from_slice(now);
            }
            cell.store(u64::from_ne_bytes(bytes), Relaxed);
            rest = later;
            at = at.wrapping_add(n as u32);
        }
    }

    /// The addresses of the lines of [`DIFFERENCE_LINE`] bytes in which it differs from `other`.
    #[cfg(all(feature = "compiler", any(target_arch = "x86_64", target_arch = "wasm32")))]
    pub(crate) fn changed_lines<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = u32> {
        let lines = |store: &'a Self| store.0.0.as_chunks::<{ DIFFERENCE_LINE / 8 }>().0;
        let differs = |(own, its): (&[AtomicU64], &[AtomicU64])| {
            let pairs = own.iter().zip(its);
            pairs.fold(0, |bits, (own, its)| bits | own.load(Relaxed) ^ its.load(Relaxed)) != 0
        };
        let pairs = lines(self).iter().zip(lines(other));
        let addresses = (0..).step_by(DIFFERENCE_LINE);
        addresses.zip(pairs).filter_map(move |(at, (own, its))| differs((own, its)).then_some(at))
    }

    /// All bytes of a local store that no other thread uses.
    #[cfg(all(feature = "compiler", any(target_arch = "x86_64", target_arch = "wasm32")))]
    pub(crate) fn as_bytes(&mut self) -> &[u8] {
        // SAFETY: the doublewords are `SIZE` initialised bytes, and the exclusive borrow keeps
        // others from writing them.
        unsafe { std::slice::from_raw_parts(self.as_ptr(), SIZE as usize) }
    }

    /// The address of local store in the host's memory: [`SIZE`] bytes that live as long as
    /// `self`. Writing there has the effect of a write that the PPE makes through its mapping.
    #[must_use]
    pub fn as_ptr(&self) -> *mut u8 {
        self.0.0.as_ptr().cast_mut().cast()
    }
}
