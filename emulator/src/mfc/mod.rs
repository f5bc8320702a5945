//! The memory flow controller: queues, tags, lists, atomic lines.

pub(crate) mod command;
pub(crate) mod interconnect;
pub(crate) mod queue;
pub(crate) mod spu_side;

pub use command::{MAX_TRANSFER, TAGS};
pub use interconnect::Interconnect;

use thiserror::Error;

/// Commands that the SPU's queue holds.
pub const SPU_QUEUE_DEPTH: usize = 16;
/// Commands that the proxy queue holds.
pub const PROXY_QUEUE_DEPTH: usize = 8;

/// When a queued command is carried out, of all the moments that the architecture allows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Policy {
    /// As soon as its ordering lets it, oldest first.
    #[default]
    AtOnce,
    /// An adversary, which shows missing waits, fences and parameters: only when the program waits
    /// for a tag (or asks a second time for its status), when the queue is full, when the SPU has
    /// slept for some milliseconds, or when it stops; newest first where the order is free; and the
    /// command's parameters don't outlive it.
    AtLast,
}

/// Why the MFC refused or could not finish a command. The kinds are those that Linux tells a program
/// (alignment, invalid command, storage); the fields say which command it was.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DmaError {
    /// Sizes or addresses that the architecture does not allow.
    #[error(
        "DMA alignment: {what} (command {command:#04x}, local store {lsa:#07x}, effective address {ea:#x}, {size} bytes)"
    )]
    Alignment {
        /// Which rule was broken.
        what: &'static str,
        /// Command opcode.
        command: u8,
        /// Local-store address.
        lsa: u32,
        /// Effective address.
        ea: u64,
        /// Bytes asked for.
        size: u32,
    },
    /// An opcode or tag that does not exist, or a command that this queue does not take.
    #[error("invalid DMA command {command:#x}: {what}")]
    InvalidCommand {
        /// Which rule was broken.
        what: &'static str,
        /// Command opcode, with whatever stood in its upper bits.
        command: u32,
    },
    /// Main memory that is not there, or may not be read or written.
    #[error(
        "DMA storage fault at effective address {ea:#x} (command {command:#04x}, local store {lsa:#07x}, {size} bytes)"
    )]
    Storage {
        /// Command opcode.
        command: u8,
        /// Local-store address.
        lsa: u32,
        /// Effective address.
        ea: u64,
        /// Bytes asked for.
        size: u32,
    },
}
