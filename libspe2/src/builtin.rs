//! The handlers that the library itself registers: C99 streams, POSIX.1 and memory in effective
//! address space. One library serves all SPEs of the process.
//!
//! The standard streams are the process's own `stdin`, `stdout` and `stderr` of C. So what an SPU
//! program and the PPE program print appears in the order in which they printed it.

use std::ptr;
use std::sync::OnceLock;

use libc::{FILE, c_int, c_uint, c_void};
use spu_emulator::local_store::SIZE;
use spu_emulator::memory::MainMemory;
use spu_emulator::ppe_call::{Buffering, Errno, GuestMemory, Heap, Host, Library, SYSTEM_CALL};

use crate::process_memory::ProcessMemory;

const C99: u8 = 0;
const POSIX: u8 = 1;
const LIBEA: u8 = 5;
/// What a handler returns if the library has no function with the opcode.
const NO_FUNCTION: c_int = 1;
/// What a handler returns if the library itself fails.
const FAILED: c_int = -1;

unsafe extern "C" {
    static stdin: *mut FILE;
    static stdout: *mut FILE;
    static stderr: *mut FILE;
}

static LIBRARY: OnceLock<Library> = OnceLock::new();

fn library() -> &'static Library {
    LIBRARY.get_or_init(|| {
        // SAFETY: the function takes no arguments and exists as long as the process.
        unsafe { libc::atexit(flush_at_exit) };
        Library::new(Box::new(Streams), Box::new(ProcessHeap))
    })
}

extern "C" fn flush_at_exit() {
    // At the end of the process, nobody is left to whom a failure could be reported.
    let _ = library().flush();
}

/// Serves a call of class 0x2100.
///
/// # Safety
/// `ls_base` points to local store.
pub(crate) unsafe extern "C" fn c99(ls_base: *mut c_void, ls_address: c_uint) -> c_int {
    // SAFETY: the caller vouches for local store.
    unsafe { serve(C99, ls_base, ls_address) }
}

/// Serves a call of class 0x2101.
///
/// # Safety
/// `ls_base` points to local store.
pub(crate) unsafe extern "C" fn posix(ls_base: *mut c_void, ls_address: c_uint) -> c_int {
    // SAFETY: the caller vouches for local store.
    unsafe { serve(POSIX, ls_base, ls_address) }
}

/// Serves a call of class 0x2105.
///
/// # Safety
/// `ls_base` points to local store.
pub(crate) unsafe extern "C" fn libea(ls_base: *mut c_void, ls_address: c_uint) -> c_int {
    // SAFETY: the caller vouches for local store.
    unsafe { serve(LIBEA, ls_base, ls_address) }
}

/// # Safety
/// `ls_base` points to local store.
unsafe fn serve(class: u8, ls_base: *mut c_void, ls_address: c_uint) -> c_int {
    let store = Mapping(ls_base.cast());
    let served = std::panic::catch_unwind(|| library().serve(class, &store, ls_address));
    match served {
        Ok(Ok(())) => 0,
        Ok(Err(error)) => {
            messages::print!("libspe2: {error}");
            NO_FUNCTION
        }
        Err(_) => FAILED,
    }
}

/// Carries out a Linux system call, as the kernel does on a console. Returns whether it did: if
/// the call's block does not lie in local store, the kernel reports the stop.
pub(crate) fn system_call(store: &dyn GuestMemory, address: u32) -> bool {
    library().serve(SYSTEM_CALL, store, address).is_ok()
}

/// Local store as a handler gets it.
#[derive(Clone, Copy)]
struct Mapping(*mut u8);

impl Mapping {
    /// Copies piece by piece, because addresses wrap at the end of local store.
    fn pieces(address: u32, length: usize, mut copy: impl FnMut(usize, std::ops::Range<usize>)) {
        let mut done = 0;
        while done < length {
            let at = (address as usize).wrapping_add(done) & (SIZE as usize - 1);
            let end = length.min(done + SIZE as usize - at);
            copy(at, done..end);
            done = end;
        }
    }
}

impl GuestMemory for Mapping {
    fn read(&self, address: u32, into: &mut [u8]) {
        Self::pieces(address, into.len(), |at, piece| {
            let into = &mut into[piece];
            // SAFETY: the piece lies in local store, which is mapped as long as the handler runs.
            unsafe { ptr::copy_nonoverlapping(self.0.add(at), into.as_mut_ptr(), into.len()) };
        });
    }

