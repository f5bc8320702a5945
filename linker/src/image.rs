//! From `.s` files to one SPU ELF image.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::{Error, Tools, run};

/// An SPU program to be built.
#[derive(Clone, Debug)]
pub struct Image {
    sources: Vec<PathBuf>,
    includes: Vec<PathBuf>,
    script: PathBuf,
}

impl Image {
    /// A program of all `.s` files in `folder` and its sub-folders, laid out by the linker script.
    pub fn from_folder(folder: &Path, script: &Path) -> Result<Self, Error> {
        let mut sources = Vec::new();
        collect(folder, "s", &mut sources)?;
        if sources.is_empty() {
            return Err(Error::NoSources(folder.to_path_buf()));
        }
        Ok(Self {
            sources,
            includes: Vec::new(),
            script: script.to_path_buf(),
        })
    }

    /// Adds a folder in which `.include` finds files.
    #[must_use]
    pub fn include(mut self, folder: &Path) -> Self {
        self.includes.push(folder.to_path_buf());
        self
    }

    /// Every file that the image is made of: a build script reruns when one changes.
    pub fn inputs(&self) -> Result<Vec<PathBuf>, Error> {
        let mut inputs = self.sources.clone();
        inputs.push(self.script.clone());
        for folder in &self.includes {
            collect(folder, "inc", &mut inputs)?;
        }
        Ok(inputs)
    }

    /// Assembles and links into `image`; object files go into `work`. Warnings count as errors:
    /// of an operand out of range, the assembler only warns.
    pub fn build(&self, tools: &Tools, work: &Path, image: &Path) -> Result<(), Error> {
        let file_error = |source| Error::File {
            path: work.to_path_buf(),
            source,
        };
        fs::create_dir_all(work).map_err(file_error)?;
        let mut assemble: Vec<OsString> = ["--fatal-warnings", "-g", "--strip-local-absolute"]
            .map(OsString::from)
            .to_vec();
        for folder in &self.includes {
            assemble.extend(["-I".into(), folder.into()]);
        }
        let mut objects = Vec::new();
        for (number, source) in self.sources.iter().enumerate() {
            let stem = source.file_stem().unwrap_or_default().to_string_lossy();
            let object = work.join(format!("{number:02}-{stem}.o"));
            run(&mut tools.assemble(&assemble, &object, source))?;
            objects.push(object);
        }
        let link = [
            "--fatal-warnings".into(),
            "-T".into(),
            self.script.clone().into(),
        ];
        run(&mut tools.link(&link, image, &objects))
    }
}

/// All files below `folder` that end in `extension`, sorted, so that an image never depends on the
/// order in which the system lists them.
fn collect(folder: &Path, extension: &str, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    let error = |source| Error::File {
        path: folder.to_path_buf(),
        source,
    };
    let mut entries = fs::read_dir(folder)
        .map_err(error)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<_>, _>>()
        .map_err(error)?;
    entries.sort();
    for path in entries {
        if path.is_dir() {
            collect(&path, extension, files)?;
        } else if path.extension().is_some_and(|found| found == extension) {
            files.push(path);
        }
    }
    Ok(())
}
