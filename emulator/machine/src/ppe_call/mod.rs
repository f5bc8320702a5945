//! PPE-assisted library calls, which SPU programs make with `stop 0x21xx`.
//!
//! The word after the stop holds an opcode and the address of a block of argument cells.
//! [`Library`] carries the call out and writes the result to the block's first cell. The calls are
//! those of libspe2 (C99 streams, POSIX.1, memory in effective address space), which newlib's
//! functions use. This module does not depend on the SPU: it uses local store, and it uses the
//! host through [`Host`] and [`Heap`].
//!
//! If the guest makes a mistake that libspe2 would not catch (a file handle that is not open, a
//! null directory), the call fails with an error number instead.
//!
//! | classes | in |
//! |---|---|
//! | 0x2100 | `c99`, over `stream`, `print` and `scan` |
//! | 0x2101 | `posix` |
//! | 0x2104 (Linux system calls) | `linux` |
//! | 0x2105 | `libea` |
//!
//! [`Library`] and the classes depend on each other: the library finds the function that serves a
//! call in a class's table, and the function uses the library's state.

mod arena;
mod c99;
mod cpuinfo;
mod directive;
mod errno;
mod float_syntax;
mod guest;
mod host;
mod libea;
mod linux;
mod posix;
mod print;
mod scan;
mod scan_set;
mod stream;
mod va_list;
mod wide;

use std::sync::{Mutex, MutexGuard};

use thiserror::Error;

pub use arena::Arena;
pub use errno::Errno;
pub use guest::GuestMemory;
pub use host::{Heap, Host, Process};
pub use linux::{system_call_name, system_call_number};
pub use stream::Buffering;

use crate::lock::lock;
use guest::{Block, Guest, Reply};
use spu_isa::LIMIT_MASK;

/// Distance in bytes from the address that a call gets (that after the stop) to the address at
/// which the SPU continues.
pub const CALL_WORD: u32 = 4;

/// The low byte of the stop code of a Linux system call.
pub const SYSTEM_CALL: u8 = 4;

/// The library of a call: the low byte of its stop code.
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
    /// The class with this low byte of a stop code.
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

/// A call that no library serves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum CallError {
    /// No library has this class.
    #[error("library call of class {0:#04x} (stop {stop:#06x}), which does not exist", stop = 0x2100 + u16::from(*.0))]
    UnknownClass(u8),
    /// The library has no function with this opcode.
    #[error("library call {opcode} of class {class:?}, which has the opcodes 1 to {last}")]
    UnknownOpcode {
        /// The library.
        class: Class,
        /// The opcode of the call.
        opcode: u8,
        /// The last opcode of the library.
        last: usize,
    },
    /// The block of a system call does not lie in local store.
    #[error("system call (stop 0x2104) whose block at {0:#x} does not lie in local store")]
    OutsideLocalStore(u32),
}

/// A function of a library. Its opcode is its position in the class's table, counted from 1.
struct Call {
    name: &'static str,
    serve: fn(&Library, Block<'_>) -> Reply,
}

/// Makes a table of functions with their names in C.
macro_rules! calls {
    ($($name:ident => $serve:expr,)*) => {
        &[$(super::Call { name: stringify!($name), serve: $serve },)*]
    };
}
use calls;

/// The library that serves the calls of one program, with its open files, directories and
/// allocations. Several SPEs may call it at the same time: a call that waits keeps only the stream
/// that it waits for.
pub struct Library {
    host: Box<dyn Host>,
    heap: Mutex<Box<dyn Heap>>,
    streams: c99::Streams,
    directories: Mutex<posix::Directories>,
}

impl Library {
    /// A library with the three standard streams open.
    #[must_use]
    pub fn new(host: Box<dyn Host>, heap: Box<dyn Heap>) -> Self {
        let streams = c99::Streams::new(host.as_ref());
        Self { host, heap: Mutex::new(heap), streams, directories: Mutex::default() }
    }

    fn heap(&self) -> MutexGuard<'_, Box<dyn Heap>> {
        lock(&self.heap)
    }

    fn directories(&self) -> MutexGuard<'_, posix::Directories> {
        lock(&self.directories)
    }

    /// Carries out the call of class `number` whose opcode word is at `address`. The address is
    /// the SPU's next program counter; its lowest bit (interrupts enabled) is ignored. The SPU
    /// continues [`CALL_WORD`] bytes further.
    pub fn serve(
        &self,
        number: u8,
        memory: &dyn GuestMemory,
        address: u32,
    ) -> Result<(), CallError> {
        const OPCODE_SHIFT: u32 = 24;
        let guest = Guest(memory);
        let address = address & LIMIT_MASK & !1;
        if number == SYSTEM_CALL {
            return self.system_call(memory, address);
        }
        let word = guest.word(address);
        let class = Class::of(number).ok_or(CallError::UnknownClass(number))?;
        let opcode = (word >> OPCODE_SHIFT) as u8;
        let call = usize::from(opcode)
            .checked_sub(1)
            .and_then(|index| class.calls().get(index))
            .ok_or(CallError::UnknownOpcode { class, opcode, last: class.calls().len() })?;
        let block = Block { guest, address: word & LIMIT_MASK };
        block.put((call.serve)(self, block));
        Ok(())
    }

    /// Flushes the streams, as the end of a program does.
    pub fn flush(&self) -> Result<(), Errno> {
        self.streams.flush_all(self.host.as_ref())
    }
}
