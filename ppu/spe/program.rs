//! SPU programs: ELF images in this program's memory.

use std::ffi::c_void;
use std::ptr;

use super::sys::spe_program_handle_t;

/// Bytes aligned as the MFC likes its transfers.
#[repr(C, align(128))]
pub struct Image<Bytes: ?Sized>(pub Bytes);

/// An SPU ELF image, as libspe2 takes it.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    image: &'static [u8],
}

static TRACER: &Image<[u8]> = &Image(*include_bytes!(env!("CELLRAY_SPU_IMAGE_FILE")));

impl Program {
    /// The tracer's own program.
    #[must_use]
    pub fn tracer() -> Self {
        Self { image: &TRACER.0 }
    }

    /// Another program: a complete SPU ELF file. libspe2 trusts the offsets in it.
    ///
    /// # Safety
    ///
    /// The image must be a whole, well-formed ELF file: no header in it may point outside of it.
    #[must_use]
    pub unsafe fn from_elf(image: &'static [u8]) -> Self {
        Self { image }
    }

    /// The ELF file.
    #[must_use]
    pub fn image(&self) -> &'static [u8] {
        self.image
    }

    pub(super) fn handle(&self) -> spe_program_handle_t {
        spe_program_handle_t {
            handle_size: size_of::<spe_program_handle_t>() as u32,
            elf_image: self.image.as_ptr().cast::<c_void>(),
            toe_shadow: ptr::null(),
        }
    }
}
