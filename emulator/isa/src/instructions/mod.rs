//! The SPU's instruction set: one table, and the code that is derived from it.
//!
//! It depends neither on semantics nor on a machine. It converts words to [`Instruction`]s and
//! back.

mod class;
mod disassemble;
mod encoding;
mod format;
mod instruction;
mod op;
mod registers;
mod table;

pub use class::{Class, Pipe};
pub use disassemble::{Disassembly, disassemble};
pub use format::Format;
pub use instruction::{Instruction, feature};
pub use op::{Field, Machine, Op, Operand, Row, Target};
pub use registers::RegisterSet;
