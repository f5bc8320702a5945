//! What ends a session before its time.

use std::io;

use super::recording::RecordingError;
use crate::engine::EngineError;
use crate::framebuffer::FramebufferError;
use crate::game::WorldError;
use crate::spe::ProgramError;

/// Why a session can't go on.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    /// The game did with its world what can't be done.
    #[error(transparent)]
    World(#[from] WorldError),
    /// The game's own SPU program is none.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// No frame came.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// A picture can't be written.
    #[error(transparent)]
    Picture(#[from] FramebufferError),
    /// An input device failed.
    #[error("input: {0}")]
    Input(#[source] io::Error),
    /// A recording can't be written or read.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// A recording of another game.
    #[error("the recording is one of {recorded}, and this is {game}")]
    OtherGame {
        /// The recorded game.
        recorded: String,
        /// The one at hand.
        game: String,
    },
    /// The world is not what it was when it was recorded.
    #[error("frame {frame}: the world is another than the recorded one")]
    Diverged {
        /// Number of the frame, from 0.
        frame: u64,
    },
}
