//! One SPE context.

use std::ffi::{CStr, c_int, c_uint, c_void};
use std::path::PathBuf;
use std::ptr::{self, NonNull};

use super::sys;
use super::{Ended, Outcome, Program, SpeError};

/// An SPE context, which is destroyed when dropped.
#[derive(Debug)]
pub struct Context(NonNull<sys::spe_context>);

// SAFETY: libspe2 allows any thread to use a context, even many at the same time. The data that
// the context points to belongs to the library, which guards it, or the kernel does.
unsafe impl Send for Context {}
// SAFETY: as above.
unsafe impl Sync for Context {}

/// The number of words that the inbound mailbox holds.
const MAILBOX_DEPTH: c_int = 4;

impl Context {
    /// The stop code of [`Context::halt`]. The instruction word of a stop equals its code.
    pub const HALTED: u32 = 0x3ffe;

    /// Creates a context. Faults are returned as results of a run, not sent as signals to the
    /// process.
    ///
    /// # Errors
    /// libspe2 fails, for example because there is no SPE.
    pub fn create() -> Result<Self, SpeError> {
        Self::with_flags(sys::SPE_EVENTS_ENABLE)
    }

    /// Creates a context whose signal registers have addresses, to which other SPEs can send.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn create_mapped() -> Result<Self, SpeError> {
        Self::with_flags(sys::SPE_EVENTS_ENABLE | sys::SPE_MAP_PS)
    }

    fn with_flags(flags: c_uint) -> Result<Self, SpeError> {
        // SAFETY: the only pointer is the gang, which may be null.
        let context = unsafe { sys::spe_context_create(flags, ptr::null_mut()) };
        NonNull::new(context).map(Self).ok_or_else(|| SpeError::last("spe_context_create"))
    }

    pub(super) fn as_ptr(&self) -> sys::spe_context_ptr_t {
        self.0.as_ptr()
    }

    /// Copies a program into local store.
    ///
    /// # Errors
    /// libspe2 refuses the program.
    pub fn load(&self, program: &Program) -> Result<(), SpeError> {
        let mut handle = sys::spe_program_handle_t {
            handle_size: size_of::<sys::spe_program_handle_t>() as u32,
            elf_image: program.image().as_ptr().cast::<c_void>(),
            toe_shadow: ptr::null(),
        };
        // SAFETY: the context lives. The handle points to a complete ELF file that lives forever,
        // and the library keeps no reference to the handle.
        let result = unsafe { sys::spe_program_load(self.as_ptr(), &raw mut handle) };
        if result == 0 { Ok(()) } else { Err(SpeError::last("spe_program_load")) }
    }

    /// Runs the loaded program from its entry until it ends, with `argument` in `$4`.
    #[must_use]
    pub fn run(&self, argument: usize) -> Ended {
        let mut entry = sys::SPE_DEFAULT_ENTRY;
        let mut info = sys::spe_stop_info_t::default();
        // SAFETY: the context lives. entry and info are valid for writing. argp is only a number
        // here; libspe2 would follow it only with SPE_RUN_USER_REGS.
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
                    sys::SPE_DMA_STORAGE => "DMA to or from unmapped memory",
                    sys::SPE_INVALID_DMA => "invalid DMA command",
                    _ => "MFC exception",
                },
                info.result,
            ),
            reason => Outcome::Library(reason, info.result),
        };
        let npc = entry & !3;
        Ended { outcome, npc, instruction: self.local_store_word(npc.wrapping_sub(4)) }
    }

    /// The address of a word of local store; `address` wraps. `None` if libspe2 doesn't map local
    /// store.
    fn local_store(&self, address: u32) -> Option<*mut u32> {
        // SAFETY: the context lives.
        let (base, size) =
            unsafe { (sys::spe_ls_area_get(self.as_ptr()), sys::spe_ls_size_get(self.as_ptr())) };
        if base.is_null() || size <= 0 {
            return None;
        }
        let offset = address as usize & (size as usize - 1) & !3;
        // SAFETY: the mapping has `size` bytes, a power of two, and offset is that of a word
        // within it.
        Some(unsafe { base.cast::<u8>().add(offset) }.cast::<u32>())
    }

    /// The effective address of local store, for transfers of other SPEs. `None` if libspe2 doesn't
    /// map it.
    #[must_use]
    pub fn local_store_address(&self) -> Option<u64> {
        self.local_store(0).map(|base| base.expose_provenance() as u64)
    }

    /// The effective address of signal register 1, for `sndsig` of other SPEs. `None` if libspe2
    /// doesn't map it.
    #[must_use]
    pub fn signal_address(&self) -> Option<u64> {
        // SAFETY: the context lives.
        let area = unsafe { sys::spe_ps_area_get(self.as_ptr(), sys::SPE_SIG_NOTIFY_1_AREA) };
        let area = NonNull::new(area)?;
        Some(area.as_ptr().expose_provenance() as u64 + sys::SPE_SIG_NOTIFY_1_REGISTER)
    }

    /// Reads a word of local store, in a context that is not running.
    fn local_store_word(&self, address: u32) -> u32 {
        // SAFETY: the word is in the mapping, which lives as long as the context. The access is
        // volatile, because the SPU may write there.
        let read = |word: *mut u32| u32::from_be(unsafe { word.read_volatile() });
        self.local_store(address).map_or(0, read)
    }

    /// Stops the program wherever it is, by overwriting all of its instructions with stops. The
    /// program ends with [`Outcome::Signal`] and [`Context::HALTED`] at its next instruction.
    /// While it waits for a channel, it doesn't reach that.
    pub fn halt(&self, program: &Program) {
        for address in program.code().into_iter().flat_map(|code| code.step_by(4)) {
            if let Some(word) = self.local_store(address) {
                // SAFETY: the word is in the mapping. The access is volatile, because the SPU may
                // read and write there.
                unsafe { word.write_volatile(Self::HALTED.to_be()) };
            }
        }
    }

    /// Whether the inbound mailbox has words that the SPU has not read.
    #[must_use]
    pub fn has_unread_mail(&self) -> bool {
        // SAFETY: the context lives.
        let free = unsafe { sys::spe_in_mbox_status(self.as_ptr()) };
        (0..MAILBOX_DEPTH).contains(&free)
    }

    /// Writes all words to the inbound mailbox. Sleeps while the mailbox is full.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn mail<const COUNT: usize>(&self, mut words: [u32; COUNT]) -> Result<(), SpeError> {
        let count = words.len() as c_int;
        // SAFETY: the context lives, and the pointer is that of `count` words.
        let written = unsafe {
            sys::spe_in_mbox_write(
                self.as_ptr(),
                words.as_mut_ptr(),
                count,
                sys::SPE_MBOX_ALL_BLOCKING,
            )
        };
        if written == count { Ok(()) } else { Err(SpeError::last("spe_in_mbox_write")) }
    }

    /// Writes a word to signal register 1.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn signal(&self, word: u32) -> Result<(), SpeError> {
        // SAFETY: the context lives.
        let result =
            unsafe { sys::spe_signal_write(self.as_ptr(), sys::SPE_SIG_NOTIFY_REG_1, word) };
        if result == 0 { Ok(()) } else { Err(SpeError::last("spe_signal_write")) }
    }

    /// Reads a word from the outbound interrupt mailbox; `None` if it is empty.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn reply(&self) -> Result<Option<u32>, SpeError> {
        let mut word: c_uint = 0;
        // SAFETY: the context lives, and one word is valid for writing.
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

    /// Takes libspe2's record of how the last run ended, which also clears its event.
    ///
    /// # Errors
    /// libspe2 fails.
    pub fn take_stop_record(&self) -> Result<(), SpeError> {
        let mut info = sys::spe_stop_info_t::default();
        // SAFETY: the context lives, and info is valid for writing.
        let result = unsafe { sys::spe_stop_info_read(self.as_ptr(), &raw mut info) };
        if result == 0 { Ok(()) } else { Err(SpeError::last("spe_stop_info_read")) }
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        // SAFETY: the context lives, and has no other users any more. The only possible error is
        // that it doesn't exist.
        unsafe { sys::spe_context_destroy(self.as_ptr()) };
    }
}

