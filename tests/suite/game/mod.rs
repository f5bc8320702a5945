//! The user layer: worlds that change, input, and sessions.

mod content;
mod fresh;
mod handles;
mod input;
mod meshes;
mod refined;
mod retained;
mod session;
mod steady;
