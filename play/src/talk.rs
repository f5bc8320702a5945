//! What is said beside the picture.
//!
//! Invariant: nobody has to listen: where standard error is closed, hangs up or is full, the
//! session goes on.

use std::fmt::Display;
use std::io::{self, Write as _};

/// Says a line on standard error.
pub fn say(line: impl Display) {
    // There is nowhere else to tell of it.
    let _ = writeln!(io::stderr(), "cellray-play: {line}");
}
