//! Programs for tests. A build that fails is a test that fails.

use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};

use crate::{Image, Tools};

/// Builds an image as this file, with its objects in `objects` beside it.
///
/// # Panics
///
/// Panics if there are no SPU binutils, or if they refuse a source.
pub fn build(image: &Image, program: &Path) {
    let built = Tools::find()
        .and_then(|tools| image.build(&tools, &program.with_file_name("objects"), program))
        .map_err(|error| error.to_string())
        .and_then(|()| {
            let executable = fs::Permissions::from_mode(0o755);
            fs::set_permissions(program, executable).map_err(|error| error.to_string())
        });
    built.unwrap_or_else(|error| panic!("{error}"));
}

/// Builds a source, which becomes `sources/<name>.s` in the folder, as `program` there.
///
/// # Panics
///
/// As for [`build`].
#[must_use]
pub fn build_source(source: &str, name: &str, folder: &Path, includes: &[PathBuf]) -> PathBuf {
    let sources = folder.join("sources");
    fs::create_dir_all(&sources).expect("the test's folder is writable");
    fs::write(sources.join(format!("{name}.s")), source).expect("the test's folder is writable");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("spu.ld");
    let image = Image::from_folder(&sources, &script).expect("there is a source");
    let program = folder.join("program");
    build(&includes.iter().fold(image, |image, folder| image.include(folder)), &program);
    program
}

/// Builds a program that begins with these instructions. They may use the macros of the emulator's
/// tests.
///
/// # Panics
///
/// As for [`build`].
#[must_use]
pub fn build_instructions(instructions: &str, folder: &Path) -> PathBuf {
    let text = format!(
        "        .include \"prelude.inc\"\n        .global _start\n_start:\n{instructions}\n"
    );
    let macros = Path::new(env!("CARGO_MANIFEST_DIR")).join("../emulator/machine/tests/emulator");
    build_source(&text, "program", folder, &[macros.join("machine")])
}
