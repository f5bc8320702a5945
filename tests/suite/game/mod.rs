//! The user layer: worlds that change, input, and sessions.

use crate::prelude::*;

mod animated;
mod content;
mod fresh;
mod handles;
mod input;
mod meshes;
mod moving;
mod rebuild;
mod refined;
mod refit;
mod retained;
mod session;
mod steady;
mod terrain;

/// Why a change of a world is refused.
fn kind<T>(change: &Result<T, WorldError>) -> Option<&WorldErrorKind> {
    change.as_ref().err().map(WorldError::kind)
}
