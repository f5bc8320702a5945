//! Compiles traces to units, and owns them.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};

use crate::cpu::{Cpu, Storage};
use crate::float_mode::FloatMode;
use crate::host::{self, Context, Function};
use crate::trace::Trace;
use crate::unit::{Estimates, MAX_UNITS, Tier, Unit, UnitOptions};
use crate::wasm::{Places, module};

/// Runs an instruction word, which uses registers only, on 128 registers and an FPSCR.
pub type Interpret = unsafe extern "C" fn(*mut [u32; 4], *mut [u32; 4], u32);

/// A function, with the code of its trace, which it reads.
type Made = (*const u8, Box<[u8]>);

/// All units.
pub struct CodeCache {
    estimates: Estimates,
    interpret: Interpret,
    units: Mutex<Vec<Made>>,
    next_unit: AtomicU32,
    /// Kept, because a function may have several addresses.
    exit_stub: *const u8,
}

// SAFETY: the pointers are places in the program's table, and only `Drop` removes what is there.
unsafe impl Send for CodeCache {}
// SAFETY: as above.
unsafe impl Sync for CodeCache {}

impl CodeCache {
    /// Creates an empty cache. Returns `None` for options that units have only on x86-64.
    #[must_use]
    pub fn new(
        estimates: Estimates,
        interpret: Interpret,
        options: UnitOptions,
    ) -> Option<Arc<Self>> {
        let cache = || Self {
            estimates,
            interpret,
            units: Mutex::default(),
            next_unit: AtomicU32::new(0),
            exit_stub: host::leave as Function as *const u8,
        };
        (options == UnitOptions::default()).then(|| Arc::new(cache()))
    }

    /// Creates an SPU that can run units of this cache.
    #[must_use]
    pub fn new_cpu(self: &Arc<Self>) -> Cpu {
        Cpu::new(Arc::clone(self), MAX_UNITS, false)
    }

    /// Runs the function at `target`, and returns the reason for its exit.
    ///
    /// # Safety
    ///
    /// `target` must be a unit of this cache or the exit stub. `storage` and what the context
    /// points to must be valid for the call.
    pub(crate) unsafe fn call(
        &self,
        storage: Storage,
        context: &mut Context,
        target: *const u8,
    ) -> u32 {
        let (budget, pc) = (context.budget as u32, context.pc);
        // SAFETY: the caller guarantees that it is such a function, and its arguments.
        unsafe {
            let function = std::mem::transmute::<*const u8, Function>(target);
            function(storage.registers, storage.local_store, context, budget, pc)
        }
    }

    /// The function that leaves units.
    pub(crate) fn exit_stub(&self) -> *const u8 {
        self.exit_stub
    }
}

impl Drop for CodeCache {
    fn drop(&mut self) {
        let units = self.units.get_mut().unwrap_or_else(PoisonError::into_inner);
        // Every `Unit` and `Cpu` that could call one has a reference to this value.
        units.iter().for_each(|&(unit, _)| host::remove(unit));
    }
}

/// Compiles traces to units.
pub struct Compiler {
    code: Arc<CodeCache>,
    tier: Tier,
}

impl Compiler {
    /// Creates a compiler that adds units to this cache. Browsers optimize WebAssembly by
    /// themselves, so a tier makes no difference.
    #[must_use]
    pub fn new(code: &Arc<CodeCache>, tier: Tier) -> Self {
        Self { code: Arc::clone(code), tier }
    }

    /// Compiles a trace. Returns `None` if there are too many units, or the page makes none.
    pub fn compile(&mut self, trace: Trace, mode: FloatMode) -> Option<Unit> {
        let code = Arc::clone(&self.code);
        let next = |number| Some(number + 1).filter(|&count| count as usize <= MAX_UNITS);
        let number = code.next_unit.fetch_update(Relaxed, Relaxed, next).ok()?;
        let words = trace.code().flat_map(u32::to_be_bytes).collect::<Box<[u8]>>();
        let Estimates { reciprocal, reciprocal_root } = code.estimates;
        let places = Places {
            reciprocal: reciprocal.as_ptr() as u32,
            reciprocal_root: reciprocal_root.as_ptr() as u32,
            interpret: code.interpret as usize as u32,
            code: words.as_ptr() as u32,
        };
        let entry = host::make(&module(&trace, &mode, number, places))?;
        code.units.lock().unwrap_or_else(PoisonError::into_inner).push((entry, words));
        Some(Unit { number, trace, mode, tier: self.tier, has_fallback: true, entry, code })
    }
}
