//! Exit statuses for programs that fail.

use std::process::ExitCode;

use spu_emulator::stop::Stop;

use crate::failure::{BAD_ELF, USAGE};

/// Numbers that no well-behaved program uses itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    Differs = 119,
    Halt = 120,
    InvalidInstruction = 121,
    InvalidChannel = 122,
    Dma = 123,
    UnknownStop = 124,
    Limit = 125,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(status as u8)
    }
}

impl From<&Stop> for Status {
    fn from(reason: &Stop) -> Self {
        match reason {
            Stop::Halt => Self::Halt,
            Stop::InvalidInstruction(_) => Self::InvalidInstruction,
            Stop::InvalidChannel(..) => Self::InvalidChannel,
            Stop::Dma(_) => Self::Dma,
            Stop::Signal(_) => Self::UnknownStop,
            Stop::Requested | Stop::Waits => Self::Limit,
        }
    }
}

/// The table of exit statuses for `--help`.
pub fn help() -> String {
    let meanings = [
        (Status::Differs as u8, "--check found that the two ways of counting cycles differ"),
        (Status::Halt as u8, "halt"),
        (Status::InvalidInstruction as u8, "invalid instruction"),
        (Status::InvalidChannel as u8, "invalid channel"),
        (Status::Dma as u8, "DMA error"),
        (Status::UnknownStop as u8, "unknown stop code, or library call without a handler"),
        (Status::Limit as u8, "instruction limit reached, or the program sleeps for ever"),
        (BAD_ELF, "not an SPU program"),
        (USAGE, "wrong usage, or a file that can't be read or written"),
    ];
    let lines = meanings.map(|(status, meaning)| format!("  {status}    {meaning}\n"));
    format!(
        "Exit status:\n  0-255  the program's own: the low byte of its stop 0x20xx\n{}\
         A status from 119 on that is not the program's own comes with a message on standard error.",
        lines.concat()
    )
}
