//! Sets the shared library's soname to the console's, so that a program linked against it, or
//! against the import stub, runs with either library. It also links the library against symbol
//! versions of an old C library, so that it runs on old systems.

use std::env;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use spu_build::{Script, script, stub};

fn main() -> ExitCode {
    script(link)
}

fn link(script: &mut Script) -> Result<(), Box<dyn Error>> {
    script.watch(Path::new("build.rs"));
    if env::var("CARGO_CFG_TARGET_OS")? == "linux" {
        script.add("rustc-cdylib-link-arg=-Wl,-soname,libspe2.so.2");
    }
    let glibc = env::var("CARGO_CFG_TARGET_ENV")? == "gnu";
    if env::var("CARGO_CFG_TARGET_ARCH")? == "powerpc64" && glibc {
        let folder = PathBuf::from(env::var("OUT_DIR")?).join("stub");
        fs::create_dir_all(&folder)?;
        stub::glibc::build(&stub::compiler(script), &folder)?;
        script.add(format_args!("rustc-link-search=native={}", folder.display()));
    }
    Ok(())
}
