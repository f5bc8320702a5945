//! Writes the output that the options ask for.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

use serde::Serialize;

use crate::failure::Failure;

/// Writes to a file.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(Failure::file(path))
}

/// Writes to a file, or else to standard error.
pub fn write_text(path: Option<&Path>, text: &str) -> Result<(), Failure> {
    match path {
        Some(path) => write_file(path, text.as_bytes()),
        None => {
            let path = Path::new("standard error");
            messages::unless_closed(io::stderr().write_all(text.as_bytes()))
                .map_err(Failure::file(path))
        }
    }
}

/// Pretty-printed JSON with a newline at the end. Maps with text keys and numbers can always be
/// written.
pub fn json(value: &impl Serialize) -> String {
    let json = serde_json::to_string_pretty(value).unwrap_or_default();
    format!("{json}\n")
}