    fn write(&self, address: u32, from: &[u8]) {
        Self::pieces(address, from.len(), |at, piece| {
            let from = &from[piece];
            // SAFETY: the piece lies in local store, which is mapped as long as the handler runs.
            unsafe { ptr::copy_nonoverlapping(from.as_ptr(), self.0.add(at), from.len()) };
        });
    }
}

/// The process's descriptors, and C's streams on the first three.
struct Streams;

/// The process's stream on a descriptor.
fn stream(descriptor: i32) -> Option<*mut FILE> {
    // SAFETY: the C library has set these pointers before any code of the program runs.
    unsafe {
        match descriptor {
            libc::STDIN_FILENO => Some(stdin),
            libc::STDOUT_FILENO => Some(stdout),
            libc::STDERR_FILENO => Some(stderr),
            _ => None,
        }
    }
}

fn last_errno() -> Errno {
    std::io::Error::last_os_error().into()
}

impl Host for Streams {
    fn read_stream(&self, descriptor: i32, into: &mut [u8]) -> Result<usize, Errno> {
        let Some(stream) = stream(descriptor) else {
            return self.read(descriptor, into);
        };
        // SAFETY: the stream is open as long as the process, and the buffer has this size.
        let read = unsafe { libc::fread(into.as_mut_ptr().cast(), 1, into.len(), stream) };
        // SAFETY: as above.
        if read == 0 && unsafe { libc::ferror(stream) } != 0 {
            return Err(last_errno());
        }
        if read == 0 {
            // The guest's stream keeps its own end, and clears it by itself.
            // SAFETY: as above.
            unsafe { libc::clearerr(stream) };
        }
        Ok(read)
    }

    fn write_stream(&self, descriptor: i32, from: &[u8]) -> Result<usize, Errno> {
        let Some(stream) = stream(descriptor) else {
            return self.write(descriptor, from);
        };
        // SAFETY: the stream is open as long as the process, and the buffer has this size.
        match unsafe { libc::fwrite(from.as_ptr().cast(), 1, from.len(), stream) } {
            0 if !from.is_empty() => Err(last_errno()),
            written => Ok(written),
        }
    }

    fn buffers(&self, descriptor: i32) -> bool {
        stream(descriptor).is_some()
    }

    fn flush(&self, descriptor: i32) -> Result<(), Errno> {
        match stream(descriptor) {
            // SAFETY: the stream is open as long as the process.
            Some(stream) if unsafe { libc::fflush(stream) } != 0 => Err(last_errno()),
            _ => Ok(()),
        }
    }

    fn set_buffering(&self, descriptor: i32, buffering: Buffering, size: usize) {
        let mode = match buffering {
            Buffering::Full => libc::_IOFBF,
            Buffering::Line => libc::_IOLBF,
            Buffering::None => libc::_IONBF,
        };
        if let Some(stream) = stream(descriptor) {
            // SAFETY: the stream is open as long as the process, and allocates its own buffer.
            unsafe { libc::setvbuf(stream, ptr::null_mut(), mode, size) };
        }
    }
}

/// The process's heap. Either side may free what the other has allocated.
struct ProcessHeap;

impl Heap for ProcessHeap {
    fn is_process(&self) -> bool {
        true
    }

    fn allocate(&mut self, size: u64, alignment: u64) -> Option<u64> {
        let size = usize::try_from(size.max(1)).ok()?;
        let alignment = usize::try_from(alignment).ok()?;
        let mut memory = ptr::null_mut();
        // SAFETY: the result is a valid place for a pointer, and the alignment is a power of two
        // of at least a pointer's size.
        if unsafe { libc::posix_memalign(&raw mut memory, alignment, size) } != 0 {
            return None;
        }
        // SAFETY: the memory is new and has this size.
        unsafe { memory.cast::<u8>().write_bytes(0, size) };
        Some(memory.expose_provenance() as u64)
    }

    /// As with C's `free`, the guest vouches for the address.
    fn release(&mut self, ea: u64) -> bool {
        // SAFETY: the guest is part of the process and vouches for its allocation.
        unsafe { libc::free(ptr::with_exposed_provenance_mut(ea as usize)) };
        true
    }

    fn size_of(&self, ea: u64) -> Option<u64> {
        // SAFETY: the guest is part of the process and vouches for its allocation.
        let size =
            unsafe { libc::malloc_usable_size(ptr::with_exposed_provenance_mut(ea as usize)) };
        Some(size as u64)
    }

    fn read(&self, ea: u64, into: &mut [u8]) -> bool {
        ProcessMemory.read(ea, into).is_ok()
    }

    fn write(&self, ea: u64, from: &[u8]) -> bool {
        ProcessMemory.write(ea, from).is_ok()
    }
}
