//! The errors that end a session.

use std::io;

use super::recording::RecordingError;
use crate::engine::EngineError;
use crate::framebuffer::FramebufferError;
use crate::game::WorldError;
use crate::spe::ProgramError;

/// Why a session can't go on.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    /// The world refused a change that the game made, or can't be traced.
    #[error(transparent)]
    World(#[from] WorldError),
    /// The game's own SPU program is not valid.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// The engine could not make a frame.
    #[error(transparent)]
    Engine(#[from] EngineError),
    /// A picture can't be read back or written.
    #[error(transparent)]
    Picture(#[from] FramebufferError),
    /// An input device failed.
    #[error("input: {0}")]
    Input(#[source] io::Error),
    /// A recording can't be written or read.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// The recording is of another game.
    #[error("the recording is of {recorded}, but this game is {game}")]
    OtherGame {
        /// The recorded game's name.
        recorded: String,
        /// This game's name.
        game: String,
    },
    /// The world differs from the recorded one.
    #[error("frame {frame}: the world differs from the recorded one")]
    Diverged {
        /// Number of the frame, from 0.
        frame: u64,
    },
}
