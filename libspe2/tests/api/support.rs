//! Contexts that clean up after themselves, programs, and errno checks.

use std::ffi::CString;
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use spe2::context::{spe_context_create, spe_context_destroy, spe_ls_area_get};
use spe2::image::{spe_image_close, spe_image_open, spe_program_load};
use spe2::mailbox::spe_in_mbox_write;
use spe2::run::spe_context_run;
use spe2::types::{
    SPE_DEFAULT_ENTRY, SPE_EVENTS_ENABLE, SpeContext, SpeProgramHandle, SpeStopInfo, SpeStopResult,
};
use spu_build::for_tests::build_instructions;

/// How long any call in these tests may take, on a machine that is busy with other things.
pub const PATIENCE: Duration = Duration::from_secs(600);

/// Asserts that a call returned -1 and set this errno.
#[track_caller]
pub fn assert_fails(returned: i32, errno: i32) {
    let found = last_errno();
    assert_eq!(returned, -1);
    assert_eq!(found, errno);
}

/// Asserts that a call returned NULL and set this errno.
#[track_caller]
pub fn assert_null<T>(returned: *mut T, errno: i32) {
    let found = last_errno();
    assert!(returned.is_null());
    assert_eq!(found, errno);
}

pub fn last_errno() -> i32 {
    std::io::Error::last_os_error().raw_os_error().unwrap()
}

pub fn open_image(path: &Path) -> *mut SpeProgramHandle {
    let name = CString::new(path.as_os_str().as_bytes()).unwrap();
    unsafe { spe_image_open(name.as_ptr()) }
}

/// A context that is destroyed when dropped.
pub struct Context(*mut SpeContext);

unsafe impl Send for Context {}
unsafe impl Sync for Context {}

impl Drop for Context {
    fn drop(&mut self) {
        assert_eq!(unsafe { spe_context_destroy(self.0) }, 0);
    }
}

/// Sends a word to a context when dropped.
struct Wakes<'a>(&'a Context);

impl Drop for Wakes<'_> {
    fn drop(&mut self) {
        let mut word = 0;
        let written = unsafe { spe_in_mbox_write(self.0.0, &raw mut word, 1, 1) };
        assert_eq!(written, 1);
    }
}

/// A stop, as the program sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stop {
    pub returned: i32,
    /// Only valid after a failure.
    pub errno: i32,
    pub reason: u32,
    pub code: i32,
    pub status: i32,
    pub entry: u32,
}

pub fn no_stop_info() -> SpeStopInfo {
    SpeStopInfo { stop_reason: 0, result: SpeStopResult { reserved: 0 }, spu_status: 0 }
}

impl Context {
    /// Takes ownership of a pointer from `spe_context_create`.
    pub fn owning(pointer: *mut SpeContext) -> Self {
        assert!(!pointer.is_null(), "errno {}", last_errno());
        Self(pointer)
    }

    pub fn pointer(&self) -> *mut SpeContext {
        self.0
    }

    pub fn new(flags: u32) -> Self {
        Self::owning(unsafe { spe_context_create(flags, ptr::null_mut()) })
    }

    /// A context with events enabled and a program loaded.
    pub fn with_program(source: &str) -> Self {
        let context = Self::new(SPE_EVENTS_ENABLE);
        context.load(source);
        context
    }

    pub fn load(&self, source: &str) {
        let folder = tempfile::tempdir().unwrap();
        let program = open_image(&build_instructions(source, folder.path()));
        assert!(!program.is_null(), "errno {}", last_errno());
        assert_eq!(unsafe { spe_program_load(self.0, program) }, 0);
        assert_eq!(unsafe { spe_image_close(program) }, 0);
    }

    pub fn run_from(&self, entry: u32, flags: u32, argp: u64, envp: u64) -> Stop {
        let mut entry = entry;
        let mut info = no_stop_info();
        let returned = unsafe {
            spe_context_run(
                self.0,
                &raw mut entry,
                flags,
                ptr::with_exposed_provenance_mut(argp as usize),
                ptr::with_exposed_provenance_mut(envp as usize),
                &raw mut info,
            )
        };
        Stop {
            returned,
            errno: if returned == -1 { last_errno() } else { 0 },
            reason: info.stop_reason,
            code: unsafe { info.result.code },
            status: info.spu_status,
            entry,
        }
    }

    pub fn run(&self) -> Stop {
        self.run_from(SPE_DEFAULT_ENTRY, 0, 0, 0)
    }

    /// Calls `body` while the context runs, as a console's proxy commands need it.
    pub fn while_it_runs(&self, body: impl FnOnce()) {
        self.load("rdch $10,$ch29\n stop 0x2000\n");
        let stop = elsewhere(
            || self.run(),
            || {
                // Also if the body fails, so that the run ends.
                let _end = Wakes(self);
                body();
            },
        );
        assert_eq!(stop.returned, 0);
    }

    /// Returns `length` bytes of local store from `address` on.
    pub fn local_store(&self, address: u32, length: usize) -> Vec<u8> {
        let area: *const u8 = unsafe { spe_ls_area_get(self.0) }.cast();
        let mut bytes = vec![0; length];
        unsafe { ptr::copy_nonoverlapping(area.add(address as usize), bytes.as_mut_ptr(), length) };
        bytes
    }

    pub fn set_local_store(&self, address: u32, bytes: &[u8]) {
        let area: *mut u8 = unsafe { spe_ls_area_get(self.0) }.cast();
        unsafe {
            ptr::copy_nonoverlapping(bytes.as_ptr(), area.add(address as usize), bytes.len());
        }
    }
}

/// Returns the result of `body` on another thread, if it ends in time.
#[expect(clippy::print_stderr, reason = "a test has nothing to lose but its output")]
pub fn elsewhere<T: Send>(body: impl FnOnce() -> T + Send, meanwhile: impl FnOnce()) -> T {
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        scope.spawn(move || sender.send(body()));
        meanwhile();
        receiver.recv_timeout(PATIENCE).unwrap_or_else(|_| {
            // The scope would wait for the thread for ever.
            eprintln!("a call of the library does not return");
            std::process::abort()
        })
    })
}

/// Memory aligned for DMA.
#[repr(C, align(128))]
pub struct Aligned<const N: usize>(pub [u8; N]);

impl<const N: usize> Aligned<N> {
    pub fn new() -> Box<Self> {
        Box::new(Self([0; N]))
    }

    pub fn pointer(&mut self) -> *mut libc::c_void {
        self.0.as_mut_ptr().cast()
    }

    pub fn ea(&mut self) -> u64 {
        self.pointer().expose_provenance() as u64
    }
}
