//! The table in a document, between two markers. Invariant: the text outside the markers does not
//! change.

use std::fs;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// The line before the table.
pub const BEGIN: &str =
    "<!-- written by `cargo run --release --bin kernels -- measure --write` -->";
/// The line after the table.
pub const END: &str = "<!-- end of what is written -->";

/// Why a document could not be written, or that it is stale.
#[derive(Debug, Error)]
pub enum DocumentError {
    /// The document can't be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The document.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// The markers are missing.
    #[error("{}: there are no lines `{BEGIN}` and `{END}` around the table", path.display())]
    Markers {
        /// The document.
        path: PathBuf,
    },
    /// The table differs from the present measurement.
    #[error(
        "{}: stale at line {line}: it has\n  {found}\nbut the present measurement is\n  {expected}\nWrite it again with --write",
        path.display()
    )]
    Stale {
        /// The document.
        path: PathBuf,
        /// The number of its first line that differs, from 1.
        line: usize,
        /// The line in the document.
        found: String,
        /// The expected line.
        expected: String,
    },
}

/// Writes `table` into the document.
pub fn write(path: &Path, table: &str) -> Result<(), DocumentError> {
    let text = renewed(path, &read(path)?, table)?;
    fs::write(path, text).map_err(|source| file_error(path, source))
}

/// Compares the document's table with `table`.
pub fn check(path: &Path, table: &str) -> Result<(), DocumentError> {
    let found = read(path)?;
    let expected = renewed(path, &found, table)?;
    if found == expected {
        return Ok(());
    }
    let (mut found, mut expected) = (found.lines(), expected.lines());
    let mut line = 0;
    loop {
        line += 1;
        let (found, expected) = (found.next(), expected.next());
        if found != expected || found.is_none() {
            let text = |line: Option<&str>| line.unwrap_or("(nothing)").to_owned();
            return Err(DocumentError::Stale {
                path: path.to_path_buf(),
                line,
                found: text(found),
                expected: text(expected),
            });
        }
    }
}

fn renewed(path: &Path, text: &str, table: &str) -> Result<String, DocumentError> {
    let markers = || DocumentError::Markers { path: path.to_path_buf() };
    let (before, rest) = text.split_once(BEGIN).ok_or_else(markers)?;
    let (_, after) = rest.split_once(END).ok_or_else(markers)?;
    Ok(format!("{before}{BEGIN}\n\n{table}\n{END}{after}"))
}

fn read(path: &Path) -> Result<String, DocumentError> {
    fs::read_to_string(path).map_err(|source| file_error(path, source))
}

fn file_error(path: &Path, source: std::io::Error) -> DocumentError {
    DocumentError::File { path: path.to_path_buf(), source }
}
