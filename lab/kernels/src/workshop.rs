//! Makes everything that the laboratory runs from the kernels' sources: schedules, objects and
//! images. Schedules and objects are kept as for every build ([`Schedules`]).

use std::fs;
use std::path::{Path, PathBuf};

use protocol::assembler;
use protocol::formulation::Formulations;
use spu_build::{Image, Schedules, Tools, each};
use spu_isa::timing::Rules;
use spu_scheduler::check::{self, CheckError};
use spu_scheduler::code::{Code, CodeError};
use spu_scheduler::{Kind, Scheduled};
use thiserror::Error;

use crate::source::Source;

/// Why something could not be made or checked.
#[derive(Debug, Error)]
pub enum WorkshopError {
    /// A source can't be assembled or scheduled, or an image can't be linked.
    #[error(transparent)]
    Build(#[from] spu_build::Error),
    /// A file can't be read or written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's error.
        source: std::io::Error,
    },
    /// An object has no code.
    #[error("{}: {source}", path.display())]
    Code {
        /// The source.
        path: PathBuf,
        /// The reason.
        source: CodeError,
    },
    /// The notes of a schedule can't be checked.
    #[error("{}: {source}", path.display())]
    Check {
        /// The source.
        path: PathBuf,
        /// The reason.
        source: CheckError,
    },
    /// Images are missing or stale.
    #[error("stale: {}; write them again with `kernels images`", .0.join(", "))]
    StaleImages(Vec<String>),
}

/// The sources of a repository, and what is made of them.
#[derive(Debug)]
pub struct Workshop {
    root: PathBuf,
    tools: Tools,
    schedules: Schedules,
}

impl Workshop {
    /// A workshop for the sources of the repository in folder `root`. The file that the build
    /// generates for them to include goes to the folder `made`. `keep` determines where schedules
    /// are kept, of the tools and the folders of includes.
    pub fn new(
        root: &Path,
        made: &Path,
        keep: impl FnOnce(&Tools, &[PathBuf]) -> Result<Schedules, spu_build::Error>,
    ) -> Result<Self, WorkshopError> {
        let file = |source| WorkshopError::File { path: made.to_path_buf(), source };
        fs::create_dir_all(made).map_err(file)?;
        let constants = made.join(assembler::FILE);
        let text = assembler::constants();
        // Another process may be reading it.
        if fs::read_to_string(&constants).ok().as_ref() != Some(&text) {
            let fresh = tempfile::NamedTempFile::new_in(made).map_err(file)?;
            fs::write(&fresh, text).map_err(file)?;
            fresh.persist(&constants).map_err(|error| file(error.error))?;
        }
        let includes = [root.join("spu/include"), root.join("lab/spu/include"), made.to_path_buf()];
        let tools = Tools::find()?;
        let schedules = keep(&tools, &includes)?;
        Ok(Self { root: root.to_path_buf(), tools, schedules })
    }

    /// A workshop for this repository's sources and build folder.
    pub fn here() -> Result<Self, WorkshopError> {
        let root = Path::new(HERE);
        let target = std::env::var_os("CARGO_TARGET_DIR");
        let target = target.map_or_else(|| root.join("target"), PathBuf::from);
        Self::new(root, &target.join("kernels"), Schedules::new)
    }

    /// All kernels.
    pub fn sources(&self) -> Result<Vec<Source>, WorkshopError> {
        Source::all(&self.root).map_err(|(path, source)| WorkshopError::File { path, source })
    }

    /// A kernel's schedule.
    pub fn schedule(&self, kernel: &Source) -> Result<Scheduled, WorkshopError> {
        Ok(self.schedules.schedule(&self.root.join(kernel.file))?)
    }

    /// Compares the notes in a kernel's schedule with the model, like `spu time --check`.
    pub fn notes(&self, kernel: &Source) -> Result<check::Outcome, WorkshopError> {
        let path = self.schedules.file(&self.root.join(kernel.file), Kind::Kernel)?;
        let failed = |path: &Path| {
            let path = path.to_path_buf();
            |source| WorkshopError::File { path, source }
        };
        let text = fs::read_to_string(&path).map_err(failed(&path))?;
        let object = self.schedules.object(&path)?;
        let bytes = fs::read(&object).map_err(failed(&object))?;
        let code = Code::parse(&bytes)
            .map_err(|source| WorkshopError::Code { path: path.clone(), source })?;
        check::check(&code, &[(path.clone(), text)], Rules::default())
            .map_err(|source| WorkshopError::Check { path, source })
    }

    /// The images of all kernels, plain and scheduled. They contain no program around the kernels.
    pub fn images(&self, kernels: &[Source]) -> Result<[Vec<u8>; 2], WorkshopError> {
        let schedules = &self.schedules;
        let start = schedules.object(&self.root.join("lab/kernels/image/start.s"))?;
        let path = |kernel: &Source| self.root.join(kernel.file);
        let plain = each(kernels, |kernel| schedules.object(&path(kernel)))?;
        let scheduled = each(kernels, |kernel| {
            schedules.object(&schedules.file(&path(kernel), Kind::Kernel)?)
        })?;
        let link = |mut objects: Vec<PathBuf>| {
            objects.insert(0, start.clone());
            let image = Image::new(&self.root.join("linker/spu.ld"));
            self.link(&image, &objects)
        };
        Ok([link(plain)?, link(scheduled)?])
    }

    /// The tracer's program with any formulations.
    pub fn tracer(&self, formulations: Formulations) -> Result<Vec<u8>, WorkshopError> {
        let sources = self.sources()?;
        let roles = formulations.roles().map(|(_, kernel)| kernel);
        let mut image = spu_build::tracer()?.include(&self.root.join("lab/spu/include"));
        for kernel in sources.iter().filter(|kernel| !kernel.shipped()) {
            if roles.contains(&kernel.name) {
                image = image.kernel(&self.root.join(kernel.file));
            }
        }
        let image = image.formulations(formulations);
        let work = tempfile::tempdir()
            .map_err(|source| WorkshopError::File { path: std::env::temp_dir(), source })?;
        let objects = image.assemble(&self.tools, work.path())?;
        self.link(&image, &objects)
    }

    fn link(&self, image: &Image, objects: &[PathBuf]) -> Result<Vec<u8>, WorkshopError> {
        let work = tempfile::tempdir()
            .map_err(|source| WorkshopError::File { path: std::env::temp_dir(), source })?;
        let file = work.path().join("image.elf");
        image.link(&self.tools, work.path(), objects, &file)?;
        fs::read(&file).map_err(|source| WorkshopError::File { path: file, source })
    }
}

/// The repository's root.
const HERE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
