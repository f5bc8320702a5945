//! Builds the SPU program of the microbenchmarks.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    spu_build::embed("clock.elf", || {
        let folder = Path::new("spu");
        let script = Path::new("../../linker/spu.ld");
        Ok(spu_build::Image::from_folder(folder, script)?.include(folder).without_line_tables())
    })
}
