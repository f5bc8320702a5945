//! Faults that a test asks for by the variable `SPUFS`: `absent`, a kernel without the system
//! calls; `denied`, a folder that may not be written to; `silent:N`, an SPE that never replies,
//! which is that of the context that was created N-th, counted from 0.

use std::env;
use std::sync::OnceLock;

use crate::error::Errno;

#[derive(Clone, Copy)]
enum Fault {
    Absent,
    Denied,
    Silent(usize),
}

static FAULT: OnceLock<Option<Fault>> = OnceLock::new();

fn fault() -> Option<Fault> {
    *FAULT.get_or_init(|| {
        let word = env::var("SPUFS").ok()?;
        Some(match (word.as_str(), word.strip_prefix("silent:").map(str::parse)) {
            ("absent", _) => Fault::Absent,
            ("denied", _) => Fault::Denied,
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
