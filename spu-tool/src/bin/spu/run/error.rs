//! What can be wrong with the bench that was asked for.

use std::io;
use std::path::PathBuf;

use spu_emulator::memory::{MemoryFault, RegionError};
use thiserror::Error;

use crate::failure::Failure;

#[derive(Debug, Error)]
pub enum RunError {
    #[error("{what}: {error}")]
    Region { what: String, error: RegionError },
    #[error("{what}: {error}")]
    Memory { what: String, error: MemoryFault },
    #[error("{path}: {size} bytes at {address:#x} do not fit into local store")]
    OutsideLocalStore {
        path: PathBuf,
        address: u64,
        size: usize,
    },
    #[error("the arguments take {0} bytes, for which local store has no room")]
    Arguments(usize),
    #[error("no thread to watch the program: {0}")]
    Thread(io::Error),
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        Self::verb(error)
    }
}
