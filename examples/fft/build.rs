//! Builds the SPU program from `spu/` and the schedules of `kernels/`.

use std::process::ExitCode;

fn main() -> ExitCode {
    spu_build::embed("fft.elf", || {
        let image = spu_build::Image::from_folder("spu".as_ref(), "../../linker/spu.ld".as_ref())?;
        Ok(image.kernels("kernels".as_ref())?.without_line_tables())
    })
}
