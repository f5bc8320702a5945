//! An assembler for the Cell's SPU. It makes the bytes and relocations that the SPU binutils make.
//!
//! Mnemonics, operands and encodings come from the instruction table of [`spu_isa`].
//! [`assemble`] makes a [`Program`] of a source: sections, symbols, and relocations for a linker.
//! [`Program::link`] places one that needs no other files, and [`Linked::bytes`] can be loaded
//! into local store. [`Program::elf`] and [`Linked::elf`] make files for other tools.
//!
//! ```
//! let source = "
//!         .text
//!         .global _start
//! _start: ila     $3,numbers
//!         lqd     $4,0($3)
//!         ai      $4,$4,-1        # each word is one less
//!         stqd    $4,0($3)
//!         stop    0x2000
//!
//!         .data
//!         .balign 16
//! numbers: .long  4,3,2,1
//! ";
//! let program = spu_assembler::assemble("less.s", source)?.link(0x80)?;
//! assert_eq!(program.entry, 0x80);
//! assert_eq!(program.bytes[..4], [0x42, 0x00, 0x80, 0x03]); // ila $3,0x100
//! assert_eq!(program.bytes[0x80..0x84], [0, 0, 0, 4]);
//!
//! let errors = spu_assembler::assemble("wrong.s", " aii $3,$4,1\n").unwrap_err();
//! assert_eq!(
//!     errors.to_string(),
//!     "wrong.s:1:2: there is no instruction aii; did you mean ai?"
//! );
//! # Ok::<(), spu_assembler::Errors>(())
//! ```
//!
//! # The language
//!
//! It is that of the GNU assembler without its macros, conditions, repetitions and included files:
//! [`Errors::uses_macros`] is true of a source that needs those. Numbered subsections are missing,
//! too. Comments begin with `#` or `//`, or are between `/*` and `*/`. A register
//! may be named by a symbol: after `.set sum,5`, `$sum` and `$sum+1` are registers.

mod cursor;
mod diagnostic;
mod directive;
mod elf;
mod expression;
mod instruction;
mod lines;
mod link;
mod program;
mod source;
mod symbols;

pub use diagnostic::{Diagnostic, Errors, Position};
pub use link::Linked;
pub use program::{
    Binding, Place, Program, Relocation, RelocationKind, Section, Symbol, SymbolKind, Target,
};

/// Assembles a source. `file` is its name in messages.
///
/// # Errors
///
/// There is an error for each statement that can't be assembled.
pub fn assemble(file: &str, source: &str) -> Result<Program, Errors> {
    source::assemble(file, source)
}
