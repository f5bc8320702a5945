//! Finds the SPU assembler and linker.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Error, run};

/// The SPU assembler and linker on this machine.
#[derive(Clone, Debug)]
pub struct Tools {
    assembler: Tool,
    linker: Tool,
}

/// A tool, or the compiler driver that calls it.
#[derive(Clone, Debug)]
struct Tool {
    path: PathBuf,
}

impl Tools {
    /// The variables that [`Tools::find`] reads. A build script runs again when they change.
    pub const VARIABLES: [&str; 3] = ["SPU_AS", "SPU_LD", "XDG_CACHE_HOME"];

    /// Looks for the tools in this order: first the variables `SPU_AS` and `SPU_LD`, which may
    /// also name an `spu-gcc`; then `spu-elf-as` or `spu-as` and their linkers on `PATH`; then the
    /// tools that `ci/setup` built in the user's cache folder; and for whatever is still missing,
    /// `spu-gcc` on `PATH`.
    pub fn find() -> Result<Self, Error> {
        Ok(Self {
            assembler: Tool::find("assembler", "SPU_AS", "as")?,
            linker: Tool::find("linker", "SPU_LD", "ld")?,
        })
    }

    /// Whether a variable names a tool. Then no other tool is used instead.
    #[must_use]
    pub fn are_named() -> bool {
        ["SPU_AS", "SPU_LD"].map(env::var_os).iter().any(Option::is_some)
    }

    /// Assembles one source with line tables. `.include` searches `includes`, and `further` are
    /// options of the assembler. Warnings count as errors, because the assembler only warns of an
    /// operand that is out of range.
    pub fn assemble(
        &self,
        includes: &[PathBuf],
        further: &[&str],
        object: &Path,
        source: &Path,
    ) -> Result<(), Error> {
        run(&mut self.assembling(includes, &[&["-g"], further].concat(), object, source))
    }

    /// Assembles one source without line tables and names of constants, so that objects are the
    /// same if their code is.
    pub fn assemble_code(
        &self,
        includes: &[PathBuf],
        object: &Path,
        source: &Path,
    ) -> Result<(), Error> {
        run(&mut self.assembling(includes, &["--strip-local-absolute"], object, source))
    }

    fn assembling(
        &self,
        includes: &[PathBuf],
        further: &[&str],
        object: &Path,
        source: &Path,
    ) -> Command {
        let mut options: Vec<OsString> = vec!["--fatal-warnings".into()];
        options.extend(further.iter().map(OsString::from));
        for folder in includes {
            options.extend(["-I".into(), folder.into()]);
        }
        let mut command = self.assembler.command("-c", "-Wa,", &options);
        command.arg("-o").arg(object).arg(source);
        command
    }

    /// Links objects. `options` are options of the linker.
    pub(crate) fn link(&self, options: &[OsString], image: &Path, objects: &[PathBuf]) -> Command {
        let mut command = self.linker.command("-nostdlib", "-Wl,", options);
        command.arg("-o").arg(image).args(objects);
        command
    }
}

impl Tool {
    fn find(what: &'static str, variable: &'static str, name: &str) -> Result<Self, Error> {
        if let Some(value) = env::var_os(variable) {
            let named = PathBuf::from(&value);
            let path = if named.components().count() > 1 {
                named.is_file().then_some(named)
            } else {
                on_path(&value)
            };
            let looked = format!("{variable}={}", value.to_string_lossy());
            return match path {
                Some(path) => Ok(Self { path }),
                None => Err(Error::NoTool { what, variable, looked }),
            };
        }
        let cached = cached(name);
        on_path(format!("spu-elf-{name}"))
            .or_else(|| on_path(format!("spu-{name}")))
            .or_else(|| cached.clone().filter(|path| path.is_file()))
            .or_else(|| on_path("spu-gcc"))
            .map(|path| Self { path })
            .ok_or_else(|| {
                let cached =
                    cached.map_or("no cache folder".into(), |path| path.display().to_string());
                let looked = format!("spu-elf-{name}, spu-{name} and spu-gcc on PATH, {cached}");
                Error::NoTool { what, variable, looked }
            })
    }

    /// The tool with its options. A compiler driver gets its mode, and passes the options to the
    /// tool.
    fn command(&self, mode: &str, prefix: &str, options: &[OsString]) -> Command {
        let mut command = Command::new(&self.path);
        let stem = self.path.file_stem().unwrap_or_default();
        if stem.to_string_lossy().ends_with("gcc") {
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

fn on_path(name: impl AsRef<Path>) -> Option<PathBuf> {
    let path = env::var_os("PATH")?;
    env::split_paths(&path).map(|folder| folder.join(&name)).find(|file| file.is_file())
}

/// The path at which `ci/setup` installs a tool that it builds.
fn cached(name: &str) -> Option<PathBuf> {
    Some(cache()?.join("cellray/spu-binutils/bin").join(format!("spu-elf-{name}")))
}

pub(crate) fn cache() -> Option<PathBuf> {
    let named = env::var_os("XDG_CACHE_HOME").map(PathBuf::from);
    named.or_else(|| Some(PathBuf::from(env::var_os("HOME")?).join(".cache")))
}
