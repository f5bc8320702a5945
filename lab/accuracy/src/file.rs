//! What can go wrong with a file of results.

use std::io;
use std::path::{Path, PathBuf};

/// Why a file is not written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// A folder or file.
    #[error("{}: {source}", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
    /// A number that JSON has no form for.
    #[error("results as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// A table.
    #[error("{}: {source}", path.display())]
    Csv {
        /// Which.
        path: PathBuf,
        /// What failed.
        source: csv::Error,
    },
    /// A plot.
    #[error("{}: {reason}", path.display())]
    Plot {
        /// Which.
        path: PathBuf,
        /// What failed.
        reason: String,
    },
}

impl OutputError {
    /// What the system says of a file.
    pub(crate) fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        |source| Self::File { path, source }
    }
}
