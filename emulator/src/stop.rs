//! Why an SPU stopped: a value, never a panic.

use std::fmt;

/// Whether a channel was read, written, or asked for its count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChannelAccess {
    /// `rdch`
    Read,
    /// `wrch`
    Write,
    /// `rchcnt`
    Count,
}

/// What ended the instruction at [`Stopped::pc`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// `stop` or `stopd` (which reports 0x3fff), with its 14-bit code.
    Signal(u16),
    /// One of the halt instructions found its condition true.
    Halt,
    /// No instruction has this word's opcode.
    InvalidInstruction(u32),
    /// The channel does not exist, or not in this direction.
    InvalidChannel(u8, ChannelAccess),
    /// The MFC refused or could not finish a command.
    Dma(crate::mfc::DmaError),
    /// Somebody outside asked the SPU to stop.
    Requested,
}

/// A stop and where it happened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// What happened.
    pub reason: Stop,
    /// Address of the instruction that stopped the SPU (for [`Stop::Requested`] and
    /// [`Stop::Dma`], which are not precise: of the next one).
    pub pc: u32,
    /// Where the SPU goes on when it is run again.
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
                write!(
                    f,
                    "{access} of channel {channel}, which has no such access, at {pc:#07x}"
                )
            }
            Stop::Dma(error) => write!(f, "{error} (near {pc:#07x})"),
            Stop::Requested => write!(f, "stopped from outside at {pc:#07x}"),
        }
    }
}
