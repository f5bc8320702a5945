//! Where the SPU assembler and linker are.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Error;

/// The SPU assembler and linker of this machine.
#[derive(Clone, Debug)]
pub struct Tools {
    assembler: PathBuf,
    linker: PathBuf,
    /// `spu-gcc` drives both: it takes the binutils' options behind `-Wa` and `-Wl`.
    compiler_driver: bool,
}

impl Tools {
    /// Variables that [`Tools::find`] looks at: a build script reruns when they change.
    pub const VARIABLES: [&str; 3] = ["SPU_AS", "SPU_LD", "XDG_CACHE_HOME"];

    /// Looks for the tools in this order: the variables `SPU_AS` and `SPU_LD`; `spu-elf-as` or
    /// `spu-as` and the linker beside it on `PATH`; `spu-gcc` on `PATH`; what `ci/setup` built in
    /// the user's cache folder.
    pub fn find() -> Result<Self, Error> {
        let assembler = find_tool("SPU_AS", "as");
        let linker = find_tool("SPU_LD", "ld");
        if let (Some(assembler), Some(linker)) = (&assembler, &linker) {
            return Ok(Self {
                assembler: assembler.clone(),
                linker: linker.clone(),
                compiler_driver: false,
            });
        }
        let named = env::var_os("SPU_AS").is_some() || env::var_os("SPU_LD").is_some();
        if let (false, Some(gcc)) = (named, on_path("spu-gcc")) {
            return Ok(Self {
                assembler: gcc.clone(),
                linker: gcc,
                compiler_driver: true,
            });
        }
        let (what, variable, name) = match assembler {
            None => ("assembler", "SPU_AS", "as"),
            Some(_) => ("linker", "SPU_LD", "ld"),
        };
        let looked = match env::var_os(variable) {
            Some(value) => format!("{variable}={}", value.to_string_lossy()),
            None => format!(
                "spu-elf-{name}, spu-{name} and spu-gcc on PATH, {}",
                cached(name).map_or("no cache folder".into(), |path| path.display().to_string())
            ),
        };
        Err(Error::NoTool {
            what,
            variable,
            looked,
        })
    }

    /// `as` with the options given, in the spelling that the tool at hand takes.
    pub(crate) fn assemble(&self, options: &[OsString]) -> Command {
        self.command(&self.assembler, "-c", "-Wa,", options)
    }

    /// `ld` with the options given.
    pub(crate) fn link(&self, options: &[OsString]) -> Command {
        self.command(&self.linker, "-nostdlib", "-Wl,", options)
    }

    fn command(&self, tool: &Path, mode: &str, prefix: &str, options: &[OsString]) -> Command {
        let mut command = Command::new(tool);
        if self.compiler_driver {
            command.arg(mode);
            for option in options {
                let mut passed = OsString::from(prefix);
                passed.push(option);
                command.arg(passed);
            }
        } else {
            command.args(options);
        }
        command
    }
}

fn find_tool(variable: &str, name: &str) -> Option<PathBuf> {
    if let Some(value) = env::var_os(variable) {
        let path = PathBuf::from(&value);
        return if path.components().count() > 1 {
            path.is_file().then_some(path)
        } else {
            on_path(&value)
        };
    }
    on_path(format!("spu-elf-{name}"))
        .or_else(|| on_path(format!("spu-{name}")))
        .or_else(|| cached(name).filter(|path| path.is_file()))
}

fn on_path(name: impl AsRef<Path>) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    env::split_paths(&path)
        .map(|folder| folder.join(&name))
        .find(|file| file.is_file())
}

/// Where `ci/setup` puts the tools that it builds.
fn cached(name: &str) -> Option<PathBuf> {
    let cache = env::var_os("XDG_CACHE_HOME")
        .map(PathBuf::from)
        .or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cache")))?;
    Some(
        cache
            .join("cellray/spu-binutils/bin")
            .join(format!("spu-elf-{name}")),
    )
}
