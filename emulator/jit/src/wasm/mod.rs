//! Translates traces to WebAssembly modules, each with one function, for a program that is
//! WebAssembly itself.
//!
//! A unit works on the program's own memory, and finds other units and the program's functions in
//! the program's table. Registers are locals while it runs, and it writes the changed ones back
//! where it exits. WebAssembly has neither rounding modes nor exception flags. So singles are
//! computed in doubles, where a product is exact, and a sum whose rounding may have reached a
//! single is corrected by its exact error (Knuth's two-sum). Each operation tests its operands and
//! results, before it changes anything: where a lane is not what IEEE has it to be, the unit fails
//! at this instruction, or has the interpreter run it if [`FloatMode::in_doubles`] contains it.

mod branch;
mod emitter;
mod integer;
mod memory;
mod operation;
mod shift_rotate;
mod singles;

use wasm_encoder::{
    CodeSection, EntityType, ExportKind, ExportSection, Function, FunctionSection, ImportSection,
    MemoryType, Module, RefType, TableType, TypeSection, ValType,
};

use crate::float_mode::FloatMode;
use crate::trace::Trace;
use emitter::Emitter;

/// Offsets of the fields that a unit shares with its caller.
pub mod field {
    /// The FPSCR, which a unit changes only by the interpreter.
    pub const FPSCR: u32 = 0;
    /// The address of the table of units: for each word of local store, the number of the function
    /// in the program's table that continues there.
    pub const TABLE: u32 = 16;
    /// The address of the number of entries of each unit.
    pub const ENTRIES: u32 = 20;
    /// The 64-bit number of instructions that may still run.
    pub const BUDGET: u32 = 24;
    /// The program counter.
    pub const PC: u32 = 32;
    /// The number of the unit that failed or was stale.
    pub const UNIT: u32 = 36;
}

/// The parts of the program that units use.
#[derive(Clone, Copy, Debug)]
pub struct Places {
    /// The address of the table of `frest`.
    pub reciprocal: u32,
    /// The address of the table of `frsqest`.
    pub reciprocal_root: u32,
    /// The place in the program's table of the function that runs an instruction word on registers
    /// and FPSCR. Its arguments are the addresses of both and the word.
    pub interpret: u32,
    /// The address of the trace's words in the SPU's byte order: those of [`Trace::code`].
    pub code: u32,
}

/// The module from which units import, and the unit's name in its own module.
pub const IMPORTS: &str = "program";
/// See [`IMPORTS`].
pub const UNIT: &str = "unit";

/// The types of units and of [`Places::interpret`], by their positions in a module.
const UNIT_TYPE: u32 = 0;
const INTERPRET_TYPE: u32 = 1;

/// The bytes of the module of a trace. It imports `memory` and `table`.
///
/// The unit's arguments are the addresses of registers, local store and shared [`field`]s, the
/// budget and the program counter. Its result is the reason for the exit.
#[must_use]
pub fn module(trace: &Trace, mode: &FloatMode, number: u32, places: Places) -> Vec<u8> {
    let mut types = TypeSection::new();
    types.ty().function([ValType::I32; 5], [ValType::I32]);
    types.ty().function([ValType::I32; 3], []);
    let mut imports = ImportSection::new();
    let memory = MemoryType {
        minimum: 0,
        maximum: None,
        memory64: false,
        shared: false,
        page_size_log2: None,
    };
    imports.import(IMPORTS, "memory", EntityType::Memory(memory));
    let table = TableType {
        element_type: RefType::FUNCREF,
        minimum: 0,
        maximum: None,
        table64: false,
        shared: false,
    };
    imports.import(IMPORTS, "table", EntityType::Table(table));
    let mut functions = FunctionSection::new();
    functions.function(UNIT_TYPE);
    let mut exports = ExportSection::new();
    exports.export(UNIT, ExportKind::Func, 0);
    let (locals, body) = Emitter::new(trace, mode, number, places).emit();
    let mut function = Function::new(locals);
    function.raw(body);
    let mut code = CodeSection::new();
    code.function(&function);
    let mut module = Module::new();
    module.section(&types).section(&imports).section(&functions).section(&exports).section(&code);
    module.finish()
}
