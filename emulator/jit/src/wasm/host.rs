//! The data that units share with the program, and the functions of the page that make units.

use std::mem::offset_of;

use crate::exit::Exit;
use crate::wasm::field;

/// The data that units share with their caller, at the offsets of [`field`].
#[repr(C, align(16))]
pub(crate) struct Context {
    pub fpscr: [u32; 4],
    pub table: *const *const u8,
    pub entries: *mut u32,
    pub budget: i64,
    pub pc: u32,
    pub unit: u32,
    /// Never used, because units log nothing.
    pub log: *mut u32,
}

const _: () = {
    assert!(offset_of!(Context, fpscr) == field::FPSCR as usize);
    assert!(offset_of!(Context, table) == field::TABLE as usize);
    assert!(offset_of!(Context, entries) == field::ENTRIES as usize);
    assert!(offset_of!(Context, budget) == field::BUDGET as usize);
    assert!(offset_of!(Context, pc) == field::PC as usize);
    assert!(offset_of!(Context, unit) == field::UNIT as usize);
};

impl Context {
    /// The data of an SPU's units, with its table and its numbers of entries.
    pub fn new(table: *mut *const u8, entries: *mut u32) -> Self {
        let log = std::ptr::null_mut();
        Self { fpscr: [0; 4], table, entries, budget: 0, pc: 0, unit: 0, log }
    }
}

/// A unit, as the page makes it of a module of [`crate::wasm::module`].
pub(crate) type Function = unsafe extern "C" fn(*mut u8, *mut u8, *mut Context, u32, u32) -> u32;

#[link(wasm_import_module = "spu_jit")]
unsafe extern "C" {
    /// Makes an instance of a module, whose imports are this program's memory and table. Puts its
    /// unit into the table and returns the place, or 0 if that fails.
    fn compile(module: *const u8, length: usize) -> *const u8;

    /// Removes a unit from the table.
    fn release(unit: *const u8);
}

/// The function of a module.
pub(crate) fn make(module: &[u8]) -> Option<*const u8> {
    // SAFETY: the page only reads the module.
    let unit = unsafe { compile(module.as_ptr(), module.len()) };
    (!unit.is_null()).then_some(unit)
}

/// Removes a function that [`make`] returned, and that nobody calls again.
pub(crate) fn remove(unit: *const u8) {
    // SAFETY: the place is in the table, and other functions are in other places.
    unsafe { release(unit) };
}

/// The function that leaves units. Tables hold it for every address without a unit.
pub(crate) unsafe extern "C" fn leave(
    _registers: *mut u8,
    _local_store: *mut u8,
    context: *mut Context,
    budget: u32,
    pc: u32,
) -> u32 {
    // SAFETY: units pass on their caller's context, which is valid during the call.
    let context = unsafe { &mut *context };
    (context.budget, context.pc) = (budget.into(), pc);
    Exit::LEFT
}
