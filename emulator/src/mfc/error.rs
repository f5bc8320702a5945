//! Why a command fails.

use thiserror::Error;

/// Why the MFC refused or could not finish a command. The kinds are those that Linux tells a
/// program (alignment, invalid command, storage); the fields say which command it was.
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
