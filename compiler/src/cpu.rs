//! One SPU that runs units.

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
    // What the table points into.
    code: Arc<Code>,
}

// SAFETY: the pointers lead into what the value owns, and into code that is never changed and that
// `code` keeps.
unsafe impl Send for Cpu {}

impl Cpu {
    pub(crate) fn new(code: Arc<Code>, units: usize) -> Self {
        let mut table = vec![code.leave(); PLACES].into_boxed_slice();
        let mut entries = vec![0; units].into_boxed_slice();
        let context = Box::new(Context {
            fpscr: [0; 4],
            unread: [0; 4],
            table: table.as_mut_ptr().cast_const(),
            entries: entries.as_mut_ptr(),
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
            code,
        }
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
        // SAFETY: the trampoline is this compiler's, as is the target: the table has nothing else.
        // The context points to this value's own boxes, and the caller vouches for the storage.
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
