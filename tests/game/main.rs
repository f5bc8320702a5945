//! The user layer: worlds that change, input, sessions.

mod content;
mod fresh;
mod handles;
mod input;
#[path = "../frames/recorder.rs"]
mod recorder;
mod retained;
mod session;
mod steady;
