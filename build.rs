//! Builds the SPU program and embeds it; for the console's target, also a library of libspe2's names
//! to link against. Every switch is listed in `docs/build-options.md`.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use spu_build::{Tools, stub, tracer};

type Outcome<T> = Result<T, Box<dyn std::error::Error>>;

fn main() {
    if let Err(error) = build() {
        eprintln!("{error}");
        std::process::exit(1);
    }
}

fn build() -> Outcome<()> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    println!("cargo:rerun-if-changed=build.rs");

    let image = out.join("cellray-spu.elf");
    println!("cargo:rerun-if-env-changed=CELLRAY_SPU_IMAGE");
    match env::var_os("CELLRAY_SPU_IMAGE") {
        Some(ready) => {
            let ready = PathBuf::from(ready);
            println!("cargo:rerun-if-changed={}", ready.display());
            fs::copy(&ready, &image).map_err(|error| format!("{}: {error}", ready.display()))?;
        }
        None => spu_program(&out, &image)?,
    }
    println!("cargo:rustc-env=CELLRAY_SPU_IMAGE_FILE={}", image.display());

    if env::var("CARGO_CFG_TARGET_ARCH")? == "powerpc64" {
        libspe2_stub(&root, &out)?;
    }
    Ok(())
}

fn spu_program(out: &Path, image: &Path) -> Outcome<()> {
    // The folders themselves are watched too: a new file changes its folder, not a listed file.
    println!("cargo:rerun-if-changed=spu");
    for variable in Tools::VARIABLES {
        println!("cargo:rerun-if-env-changed={variable}");
    }
    let program = tracer()?;
    for input in program.inputs()? {
        println!("cargo:rerun-if-changed={}", input.display());
    }
    Ok(program.build(&Tools::find()?, &out.join("objects"), image)?)
}

/// Links the console's program against the names of libspe2 alone, so that no PS3 sysroot is needed.
fn libspe2_stub(root: &Path, out: &Path) -> Outcome<()> {
    let list = root.join("linker/libspe2.symbols");
    println!("cargo:rerun-if-changed={}", list.display());
    println!("cargo:rerun-if-env-changed=RUSTC_LINKER");
    let compiler = env::var_os("RUSTC_LINKER").unwrap_or_else(|| "cc".into());
    let folder = out.join("stub");
    fs::create_dir_all(&folder)?;
    let text = fs::read_to_string(&list).map_err(|error| format!("{}: {error}", list.display()))?;
    stub::build(
        Path::new(&compiler),
        "libspe2.so.2",
        &stub::names(&text),
        &folder.join("libspe2.so"),
    )?;
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rustc-link-lib=dylib=spe2");
    Ok(())
}
