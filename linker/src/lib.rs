//! Builds SPU programs from assembly, for use in a build script.
//!
//! [`embed`] is a whole build script, and [`prebuilt`] has the tracer's images for machines without
//! an SPU assembler. [`Tools::find`] names the SPU assembler and linker,
//! [`Image`] turns `.s` files into one SPU ELF image, [`stub`] makes a shared library of nothing
//! but names, to link against where the real one is not installed. [`tracer`] is the tracer's own
//! program, to which another crate's build script may add shaders. Apart from that, nothing here
//! knows what the programs do.

mod image;
pub mod prebuilt;
mod script;
pub mod stub;
mod tools;
mod tracer;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub use image::Image;
pub use script::{Script, embed, script};
pub use tools::Tools;
pub use tracer::{assemble_shader, tracer, tracer_with};

/// Why a program was not built. Its `Display` is meant for the person who runs the build.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// No assembler or no linker.
    #[error(
        "no SPU {what}: looked for {looked}.\n\
         It is part of the GNU binutils, built for the Cell's SPUs: configure their source with \
         --target=spu-elf --disable-werror (on Debian and Ubuntu it comes in the package binutils-source; its \
         build needs gcc, make, flex, bison and texinfo), and have spu-elf-as and spu-elf-ld on PATH, or name \
         them by the variables SPU_AS and SPU_LD; {variable} names this one.\n\
         In a clone of cellray's repository ci/setup does all of that once, for every crate of the user."
    )]
    NoTool {
        /// Assembler or linker.
        what: &'static str,
        /// The variable that may name it.
        variable: &'static str,
        /// Where it was looked for.
        looked: String,
    },
    /// A command could not be started.
    #[error("cannot run `{command}`: {source}")]
    Start {
        /// The whole command line.
        command: String,
        /// The system's error.
        source: std::io::Error,
    },
    /// A command failed.
    #[error("`{command}` failed ({status}):\n{output}")]
    Failed {
        /// The whole command line.
        command: String,
        /// How it ended.
        status: std::process::ExitStatus,
        /// What it printed.
        output: String,
    },
    /// A file or folder could not be read or written.
    #[error("{path}: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// No source files.
    #[error("{0}: no .s files in it")]
    NoSources(PathBuf),
    /// Prebuilt images of other sources.
    #[error(
        "{}: these images were built from other sources than those beside them; write them again with \
         `cargo run --bin kernels -- images`", .0.display()
    )]
    StaleImages(PathBuf),
    /// The C library to link against can't be read.
    #[error("{0}")]
    Library(String),
}

/// Runs a command to its end; its output is part of the error.
fn run(command: &mut Command) -> Result<(), Error> {
    output(command).map(|_| ())
}

/// The same, for what it writes to its standard output.
fn output(command: &mut Command) -> Result<String, Error> {
    let line = || {
        let words = std::iter::once(command.get_program()).chain(command.get_args());
        words
            .map(|word| word.to_string_lossy())
            .collect::<Vec<_>>()
            .join(" ")
    };
    let line = line();
    let output = command.output().map_err(|source| Error::Start {
        command: line.clone(),
        source,
    })?;
    let mut text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(text);
    }
    text.push_str(&String::from_utf8_lossy(&output.stderr));
    Err(Error::Failed {
        command: line,
        status: output.status,
        output: text,
    })
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    fs::write(path, text).map_err(|source| file_error(path, source))
}

fn file_error(path: &Path, source: std::io::Error) -> Error {
    Error::File {
        path: path.to_path_buf(),
        source,
    }
}
