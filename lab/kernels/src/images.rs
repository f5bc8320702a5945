//! The stored images, for builds without an SPU assembler.

use std::fs;
use std::path::Path;

use spu_build::{Tools, prebuilt};

use crate::workshop::WorkshopError;

/// Builds the images that `cellray` ships and writes them to `spu/images`.
///
/// # Errors
///
/// Fails if there is no SPU assembler, if it rejects a source, or if a file can't be written.
pub fn write() -> Result<(), WorkshopError> {
    build(&prebuilt::folder())
}

/// Compares the images in `spu/images` with those that the present sources make.
///
/// # Errors
///
/// Fails with [`WorkshopError::StaleImages`], which names the files that differ.
pub fn check() -> Result<(), WorkshopError> {
    let fresh = temporary()?;
    build(fresh.path())?;
    let mut stale = Vec::new();
    for file in files(fresh.path())? {
        let name = file.file_name().unwrap_or_default();
        if read(&file)? != fs::read(prebuilt::folder().join(name)).unwrap_or_default() {
            stale.push(format!("spu/images/{}", name.display()));
        }
    }
    if stale.is_empty() { Ok(()) } else { Err(WorkshopError::StaleImages(stale)) }
}

fn build(folder: &Path) -> Result<(), WorkshopError> {
    Ok(prebuilt::build(&Tools::find()?, temporary()?.path(), folder)?)
}

fn temporary() -> Result<tempfile::TempDir, WorkshopError> {
    tempfile::tempdir().map_err(|source| failed(&std::env::temp_dir(), source))
}

fn files(folder: &Path) -> Result<Vec<std::path::PathBuf>, WorkshopError> {
    let error = |source| failed(folder, source);
    let entries = fs::read_dir(folder).map_err(error)?;
    let mut files = entries
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>, _>>()
        .map_err(error)?;
    files.sort();
    Ok(files)
}

fn read(path: &Path) -> Result<Vec<u8>, WorkshopError> {
    fs::read(path).map_err(|source| failed(path, source))
}

fn failed(path: &Path, source: std::io::Error) -> WorkshopError {
    WorkshopError::File { path: path.to_path_buf(), source }
}
