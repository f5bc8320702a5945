//! The tracer's program, as this repository has it.

use std::path::Path;

use protocol::formulation::Formulations;

use crate::{Error, Image};

/// Folders below `spu/` that hold kernels.
const KERNELS: [&str; 4] = ["isect", "shade", "shaders", "trace"];

/// The tracer's program: its driver, its kernels scheduled, and the shaders that it comes with. It
/// intersects by the standard formulations, unless [`Image::formulations`] says otherwise.
///
/// A build script adds a folder of shaders and builds it, as [`embed`](crate::embed) shows.
pub fn tracer() -> Result<Image, Error> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let spu = root.join("spu");
    let mut image = Image::new(&root.join("linker/spu.ld")).folder(&spu.join("main"))?;
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
