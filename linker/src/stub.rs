//! Makes a shared library that contains only names.
//!
//! It has the soname and the functions of a library that is not installed where a program is
//! built, so that the program can be linked against it. At run time the loader uses the real
//! library. [`glibc`] makes stubs of an installed library with the names that an older version
//! had.

pub mod glibc;

use std::env;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Error, Script, run, write};

/// The functions of libspe2, one a line, for [`names`].
pub const LIBSPE2: &str = include_str!("../libspe2.symbols");

/// The compiler for a build script's target, which is the one that cargo links with.
#[must_use]
pub fn compiler(script: &mut Script) -> PathBuf {
    script.watch_variable("RUSTC_LINKER");
    env::var_os("RUSTC_LINKER").map_or_else(|| "cc".into(), PathBuf::from)
}

/// Writes `library` with the given soname and functions, using the target's `compiler`.
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

/// Compiles `text` to a shared library that is not linked to any other.
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
    // The stubs declare functions for which the compiler has other types built in.
    command.args(["-shared", "-nostdlib", "-fPIC", "-fno-builtin", "-w"]);
    command.arg(format!("-Wl,-soname,{soname}")).args(options);
    command.args([OsString::from("-o"), library.into(), source.into()]);
    run(&mut command)
}

/// The names in a list with one name a line. `#` starts a comment.
pub fn names(list: &str) -> Vec<&str> {
    list.lines()
        .map(|line| line.split('#').next().unwrap_or_default().trim())
        .filter(|name| !name.is_empty())
        .collect()
}
