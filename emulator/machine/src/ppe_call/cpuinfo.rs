//! `/proc/cpuinfo` as a console has it.
//!
//! newlib's `spu_timebase` looks there for the time base, by which SPU timers and the sampling of
//! `-pg` programs are set. On other machines the file has no such line.

use std::ffi::CStr;
use std::fs;
use std::io::{Seek as _, Write as _};
use std::os::fd::{FromRawFd as _, IntoRawFd as _};

use super::Errno;
use super::errno::check;
use crate::decrementer::TICKS_PER_SECOND;

const PATH: &CStr = c"/proc/cpuinfo";

/// What a PlayStation 3 shows: one PPE with two threads.
fn text() -> String {
    let processor = |number| {
        format!(
            "processor\t: {number}\n\
             cpu\t\t: Cell Broadband Engine, altivec supported\n\
             clock\t\t: 3192.000000MHz\n\
             revision\t: 5.1 (pvr 0070 0501)\n\n"
        )
    };
    let processors = processor(0) + &processor(1);
    format!("{processors}timebase\t: {TICKS_PER_SECOND}\nplatform\t: PS3\n")
}

/// Opens a file as `open` does. A guest that reads `/proc/cpuinfo` gets a console's, unless the
/// host's contains the time base.
pub(super) fn open(path: &CStr, flags: i32, mode: libc::c_uint) -> Result<i32, Errno> {
    let is_read = flags & libc::O_ACCMODE == libc::O_RDONLY;
    if path == PATH && is_read && !has_time_base(&fs::read_to_string("/proc/cpuinfo")) {
        return unnamed_file(&text());
    }
    // SAFETY: the path ends in 0.
    check(unsafe { libc::open(path.as_ptr(), flags, mode) })
}

fn has_time_base(text: &std::io::Result<String>) -> bool {
    let has = |text: &String| text.lines().any(|line| line.starts_with("timebase"));
    text.as_ref().is_ok_and(has)
}

fn unnamed_file(text: &str) -> Result<i32, Errno> {
    let name = c"cpuinfo";
    // Older C libraries have no function for it.
    // SAFETY: the name ends in 0.
    let made = unsafe { libc::syscall(libc::SYS_memfd_create, name.as_ptr(), 0) };
    let descriptor = check(made as i32)?;
    // SAFETY: the descriptor was just made, and belongs to nobody else.
    let mut file = unsafe { fs::File::from_raw_fd(descriptor) };
    let written = file.write_all(text.as_bytes()).and_then(|()| file.rewind());
    match written {
        Ok(()) => Ok(file.into_raw_fd()),
        Err(error) => Err(Errno(error.raw_os_error().unwrap_or(libc::EIO))),
    }
}
