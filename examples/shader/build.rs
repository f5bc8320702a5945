//! Builds the tracer's SPU program with this crate's shaders in it.

use std::env;
use std::error::Error;
use std::path::PathBuf;

use spu_build::{Tools, tracer};

fn main() -> Result<(), Box<dyn Error>> {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    println!("cargo:rerun-if-changed=shaders");
    for variable in Tools::VARIABLES {
        println!("cargo:rerun-if-env-changed={variable}");
    }
    let program = tracer()?.folder(&here.join("shaders"))?;
    for input in program.inputs()? {
        println!("cargo:rerun-if-changed={}", input.display());
    }
    program.build(
        &Tools::find()?,
        &out.join("objects"),
        &out.join("tracer.elf"),
    )?;
    Ok(())
}
