//! Why a source can't be scheduled.

use thiserror::Error;

use crate::code::CodeError;

/// Why a source can't be scheduled.
#[derive(Debug, Error)]
pub enum ScheduleError {
    /// The object can't be read.
    #[error(transparent)]
    Object(#[from] CodeError),
    /// The input is a linked program.
    #[error("not an object: pass the assembler's output before it is linked")]
    Linked,
    /// The object has no line table.
    #[error("no line table: assemble with -g")]
    NoLines,
    /// The object was not made from this source.
    #[error("the object's line table does not name {0}")]
    NotInTable(String),
    /// The assembler rejects the schedule.
    #[error("the schedule does not assemble: {0}")]
    Assembler(Box<dyn std::error::Error + Send + Sync>),
    /// The source contains no function of the object.
    #[error("no function: the source has no `function NAME`, or the object has no such symbol")]
    NoFunction,
    /// An error at a line of the source.
    #[error("{file}:{line}: {what}")]
    At {
        /// The source, under the name that the caller used.
        file: String,
        /// The line number in it, from 1.
        line: u64,
        /// The error there.
        what: Unschedulable,
    },
}

/// Code that can't be scheduled.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Unschedulable {
    /// A word that is not an instruction.
    #[error("the word {0:#010x} is not an instruction: a function can't contain data")]
    Word(u32),
    /// An instruction that has no assembly notation.
    #[error(
        "the word {0:#010x} can't be written as an instruction: it has reserved bits set, or a constant that no instruction takes"
    )]
    Notation(u32),
    /// A hint in the plain source.
    #[error("a branch hint: remove it, because the scheduler inserts hints itself")]
    Hint,
    /// A relocation that has no plain assembly notation.
    #[error("relocation of type {0}, which has no assembly notation")]
    Relocation(u32),
    /// A branch or address into the function that is not the start of a block.
    #[error("it refers to {0:#x}, where there is no label")]
    Address(u32),
    /// A directive that would be lost.
    #[error("directive {0} inside a function would be lost; move it out")]
    Directive(String),
    /// The function does not start on a pair.
    #[error("function {0} does not start at a multiple of 8: put .align 3 before it")]
    Alignment(String),
    /// A function without an end.
    #[error("function {0} has no `endfunction` or `.size` after it")]
    NoEnd(String),
    /// No register is free for a test that the schedule needs.
    #[error("no register of $2 to $79 is free here")]
    NoRegister,
    /// A fault of the scheduler: the schedule does not have all the instructions of the plain
    /// code.
    #[error(
        "fault of the scheduler: the schedule has `{instruction}` {found} times, not {expected}"
    )]
    Miscounted {
        /// The plain instruction.
        instruction: String,
        /// How often the schedule should contain it.
        expected: usize,
        /// How often it does.
        found: usize,
    },
    /// A fault of the scheduler: an instruction that is not in the plain code and that no schedule
    /// needs.
    #[error("fault of the scheduler: `{0}` is not in the plain code")]
    Foreign(String),
    /// A fault of the scheduler: its text assembles to another instruction than it should.
    #[error("fault of the scheduler: its text assembles to `{found}` instead of `{meant}`")]
    Miswritten {
        /// The intended instruction.
        meant: String,
        /// The instruction that the assembler made.
        found: String,
    },
}
