//! Makes everything that the laboratory runs from the kernels' sources: schedules, objects and
//! images.
//!
//! The schedules of kernels that `cellray` ships are files in the repository, which are compared
//! with the scheduler's output. The others are made when they are needed. Results are kept in the
//! build folder under a hash of all their inputs: the source, its includes, and the scheduler's
//! own code. So nothing here depends on when it was compiled, and after an edit only the files
//! that depend on it are made again.

use std::collections::BTreeSet;
use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use protocol::assembler;
use protocol::formulation::Formulations;
use serde::{Deserialize, Serialize};
use spu_build::{Image, Tools};
use spu_isa::timing::Rules;
use spu_scheduler::check::{self, CheckError};
use spu_scheduler::code::{Code, CodeError};
use spu_scheduler::{self as scheduler, Outcome};
use thiserror::Error;

use crate::loops::Cycles;
use crate::source::Source;

/// Why something could not be made or checked.
#[derive(Debug, Error)]
pub enum WorkshopError {
    /// A source can't be assembled, or an image can't be linked.
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
    /// The scheduler rejects a source.
    #[error("{}: {source}", path.display())]
    Scheduler {
        /// The source.
        path: PathBuf,
        /// The reason.
        source: scheduler::ScheduleError,
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
    /// Schedules are missing or stale.
    #[error("stale: {}; write them again with `kernels schedule`", .0.join(", "))]
    Stale(Vec<String>),
    /// Images are missing or stale.
    #[error("stale: {}; write them again with `kernels images`", .0.join(", "))]
    StaleImages(Vec<String>),
}

/// The scheduler's output for a kernel.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Schedule {
    /// The new source.
    pub text: String,
    /// Its loops: their labels, and the cycles of a pass or the reason why passes do not overlap.
    pub loops: Vec<(String, Result<Cycles, String>)>,
}

/// The sources of a repository, and the folder for files made from them.
#[derive(Debug)]
pub struct Workshop {
    root: PathBuf,
    made: PathBuf,
    tools: Tools,
    includes: Vec<PathBuf>,
    /// The hash of the scheduler's code.
    scheduler: u64,
}

/// The folders of the repository that hold the scheduler's code.
const SCHEDULER: [&str; 2] = ["emulator/isa/src", "emulator/scheduler/src"];

impl Workshop {
    /// A workshop for the sources of the repository in folder `root`. Files made from them go to
    /// the folder `made`.
    pub fn new(root: &Path, made: &Path) -> Result<Self, WorkshopError> {
        let mut includes = vec![root.join("spu/include"), root.join("lab/spu/include")];
        let constants = assembler::constants();
        let generated = made.join(format!("{:016x}", hash([constants.as_bytes()])));
        store(&generated.join(assembler::FILE), constants.as_bytes())?;
        includes.push(generated);
        let folders = SCHEDULER.map(|folder| Path::new(HERE).join(folder));
        Ok(Self {
            root: root.to_path_buf(),
            made: made.to_path_buf(),
            tools: Tools::find()?,
            scheduler: hash_of_files(&folders)?,
            includes,
        })
    }

    /// A workshop for this repository's sources and build folder.
    pub fn here() -> Result<Self, WorkshopError> {
        let root = Path::new(HERE);
        let target = std::env::var_os("CARGO_TARGET_DIR");
        let target = target.map_or_else(|| root.join("target"), PathBuf::from);
        Self::new(root, &target.join("kernels"))
    }

    /// All kernels.
    pub fn sources(&self) -> Result<Vec<Source>, WorkshopError> {
        Source::all(&self.root).map_err(|(path, source)| WorkshopError::File { path, source })
    }

    /// Schedules a kernel, or returns a kept result.
    pub fn schedule(&self, kernel: &Source) -> Result<Schedule, WorkshopError> {
        let path = self.root.join(kernel.file);
        let text = read(&path)?;
        let key = hash([
            text.as_bytes(),
            path.as_os_str().as_encoded_bytes(),
            &self.included(&text)?.to_be_bytes(),
            &self.scheduler.to_be_bytes(),
        ]);
        let kept = self.made.join(format!("{key:016x}/{}.json", kernel.name));
        if let Ok(schedule) = fs::read(&kept)
            && let Ok(schedule) = serde_json::from_slice(&schedule)
        {
            return Ok(schedule);
        }
        let contents = |object: PathBuf| {
            fs::read(&object).map_err(|source| WorkshopError::File { path: object, source })
        };
        let object = self.object(&path).and_then(contents)?;
        let copy = kept.with_extension("s");
        let assemble = |text: &str| {
            store(&copy, text.as_bytes())?;
            self.object(&copy).and_then(contents)
        };
        let made = scheduler::schedule(&object, &path.to_string_lossy(), &text, assemble)
            .map_err(|source| WorkshopError::Scheduler { path: path.clone(), source })?;
        let loops = made.loops.into_iter().map(|report| {
            let outcome = match report.outcome {
                Outcome::Pipelined(figures) => Ok((&figures).into()),
                Outcome::Plain(why) => Err(why),
            };
            (report.name, outcome)
        });
        let schedule = Schedule { loops: loops.collect(), text: made.text };
        let json = serde_json::to_vec(&schedule).expect("texts and numbers can be written as JSON");
        store(&kept, &json)?;
        Ok(schedule)
    }

