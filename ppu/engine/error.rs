//! The errors of the engine.

use super::silence::Silence;
use super::unchecked::Unchecked;
use crate::framebuffer::FramebufferError;
use crate::scene::SceneError;
use crate::spe::{Ended, ProgramError, SpeError};
use crate::work::Refusal;
use protocol::layout::MAX_SPUS;

/// Why the engine made no frame.
#[derive(Debug, thiserror::Error)]
pub enum EngineError {
    /// The number of SPUs is 0, or more than a frame's record holds.
    #[error("{0} SPUs: must be 1 to {MAX_SPUS}")]
    SpuCount(u32),
    /// An SPU program ended; no further frame can be traced.
    #[error("SPU {spu} {ended}{unchecked}")]
    Ended {
        /// Number of the SPU.
        spu: u32,
        /// How the program ended.
        ended: Ended,
        /// Whether unchecked shaders may be the cause.
        unchecked: Unchecked,
    },
    /// An SPU refused the frame.
    #[error("SPU {spu} {refusal}{unchecked}")]
    Refused {
        /// Number of the SPU.
        spu: u32,
        /// The reason that the SPU gave.
        refusal: Refusal,
        /// Whether unchecked shaders may be the cause.
        unchecked: Unchecked,
    },
    /// An SPU did not reply, and no SPU did anything until the timeout.
    #[error("SPU {spu} {silence}{unchecked}")]
    Silent {
        /// Number of the first SPU that did not reply.
        spu: u32,
        /// The state of that SPU.
        silence: Silence,
        /// Whether unchecked shaders may be the cause.
        unchecked: Unchecked,
    },
    /// The SPUs' statistics do not add up to the whole picture.
    #[error("the SPUs traced {traced} of {wanted} rays: the picture is incomplete{unchecked}")]
    Incomplete {
        /// Rays in the statistics.
        traced: u64,
        /// Pixels of the tiles that had to be traced.
        wanted: u64,
        /// Whether unchecked shaders may be the cause.
        unchecked: Unchecked,
    },
    /// The SPUs were lost by an earlier error.
    #[error("the SPUs were lost by an earlier error")]
    Lost,
    /// The scene can't be drawn.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The framebuffer failed.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
    /// libspe2 failed.
    #[error(transparent)]
    Spe(#[from] SpeError),
    /// The SPU program is not valid.
    #[error(transparent)]
    Program(#[from] ProgramError),
}
