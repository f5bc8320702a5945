//! The tracer's program, as it is in this repository.

use std::fs;
use std::path::{Path, PathBuf};

use protocol::assembler;
use protocol::formulation::Formulations;

use crate::{Error, Image, Tools, file_error, write};

/// Folders below `spu/` that hold kernels.
const KERNELS: [&str; 5] = ["build", "isect", "shade", "shaders", "trace"];

/// The tracer's program: its driver, its kernels, and its own shaders. It uses the
/// standard formulations, unless [`Image::formulations`] chooses others.
///
/// A build script adds a folder of shaders and builds the image, as [`embed`](crate::embed) shows.
pub fn tracer() -> Result<Image, Error> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    // A link to the repository's folder, so that this crate's package contains the files.
    let spu = root.join("spu");
    let mut image = Image::new(&root.join("spu.ld")).drivers(&spu.join("main"))?;
    for kernels in KERNELS {
        image = image.kernels(&spu.join(kernels))?;
    }
    let image = image
        .only_used()
        .overlapping()
        .include(&spu.join("include"))
        .constants()
        .formulations(Formulations::standard());
    Ok(image)
}

/// Builds the tracer's program with additional shaders, each in its own `.s` file, and returns the
/// ELF image. Programs that try out shaders at run time use it.
///
/// # Errors
///
/// Fails if there is no SPU assembler, if it rejects a source, or if a file can't be read.
pub fn tracer_with(shaders: &[PathBuf]) -> Result<Vec<u8>, Error> {
    let temporary = std::env::temp_dir();
    let work = tempfile::tempdir().map_err(|source| file_error(&temporary, source))?;
    let mut program = tracer()?;
    for shader in shaders {
        fs::metadata(shader).map_err(|source| file_error(shader, source))?;
        program = program.source(shader);
    }
    let image = work.path().join("tracer.elf");
    program.build(&Tools::find()?, &work.path().join("objects"), &image)?;
    fs::read(&image).map_err(|source| file_error(&image, source))
}

/// Assembles one shader into an object that includes the names of its registers, which the
/// scheduler needs.
///
/// # Errors
///
/// The same as those of [`tracer_with`].
pub fn assemble_shader(shader: &Path, object: &Path) -> Result<(), Error> {
    let temporary = std::env::temp_dir();
    let work = tempfile::tempdir().map_err(|source| file_error(&temporary, source))?;
    let constants = work.path().join(assembler::FILE);
    write(&constants, &assembler::constants())?;
    let includes = Path::new(env!("CARGO_MANIFEST_DIR")).join("spu/include");
    let includes = [includes, work.path().to_path_buf()];
    Tools::find()?.assemble(&includes, &[], object, shader)
}
