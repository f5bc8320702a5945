//! The files of recorded sessions.
//!
//! Invariant: an existing file is never overwritten.

use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use cellray::game::{Game, Recording, RecordingError, Session};

use crate::error::PlayError;

/// A file whose errors name its path.
struct NamedFile {
    file: File,
    path: PathBuf,
}

impl NamedFile {
    fn name(&self, error: io::Error) -> io::Error {
        io::Error::new(error.kind(), format!("{}: {error}", self.path.display()))
    }
}

impl Write for NamedFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes).map_err(|error| self.name(error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush().map_err(|error| self.name(error))
    }
}

/// Records the session, or plays a recording back, if a path is given for it.
pub fn connect<G: Game>(
    session: Session<G>,
    record: Option<&Path>,
    replay: Option<&Path>,
) -> Result<Session<G>, PlayError> {
    let session = match replay {
        Some(path) => session.replaying(open(path)?)?,
        None => session,
    };
    Ok(match record {
        Some(path) => session.record_to(create(path)?),
        None => session,
    })
}

fn open(path: &Path) -> Result<Recording, PlayError> {
    Recording::open(path).map_err(|source| PlayError::Recording { path: path.to_owned(), source })
}

fn create(path: &Path) -> Result<Box<dyn Write>, PlayError> {
    let file = OpenOptions::new().write(true).create_new(true).open(path);
    let file = file.map_err(|error| PlayError::Recording {
        path: path.to_owned(),
        source: RecordingError::Io(error),
    })?;
    Ok(Box::new(BufWriter::new(NamedFile { file, path: path.to_owned() })))
}
