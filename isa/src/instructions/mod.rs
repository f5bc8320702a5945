//! The SPU's instruction set: one table, and what derives from it.
//!
//! It knows nothing of semantics or of the machine: words in, [`Instruction`]s out, and back.

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
