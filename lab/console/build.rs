//! Builds the SPU program of the instruction corners.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    spu_build::embed("corners.elf", || {
        let folder = Path::new("spu");
        let script = Path::new("../../linker/spu.ld");
        Ok(spu_build::Image::from_folder(folder, script)?.without_line_tables())
    })
}
