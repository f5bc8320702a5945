//! Schedules and objects of kernels: made when they are needed, and kept.
//!
//! Invariant: a file is kept under a hash of all that it is made of: the source, the files that the
//! source includes, directly or indirectly, and the scheduler's own code. So an edit costs the
//! kernels that it concerns, and nothing depends on times of files.

use std::collections::BTreeSet;
use std::env;
use std::ffi::OsStr;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher as _};
use std::path::{Path, PathBuf};

use protocol::assembler;
use spu_scheduler::{Figures, Kind, LoopReport, Outcome, Scheduled, schedule};

use crate::{Error, Tools, file_error, tools};

/// The schedules of sources that search the same folders for includes.
#[derive(Clone, Debug)]
pub struct Schedules {
    tools: Tools,
    includes: Vec<PathBuf>,
    kept: PathBuf,
}

/// What of the included files a kept file is made of.
#[derive(Clone, Copy)]
enum Included {
    /// All of it.
    Text,
    /// All but comments, and but the constants of the work-unit layout: most kernels use few of
    /// these.
    Code,
}

/// The beginning of a line after a kept schedule, with the result for one of its loops.
const LOOP: &str = "#loop: ";

impl Schedules {
    /// Schedules that all builds of a user keep together, in `cellray/schedules` of the user's cache
    /// folder; where that can't be written, in cargo's `OUT_DIR` or the folder of temporary files.
    ///
    /// # Errors
    ///
    /// All of these folders are read-only.
    pub fn new(tools: &Tools, includes: &[PathBuf]) -> Result<Self, Error> {
        let cache = tools::cache().map(|cache| cache.join("cellray"));
        let out = env::var_os("OUT_DIR").map(PathBuf::from);
        let folders = cache.into_iter().chain(out).chain([env::temp_dir().join("cellray")]);
        let mut refused = None;
        for folder in folders.map(|folder| folder.join("schedules")) {
            let writable =
                fs::create_dir_all(&folder).and_then(|()| tempfile::tempfile_in(&folder));
            match writable {
                Ok(_) => return Ok(Self::kept_in(&folder, tools, includes)),
                Err(error) => refused = Some(file_error(&folder, error)),
            }
        }
        Err(refused.expect("there is always a folder of temporary files"))
    }

    /// Schedules that are kept in this folder.
    #[must_use]
    pub fn kept_in(folder: &Path, tools: &Tools, includes: &[PathBuf]) -> Self {
        Self { tools: tools.clone(), includes: includes.to_vec(), kept: folder.to_path_buf() }
    }

    /// The file with a source's schedule. It is made if it is not there.
    ///
    /// # Errors
    ///
    /// The source can't be assembled or scheduled, or a file can't be read or written.
    pub fn file(&self, source: &Path, kind: Kind) -> Result<PathBuf, Error> {
        let name = source.file_name().unwrap_or_default();
        let text = read(source)?;
        // A driver's line table names its source.
        let named = (kind == Kind::Driver).then_some(source);
        let further = (spu_scheduler::SOURCES, kind, self.code(source)?, name, named);
        let (folder, kept) = self.place(&text, Included::Code, further, name)?;
        if kept.is_file() {
            return Ok(kept);
        }
        let work = tempfile::tempdir_in(&folder).map_err(|error| file_error(&folder, error))?;
        let object = |source: &Path| -> Result<Vec<u8>, Error> {
            let object = work.path().join("kernel.o");
            self.tools.assemble(&self.includes, &[], &object, source)?;
            fs::read(&object).map_err(|error| file_error(&object, error))
        };
        let fresh = work.path().join(name);
        let assemble = |text: &str| {
            crate::write(&fresh, text)?;
            object(&fresh)
        };
        let plain = object(source)?;
        let made = schedule(&plain, kind, &source.to_string_lossy(), &text, assemble)
            .map_err(|error| Error::Scheduler { path: source.to_path_buf(), source: error })?;
        let notes: String = made.loops.iter().map(loop_line).collect();
        crate::write(&fresh, &(made.text + &notes))?;
        // Another process that makes the same file at the same time never sees a partial file.
        fs::rename(&fresh, &kept).map_err(|error| file_error(&kept, error))?;
        Ok(kept)
    }

    /// A kernel's schedule, and what the scheduler reports of its loops.
    ///
    /// # Errors
    ///
    /// The same as those of [`file`](Self::file).
    pub fn schedule(&self, source: &Path) -> Result<Scheduled, Error> {
        let kept = self.file(source, Kind::Kernel)?;
        let text = read(&kept)?;
        let (loops, lines): (Vec<&str>, Vec<&str>) =
            text.split_inclusive('\n').partition(|line| line.starts_with(LOOP));
        let loops: Option<Vec<LoopReport>> = loops.into_iter().map(report).collect();
        let damaged = || std::io::Error::other("the file is damaged: remove it");
        let loops = loops.ok_or_else(|| file_error(&kept, damaged()))?;
        Ok(Scheduled { text: lines.concat(), loops })
    }

