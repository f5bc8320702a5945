//! Errors in the test bench that the command line asks for.

use std::io;
use std::path::PathBuf;

use spu_emulator::memory::{MemoryFault, RegionError};
use spu_emulator::simulated::TimingFileError;
use thiserror::Error;

use crate::failure::Failure;

#[derive(Debug, Error)]
pub enum RunError {
    #[error("{what}: {error}")]
    Region { what: String, error: RegionError },
    #[error("{what}: {error}")]
    Memory { what: String, error: MemoryFault },
    #[error("{path}: {size} bytes at {address:#x} do not fit into local store")]
    OutsideLocalStore { path: PathBuf, address: u64, size: usize },
    #[error(transparent)]
    Machine(TimingFileError),
    #[error("the arguments take {0} bytes; they don't fit into local store")]
    Arguments(usize),
    #[error("--root {path}: {error}")]
    Root { path: PathBuf, error: io::Error },
    #[error("--gdb {port}: {error}")]
    Debugger { port: u16, error: io::Error },
    #[error("can't start the thread that watches the program: {0}")]
    Thread(io::Error),
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        Self::command(error)
    }
}
