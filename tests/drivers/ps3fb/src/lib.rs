//! A stand-in for ps3fb and a virtual terminal: an object to preload into the console's program,
//! which handles `open` and `ioctl` of one device and of /dev/tty as the kernel's drivers would.
//!
//! | variable | |
//! | --- | --- |
//! | `PS3FB_DEVICE` | path of the character device that it stands in for |
//! | `PS3FB_MEMORY` | file that holds the device's memory |
//! | `PS3FB_SCREEN` | file that gets what the television shows, when a frame is selected |
//! | `PS3FB_LOG` | file that gets a line for each call that changes something or waits |
//! | `PS3FB` | which driver it is: words that `driver.rs` lists |
//!
//! Invariant: what is not opened by those two names goes to the C library untouched. Request
//! numbers are those of PowerPC's kernel, so the program under test must be one for it.

mod driver;
mod interpose;
mod terminal;

use driver::Driver;
use libc::c_int;
use std::env;
use std::ffi::{CStr, c_void};
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::os::fd::IntoRawFd;
use std::sync::{Mutex, MutexGuard, PoisonError};
use terminal::Terminal;

type Errno = c_int;

/// What stands in for something, and the descriptors that the program has of it.
struct Stand<T> {
    device: T,
    descriptors: Vec<c_int>,
}

struct Stands {
    driver: Stand<Driver>,
    terminal: Stand<Terminal>,
    log: File,
}

static STANDS: Mutex<Option<Stands>> = Mutex::new(None);

fn stands() -> MutexGuard<'static, Option<Stands>> {
    STANDS.lock().unwrap_or_else(PoisonError::into_inner)
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn file(name: &str) -> File {
    let path = variable(name);
    OpenOptions::new()
        .read(true)
        .write(true)
        .create(true)
        .truncate(false)
        .open(&path)
        .unwrap_or_else(|error| panic!("{name}={path}: {error}"))
}

/// A descriptor for the program if `path` is one that this stands in for.
fn open(path: &CStr) -> Option<c_int> {
    let path = path.to_bytes();
    let is_device = env::var_os("PS3FB_DEVICE").is_some_and(|name| name.as_encoded_bytes() == path);
    if !is_device && path != b"/dev/tty" {
        return None;
    }
    if stands().is_none() {
        let driver = Driver::new(&variable("PS3FB"), file("PS3FB_MEMORY"), file("PS3FB_SCREEN"));
        let new = Stands {
            driver: Stand { device: driver, descriptors: Vec::new() },
            terminal: Stand { device: Terminal::default(), descriptors: Vec::new() },
            log: file("PS3FB_LOG"),
        };
        stands().get_or_insert(new);
    }
    // Any descriptor serves the terminal; the device's is mapped, so it is its memory's.
    let descriptor = file("PS3FB_MEMORY").into_raw_fd();
    let mut stands = stands();
    let stands = stands.as_mut()?;
    let descriptors =
        if is_device { &mut stands.driver.descriptors } else { &mut stands.terminal.descriptors };
    descriptors.push(descriptor);
    Some(descriptor)
}

/// The result of a request, if `descriptor` is one that [`open`] gave.
///
/// # Safety
/// `argument` must be what `request` takes.
unsafe fn ioctl(
    descriptor: c_int,
    request: u32,
    argument: *mut c_void,
) -> Option<Result<(), Errno>> {
    let mut stands = stands();
    let Stands { driver, terminal, log } = stands.as_mut()?;
    let mut note = |line: String| {
        // A test that can't write its log fails by what it lacks.
        let _ = log.write_all((line + "\n").as_bytes());
    };
    // SAFETY: the caller's promise.
    unsafe {
        if driver.descriptors.contains(&descriptor) {
            Some(driver.device.ioctl(request, argument, &mut note))
        } else if terminal.descriptors.contains(&descriptor) {
            Some(terminal.device.ioctl(request, argument, &mut note))
        } else {
            None
        }
    }
}

/// The program has closed `descriptor`.
fn close(descriptor: c_int) {
    if let Some(stands) = stands().as_mut() {
        stands.driver.descriptors.retain(|&known| known != descriptor);
        stands.terminal.descriptors.retain(|&known| known != descriptor);
    }
}
