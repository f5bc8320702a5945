//! PPE-assisted library calls: what SPU programs ask of the PPE by `stop 0x21xx`.
//!
//! The word after the stop holds an opcode and the address of a block of argument cells;
//! [`Library`] carries the call out and puts the result into the block's first cell. The calls are
//! those of libspe2 (C99 streams, POSIX.1, memory in effective address space), which newlib's
//! functions use. Nothing here knows the SPU: it sees local store, and the host through
//! [`Outside`] and [`Heap`].
//!
//! Where libspe2 takes a guest's mistake for its own (a file handle that is not open, a null
//! directory), the call fails with an error number instead.
//!
//! | classes | in |
//! |---|---|
//! | 0x2100 | `c99`, over `stream`, `print` and `scan` |
//! | 0x2101 | `posix` |
//! | 0x2105 | `libea` |
//!
//! [`Library`] and the classes know each other: it finds the function that serves a call in a
//! class's table, and the function works on what the library holds.

mod arena;
mod c99;
mod directive;
mod errno;
mod float_syntax;
mod guest;
mod libea;
mod number;
mod outside;
mod posix;
mod print;
mod scan;
mod stream;
mod va_list;

use thiserror::Error;

pub use arena::Arena;
pub use errno::Errno;
pub use guest::GuestMemory;
pub use outside::{Heap, Outside, Process};

use guest::{Block, Guest, Reply};
use spu_isa::LIMIT_MASK;

/// Bytes from the address that a call gets (that after the stop) to where the SPU goes on.
pub const CALL_WORD: u32 = 4;

/// Which library a call is for: the low byte of its stop code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// C99's streams: stop 0x2100.
    C99,
    /// POSIX.1: stop 0x2101.
    Posix,
    /// Memory in effective address space: stop 0x2105.
    Libea,
}

impl Class {
    /// The class of a stop code's low byte.
    #[must_use]
    pub fn of(number: u8) -> Option<Self> {
        match number {
            0 => Some(Self::C99),
            1 => Some(Self::Posix),
            5 => Some(Self::Libea),
            _ => None,
        }
    }

    fn calls(self) -> &'static [Call] {
        match self {
            Self::C99 => c99::CALLS,
            Self::Posix => posix::CALLS,
            Self::Libea => libea::CALLS,
        }
    }

    /// The name of the function with this opcode.
    #[must_use]
    pub fn function(self, opcode: u8) -> Option<&'static str> {
        let index = usize::from(opcode).checked_sub(1)?;
        self.calls().get(index).map(|call| call.name)
    }
}

/// A call that nobody serves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum CallError {
    /// No library has this class.
    #[error("library call of class {0:#04x} (stop {stop:#06x}), which nobody serves", stop = 0x2100 + u16::from(*.0))]
    UnknownClass(u8),
    /// The library has no function with this opcode.
    #[error("library call {opcode} of class {class:?}, which has the opcodes 1 to {last}")]
    UnknownOpcode {
        /// The library.
        class: Class,
        /// What the guest asked for.
        opcode: u8,
        /// The last opcode that there is.
        last: usize,
    },
}

/// A function of a library; its opcode is its place in the class's table, counted from 1.
struct Call {
    name: &'static str,
    serve: fn(&mut Library, Block<'_>) -> Reply,
}

/// Names a table's functions as C does.
macro_rules! calls {
    ($($name:ident => $serve:expr,)*) => {
        &[$(super::Call { name: stringify!($name), serve: $serve },)*]
    };
}
use calls;

/// What serves the calls of one program: its open files, directories and allocations.
pub struct Library {
    outside: Box<dyn Outside>,
    heap: Box<dyn Heap>,
    streams: c99::Streams,
    directories: posix::Directories,
}

impl Library {
    /// A library with the three standard streams open.
    #[must_use]
    pub fn new(mut outside: Box<dyn Outside>, heap: Box<dyn Heap>) -> Self {
        let streams = c99::Streams::new(outside.as_mut());
        Self {
            outside,
            heap,
            streams,
            directories: posix::Directories::default(),
        }
    }

    /// Carries out the call of class `number` whose opcode word is at `address`: the SPU's next
    /// program counter, of which the lowest bit (interrupts enabled) does not count. The SPU goes
    /// on [`CALL_WORD`] bytes further.
    pub fn serve(
        &mut self,
        number: u8,
        memory: &dyn GuestMemory,
        address: u32,
    ) -> Result<(), CallError> {
        const OPCODE_SHIFT: u32 = 24;
        let guest = Guest(memory);
        let word = guest.word(address & LIMIT_MASK & !1);
        let class = Class::of(number).ok_or(CallError::UnknownClass(number))?;
        let opcode = (word >> OPCODE_SHIFT) as u8;
        let call = usize::from(opcode)
            .checked_sub(1)
            .and_then(|index| class.calls().get(index))
            .ok_or(CallError::UnknownOpcode {
                class,
                opcode,
                last: class.calls().len(),
            })?;
        let block = Block {
            guest,
            address: word & LIMIT_MASK,
        };
        block.put((call.serve)(self, block));
        Ok(())
    }

    /// Writes out what the streams still hold, as a program's end does.
    pub fn flush(&mut self) -> Result<(), Errno> {
        self.streams.flush_all(self.outside.as_mut())
    }
}
