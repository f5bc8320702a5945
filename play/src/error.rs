//! Why there was nothing to see, or no more.

use std::io;
use std::path::PathBuf;

use cellray::EngineError;
use cellray::framebuffer::FramebufferError;
use cellray::game::{RecordingError, SessionError};
use cellray::scene::SceneError;
use cellray::spe::ProgramError;

use crate::display::DisplayError;

/// Why a session came to no good end.
#[derive(Debug, thiserror::Error)]
pub enum PlayError {
    /// No game of that name.
    #[error("no game {name:?}; there are: {known}")]
    NoGame {
        /// The name.
        name: String,
        /// Those that there are.
        known: String,
    },
    /// The scene can't be read.
    #[error(transparent)]
    Scene(#[from] nff::Error),
    /// The SPU program can't be.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// A shader can't be assembled or linked.
    #[error(transparent)]
    Build(#[from] spu_build::Error),
    /// A picture can't be read.
    #[error("{}: {source}", path.display())]
    Picture {
        /// Its file.
        path: PathBuf,
        /// What is wrong.
        source: image::ImageError,
    },
    /// A scene that the SPUs don't take.
    #[error(transparent)]
    Refused(#[from] SceneError),
    /// Options that don't go together.
    #[error("{0}")]
    Options(&'static str),
    /// No display was named and there is none to choose.
    #[error(
        "no display server and no terminal to show it on; say --display fb for the console's framebuffer, or \
         --frames A..B --out 'f-%05d.png' for pictures"
    )]
    NoDisplay,
    /// The display can't be had.
    #[error(transparent)]
    Display(#[from] DisplayError),
    /// The display failed.
    #[error("display: {0}")]
    Show(#[source] io::Error),
    /// Nothing can be written to standard output.
    #[error("standard output: {0}")]
    Output(#[source] io::Error),
    /// Signals can't be caught.
    #[error("signals: {0}")]
    Signals(#[source] io::Error),
    /// A recording can't be made or read.
    #[error("{}: {source}", path.display())]
    Recording {
        /// Its file.
        path: PathBuf,
        /// What is wrong.
        source: RecordingError,
    },
    /// A frame can't be traced or shown.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The framebuffer refuses.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
    /// The SPUs can't go on.
    #[error(transparent)]
    Engine(#[from] EngineError),
}
