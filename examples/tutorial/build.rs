//! Builds the tracer's SPU program with the shaders of this crate in it.

use std::env;
use std::error::Error;
use std::path::PathBuf;

use spu_build::{Tools, tracer};

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let program = tracer()?.folder("shaders".as_ref())?;
    // The folder too: a file may be added to it.
    println!("cargo:rerun-if-changed=shaders");
    for input in program.inputs()? {
        println!("cargo:rerun-if-changed={}", input.display());
    }
    for variable in Tools::VARIABLES {
        println!("cargo:rerun-if-env-changed={variable}");
    }
    let image = out.join("tracer.elf");
    program.build(&Tools::find()?, &out.join("objects"), &image)?;
    Ok(())
}
