//! Why an SPU stopped.

use std::fmt;

/// The kind of access to a channel: read, write, or query of the count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChannelAccess {
    /// `rdch`
    Read,
    /// `wrch`
    Write,
    /// `rchcnt`
    Count,
}

/// Why the SPU stopped at [`Stopped::pc`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// `stop` or `stopd` (which reports 0x3fff), with its 14-bit code.
    Signal(u16),
    /// One of the halt instructions found its condition true.
    Halt,
    /// No instruction has this word's opcode.
    InvalidInstruction(u32),
    /// The channel does not exist, or does not allow this access.
    InvalidChannel(u8, ChannelAccess),
    /// The MFC refused a command or could not complete it.
    Dma(crate::mfc::DmaError),
    /// Another thread asked the SPU to stop.
    Requested,
    /// The SPU would sleep, but its thread also runs others ([`in_turn`](crate::in_turn)).
    Waits,
}

/// Why and where an SPU stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// The reason.
    pub reason: Stop,
    /// Address of the instruction that stopped the SPU. For [`Stop::Requested`] and [`Stop::Dma`],
    /// which are not precise, it is the address of the next instruction.
    pub pc: u32,
    /// Address at which the SPU continues when it is run again.
    pub npc: u32,
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pc = self.pc;
        match &self.reason {
            Stop::Signal(code) => write!(f, "stop {code:#06x} at {pc:#07x}"),
            Stop::Halt => write!(f, "halt at {pc:#07x}"),
            Stop::InvalidInstruction(word) => {
                write!(f, "invalid instruction {word:#010x} at {pc:#07x}")
            }
            Stop::InvalidChannel(channel, access) => {
                let access = match access {
                    ChannelAccess::Read => "rdch",
                    ChannelAccess::Write => "wrch",
                    ChannelAccess::Count => "rchcnt",
                };
                write!(f, "{access} is not possible on channel {channel} at {pc:#07x}")
            }
            Stop::Dma(error) => write!(f, "{error} (near {pc:#07x})"),
            Stop::Requested => write!(f, "stopped by request at {pc:#07x}"),
            Stop::Waits => write!(f, "waits for a channel at {pc:#07x}"),
        }
    }
}
