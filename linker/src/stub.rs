//! A shared library of nothing but names.
//!
//! It has the soname and the functions of a library that is not installed where a program is
//! built, so that the program can be linked against it; at run time the loader takes the real one.
//! [`glibc`] has the names of one that is installed, as they were earlier.

pub mod glibc;

use std::env;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Error, Script, run, write};

/// The functions of libspe2, one a line, for [`names`].
pub const LIBSPE2: &str = include_str!("../libspe2.symbols");

/// The compiler of a build script's target: what cargo links with.
#[must_use]
pub fn compiler(script: &mut Script) -> PathBuf {
    script.watch_variable("RUSTC_LINKER");
    env::var_os("RUSTC_LINKER").map_or_else(|| "cc".into(), PathBuf::from)
}

/// Writes `library` with the given soname and functions, compiled by the target's `compiler`.
pub fn build(
    compiler: &Path,
    soname: &str,
    functions: &[&str],
    library: &Path,
) -> Result<(), Error> {
    let mut text = String::new();
    for function in functions {
        let _ = writeln!(text, "void {function}(void) {{}}");
    }
    share(compiler, soname, &text, &[], library)
}

/// Compiles `text` to a shared library that is linked to none.
fn share(
    compiler: &Path,
    soname: &str,
    text: &str,
    options: &[OsString],
    library: &Path,
) -> Result<(), Error> {
    let source = library.with_extension("c");
    write(&source, text)?;
    let mut command = Command::new(compiler);
    // Names that the compiler knows are not declared as it knows them.
    command.args(["-shared", "-nostdlib", "-fPIC", "-fno-builtin", "-w"]);
    command.arg(format!("-Wl,-soname,{soname}")).args(options);
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
