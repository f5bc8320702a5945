//! Gives the shared library the console's soname, so that a program linked against it, or against
//! the import stub, runs with either library; and links it against an old C library's names, so that an old
//! system runs it.

use std::env;
use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use spu_build::stub;

fn main() -> ExitCode {
    match link() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn link() -> Result<(), Box<dyn Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    if env::var("CARGO_CFG_TARGET_OS")? == "linux" {
        println!("cargo:rustc-cdylib-link-arg=-Wl,-soname,libspe2.so.2");
    }
    if env::var("CARGO_CFG_TARGET_ARCH")? == "powerpc64" {
        let folder = PathBuf::from(env::var("OUT_DIR")?).join("stub");
        fs::create_dir_all(&folder)?;
        stub::glibc::build(&stub::compiler(), &folder)?;
        println!("cargo:rustc-link-search=native={}", folder.display());
    }
    Ok(())
}
