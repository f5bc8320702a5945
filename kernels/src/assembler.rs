//! The SPU assembler, as the scheduler needs it: with line tables, and with the names of registers,
//! which an image leaves out.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use thiserror::Error;

/// Why a source was not assembled.
#[derive(Debug, Error)]
pub enum AssemblerError {
    /// There is no assembler.
    #[error("no SPU assembler: name one by SPU_AS, or run ci/setup, which builds the SPU binutils")]
    Missing,
    /// It can't be started, or its object can't be read.
    #[error("{}: {source}", path.display())]
    File {
        /// What can't be.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// It complains; warnings count.
    #[error("{}: not assembled\n{output}", path.display())]
    Refused {
        /// The source.
        path: PathBuf,
        /// What it says.
        output: String,
    },
}

/// An assembler and where its sources find what they include.
#[derive(Debug)]
pub struct Assembler {
    path: PathBuf,
    includes: Vec<PathBuf>,
}

impl Assembler {
    /// The assembler that the build finds: the one that `SPU_AS` names, on `PATH`, or built by
    /// `ci/setup`.
    pub fn find(includes: Vec<PathBuf>) -> Result<Self, AssemblerError> {
        let path = match env::var_os("SPU_AS") {
            Some(named) => PathBuf::from(named),
            None => look().ok_or(AssemblerError::Missing)?,
        };
        Ok(Self { path, includes })
    }

    /// The object of a source; it is written to `object` first.
    pub fn assemble(&self, source: &Path, object: &Path) -> Result<Vec<u8>, AssemblerError> {
        let mut command = Command::new(&self.path);
        command.args(["--fatal-warnings", "-g"]);
        for folder in &self.includes {
            command.arg("-I").arg(folder);
        }
        let output = command.arg("-o").arg(object).arg(source).output();
        let output = output.map_err(|error| file_error(&self.path, error))?;
        if !output.status.success() {
            return Err(AssemblerError::Refused {
                path: source.to_path_buf(),
                output: String::from_utf8_lossy(&output.stderr).into_owned(),
            });
        }
        std::fs::read(object).map_err(|error| file_error(object, error))
    }
}

fn look() -> Option<PathBuf> {
    let cache = env::var_os("XDG_CACHE_HOME")
        .map(PathBuf::from)
        .or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cache")));
    let set_up = cache.map(|cache| cache.join("cellray/spu-binutils/bin"));
    let on_path = env::var_os("PATH").unwrap_or_default();
    env::split_paths(&on_path)
        .chain(set_up)
        .flat_map(|folder| ["spu-elf-as", "spu-as"].map(|name| folder.join(name)))
        .find(|file| file.is_file())
}

fn file_error(path: &Path, source: std::io::Error) -> AssemblerError {
    AssemblerError::File {
        path: path.to_path_buf(),
        source,
    }
}
