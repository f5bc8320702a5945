//! What can go wrong where results are written, and with which file.

use std::fmt::Display;

/// Something that can't be written.
#[derive(Debug, thiserror::Error)]
#[error("{what}: {reason}")]
pub struct OutputError {
    /// Which file or folder, or what of the results.
    what: String,
    /// What is said of it: by the system, or by what writes its form.
    reason: String,
}

impl OutputError {
    /// What is said of a file, a folder or a part of the results.
    pub(crate) fn of<E: Display>(what: impl Display) -> impl Fn(E) -> Self {
        let what = what.to_string();
        move |reason| Self {
            what: what.clone(),
            reason: reason.to_string(),
        }
    }
}
