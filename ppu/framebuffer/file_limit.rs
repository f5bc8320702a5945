//! The limit of the process for the size of files.

use std::io;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use signal_hook::consts::SIGXFSZ;

/// Catches SIGXFSZ, so that writing a file beyond the process's size limit returns an error. By
/// default the system would kill the program.
///
/// # Errors
/// The system refuses to install the handler.
pub fn refuse_large_files() -> io::Result<()> {
    signal_hook::flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
    Ok(())
}
