//! `spu run --root DIR`: the program finds DIR as `/`, and no other file.
//!
//! The program runs on a thread of its own, whose root directory is changed. Paths, `..` and
//! symbolic links then all stay below it. The thread also gives up all privileges, so that it can
//! make no device. The other threads keep the system's root, so that the
//! files of the command line are found. Who is not root needs a user namespace for that, which only
//! a process without other threads can enter.

use std::ffi::CString;
use std::fs;
use std::io;
use std::os::unix::ffi::OsStrExt as _;
use std::path::Path;
use std::thread;

use super::sleep::THREAD;
use crate::failure::Failure;

/// Gets the right to change a thread's root directory. Must be called before any thread starts.
pub fn prepare(root: &Path) -> Result<(), Failure> {
    // SAFETY: these functions take no pointers.
    let (user, group) = unsafe { (libc::geteuid(), libc::getegid()) };
    if user == 0 {
        return Ok(());
    }
    let entered = || {
        // SAFETY: the function takes a number.
        check(unsafe { libc::unshare(libc::CLONE_NEWUSER) })?;
        fs::write("/proc/self/setgroups", "deny")?;
        fs::write("/proc/self/uid_map", format!("{user} {user} 1"))?;
        fs::write("/proc/self/gid_map", format!("{group} {group} 1"))
    };
    entered().map_err(|error| refused(root, error))
}

/// Runs `body` where `root` is the root directory, if there is one.
pub fn within<T: Send>(root: Option<&Path>, body: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    let Some(root) = root else {
        return Ok(body());
    };
    thread::scope(|scope| {
        let run = || {
            enter(root).map_err(|error| refused(root, error))?;
            Ok(body())
        };
        let thread = thread::Builder::new().spawn_scoped(scope, run);
        match thread.map_err(Failure::of(THREAD))?.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

fn enter(root: &Path) -> io::Result<()> {
    let path = CString::new(root.as_os_str().as_bytes())?;
    // SAFETY: the function takes a number. From now on, the thread has a root of its own.
    check(unsafe { libc::unshare(libc::CLONE_FS) })?;
    // SAFETY: the path ends in 0.
    check(unsafe { libc::chroot(path.as_ptr()) })?;
    // SAFETY: as above.
    check(unsafe { libc::chdir(c"/".as_ptr()) })?;
    give_up_privileges()
}

/// Gives up this thread's capabilities. Programs that it starts don't get them back.
fn give_up_privileges() -> io::Result<()> {
    const NO_ROOT: libc::c_ulong = 1;
    const NO_ROOT_LOCKED: libc::c_ulong = 2;
    const VERSION_3: u32 = 0x2008_0522;
    const THIS_THREAD: u32 = 0;
    let header = [VERSION_3, THIS_THREAD];
    // Effective, permitted and inheritable ones, in two parts of 32.
    let none = [0_u32; 6];
    // SAFETY: the function takes numbers.
    check(unsafe { libc::prctl(libc::PR_SET_SECUREBITS, NO_ROOT | NO_ROOT_LOCKED) })?;
    // SAFETY: the header and the data have the sizes of this version.
    let result = unsafe { libc::syscall(libc::SYS_capset, header.as_ptr(), none.as_ptr()) };
    check(result as libc::c_int)
}

fn check(result: libc::c_int) -> io::Result<()> {
    if result == 0 {
        return Ok(());
    }
    Err(io::Error::last_os_error())
}

fn refused(root: &Path, error: io::Error) -> Failure {
    Failure::of(format!("--root {}", root.display()))(error)
}
