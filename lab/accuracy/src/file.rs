//! Errors in writing results, with the file's name.

use std::fmt::Display;

/// An output that can't be written.
#[derive(Debug, thiserror::Error)]
#[error("{what}: {reason}")]
pub struct OutputError {
    /// The file or folder, or the part of the results.
    what: String,
    /// The reason, from the system or from the serialiser.
    reason: String,
}

impl OutputError {
    /// Makes an error about a file, a folder or a part of the results.
    pub(crate) fn of<E: Display>(what: impl Display) -> impl Fn(E) -> Self {
        let what = what.to_string();
        move |reason| Self { what: what.clone(), reason: reason.to_string() }
    }
}