    /// Schedules many kernels with as many threads as there are processors.
    pub fn schedules(&self, kernels: &[Source]) -> Result<Vec<Schedule>, WorkshopError> {
        self.each(kernels, Self::schedule)
    }

    /// The file of a kernel's schedule: the repository's, or one that is made now.
    fn scheduled(&self, kernel: &Source) -> Result<PathBuf, WorkshopError> {
        if let Some(file) = kernel.scheduled_file() {
            return Ok(self.root.join(file));
        }
        let schedule = self.schedule(kernel)?;
        let key = hash([schedule.text.as_bytes()]);
        let path = self.made.join(format!("{key:016x}/{}.s", kernel.name));
        store(&path, schedule.text.as_bytes())?;
        Ok(path)
    }

    /// Writes the schedules of the shipped kernels among these.
    pub fn write(&self, kernels: &[Source]) -> Result<(), WorkshopError> {
        for (kernel, schedule) in kernels.iter().zip(self.schedules(kernels)?) {
            if let Some(file) = kernel.scheduled_file() {
                store(&self.root.join(file), schedule.text.as_bytes())?;
            }
        }
        Ok(())
    }

    /// Compares the schedules of the shipped kernels among these with the scheduler's present
    /// output. The error names all that are stale.
    pub fn check(&self, kernels: &[Source]) -> Result<(), WorkshopError> {
        let mut stale = Vec::new();
        for (kernel, schedule) in kernels.iter().zip(self.schedules(kernels)?) {
            let Some(file) = kernel.scheduled_file() else {
                continue;
            };
            let path = self.root.join(&file);
            let found = match fs::read_to_string(&path) {
                Ok(text) => Some(text),
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
                Err(source) => return Err(WorkshopError::File { path, source }),
            };
            if found != Some(schedule.text) {
                stale.push(file);
            }
        }
        if stale.is_empty() { Ok(()) } else { Err(WorkshopError::Stale(stale)) }
    }

    /// Compares the notes in a kernel's schedule with the model, like `spu time --check`.
    pub fn notes(&self, kernel: &Source) -> Result<check::Outcome, WorkshopError> {
        let path = self.scheduled(kernel)?;
        let text = read(&path)?;
        let object = self.object(&path)?;
        let bytes =
            fs::read(&object).map_err(|source| WorkshopError::File { path: object, source })?;
        let code = Code::parse(&bytes)
            .map_err(|source| WorkshopError::Code { path: path.clone(), source })?;
        check::check(&code, &[(path.clone(), text)], Rules::default())
            .map_err(|source| WorkshopError::Check { path, source })
    }

