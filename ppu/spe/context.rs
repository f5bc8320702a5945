//! One SPE context.

use std::ffi::{CStr, c_int, c_uint, c_void};
use std::fmt;
use std::path::PathBuf;
use std::ptr::{self, NonNull};

use super::sys;
use super::{Program, SpeError};

/// An SPE context; destroyed when dropped.
#[derive(Debug)]
pub struct Context(NonNull<sys::spe_context>);

// SAFETY: libspe2 allows any thread to use a context, many at the same time; what the context
// points to is the library's own and guarded by it or by the kernel.
unsafe impl Send for Context {}
// SAFETY: as above.
unsafe impl Sync for Context {}

/// Why an SPU program came to an end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It exited with this code.
    Exit(i32),
    /// It stopped with a code that nobody has given a meaning.
    Signal(u32),
    /// The SPU could not go on: `SPU_Status` and what its bits say.
    Fault(&'static str),
    /// The MFC raised an exception; the kernel's event word and what it says.
    Dma(&'static str, i32),
    /// libspe2 gave up for a reason of its own: stop reason and result.
    Library(u32, i32),
}

/// The end of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ended {
    /// What happened.
    pub outcome: Outcome,
    /// Local-store address of the next instruction.
    pub npc: u32,
    /// The instruction word before it: the one that stopped, unless the stop was not precise.
    pub instruction: u32,
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.outcome {
            Outcome::Exit(code) => write!(f, "exited with code {code}")?,
            Outcome::Signal(code) => write!(f, "stopped with the unknown code {code:#06x}")?,
            Outcome::Fault(what) => write!(f, "stopped: {what}")?,
            Outcome::Dma(what, word) => write!(f, "stopped: {what} (event {word:#06x})")?,
            Outcome::Library(reason, result) => {
                write!(
                    f,
                    "stopped: libspe2's stop reason {reason}, result {result}"
                )?;
            }
        }
        let pc = self.npc.wrapping_sub(4);
        write!(f, " at {pc:#07x}, instruction {:#010x}", self.instruction)
    }
}

/// Words that the inbound mailbox holds.
const MAILBOX_DEPTH: c_int = 4;

impl Context {
    /// The stop code of [`Context::halt`]. The instruction of a stop is its code.
    pub const HALTED: u32 = 0x3ffe;

    /// A context whose faults come back as results, not as signals to the process.
    pub fn create() -> Result<Self, SpeError> {
        // SAFETY: takes no pointer but the gang, which may be null.
        let context = unsafe { sys::spe_context_create(sys::SPE_EVENTS_ENABLE, ptr::null_mut()) };
        NonNull::new(context)
            .map(Self)
            .ok_or_else(|| SpeError::last("spe_context_create"))
    }

    pub(super) fn as_ptr(&self) -> sys::spe_context_ptr_t {
        self.0.as_ptr()
    }

    /// Copies a program into local store.
    pub fn load(&self, program: &Program) -> Result<(), SpeError> {
        let mut handle = program.handle();
        // SAFETY: the context lives; the handle points to a whole ELF file that lives for ever,
        // and the library keeps no reference to the handle itself.
        let result = unsafe { sys::spe_program_load(self.as_ptr(), &raw mut handle) };
        if result == 0 {
            Ok(())
        } else {
            Err(SpeError::last("spe_program_load"))
        }
    }

    /// Runs the loaded program from its entry until it ends; `argument` arrives in `$4`.
    #[must_use]
    pub fn run(&self, argument: usize) -> Ended {
        let mut entry = sys::SPE_DEFAULT_ENTRY;
        let mut info = sys::spe_stop_info_t::default();
        // SAFETY: the context lives; entry and info are valid for writing; argp is a number to
        // this program and to the SPU's, and libspe2 follows it only with SPE_RUN_USER_REGS.
        unsafe {
            sys::spe_context_run(
                self.as_ptr(),
                &raw mut entry,
                0,
                argument as *mut c_void,
                ptr::null_mut(),
                &raw mut info,
            );
        }
        let outcome = match info.stop_reason {
            sys::SPE_EXIT => Outcome::Exit(info.result),
            sys::SPE_STOP_AND_SIGNAL => Outcome::Signal(info.result as u32),
            sys::SPE_RUNTIME_ERROR => Outcome::Fault(match info.result {
                sys::SPE_SPU_HALT => "a halt instruction found its condition true",
                sys::SPE_SPU_INVALID_INSTR => "invalid instruction",
                sys::SPE_SPU_INVALID_CHANNEL => "invalid channel",
                _ => "unknown SPU error",
            }),
            sys::SPE_RUNTIME_EXCEPTION => Outcome::Dma(
                match info.result {
                    sys::SPE_DMA_ALIGNMENT => "DMA alignment",
                    sys::SPE_DMA_STORAGE => "DMA to or from memory that is not there",
                    sys::SPE_INVALID_DMA => "invalid DMA command",
                    _ => "MFC exception",
                },
                info.result,
            ),
            reason => Outcome::Library(reason, info.result),
        };
        let npc = entry & !3;
        Ended {
            outcome,
            npc,
            instruction: self.local_store_word(npc.wrapping_sub(4)),
        }
    }

