//! The SPU's `va_list`, which gives access to the variadic arguments of a call.
//!
//! Each argument is a register's image in its own cell, with the value at the start of the cell.
//! The arguments that were passed in registers are saved one after another. The others are beyond
//! the caller's frame header.

use super::guest::{CELL, Guest};

/// Size in bytes of the frame header between the saved registers and the arguments on the stack.
const FRAME_HEADER: u32 = 32;

pub(super) struct VaList<'a> {
    guest: Guest<'a>,
    next: u32,
    caller_stack: u32,
}

impl<'a> VaList<'a> {
    /// The list whose two cells start at `address`.
    pub fn at(guest: Guest<'a>, address: u32) -> Self {
        Self {
            guest,
            next: guest.word(address),
            caller_stack: guest.word(address.wrapping_add(CELL)),
        }
    }

    fn cell(&mut self) -> u32 {
        let here = if self.next == self.caller_stack {
            self.next.wrapping_add(FRAME_HEADER)
        } else {
            self.next
        };
        self.next = here.wrapping_add(CELL);
        here
    }

    pub fn word(&mut self) -> u32 {
        let cell = self.cell();
        self.guest.word(cell)
    }

    pub fn doubleword(&mut self) -> u64 {
        let cell = self.cell();
        self.guest.doubleword(cell)
    }
}
