//! Records a run in simulated time, by the files that libspe2 writes about it.
//!
//! libspe2 reads its environment once and writes until the process ends. So a program runs itself
//! again with that environment, and the folder of the files outlives the run.

use std::env;
use std::fs;
use std::io;
use std::path::PathBuf;
use std::process::{Command, ExitStatus};

use tempfile::TempDir;
use thiserror::Error;

const TIMING: &str = "LIBSPE2_TIMING";
const TIMELINE: &str = "LIBSPE2_TIMELINE";
const PROFILE: &str = "LIBSPE2_PROFILE";

/// Why nothing could be recorded.
#[derive(Debug, Error)]
pub enum RecordingError {
    /// The program can't be run again.
    #[error("running again in simulated time: {0}")]
    Again(#[from] io::Error),
    /// libspe2 wrote no such file.
    #[error("{what} in {path}: {source}")]
    Missing {
        /// The variable that asked for it.
        what: &'static str,
        /// Where it should be.
        path: PathBuf,
        /// The system's error.
        source: io::Error,
    },
}

/// The files that libspe2 writes about this run.
pub struct Recording {
    timeline: PathBuf,
    profile: PathBuf,
}

impl Recording {
    /// The files that the environment asks libspe2 for; `None` if it does not ask for all.
    #[must_use]
    pub fn of_this_run() -> Option<Self> {
        let path = |name| env::var_os(name).map(PathBuf::from);
        env::var_os(TIMING).filter(|value| value == "1")?;
        Some(Self { timeline: path(TIMELINE)?, profile: path(PROFILE)? })
    }

    /// Runs this program again, with the same arguments, so that libspe2 records it.
    ///
    /// # Errors
    /// There is no place for temporary files, or the program can't be started.
    pub fn run_again() -> Result<ExitStatus, RecordingError> {
        let folder = TempDir::new()?;
        let status = Command::new(env::current_exe()?)
            .args(env::args_os().skip(1))
            .env(TIMING, "1")
            .env(TIMELINE, folder.path().join("timeline.json"))
            .env(PROFILE, folder.path().join("profile.json"))
            .status()?;
        Ok(status)
    }

    /// The timeline of the run, after all its contexts were destroyed.
    ///
    /// # Errors
    /// libspe2 has not written it.
    pub fn timeline(&self) -> Result<Vec<u8>, RecordingError> {
        read(TIMELINE, &self.timeline)
    }

    /// The profile of the run, after all its contexts were destroyed.
    ///
    /// # Errors
    /// libspe2 has not written it.
    pub fn profile(&self) -> Result<Vec<u8>, RecordingError> {
        read(PROFILE, &self.profile)
    }
}

fn read(what: &'static str, path: &PathBuf) -> Result<Vec<u8>, RecordingError> {
    fs::read(path).map_err(|source| RecordingError::Missing { what, path: path.clone(), source })
}
