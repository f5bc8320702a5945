//! SPU programs in files and in memory.

use std::fs::{File, OpenOptions};
use std::io::Read;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{MetadataExt, OpenOptionsExt};
use std::path::Path;
use std::ptr;
use std::sync::atomic::Ordering::SeqCst;

use libc::{c_char, c_int};
use spu_emulator::elf::{self, ElfError, Image, TOE_SIZE};
use spu_emulator::memory::MainMemory;

use crate::context::context;
use crate::error::{self, Errno};
use crate::process_memory::ProcessMemory;
use crate::types::{SpeContext, SpeProgramHandle};

const PAGE: usize = 4096;

/// A page of an image. SPU programs read their image by DMA, so it is aligned as a mapping is.
#[repr(C, align(4096))]
struct Page([u8; PAGE]);

/// What `spe_image_open` creates. The program sees only the first member.
#[repr(C)]
struct OpenImage {
    handle: SpeProgramHandle,
    pages: Box<[Page]>,
    toe_shadow: Box<[u8; TOE_SIZE as usize]>,
}

fn refuse(error: &ElfError) -> Errno {
    messages::print!("libspe2: {error}");
    Errno(libc::EINVAL)
}

fn contents(path: &Path) -> Result<Vec<u8>, Errno> {
    // Opening a pipe that has no writer must not hang. The flag has no effect on files.
    let mut file: File = OpenOptions::new().read(true).custom_flags(libc::O_NONBLOCK).open(path)?;
    let metadata = file.metadata()?;
    if metadata.mode() & 0o111 == 0 {
        return Err(Errno(libc::EACCES));
    }
    if !metadata.is_file() {
        return Err(Errno(libc::EINVAL));
    }
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn open(path: &Path) -> Result<*mut SpeProgramHandle, Errno> {
    let bytes = contents(path)?;
    let image = Image::parse(&bytes).map_err(|error| refuse(&error))?;
    let mut pages: Box<[Page]> = bytes
        .chunks(PAGE)
        .map(|chunk| {
            let mut page = Page([0; PAGE]);
            page.0[..chunk.len()].copy_from_slice(chunk);
            page
        })
        .collect();
    let elf_image = pages.as_mut_ptr();
    let mut toe_shadow = Box::new([0; TOE_SIZE as usize]);
    if image.toe().is_some() {
        let ea = elf_image.expose_provenance() as u64;
        toe_shadow[..8].copy_from_slice(&ea.to_be_bytes());
    }
    let handle = SpeProgramHandle {
        handle_size: size_of::<SpeProgramHandle>() as u32,
        elf_image: elf_image.cast(),
        toe_shadow: toe_shadow.as_mut_ptr().cast(),
    };
    let open = Box::new(OpenImage { handle, pages, toe_shadow });
    Ok(Box::into_raw(open).cast())
}

/// Opens an SPU program. The file must have an execute permission.
///
/// # Safety
/// `filename` is NULL or a C string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_image_open(filename: *const c_char) -> *mut SpeProgramHandle {
    error::pointer(|| {
        if filename.is_null() {
            return Err(Errno(libc::EFAULT));
        }
        // SAFETY: the caller vouches for the string.
        let name = unsafe { std::ffi::CStr::from_ptr(filename) };
        open(Path::new(std::ffi::OsStr::from_bytes(name.to_bytes())))
    })
}

/// Frees an image that [`spe_image_open`] opened.
///
/// # Safety
/// `program` is NULL or came from `spe_image_open` and is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_image_close(program: *mut SpeProgramHandle) -> c_int {
    error::int(|| {
        if program.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        // SAFETY: the handle is the first member of a box that `open` made, and the caller gives
        // it up.
        let OpenImage { pages, toe_shadow, .. } =
            *unsafe { Box::from_raw(program.cast::<OpenImage>()) };
        drop((pages, toe_shadow));
        Ok(0)
    })
}

/// Returns the bytes of an image of which only the address is known.
fn image_at(ea: u64) -> Result<Vec<u8>, Errno> {
    let fetch = |offset: u64, into: &mut [u8]| {
        ea.checked_add(offset).is_some_and(|ea| ProcessMemory.read(ea, into).is_ok())
    };
    let length = elf::file_length(fetch).map_err(|error| refuse(&error))?;
    let mut bytes = vec![0; length as usize];
    if !fetch(0, &mut bytes) {
        return Err(Errno(libc::EINVAL));
    }
    Ok(bytes)
}

/// Loads a program into a context's local store.
///
/// # Safety
/// `spe` is NULL or a live context, `program` NULL or a handle.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_program_load(
    spe: *mut SpeContext,
    program: *mut SpeProgramHandle,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        if program.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        // SAFETY: the caller vouches for the handle.
        let handle = unsafe { ptr::read(program) };
        let ea = handle.elf_image.expose_provenance() as u64;
        let bytes = image_at(ea)?;
        let image = Image::parse(&bytes).map_err(|error| refuse(&error))?;
        let backend = &context.backend;
        image.load_with(ea, |address, bytes| backend.write_local_store(address, bytes));
        if let Some(toe) = image.toe()
            && !handle.toe_shadow.is_null()
        {
            let mut shadow = [0; TOE_SIZE as usize];
            let shadow_ea = handle.toe_shadow.expose_provenance() as u64;
            ProcessMemory.read(shadow_ea, &mut shadow).map_err(|_| Errno(libc::EINVAL))?;
            backend.write_local_store(toe, &shadow);
        }
        context.entry.store(image.entry(), SeqCst);
        backend.loaded(&bytes);
        Ok(0)
    })
}
