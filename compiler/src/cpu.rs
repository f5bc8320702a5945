//! One SPU that runs units.

use std::ptr;
use std::sync::Arc;

use crate::compiler::{Code, Unit};
use crate::host::{self, Context};

/// Words of local store: places where a unit can start.
const PLACES: usize = spu_isa::LOCAL_STORE_SIZE as usize / 4;

/// Why compiled code was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// No unit starts where the SPU is, or the budget does not suffice for the one that does.
    Left,
    /// The next instruction is the interpreter's.
    Interpret,
    /// The unit of this number can't go on from where the SPU is: the interpreter has to.
    Failed(u32),
    /// Local store no longer has the code of the unit of this number, which did nothing.
    Stale(u32),
}

impl Exit {
    pub(crate) const LEFT: u32 = 0;
    pub(crate) const INTERPRET: u32 = 1;
    pub(crate) const FAILED: u32 = 2;
    pub(crate) const STALE: u32 = 3;
}

/// A passage through a unit: its first instructions, up to where it was left or went round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Passage {
    /// The unit's number.
    pub unit: u32,
    /// Instructions that have run, at least 1.
    pub count: u32,
}

/// Bits of a passage's word for the count, which is at most [`MOST_STEPS`](crate::MOST_STEPS).
const COUNT_BITS: u32 = 8;

impl Passage {
    pub(crate) const fn new(unit: u32, count: u32) -> Self {
        Self { unit, count }
    }

    /// As it stands in the log.
    pub(crate) const fn to_word(self) -> u32 {
        self.unit << COUNT_BITS | self.count
    }

    /// From a word of [`Cpu::log`].
    #[must_use]
    pub const fn from_word(word: u32) -> Self {
        Self {
            unit: word >> COUNT_BITS,
            count: word & ((1 << COUNT_BITS) - 1),
        }
    }
}

/// What compiled code works on, each as it lies in memory.
#[derive(Clone, Copy, Debug)]
pub struct Storage {
    /// 128 quadwords, aligned to 16 bytes; in each the preferred word first, in the host's order.
    pub registers: *mut u8,
    /// 256 KB, aligned to 16 bytes; in the SPU's order.
    pub local_store: *mut u8,
}

/// Which units one SPU runs, and where it is between them.
pub struct Cpu {
    context: Box<Context>,
    table: Box<[*const u8]>,
    entries: Box<[u32]>,
    log: Vec<u32>,
    logs: bool,
    // What the table points into.
    code: Arc<Code>,
}

// SAFETY: the pointers lead into what the value owns, and into code that is never changed and that
// `code` keeps.
unsafe impl Send for Cpu {}

impl Cpu {
    pub(crate) fn new(code: Arc<Code>, units: usize, logs: bool) -> Self {
        let mut table = vec![code.leave(); PLACES].into_boxed_slice();
        let mut entries = vec![0; units].into_boxed_slice();
        let context = Box::new(Context {
            fpscr: [0; 4],
            unread: [0; 4],
            table: table.as_mut_ptr().cast_const(),
            entries: entries.as_mut_ptr(),
            log: ptr::null_mut(),
            budget: 0,
            pc: 0,
            unit: 0,
            mxcsr: 0,
            host_mxcsr: 0,
        });
        Self {
            context,
            table,
            entries,
            log: Vec::new(),
            logs,
            code,
        }
    }

    /// What the last [`enter`](Self::enter) ran, if the compiler's units write it down: for each
    /// [`Passage`] a word, followed by the targets of the hints by a register among its
    /// instructions.
    #[must_use]
    pub fn log(&self) -> &[u32] {
        &self.log
    }

    /// Whether some unit is to run at `pc`.
    #[inline]
    #[must_use]
    pub fn has(&self, pc: u32) -> bool {
        self.table[pc as usize / 4 % PLACES] != self.code.leave()
    }

    /// From now on `unit` runs where it starts.
    ///
    /// # Panics
    ///
    /// If the unit is of another compiler.
    pub fn install(&mut self, unit: &Unit) {
        assert!(
            Arc::ptr_eq(unit.code_owner(), &self.code),
            "a unit of another compiler"
        );
        self.table[unit.start() as usize / 4 % PLACES] = unit.entry();
    }

    /// From now on nothing runs at `pc`.
    pub fn remove(&mut self, pc: u32) {
        self.table[pc as usize / 4 % PLACES] = self.code.leave();
    }

    /// How often the unit of this number was entered, each time round a loop counted.
    #[must_use]
    pub fn entries(&self, unit: u32) -> u32 {
        self.entries[unit as usize]
    }

    /// Runs units from `pc` on, at most `budget` instructions. Gives why it ended, where the SPU
    /// is, and how many instructions ran.
    ///
    /// # Safety
    ///
    /// `storage` is as [`Storage`] says, valid during the call, and `registers` reached by nobody
    /// else. Others may reach local store, as peers of an SPU do.
    pub unsafe fn enter(
        &mut self,
        storage: Storage,
        fpscr: &mut [u32; 4],
        pc: u32,
        budget: u32,
    ) -> (Exit, u32, u32) {
        let target = self.table[pc as usize / 4 % PLACES];
        let context = &mut *self.context;
        context.fpscr = *fpscr;
        context.pc = pc;
        context.budget = i64::from(budget);
        if self.logs {
            // A passage takes a word, and one more for each hint, and has run as many instructions.
            self.log.clear();
            self.log.reserve(2 * budget as usize);
            context.log = self.log.as_mut_ptr();
        }
        // SAFETY: the trampoline is this compiler's, as is the target: the table has nothing else.
        // The context points to this value's own boxes, and to a log with room for all that the
        // budget lets run. The caller vouches for the storage.
        let status = unsafe {
            host::call(
                self.code.trampoline(),
                storage.registers,
                storage.local_store,
                context,
                target,
            )
        };
        *fpscr = context.fpscr;
        if self.logs {
            // SAFETY: the units have written the words up to this place, within the capacity.
            unsafe {
                let written = context.log.offset_from_unsigned(self.log.as_ptr());
                self.log.set_len(written);
            }
        }
        let exit = match status {
            Exit::LEFT => Exit::Left,
            Exit::INTERPRET => Exit::Interpret,
            Exit::FAILED => Exit::Failed(context.unit),
            _ => Exit::Stale(context.unit),
        };
        let executed = i64::from(budget) - context.budget;
        (exit, context.pc, executed as u32)
    }
}
