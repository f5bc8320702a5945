//! Exit statuses of programs that go wrong.

use std::process::ExitCode;

use spu_emulator::stop::Stop;

use crate::failure::{BAD_ELF, USAGE};

/// Numbers that no well-behaved program uses for itself.
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
            Stop::Requested => Self::Limit,
        }
    }
}

/// The table for `--help`.
pub fn help() -> String {
    let meanings = [
        (
            Status::Differs as u8,
            "--check has found the two ways of counting cycles to differ",
        ),
        (Status::Halt as u8, "halt"),
        (Status::InvalidInstruction as u8, "invalid instruction"),
        (Status::InvalidChannel as u8, "invalid channel"),
        (Status::Dma as u8, "DMA error"),
        (
            Status::UnknownStop as u8,
            "stop code that means nothing, or library call that nobody serves",
        ),
        (
            Status::Limit as u8,
            "instruction limit reached, or the program sleeps for ever",
        ),
        (BAD_ELF, "not an SPU program"),
        (
            USAGE,
            "wrong usage, or a file that can't be read or written",
        ),
    ];
    let lines = meanings.map(|(status, meaning)| format!("  {status}    {meaning}\n"));
    format!(
        "Exit status:\n  0-255  of the program: the low byte of its stop 0x20xx\n{}\
         Those from 119 on that are not the program's own are named on standard error.",
        lines.concat()
    )
}
