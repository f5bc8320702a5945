//! Builds one SPU ELF image from `.s` files.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use protocol::assembler;
use protocol::formulation::Formulations;
use spu_scheduler::Kind;

use crate::{Error, Schedules, Tools, each, file_error, run, write};

/// An SPU program to be built.
#[derive(Clone, Debug)]
pub struct Image {
    folders: Vec<PathBuf>,
    sources: Vec<PathBuf>,
    scheduled: BTreeMap<PathBuf, Kind>,
    includes: Vec<PathBuf>,
    constants: bool,
    script: PathBuf,
    link: Vec<OsString>,
    formulations: Option<Formulations>,
}

impl Image {
    /// A program from all `.s` files in `folder` and its sub-folders.
    pub fn from_folder(folder: &Path, script: &Path) -> Result<Self, Error> {
        Self::new(script).folder(folder)
    }

    /// A program without sources, for which the linker script defines the layout.
    #[must_use]
    pub fn new(script: &Path) -> Self {
        Self {
            folders: Vec::new(),
            sources: Vec::new(),
            scheduled: BTreeMap::new(),
            includes: Vec::new(),
            constants: false,
            script: script.to_path_buf(),
            link: Vec::new(),
            formulations: None,
        }
    }

    /// Adds one `.s` file.
    #[must_use]
    pub fn source(mut self, file: &Path) -> Self {
        self.sources.push(file.to_path_buf());
        self
    }

    /// Adds all `.s` files in `folder` and its sub-folders.
    pub fn folder(mut self, folder: &Path) -> Result<Self, Error> {
        let before = self.sources.len();
        collect(folder, "s", &mut self.sources)?;
        if self.sources.len() == before {
            return Err(Error::NoSources(folder.to_path_buf()));
        }
        self.folders.push(folder.to_path_buf());
        Ok(self)
    }

    /// Adds all `.s` files in `folder` and its sub-folders as kernels: the image contains their
    /// schedules.
    pub fn kernels(self, folder: &Path) -> Result<Self, Error> {
        self.scheduled(folder, Kind::Kernel)
    }

    /// Adds all `.s` files in `folder` and its sub-folders as drivers, which call kernels and each
    /// other: in the image, the instructions of their blocks are reordered.
    pub fn drivers(self, folder: &Path) -> Result<Self, Error> {
        self.scheduled(folder, Kind::Driver)
    }

    fn scheduled(self, folder: &Path, kind: Kind) -> Result<Self, Error> {
        let before = self.sources.len();
        let mut image = self.folder(folder)?;
        let sources = image.sources[before..].iter();
        image.scheduled.extend(sources.map(|source| (source.clone(), kind)));
        Ok(image)
    }

    /// Adds one `.s` file as a kernel.
    #[must_use]
    pub fn kernel(mut self, file: &Path) -> Self {
        self.scheduled.insert(file.to_path_buf(), Kind::Kernel);
        self.source(file)
    }

    /// Leaves out the line tables, so that the image depends only on its sources and not on their
    /// paths.
    #[must_use]
    pub fn without_line_tables(mut self) -> Self {
        self.link.push("--strip-debug".into());
        self
    }

    /// Leaves out sections that are not referenced.
    #[must_use]
    pub fn only_used(mut self) -> Self {
        self.link.push("--gc-sections".into());
        self
    }

    /// Allows sections to have the same addresses, of which a program loads one at a time.
    #[must_use]
    pub fn overlapping(mut self) -> Self {
        self.link.extend(["--no-overlays".into(), "--no-check-sections".into()]);
        self
    }

    /// Makes an image without an entry point, which contains functions to be called.
    #[must_use]
    pub fn without_entry(mut self) -> Self {
        self.link.push("--entry=0".into());
        self
    }

    /// Adds a folder to search for `.include` files.
    #[must_use]
    pub fn include(mut self, folder: &Path) -> Self {
        self.includes.push(folder.to_path_buf());
        self
    }

    /// Lets sources include the constants of the work-unit layout, `work_unit.inc`.
    #[must_use]
    pub fn constants(mut self) -> Self {
        self.constants = true;
        self
    }

    /// Makes the kernels of these formulations the ones that the tracer's driver calls, and stores
    /// their names in the section `.formulation`.
    #[must_use]
    pub fn formulations(mut self, formulations: Formulations) -> Self {
        self.formulations = Some(formulations);
        self
    }

