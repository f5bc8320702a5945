//! Problem-state areas of contexts with `SPE_MAP_PS`: registers that programs load and store.
//!
//! An area is memory that nobody may access. A load or store there raises SIGSEGV, and the handler
//! of that signal decodes the instruction, accesses the emulated register instead, and continues
//! after the instruction. The handler runs on the thread that made the access and outside of any
//! function of this library, so it may take locks.
//!
//! Limitation: a program that installs its own handler of SIGSEGV after its first context must pass
//! on the faults that are not its own.

#[cfg_attr(target_arch = "x86_64", path = "access_x86_64.rs")]
#[cfg_attr(any(target_arch = "powerpc64", target_arch = "powerpc"), path = "access_powerpc.rs")]
#[cfg_attr(
    not(any(target_arch = "x86_64", target_arch = "powerpc64", target_arch = "powerpc")),
    path = "access_absent.rs"
)]
mod access;
mod registers;

use std::io;
use std::ptr;
use std::sync::{Arc, PoisonError, RwLock};

use libc::c_void;
use spu_emulator::signal::SignalRegister;
use spu_emulator::spe::Spe;

use crate::error::Errno;
use crate::fault_handler;
use access::Access;
use registers::{Registers, SIGNAL_1, SIGNAL_2};

pub(crate) use registers::{RunState, SIZE};

/// The offsets of the areas in the map, in the order of `enum ps_area`.
pub(crate) const AREAS: [usize; 5] = [0, 0x3000, 0x4000, 0x14000, 0x1c000];

/// All areas of the process, for the signal handler.
static MAPPED: RwLock<Vec<(usize, Arc<Registers>)>> = RwLock::new(Vec::new());

/// The problem state of a context. It is unmapped when this value is dropped.
pub(crate) struct Areas {
    base: usize,
}

impl Areas {
    pub(crate) fn map(spe: &Arc<Spe>, run: &Arc<RunState>) -> Result<Self, Errno> {
        if !access::SUPPORTED {
            messages::print!("libspe2: SPE_MAP_PS: not on this kind of processor");
            return Err(Errno(libc::ENOTSUP));
        }
        fault_handler::install()?;
        // SAFETY: a new mapping at an address that the kernel chooses overlaps nothing.
        let mapping = unsafe {
            libc::mmap(
                ptr::null_mut(),
                SIZE,
                libc::PROT_NONE,
                libc::MAP_PRIVATE | libc::MAP_ANONYMOUS,
                -1,
                0,
            )
        };
        if mapping == libc::MAP_FAILED {
            return Err(io::Error::last_os_error().into());
        }
        let base = mapping.expose_provenance();
        let registers = Registers::new(Arc::clone(spe), Arc::clone(run));
        let mut mapped = MAPPED.write().unwrap_or_else(PoisonError::into_inner);
        mapped.push((base, Arc::new(registers)));
        drop(mapped);
        // Other SPEs send signals to these addresses.
        spe.map_signal(SignalRegister::One, (base + SIGNAL_1) as u64);
        spe.map_signal(SignalRegister::Two, (base + SIGNAL_2) as u64);
        Ok(Self { base })
    }

    /// The address of an area, or `None` if there is no such area.
    pub(crate) fn area(&self, number: usize) -> Option<*mut c_void> {
        let offset = AREAS.get(number)?;
        Some(ptr::with_exposed_provenance_mut(self.base + offset))
    }
}

impl Drop for Areas {
    fn drop(&mut self) {
        let mut mapped = MAPPED.write().unwrap_or_else(PoisonError::into_inner);
        mapped.retain(|(base, _)| *base != self.base);
        drop(mapped);
        // SAFETY: the mapping belongs to this value and has this size.
        unsafe { libc::munmap(ptr::with_exposed_provenance_mut(self.base), SIZE) };
    }
}

/// The registers at an address, and the offset of the address.
fn registers_at(address: usize) -> Option<(Arc<Registers>, usize)> {
    let mapped = MAPPED.read().unwrap_or_else(PoisonError::into_inner);
    let found = mapped.iter().find(|(base, _)| (*base..base + SIZE).contains(&address));
    found.map(|(base, registers)| (Arc::clone(registers), address - base))
}

/// Carries out an access to a register, if there is one at this address.
///
/// # Safety
/// `context` is what the kernel passes to a handler of the fault.
pub(crate) unsafe fn serve(address: usize, context: *mut c_void) -> bool {
    let Some((registers, offset)) = registers_at(address) else {
        return false;
    };
    // SAFETY: the errno of this thread can always be accessed.
    let errno = unsafe { *libc::__errno_location() };
    // SAFETY: the caller vouches for the context.
    let decoded = unsafe { access::decode(context) };
    let Some(decoded) = decoded else {
        messages::print!(
            "libspe2: offset {offset:#x} of a problem-state area is accessed by an instruction \
             that is no plain 32-bit load or store"
        );
        std::process::abort();
    };
    match decoded.access {
        Access::Load => {
            let value = registers.read(offset);
            // SAFETY: as above.
            unsafe { decoded.set_result(context, value) };
        }
        Access::Store(value) => registers.write(offset, value),
    }
    // SAFETY: as above.
    unsafe { decoded.step(context) };
    // SAFETY: as above.
    unsafe { *libc::__errno_location() = errno };
    true
}
