//! Assembles programs for the tests of the machine with the SPU binutils.

use std::fs;
use std::path::Path;

/// The ELF image of a program. `_start` is added before the source.
pub fn assemble(source: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let sources = folder.path().join("sources");
    fs::create_dir(&sources).unwrap();
    let text =
        format!("        .include \"prelude.inc\"\n        .global _start\n_start:\n{source}\n");
    fs::write(sources.join("program.s"), text).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let image = folder.path().join("program");
    let built = spu_build::Tools::find().and_then(|tools| {
        spu_build::Image::from_folder(&sources, &root.join("../../linker/spu.ld"))?
            .include(&root.join("tests/emulator/machine"))
            .build(&tools, &folder.path().join("objects"), &image)
    });
    if let Err(error) = built {
        panic!("{error}\n(ci/setup installs the SPU binutils)");
    }
    fs::read(image).unwrap()
}