    /// The images of all kernels, plain and scheduled. They contain no program around the kernels.
    pub fn images(&self, kernels: &[Source]) -> Result<[Vec<u8>; 2], WorkshopError> {
        let start = self.object(&self.root.join("lab/kernels/image/start.s"))?;
        let plain = self.each(kernels, |this, kernel| this.object(&this.root.join(kernel.file)))?;
        let scheduled = self.each(kernels, |this, kernel| this.object(&this.scheduled(kernel)?))?;
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
                image = image.source(&self.scheduled(kernel)?);
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

    /// A hash of all files that a source includes, directly or indirectly.
    fn included(&self, text: &str) -> Result<u64, WorkshopError> {
        let mut hasher = DefaultHasher::new();
        let mut seen = BTreeSet::new();
        let mut open = included_names(text);
        while let Some(name) = open.pop() {
            let found = |folder: &PathBuf| Some(folder.join(&name)).filter(|path| path.is_file());
            // The assembler reports missing files.
            if let Some(path) = self.includes.iter().find_map(found)
                && seen.insert(path.clone())
            {
                let text = read(&path)?;
                (&name, &text).hash(&mut hasher);
                open.extend(included_names(&text));
            }
        }
        Ok(hasher.finish())
    }

    /// The object of a source, with the names of registers, which the scheduler needs.
    fn object(&self, source: &Path) -> Result<PathBuf, WorkshopError> {
        let text = read(source)?;
        let key = hash([
            text.as_bytes(),
            source.as_os_str().as_encoded_bytes(),
            &self.included(&text)?.to_be_bytes(),
        ]);
        let stem = source.file_stem().unwrap_or_default().to_string_lossy();
        let folder = self.made.join(format!("{key:016x}"));
        let object = folder.join(format!("{stem}.o"));
        if !object.is_file() {
            let failed = |path: &Path| {
                let path = path.to_path_buf();
                |source| WorkshopError::File { path, source }
            };
            fs::create_dir_all(&folder).map_err(failed(&folder))?;
            // Another process that makes the same file at the same time never sees a partial file.
            let partial = tempfile::tempdir_in(&folder).map_err(failed(&folder))?;
            let fresh = partial.path().join("fresh.o");
            self.tools.assemble(&self.includes, &[], &fresh, source)?;
            fs::rename(&fresh, &object).map_err(failed(&object))?;
        }
        Ok(object)
    }

    fn each<T: Send>(
        &self,
        kernels: &[Source],
        make: impl Fn(&Self, &Source) -> Result<T, WorkshopError> + Sync,
    ) -> Result<Vec<T>, WorkshopError> {
        let next = AtomicUsize::new(0);
        let work = || {
            let mut made = Vec::new();
            while let Some(kernel) = kernels.get(next.fetch_add(1, Ordering::Relaxed)) {
                made.push((kernel.file, make(self, kernel)));
            }
            made
        };
        let workers = thread::available_parallelism().map_or(1, usize::from);
        let mut made: Vec<_> = thread::scope(|scope| {
            let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
            let made = workers
                .into_iter()
                .flat_map(|worker| worker.join().expect("the worker does not panic"));
            made.collect()
        });
        made.sort_by_key(|(file, _)| kernels.iter().position(|kernel| kernel.file == *file));
        made.into_iter().map(|(_, made)| made).collect()
    }
}

/// The repository's root.
const HERE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The files named by a text's `.include` directives.
fn included_names(text: &str) -> Vec<String> {
    let behind = text.split(".include").skip(1);
    let names = behind.filter_map(|rest| rest.lines().next()?.split('"').nth(1));
    names.map(ToOwned::to_owned).collect()
}

/// A hash that is the same in every run.
fn hash<const N: usize>(parts: [&[u8]; N]) -> u64 {
    let mut hasher = DefaultHasher::new();
    parts.hash(&mut hasher);
    hasher.finish()
}

/// A hash of all files below these folders, and of their names.
fn hash_of_files(folders: &[PathBuf]) -> Result<u64, WorkshopError> {
    let mut hasher = DefaultHasher::new();
    let mut open = folders.to_vec();
    while let Some(folder) = open.pop() {
        let failed = |source| WorkshopError::File { path: folder.clone(), source };
        let entries = fs::read_dir(&folder).map_err(failed)?;
        let entries = entries.map(|entry| entry.map(|entry| entry.path()));
        let mut entries: Vec<PathBuf> = entries.collect::<Result<_, _>>().map_err(failed)?;
        entries.sort();
        for path in entries {
            if path.is_dir() {
                open.push(path);
            } else {
                path.file_name().hash(&mut hasher);
                let bytes = fs::read(&path);
                bytes.map_err(|source| WorkshopError::File { path, source })?.hash(&mut hasher);
            }
        }
    }
    Ok(hasher.finish())
}

/// Writes a file and its folders, unless it already has these bytes. Other processes never see a
/// partial file.
fn store(path: &Path, bytes: &[u8]) -> Result<(), WorkshopError> {
    if fs::read(path).is_ok_and(|found| found == bytes) {
        return Ok(());
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    let stored = fs::create_dir_all(folder).and_then(|()| {
        let mut file = tempfile::NamedTempFile::new_in(folder)?;
        std::io::Write::write_all(&mut file, bytes)?;
        file.persist(path)?;
        Ok(())
    });
    stored.map_err(|source| WorkshopError::File { path: path.to_path_buf(), source })
}

fn read(path: &Path) -> Result<String, WorkshopError> {
    fs::read_to_string(path)
        .map_err(|source| WorkshopError::File { path: path.to_path_buf(), source })
}
