//! Faults that a test asks for by the variable `SPUFS`: `absent`, a kernel without the system
//! calls; `denied`, a folder that may not be written to; `silent:N`, an SPE that never replies,
//! which is that of the context that was created N-th, counted from 0; `contended`, where a signal
//! ends every second call that does not wait, because the context is being moved.

use std::env;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use crate::error::Errno;

#[derive(Clone, Copy)]
enum Fault {
    Absent,
    Denied,
    Silent(usize),
    Contended,
}

static FAULT: OnceLock<Option<Fault>> = OnceLock::new();

fn fault() -> Option<Fault> {
    *FAULT.get_or_init(|| {
        let word = env::var("SPUFS").ok()?;
        Some(match (word.as_str(), word.strip_prefix("silent:").map(str::parse)) {
            ("absent", _) => Fault::Absent,
            ("", _) => return None,
            ("denied", _) => Fault::Denied,
            ("contended", _) => Fault::Contended,
            (_, Some(Ok(number))) => Fault::Silent(number),
            _ => panic!("SPUFS: {word} is no fault"),
        })
    })
}

/// Fails where the system calls are absent.
pub(crate) fn check_calls() -> Result<(), Errno> {
    if matches!(fault(), Some(Fault::Absent)) { Err(Errno(libc::ENOSYS)) } else { Ok(()) }
}

/// Fails where contexts may not be created.
pub(crate) fn check_rights() -> Result<(), Errno> {
    if matches!(fault(), Some(Fault::Denied)) { Err(Errno(libc::EACCES)) } else { Ok(()) }
}

/// Whether the SPE of the context with this number never replies.
pub(crate) fn is_silent(number: usize) -> bool {
    matches!(fault(), Some(Fault::Silent(silent)) if silent == number)
}

/// Fails a call on a file that does not wait, if a signal shall end it.
pub(crate) fn check_contention(may_wait: bool) -> Result<(), Errno> {
    static ENDED: AtomicBool = AtomicBool::new(false);
    let is_contended = matches!(fault(), Some(Fault::Contended)) && !may_wait;
    if is_contended && !ENDED.fetch_xor(true, Relaxed) { Err(Errno(libc::EINTR)) } else { Ok(()) }
}