    /// Every input file of the image, and every folder, in which another file may appear. A build
    /// script runs again when one of these changes.
    pub fn inputs(&self) -> Result<Vec<PathBuf>, Error> {
        let mut inputs = [&self.sources[..], &self.folders[..]].concat();
        inputs.push(self.script.clone());
        for folder in &self.includes {
            collect(folder, "inc", &mut inputs)?;
        }
        Ok(inputs)
    }

    /// Assembles the sources and links them into `image`. Object files go into `work`. Warnings
    /// count as errors.
    pub fn build(&self, tools: &Tools, work: &Path, image: &Path) -> Result<(), Error> {
        let objects = self.assemble(tools, work)?;
        self.link(tools, work, &objects, image)
    }

    /// Assembles all sources. The object files go into `work`.
    pub fn assemble(&self, tools: &Tools, work: &Path) -> Result<Vec<PathBuf>, Error> {
        fs::create_dir_all(work).map_err(|source| file_error(work, source))?;
        let mut includes = self.includes.clone();
        if self.constants {
            write(&work.join(assembler::FILE), &assembler::constants())?;
            includes.push(work.to_path_buf());
        }
        let schedules = !self.scheduled.is_empty();
        let schedules = schedules.then(|| Schedules::new(tools, &includes)).transpose()?;
        let mut numbered: Vec<(usize, &PathBuf)> = self.sources.iter().enumerate().collect();
        // Long kernels take longest, and would keep one processor busy alone at the end.
        let length = |source: &PathBuf| fs::metadata(source).map_or(0, |file| file.len());
        numbered.sort_by_cached_key(|(_, source)| Reverse(length(source)));
        let mut objects = each(&numbered, |&(number, source)| {
            let stem = source.file_stem().unwrap_or_default().to_string_lossy();
            let object = work.join(format!("{number:02}-{stem}.o"));
            let schedules = schedules.as_ref().zip(self.scheduled.get(source));
            let scheduled = schedules.map(|(schedules, &kind)| schedules.file(source, kind));
            let scheduled = scheduled.transpose()?;
            let source = scheduled.as_ref().unwrap_or(source);
            tools.assemble(&includes, &["--strip-local-absolute"], &object, source)?;
            Ok((number, object))
        })?;
        objects.sort();
        Ok(objects.into_iter().map(|(_, object)| object).collect())
    }

    /// Links the objects that [`Image::assemble`] made of the same sources. Images that differ
    /// only in their formulations share the objects.
    pub fn link(
        &self,
        tools: &Tools,
        work: &Path,
        objects: &[PathBuf],
        image: &Path,
    ) -> Result<(), Error> {
        let mut objects = objects.to_vec();
        let mut link = self.link.clone();
        if let Some(formulations) = &self.formulations {
            let name = formulations.name();
            let source = work.join(format!("formulation-{name}.s"));
            let object = work.join(format!("formulation-{name}.o"));
            write(&source, &note(formulations))?;
            tools.assemble(&[], &[], &object, &source)?;
            objects.push(object);
            let roles = formulations.roles();
            link.extend(roles.map(|(role, kernel)| format!("--defsym={role}={kernel}").into()));
        }
        let absolute =
            |path: &PathBuf| std::path::absolute(path).map_err(|source| file_error(path, source));
        link.extend(["--fatal-warnings".into(), "-T".into(), absolute(&self.script)?.into()]);
        let objects: Vec<PathBuf> = objects.iter().map(absolute).collect::<Result<_, _>>()?;
        // The linker stores the image's path in the image. Linking in the image's folder makes the
        // same bytes from the same sources anywhere.
        let name = image.file_name().unwrap_or(image.as_os_str());
        let mut command = tools.link(&link, Path::new(name), &objects);
        if let Some(folder) = image.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            command.current_dir(folder);
        }
        run(&mut command)
    }
}

/// A source of the section that holds the names of the formulations.
fn note(formulations: &Formulations) -> String {
    let lines = formulations.names().map(|name| format!("        .asciz  \"{name}\"\n"));
    format!("        .section .formulation,\"\",@progbits\n{}", lines.concat())
}

/// All files below `folder` with this extension, sorted, so that an image does not depend on the
/// order in which the system lists them.
fn collect(folder: &Path, extension: &str, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    let error = |source| file_error(folder, source);
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
