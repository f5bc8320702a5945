//! The tracer's program, as this repository has it.

use std::path::Path;

use crate::{Error, Image, Version};
use protocol::formulation::Formulations;

/// The tracer's program: its driver, its kernels scheduled, and the shaders that it comes with. It
/// intersects by the standard formulations, unless [`Image::formulations`] says otherwise.
///
/// A build script adds a folder of shaders and builds it, as [`embed`](crate::embed) shows.
pub fn tracer() -> Result<Image, Error> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let spu = root.join("spu");
    let image = Image::new(&root.join("linker/spu.ld"))
        .folder(&spu.join("main"))?
        .kernels(&spu, Version::Scheduled)?
        .only_used()
        .include(&spu.join("include"))
        .constants()
        .formulations(Formulations::standard());
    Ok(image)
}
