//! Passes a hash of its sources to the crate, so that stored schedules are replaced when the
//! scheduler changes.

#![allow(clippy::print_stdout, reason = "cargo reads a build script's directives there")]

use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::io;
use std::path::{Path, PathBuf};

fn main() -> io::Result<()> {
    let mut hasher = DefaultHasher::new();
    // In a package of this crate alone, the version stands for the instruction set.
    env!("CARGO_PKG_VERSION").hash(&mut hasher);
    for folder in ["src", "../isa/src"].map(Path::new) {
        println!("cargo:rerun-if-changed={}", folder.display());
        if folder.is_dir() {
            add(folder, &mut hasher)?;
        }
    }
    println!("cargo:rustc-env=SPU_SCHEDULER_SOURCES={:016x}", hasher.finish());
    Ok(())
}

fn add(folder: &Path, hasher: &mut DefaultHasher) -> io::Result<()> {
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut entries = entries.collect::<io::Result<Vec<PathBuf>>>()?;
    entries.sort();
    for path in entries {
        if path.is_dir() {
            add(&path, hasher)?;
        } else {
            path.file_name().hash(hasher);
            fs::read(&path)?.hash(hasher);
        }
    }
    Ok(())
}
