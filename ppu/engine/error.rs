//! Why there is no frame.

use super::silence::Silence;
use super::unchecked::Unchecked;
use crate::framebuffer::FramebufferError;
use crate::scene::SceneError;
use crate::spe::{Ended, ProgramError, SpeError};
use crate::work::Refusal;
use protocol::layout::MAX_SPUS;

/// Why no frame came.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// A number of SPUs that the work unit has no room for.
    #[error("{0} SPUs: must be 1 to {MAX_SPUS}")]
    SpuCount(u32),
    /// An SPU program came to an end; no further frame can be traced.
    #[error("SPU {spu} {ended}{unchecked}")]
    Ended {
        /// Number of the SPU.
        spu: u32,
        /// How.
        ended: Ended,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// An SPU did not accept the frame.
    #[error("SPU {spu} {refusal}{unchecked}")]
    Refused {
        /// Number of the SPU.
        spu: u32,
        /// What was wrong.
        refusal: Refusal,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// An SPU did not answer, and none did anything.
    #[error("SPU {spu} {silence}{unchecked}")]
    Silent {
        /// Number of the first such SPU.
        spu: u32,
        /// What is known of it.
        silence: Silence,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// The SPUs' statistics do not add up to the whole picture.
    #[error("the SPUs traced {traced} of {wanted} rays: the picture is not whole{unchecked}")]
    Incomplete {
        /// Rays in the statistics.
        traced: u64,
        /// Pixels of the tiles that were to be traced.
        wanted: u64,
        /// What may be behind it.
        unchecked: Unchecked,
    },
    /// An earlier error has left no SPUs to work with.
    #[error("the SPUs were lost by an earlier error")]
    Lost,
    /// The scene does not suit.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The framebuffer does not show it.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
    /// libspe2 failed.
    #[error(transparent)]
    Spe(#[from] SpeError),
    /// The SPU program is not known well enough.
    #[error(transparent)]
    Program(#[from] ProgramError),
}