/// The number of SPEs that a program may use, as libspe2 reports it. Some Linux kernels also count
/// other entries of a folder, so a console with six SPEs may report 7 or 8.
///
/// # Errors
/// libspe2 fails.
pub fn usable_spes() -> Result<u32, SpeError> {
    // SAFETY: takes no pointers.
    let count = unsafe { sys::spe_cpu_info_get(sys::SPE_COUNT_USABLE_SPES, -1) };
    u32::try_from(count).map_err(|_| SpeError::last("spe_cpu_info_get"))
}

/// The file that libspe2 was loaded from: a shared library, or this program itself. `None` if the
/// system doesn't report it.
#[must_use]
pub fn library_path() -> Option<PathBuf> {
    use std::os::unix::ffi::OsStrExt as _;

    let function = sys::spe_context_create as *const c_void;
    // SAFETY: an all-zero Dl_info is valid, because it has only pointers.
    let mut info: libc::Dl_info = unsafe { std::mem::zeroed() };
    // SAFETY: dladdr accepts any address, and info is valid for writing.
    if unsafe { libc::dladdr(function, &raw mut info) } == 0 || info.dli_fname.is_null() {
        return None;
    }
    // SAFETY: dladdr returned a terminated string that lives as long as the file is loaded.
    let name = unsafe { CStr::from_ptr(info.dli_fname) };
    Some(PathBuf::from(std::ffi::OsStr::from_bytes(name.to_bytes())))
}
