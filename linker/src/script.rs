//! A build script's `main`: what cargo is told, and what a person is told when something fails.

use std::env;
use std::error::Error;
use std::fmt::{Display, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::{Image, Tools};

/// What a build script tells cargo. It is said when all went well: of a script that fails cargo
/// shows whatever it has said, so that the error would stand behind a list of files; and it runs
/// such a script again anyway.
#[derive(Debug, Default)]
pub struct Script(String);

impl Script {
    /// Tells a line, such as `rustc-link-lib=m`.
    pub fn tell(&mut self, line: impl Display) {
        // Writing to a string can't fail.
        let _ = writeln!(self.0, "cargo:{line}");
    }

    /// The script is to run again when this file changes, or anything in this folder.
    pub fn watch(&mut self, path: &Path) {
        self.tell(format_args!("rerun-if-changed={}", path.display()));
    }

    /// The same, for all that an image is made of.
    pub fn watch_image(&mut self, image: &Image) -> Result<(), crate::Error> {
        for input in image.inputs()? {
            self.watch(&input);
        }
        for variable in Tools::VARIABLES {
            self.watch_variable(variable);
        }
        Ok(())
    }

    /// The same, for a variable.
    pub fn watch_variable(&mut self, variable: &str) {
        self.tell(format_args!("rerun-if-env-changed={variable}"));
    }
}

/// The `main` of a build script: an error goes to standard error, as text to be read.
pub fn script(work: impl FnOnce(&mut Script) -> Result<(), Box<dyn Error>>) -> ExitCode {
    let mut told = Script::default();
    match work(&mut told) {
        Ok(()) => {
            print!("{}", told.0);
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The `main` of a build script that makes one SPU program, the file `name` in its folder of
/// output, `OUT_DIR`.
///
/// ```no_run
/// fn main() -> std::process::ExitCode {
///     spu_build::embed("tracer.elf", || spu_build::tracer()?.folder("shaders".as_ref()))
/// }
/// ```
pub fn embed(name: &str, image: impl FnOnce() -> Result<Image, crate::Error>) -> ExitCode {
    script(|script| {
        let out = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for a build script")?;
        let out = PathBuf::from(out);
        let image = image()?;
        script.watch(Path::new("build.rs"));
        script.watch_image(&image)?;
        image.build(&Tools::find()?, &out.join("objects"), &out.join(name))?;
        Ok(())
    })
}