    /// A word of local store; the address wraps. `None` if libspe2 has no mapping of it.
    fn local_store(&self, address: u32) -> Option<*mut u32> {
        // SAFETY: the context lives.
        let (base, size) = unsafe {
            (
                sys::spe_ls_area_get(self.as_ptr()),
                sys::spe_ls_size_get(self.as_ptr()),
            )
        };
        if base.is_null() || size <= 0 {
            return None;
        }
        let offset = address as usize & (size as usize - 1) & !3;
        // SAFETY: the mapping is `size` bytes, a power of two, and offset is a word within it.
        Some(unsafe { base.cast::<u8>().add(offset) }.cast::<u32>())
    }

    /// What stands there. Meant for a context that is not running.
    fn local_store_word(&self, address: u32) -> u32 {
        // SAFETY: a word of the mapping, which lives as long as the context; others may write
        // there, hence volatile.
        let read = |word: *mut u32| u32::from_be(unsafe { word.read_volatile() });
        self.local_store(address).map_or(0, read)
    }

    /// Makes the program stop wherever it is, for good: all of its instructions become one that
    /// stops. It does so as [`Outcome::Signal`] of [`Context::HALTED`] as soon as it comes to the
    /// next one, which it does not while it waits for a channel.
    pub fn halt(&self, program: &Program) {
        for address in program.code().into_iter().flat_map(|code| code.step_by(4)) {
            if let Some(word) = self.local_store(address) {
                // SAFETY: a word of the mapping; others may read and write there, hence volatile.
                unsafe { word.write_volatile(Self::HALTED.to_be()) };
            }
        }
    }

    /// Whether there are words in the inbound mailbox that the SPU has not read.
    #[must_use]
    pub fn has_unread_mail(&self) -> bool {
        // SAFETY: the context lives.
        let room = unsafe { sys::spe_in_mbox_status(self.as_ptr()) };
        (0..MAILBOX_DEPTH).contains(&room)
    }

    /// Writes all words into the inbound mailbox; sleeps while it is full.
    pub fn mail<const COUNT: usize>(&self, mut words: [u32; COUNT]) -> Result<(), SpeError> {
        let count = words.len() as c_int;
        // SAFETY: the context lives; the pointer is to `count` words.
        let written = unsafe {
            sys::spe_in_mbox_write(
                self.as_ptr(),
                words.as_mut_ptr(),
                count,
                sys::SPE_MBOX_ALL_BLOCKING,
            )
        };
        if written == count {
            Ok(())
        } else {
            Err(SpeError::last("spe_in_mbox_write"))
        }
    }

    /// The word in the outbound interrupt mailbox, if there is one.
    pub fn answer(&self) -> Result<Option<u32>, SpeError> {
        let mut word: c_uint = 0;
        // SAFETY: the context lives; one word is valid for writing.
        let read = unsafe {
            sys::spe_out_intr_mbox_read(
                self.as_ptr(),
                &raw mut word,
                1,
                sys::SPE_MBOX_ANY_NONBLOCKING,
            )
        };
        match read {
            0 => Ok(None),
            1 => Ok(Some(word)),
            _ => Err(SpeError::last("spe_out_intr_mbox_read")),
        }
    }

    /// Takes the stop record that libspe2 keeps of the last run, so that its event ends.
    pub fn take_stop_record(&self) -> Result<(), SpeError> {
        let mut info = sys::spe_stop_info_t::default();
        // SAFETY: the context lives; info is valid for writing.
        let result = unsafe { sys::spe_stop_info_read(self.as_ptr(), &raw mut info) };
        if result == 0 {
            Ok(())
        } else {
            Err(SpeError::last("spe_stop_info_read"))
        }
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        // SAFETY: the context lives and nobody else has it any more. An error could only mean that
        // it did not exist.
        unsafe { sys::spe_context_destroy(self.as_ptr()) };
    }
}

/// SPEs that libspe2 says a program may use. Linux counts other entries of a folder among them on
/// some kernels, so a console may answer 7 or 8 with six SPEs.
pub fn usable_spes() -> Result<u32, SpeError> {
    // SAFETY: takes no pointers.
    let count = unsafe { sys::spe_cpu_info_get(sys::SPE_COUNT_USABLE_SPES, -1) };
    u32::try_from(count).map_err(|_| SpeError::last("spe_cpu_info_get"))
}

/// The file that libspe2's code was loaded from: a shared library, or this program itself.
#[must_use]
pub fn library_path() -> Option<PathBuf> {
    use std::os::unix::ffi::OsStrExt as _;

    let function = sys::spe_context_create as *const c_void;
    // SAFETY: an all-zero Dl_info is a valid one: four null pointers.
    let mut info: libc::Dl_info = unsafe { std::mem::zeroed() };
    // SAFETY: any address may be asked for; info is valid for writing.
    if unsafe { libc::dladdr(function, &raw mut info) } == 0 || info.dli_fname.is_null() {
        return None;
    }
    // SAFETY: dladdr gave a terminated string that lives as long as the file is loaded.
    let name = unsafe { CStr::from_ptr(info.dli_fname) };
    Some(PathBuf::from(std::ffi::OsStr::from_bytes(name.to_bytes())))
}
