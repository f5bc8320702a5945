//! Builds the tracer's SPU program with this crate's shaders.

use std::process::ExitCode;

fn main() -> ExitCode {
    spu_build::embed("tracer.elf", || spu_build::tracer()?.folder("shaders".as_ref()))
}
