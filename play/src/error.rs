//! The errors that end `cellray-play`.

use std::error::Error;
use std::io;
use std::path::PathBuf;

use cellray::EngineError;
use cellray::choices::ProgramChoiceError;
use cellray::framebuffer::FramebufferError;
use cellray::game::{RecordingError, SessionError};
use cellray::scene::SceneError;
use cellray::spe::ProgramError;

use crate::display::DisplayError;

/// Why a session can't start, or why it ended with an error.
#[derive(Debug, thiserror::Error)]
pub enum PlayError {
    /// There is no game with this name.
    #[error("no game {name:?}{}; there are: {known}", question(*meant))]
    NoGame {
        /// The requested name.
        name: String,
        /// The name that was probably meant.
        meant: Option<&'static str>,
        /// The names of the games.
        known: String,
    },
    /// The level can't be read.
    #[error(transparent)]
    Level(Box<dyn Error + Send + Sync>),
    /// The scene can't be read.
    #[error(transparent)]
    Scene(#[from] meshes::Error),
    /// The SPU program can't be read, or is not valid.
    #[error(transparent)]
    Program(#[from] ProgramError),
    /// The SPU program that was chosen can't be used.
    #[error(transparent)]
    Choice(#[from] ProgramChoiceError),
    /// A picture can't be read.
    #[error("{}: {source}", path.display())]
    Picture {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: image::ImageError,
    },
    /// The scene can't be drawn.
    #[error(transparent)]
    Refused(#[from] SceneError),
    /// Man pages or completions can't be written.
    #[error(transparent)]
    Pages(io::Error),
    /// Options that can't be used together.
    #[error("{0}")]
    Options(&'static str),
    /// No display was selected, and there is no display server and no terminal.
    #[error(
        "no display server and no terminal to show it on; use --display fb for the console's framebuffer, or \
         --frames A..B --out 'f-%05d.png' for pictures"
    )]
    NoDisplay,
    /// The display can't be opened.
    #[error(transparent)]
    Display(#[from] DisplayError),
    /// The display failed.
    #[error("display: {0}")]
    Show(#[source] io::Error),
    /// Standard output can't be written to.
    #[error(transparent)]
    Output(io::Error),
    /// Signals can't be caught.
    #[error("signals: {0}")]
    Signals(#[source] io::Error),
    /// A recording can't be created or read.
    #[error("{}: {source}", path.display())]
    Recording {
        /// The recording's file.
        path: PathBuf,
        /// The reason.
        source: RecordingError,
    },
    /// The session failed: a frame can't be traced or shown.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The framebuffer failed.
    #[error(transparent)]
    Framebuffer(#[from] FramebufferError),
    /// The engine failed.
    #[error(transparent)]
    Engine(#[from] EngineError),
}

/// Asks whether a name was meant.
fn question(meant: Option<&str>) -> String {
    meant.map_or_else(String::new, |name| format!("; did you mean {name:?}?"))
}
