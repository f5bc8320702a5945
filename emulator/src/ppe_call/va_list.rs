//! The SPU's `va_list`: where the variadic arguments of a call lie.
//!
//! Each argument is a register's image in a cell of its own, its value at the cell's start. Those
//! that came in registers were saved in a row; the rest lies beyond the caller's frame header.

use super::guest::{CELL, Guest};

/// Bytes of the frame header between the saved registers and the arguments on the stack.
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
