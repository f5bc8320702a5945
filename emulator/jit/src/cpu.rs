//! One SPU that runs units.

use std::sync::Arc;

use crate::compiler::CodeCache;
use crate::exit::Exit;
use crate::host::Context;
use crate::unit::Unit;

/// The number of words in local store. A unit can start at each of them.
const LOCAL_STORE_WORDS: usize = spu_isa::LOCAL_STORE_SIZE as usize / 4;

/// A passage through a unit: how many of its instructions ran until it was left, or until its
/// loop returned to the start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Passage {
    /// The unit's number.
    pub unit: u32,
    /// The number of instructions that ran, at least 1.
    pub count: u32,
}

/// The bits of a passage's word that hold the count, which is at most
/// [`MAX_STEPS`](crate::MAX_STEPS).
const COUNT_BITS: u32 = 8;

impl Passage {
    /// Encodes it as a word of the log.
    #[cfg(target_arch = "x86_64")]
    pub(crate) const fn to_word(self) -> u32 {
        self.unit << COUNT_BITS | self.count
    }

    /// Decodes it from a word of [`Cpu::log`].
    #[must_use]
    pub const fn from_word(word: u32) -> Self {
        Self { unit: word >> COUNT_BITS, count: word & ((1 << COUNT_BITS) - 1) }
    }
}

/// The memory that compiled code works on.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    /// 128 quadwords, aligned to 16 bytes. In each, the preferred word is first, and each word is
    /// in the host's byte order.
    pub registers: *mut u8,
    /// 256 KB, aligned to 16 bytes, in the SPU's byte order.
    pub local_store: *mut u8,
    /// For each quadword of local store, a byte with [`WATCH_LOADS`] and [`WATCH_STORES`]. Only
    /// units that [watch](crate::UnitOptions::watches) read them.
    pub watched: *const u8,
}

/// Units leave loads of the quadword to the interpreter.
pub const WATCH_LOADS: u8 = 1;
/// Units leave stores to the quadword to the interpreter.
pub const WATCH_STORES: u8 = 2;

/// The units that one SPU runs, and its state between them.
pub struct Cpu {
    context: Box<Context>,
    table: Box<[*const u8]>,
    entries: Box<[u32]>,
    log: Vec<u32>,
    logs: bool,
    // Keeps the code alive that the table points to.
    code: Arc<CodeCache>,
}

// SAFETY: the pointers lead to memory that the value owns, and to code that never changes and that
// `code` keeps alive.
unsafe impl Send for Cpu {}

impl Cpu {
    pub(crate) fn new(code: Arc<CodeCache>, units: usize, logs: bool) -> Self {
        let mut table = vec![code.exit_stub(); LOCAL_STORE_WORDS].into_boxed_slice();
        let mut entries = vec![0; units].into_boxed_slice();
        let context = Box::new(Context::new(table.as_mut_ptr(), entries.as_mut_ptr()));
        Self { context, table, entries, log: Vec::new(), logs, code }
    }

    /// The instructions that the last [`enter`](Self::enter) ran, if the code cache's units log
    /// them. Each [`Passage`] takes one word, and the targets of its hints by register follow it.
    #[must_use]
    pub fn log(&self) -> &[u32] {
        &self.log
    }

    /// Whether a unit is installed at `pc`.
    #[inline]
    #[must_use]
    pub fn has_unit(&self, pc: u32) -> bool {
        self.table[pc as usize / 4 % LOCAL_STORE_WORDS] != self.code.exit_stub()
    }

    /// Installs `unit` at its start address.
    ///
    /// # Panics
    ///
    /// If the unit is in another code cache.
    pub fn install(&mut self, unit: &Unit) {
        assert!(Arc::ptr_eq(unit.code_owner(), &self.code), "the unit is from another code cache");
        self.table[unit.start() as usize / 4 % LOCAL_STORE_WORDS] = unit.entry();
    }

    /// Removes the unit at `pc`, if there is one.
    pub fn remove(&mut self, pc: u32) {
        self.table[pc as usize / 4 % LOCAL_STORE_WORDS] = self.code.exit_stub();
    }

    /// How often the unit with this number was entered. Every iteration of a loop counts.
    #[must_use]
    pub fn entries(&self, unit: u32) -> u32 {
        self.entries[unit as usize]
    }

    /// Runs units from `pc` on, at most `budget` instructions. Returns why it ended, the program
    /// counter, and how many instructions ran.
    ///
    /// # Safety
    ///
    /// `storage` must be as [`Storage`] describes and valid during the call. Nobody else may
    /// access `registers`. Others may access local store, as the PPE and other SPEs do.
    pub unsafe fn enter(
        &mut self,
        storage: Storage,
        fpscr: &mut [u32; 4],
        pc: u32,
        budget: u32,
    ) -> (Exit, u32, u32) {
        let target = self.table[pc as usize / 4 % LOCAL_STORE_WORDS];
        let context = &mut *self.context;
        context.fpscr = *fpscr;
        context.pc = pc;
        context.budget = i64::from(budget);
        if self.logs {
            // A passage takes one word, and one more for each hint. It runs at least one
            // instruction, and hints are instructions too, so 2 words an instruction suffice.
            self.log.clear();
            self.log.reserve(2 * budget as usize);
            context.log = self.log.as_mut_ptr();
        }
        // SAFETY: the target belongs to this code cache, because the table holds no other code. The
        // context points to this value's own boxes, and to a log that has capacity for every
        // instruction of the budget. The caller guarantees the storage.
        let status = unsafe { self.code.call(storage, context, target) };
        *fpscr = context.fpscr;
        if self.logs {
            // SAFETY: the units have written the words up to this place, within the capacity.
            unsafe {
                let written = context.log.offset_from_unsigned(self.log.as_ptr());
                self.log.set_len(written);
            }
        }
        let exit = Exit::of(status, context.unit);
        let executed = i64::from(budget) - context.budget;
        (exit, context.pc, executed as u32)
    }
}
