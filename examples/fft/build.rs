//! Builds the SPU program from `spu/`, where `transform.s` is what the scheduler made of the one in
//! `plain/`.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    spu_build::embed("fft.elf", || {
        let image =
            spu_build::Image::from_folder(Path::new("spu"), "../../linker/spu.ld".as_ref())?;
        Ok(image.without_line_tables())
    })
}
