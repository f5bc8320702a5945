//! Why a source can't be scheduled.

use thiserror::Error;

use crate::code::CodeError;

/// Why a source can't be scheduled.
#[derive(Debug, Error)]
pub enum ScheduleError {
    /// The object can't be read.
    #[error(transparent)]
    Object(#[from] CodeError),
    /// A linked program.
    #[error("not an object: give what the assembler writes, before it is linked")]
    Linked,
    /// No line table.
    #[error("no line table: assemble with -g")]
    NoLines,
    /// The object is not the source's.
    #[error("the object's line table does not name {0}")]
    NotInTable(String),
    /// The assembler refuses the schedule.
    #[error("the schedule does not assemble: {0}")]
    Assembler(Box<dyn std::error::Error + Send + Sync>),
    /// No function of the object stands in the source.
    #[error("no function: the source has no `function NAME`, or the object no such symbol")]
    NoFunction,
    /// Something at a line of the source.
    #[error("{file}:{line}: {what}")]
    At {
        /// The source, as named by the caller.
        file: String,
        /// Its line, from 1.
        line: u64,
        /// What is wrong there.
        what: Unschedulable,
    },
}

/// What can't be scheduled.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Unschedulable {
    /// A word that is no instruction.
    #[error("the word {0:#010x} is no instruction: data can't stand inside a function")]
    Word(u32),
    /// An instruction that the assembler has no notation for.
    #[error(
        "the word {0:#010x} can't be written as an instruction: it has reserved bits set, or a constant that none takes"
    )]
    Notation(u32),
    /// A hint in the plain source.
    #[error("a branch hint: the scheduler places them itself")]
    Hint,
    /// A relocation that the assembler has no plain notation for.
    #[error("relocation of type {0}, which can't be written down again")]
    Relocation(u32),
    /// A branch or address into the function that is not the start of an instruction's block.
    #[error("it names {0:#x}, where nothing has a name")]
    Address(u32),
    /// A directive that would be lost.
    #[error("directive {0} inside a function would be lost; move it out")]
    Directive(String),
    /// The function does not start on a pair.
    #[error("function {0} does not start at a multiple of 8: put .align 3 before it")]
    Alignment(String),
    /// The start without the end.
    #[error("function {0} has no `endfunction` or `.size` behind it")]
    NoEnd(String),
    /// No register for a test that the schedule needs.
    #[error("no register of $2 to $79 is free here")]
    NoRegister,
    /// A fault of the scheduler: the schedule does not have the plain code's instructions.
    #[error("fault of the scheduler: of `{instruction}` the schedule has {found}, not {expected}")]
    Miscounted {
        /// The plain instruction.
        instruction: String,
        /// How many of it the schedule should have.
        expected: usize,
        /// How many it has.
        found: usize,
    },
    /// A fault of the scheduler: an instruction that neither the plain code has nor a schedule
    /// needs.
    #[error("fault of the scheduler: `{0}` is not the plain code's")]
    Foreign(String),
    /// A fault of the scheduler: its text says something else than it means.
    #[error("fault of the scheduler: its text assembles to `{found}`, where it means `{meant}`")]
    Miswritten {
        /// What it means.
        meant: String,
        /// What the assembler makes of it.
        found: String,
    },
}
