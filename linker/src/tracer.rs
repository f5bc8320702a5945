//! The tracer's program, as this repository has it.

use std::fs;
use std::path::{Path, PathBuf};

use protocol::assembler;
use protocol::formulation::Formulations;

use crate::{Error, Image, Tools, file_error, write};

/// Folders below `spu/` that hold kernels.
const KERNELS: [&str; 4] = ["isect", "shade", "shaders", "trace"];

/// The tracer's program: its driver, its kernels scheduled, and the shaders that it comes with. It
/// intersects by the standard formulations, unless [`Image::formulations`] says otherwise.
///
/// A build script adds a folder of shaders and builds it, as [`embed`](crate::embed) shows.
pub fn tracer() -> Result<Image, Error> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    // A link to the repository's folder, whose files are in this crate's package.
    let spu = root.join("spu");
    let mut image = Image::new(&root.join("spu.ld")).folder(&spu.join("main"))?;
    for kernels in KERNELS {
        image = image.kernels(&spu.join(kernels), &spu.join("scheduled").join(kernels))?;
    }
    let image = image
        .only_used()
        .include(&spu.join("include"))
        .constants()
        .formulations(Formulations::standard());
    Ok(image)
}

/// Builds the tracer's program with further shaders in it, each in a `.s` file of its own, and
/// returns the ELF image: for programs that try out shaders as they run.
///
/// # Errors
///
/// No SPU assembler, a source that it refuses, or a file that can't be read.
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

/// Assembles one shader into an object, with the names of its registers, which the scheduler needs.
///
/// # Errors
///
/// As for [`tracer_with`].
pub fn assemble_shader(shader: &Path, object: &Path) -> Result<(), Error> {
    let temporary = std::env::temp_dir();
    let work = tempfile::tempdir().map_err(|source| file_error(&temporary, source))?;
    let constants = work.path().join(assembler::FILE);
    write(&constants, &assembler::constants())?;
    let includes = Path::new(env!("CARGO_MANIFEST_DIR")).join("spu/include");
    let includes = [includes, work.path().to_path_buf()];
    Tools::find()?.assemble(&includes, &[], object, shader)
}
