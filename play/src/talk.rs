//! Messages on standard error.
//!
//! Invariant: the session continues if standard error is closed, hung up or full.

use std::fmt::Display;
use std::io::{self, Write as _};

/// Prints a line on standard error.
pub fn say(line: impl Display) {
    // There is nowhere else to report an error.
    let _ = writeln!(io::stderr(), "cellray-play: {line}");
}