    /// The object of a source, with the names of registers, which the scheduler needs.
    ///
    /// # Errors
    ///
    /// The source can't be assembled, or a file can't be read or written.
    pub fn object(&self, source: &Path) -> Result<PathBuf, Error> {
        let name = source.with_extension("o");
        // The object's line table names the source.
        let name = name.file_name().unwrap_or_default();
        let (folder, kept) = self.place(&read(source)?, Included::Text, source, name)?;
        if !kept.is_file() {
            let work = tempfile::tempdir_in(&folder).map_err(|error| file_error(&folder, error))?;
            let fresh = work.path().join(name);
            self.tools.assemble(&self.includes, &[], &fresh, source)?;
            fs::rename(&fresh, &kept).map_err(|error| file_error(&kept, error))?;
        }
        Ok(kept)
    }

    /// The source's machine code. The constants of the work-unit layout that it uses are in it.
    fn code(&self, source: &Path) -> Result<Vec<u8>, Error> {
        let object = tempfile::NamedTempFile::new();
        let object = object.map_err(|error| file_error(&env::temp_dir(), error))?;
        self.tools.assemble_code(&self.includes, object.path(), source)?;
        fs::read(object.path()).map_err(|error| file_error(object.path(), error))
    }

    /// The folder, which is made, and the path of a file that is made of this text, of what it
    /// includes, and of something else.
    fn place(
        &self,
        text: &str,
        included: Included,
        further: impl Hash,
        name: &OsStr,
    ) -> Result<(PathBuf, PathBuf), Error> {
        let mut hasher = DefaultHasher::new();
        (text, further).hash(&mut hasher);
        self.add_included(text, included, &mut hasher)?;
        let folder = self.kept.join(format!("{:016x}", hasher.finish()));
        fs::create_dir_all(&folder).map_err(|error| file_error(&folder, error))?;
        let kept = folder.join(name);
        Ok((folder, kept))
    }

    /// Adds every file that a text includes, directly or indirectly.
    fn add_included(
        &self,
        text: &str,
        which: Included,
        hasher: &mut DefaultHasher,
    ) -> Result<(), Error> {
        let mut seen = BTreeSet::new();
        let mut open = included(text);
        while let Some(name) = open.pop() {
            let found = |folder: &PathBuf| Some(folder.join(&name)).filter(|path| path.is_file());
            // The assembler reports missing files.
            if let Some(path) = self.includes.iter().find_map(found)
                && seen.insert(name.clone())
            {
                let text = read(&path)?;
                match which {
                    Included::Text => (&name, &text).hash(hasher),
                    Included::Code if name == assembler::FILE => {}
                    Included::Code => {
                        let code = text.lines().filter_map(|line| line.split('#').next());
                        let code = code.map(str::trim_end).filter(|code| !code.is_empty());
                        code.for_each(|code| code.hash(hasher));
                    }
                }
                open.extend(included(&text));
            }
        }
        Ok(())
    }
}

fn read(path: &Path) -> Result<String, Error> {
    fs::read_to_string(path).map_err(|error| file_error(path, error))
}

/// The files named by a text's `.include` directives.
fn included(text: &str) -> Vec<String> {
    let after = text.split(".include").skip(1);
    let names = after.filter_map(|rest| rest.lines().next()?.split('"').nth(1));
    names.map(ToOwned::to_owned).collect()
}

/// A kept line of what the scheduler reports of a loop.
fn loop_line(report: &LoopReport) -> String {
    let outcome = match &report.outcome {
        Outcome::Plain(why) => format!("plain {why}"),
        Outcome::Pipelined(figures) => {
            let Figures { even, odd, minimum, interval, stages, registers, copies, passes } =
                figures;
            format!(
                "pipelined {even} {odd} {minimum} {interval} {stages} {registers} {copies} {passes}"
            )
        }
    };
    format!("{LOOP}{} {} {outcome}\n", report.name, report.line)
}

/// What [`loop_line`] has written.
fn report(line: &str) -> Option<LoopReport> {
    let mut words = line.strip_prefix(LOOP)?.trim_end().splitn(4, ' ');
    let name = words.next()?.to_owned();
    let line = words.next()?.parse().ok()?;
    let outcome = match (words.next()?, words.next()?) {
        ("plain", why) => Outcome::Plain(why.to_owned()),
        (_, figures) => {
            let figures = figures.split(' ').map(str::parse).collect::<Result<Vec<u64>, _>>();
            let [even, odd, minimum, interval, stages, registers, copies, passes] =
                figures.ok()?.try_into().ok()?;
            Outcome::Pipelined(Figures {
                even,
                odd,
                minimum,
                interval,
                stages,
                registers: registers.try_into().ok()?,
                copies: copies.try_into().ok()?,
                passes,
            })
        }
    };
    Some(LoopReport { name, line, outcome })
}
