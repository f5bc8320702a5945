//! Errors of MFC commands.

use thiserror::Error;

/// Why the MFC refused a command or could not complete it. The variants are the kinds that Linux
/// reports to a program (alignment, invalid command, storage). The fields identify the command.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DmaError {
    /// A size or address that the architecture does not allow.
    #[error(
        "DMA alignment: {what} (command {command:#04x}, local store {lsa:#07x}, effective address {ea:#x}, {size} bytes)"
    )]
    Alignment {
        /// The broken rule.
        what: &'static str,
        /// The command's opcode.
        command: u8,
        /// Local-store address.
        lsa: u32,
        /// Effective address.
        ea: u64,
        /// Size in bytes.
        size: u32,
    },
    /// An opcode or tag that does not exist, or a command that this queue does not accept.
    #[error("invalid DMA command {command:#x}: {what}")]
    InvalidCommand {
        /// The broken rule.
        what: &'static str,
        /// The command's opcode, with the upper bits as written.
        command: u32,
    },
    /// Main memory that does not exist, or does not allow the access.
    #[error(
        "DMA storage fault at effective address {ea:#x} (command {command:#04x}, local store {lsa:#07x}, {size} bytes)"
    )]
    Storage {
        /// The command's opcode.
        command: u8,
        /// Local-store address.
        lsa: u32,
        /// Effective address.
        ea: u64,
        /// Size in bytes.
        size: u32,
    },
}
