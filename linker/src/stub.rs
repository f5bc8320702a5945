//! A shared library of nothing but names.
//!
//! It has the soname and the functions of a library that is not installed where a program is built,
//! so that the program can be linked against it; at run time the loader takes the real one.

use std::ffi::OsString;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::{Error, run};

/// Writes `library` with the given soname and functions, compiled by the target's `compiler`.
pub fn build(
    compiler: &Path,
    soname: &str,
    functions: &[&str],
    library: &Path,
) -> Result<(), Error> {
    let source = library.with_extension("c");
    let mut text = String::new();
    for function in functions {
        let _ = writeln!(text, "void {function}(void) {{}}");
    }
    fs::write(&source, text).map_err(|error| Error::File {
        path: source.clone(),
        source: error,
    })?;
    let mut command = Command::new(compiler);
    command.args(["-shared", "-nostdlib", "-fPIC"]);
    command.arg(format!("-Wl,-soname,{soname}"));
    command.args([OsString::from("-o"), library.into(), source.into()]);
    run(&mut command)
}

/// Names of a list with one name a line; `#` starts a comment.
pub fn names(list: &str) -> Vec<&str> {
    list.lines()
        .map(|line| line.split('#').next().unwrap_or_default().trim())
        .filter(|name| !name.is_empty())
        .collect()
}
