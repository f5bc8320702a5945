//! The `main` of build scripts: it passes directives to cargo, and errors to the person who
//! builds.

use std::env;
use std::error::Error;
use std::fmt::{Display, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::{Image, Tools};

/// The directives of a build script to cargo. They are printed only if the script succeeds. If it
/// fails, cargo prints the script's whole output, so the error would come after a long list of
/// files. Cargo runs a failed script again in any case.
#[derive(Debug, Default)]
pub struct Script(String);

impl Script {
    /// Adds a directive, such as `rustc-link-lib=m`.
    pub fn add(&mut self, line: impl Display) {
        // Writing to a string can't fail.
        let _ = writeln!(self.0, "cargo:{line}");
    }

    /// Runs the script again when this file changes, or any file in this folder.
    pub fn watch(&mut self, path: &Path) {
        self.add(format_args!("rerun-if-changed={}", path.display()));
    }

    /// Runs the script again when any input of an image changes.
    pub fn watch_image(&mut self, image: &Image) -> Result<(), crate::Error> {
        for input in image.inputs()? {
            self.watch(&input);
        }
        for variable in Tools::VARIABLES {
            self.watch_variable(variable);
        }
        Ok(())
    }

    /// Runs the script again when an environment variable changes.
    pub fn watch_variable(&mut self, variable: &str) {
        self.add(format_args!("rerun-if-env-changed={variable}"));
    }
}

/// The `main` of a build script. An error goes to standard error as readable text.
pub fn script(work: impl FnOnce(&mut Script) -> Result<(), Box<dyn Error>>) -> ExitCode {
    let mut directives = Script::default();
    let worked = work(&mut directives);
    match worked.and_then(|()| Ok(messages::write_data(directives.0)?)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            messages::print!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The `main` of a build script that builds one SPU program into the file `name` in `OUT_DIR`.
///
/// ```no_run
/// fn main() -> std::process::ExitCode {
///     spu_build::embed("tracer.elf", || spu_build::tracer()?.folder("shaders".as_ref()))
/// }
/// ```
pub fn embed(name: &str, image: impl FnOnce() -> Result<Image, crate::Error>) -> ExitCode {
    script(|script| {
        let out = env::var_os("OUT_DIR")
            .ok_or("OUT_DIR is not set: this function is only for build scripts")?;
        let out = PathBuf::from(out);
        let image = image()?;
        script.watch(Path::new("build.rs"));
        script.watch_image(&image)?;
        image.build(&Tools::find()?, &out.join("objects"), &out.join(name))?;
        Ok(())
    })
}
