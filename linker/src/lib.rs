//! Builds SPU programs from assembly, for use in build scripts.
//!
//! [`embed`] is a complete build script, and [`prebuilt`] has the tracer's images for machines
//! without an SPU assembler. [`Tools::find`] finds the SPU assembler and linker. [`Image`] turns
//! `.s` files into one SPU ELF image, and [`Schedules`] makes the forms of kernels that it contains.
//! [`stub`] makes a shared library that contains only names, so that programs can be linked where
//! the real library is not installed. [`tracer`] is the tracer's own program, to which another
//! crate's build script may add shaders. The other modules do not depend on what the programs do.
//! With the feature `for-tests`, `for_tests` builds programs for tests.

#[cfg(feature = "for-tests")]
pub mod for_tests;
mod image;
pub mod prebuilt;
mod schedules;
mod script;
pub mod stub;
mod tools;
mod tracer;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

pub use image::Image;
pub use schedules::Schedules;
pub use script::{Script, embed, script};
pub use tools::Tools;
pub use tracer::{assemble_shader, tracer, tracer_with};

/// Why a program was not built. Its `Display` text is written for the person who runs the build.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The assembler or the linker was not found.
    #[error(
        "no SPU {what}: looked for {looked}.\n\
         It is part of the GNU binutils, built for the Cell's SPUs: configure their source with \
         --target=spu-elf --disable-werror (on Debian and Ubuntu it comes in the package binutils-source; its \
         build needs gcc, make, flex, bison and texinfo), and have spu-elf-as and spu-elf-ld on PATH, or name \
         them in the variables SPU_AS and SPU_LD; {variable} names this one.\n\
         In a clone of cellray's repository ci/setup does all of this once for all crates of a user."
    )]
    NoTool {
        /// "assembler" or "linker".
        what: &'static str,
        /// The variable that can name the tool.
        variable: &'static str,
        /// The places where it was looked for.
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
        /// The exit status.
        status: std::process::ExitStatus,
        /// The command's output.
        output: String,
    },
    /// A file or folder could not be read or written.
    #[error("{path}: {source}")]
    File {
        /// The path.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// A kernel can't be scheduled.
    #[error("{}: {source}", path.display())]
    Scheduler {
        /// The kernel's source.
        path: PathBuf,
        /// The reason.
        source: spu_scheduler::ScheduleError,
    },
    /// No source files.
    #[error("{0}: the folder has no .s files")]
    NoSources(PathBuf),
    /// Prebuilt images that were built from other sources.
    #[error(
        "{}: these images were not built from the present sources; build them again with \
         `cargo run --bin kernels -- images`", .0.display()
    )]
    StaleImages(PathBuf),
    /// The C library to be linked against can't be read.
    #[error("{0}")]
    Library(String),
}

/// Makes something of each item, with as many threads as there are processors. The results are in
/// the items' order; the error is that of the first item that has one.
pub fn each<I: Sync, T: Send, E: Send>(
    items: &[I],
    make: impl Fn(&I) -> Result<T, E> + Sync,
) -> Result<Vec<T>, E> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut made = Vec::new();
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(at) else { return made };
            made.push((at, make(item)));
        }
    };
    let workers = thread::available_parallelism().map_or(1, usize::from);
    let mut made: Vec<_> = thread::scope(|scope| {
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        let made = workers.into_iter().flat_map(|worker| worker.join().expect("no item panics"));
        made.collect()
    });
    made.sort_by_key(|(at, _)| *at);
    made.into_iter().map(|(_, made)| made).collect()
}

/// Runs a command to its end. If it fails, its output is part of the error.
fn run(command: &mut Command) -> Result<(), Error> {
    output(command).map(|_| ())
}

/// Runs a command like [`run`], and returns its standard output.
fn output(command: &mut Command) -> Result<String, Error> {
    let line = || {
        let words = std::iter::once(command.get_program()).chain(command.get_args());
        words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
    };
    let line = line();
    let output =
        command.output().map_err(|source| Error::Start { command: line.clone(), source })?;
    let mut text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(text);
    }
    text.push_str(&String::from_utf8_lossy(&output.stderr));
    Err(Error::Failed { command: line, status: output.status, output: text })
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    fs::write(path, text).map_err(|source| file_error(path, source))
}

fn file_error(path: &Path, source: std::io::Error) -> Error {
    Error::File { path: path.to_path_buf(), source }
}
