//! SPU programs that run, each on a thread of its own.

use std::sync::Arc;
use std::thread::{self, JoinHandle};

use super::{Context, Ended, SpeError};

/// A loaded program that runs in a context.
pub struct Running(JoinHandle<Ended>);

impl Running {
    /// Runs the program of a context, with `number` in `$4`.
    ///
    /// # Errors
    /// The system starts no thread.
    pub fn start(context: &Arc<Context>, number: u32) -> Result<Self, SpeError> {
        let runner = Arc::clone(context);
        let thread = thread::Builder::new()
            .name(format!("spu{number}"))
            .spawn(move || runner.run(number as usize))
            .map_err(|source| SpeError { call: "thread for spe_context_run", source })?;
        Ok(Self(thread))
    }

    /// Waits for the program's end.
    pub fn ended(self) -> Option<Ended> {
        self.0.join().ok()
    }
}
