//! The tracer's program with additional shaders.

use std::sync::OnceLock;

use crate::prelude::*;
use spu_build::{Error, Tools, tracer};

/// A file of this repository.
pub fn file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// Builds the tracer's program with the sources of these folders into `image`.
pub fn build(folders: &[&Path], image: &Path) -> Result<(), Error> {
    let work = tempfile::tempdir().unwrap();
    let program = folders.iter().try_fold(tracer()?, |program, folder| program.folder(folder))?;
    program.build(&Tools::find()?, work.path(), image)
}

/// The image with the shaders of the example and of `tests/suite/frames/broken_shaders`. It is
/// built once.
pub fn image() -> &'static [u8] {
    static IMAGE: OnceLock<Vec<u8>> = OnceLock::new();
    IMAGE.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let image = folder.path().join("tracer.elf");
        let folders = [file("examples/shader/shaders"), file("tests/suite/frames/broken_shaders")];
        build(&folders.each_ref().map(PathBuf::as_path), &image).unwrap();
        fs::read(image).unwrap()
    })
}

pub fn program() -> Program {
    Program::from_image(image()).unwrap()
}
