//! Contexts and gangs: how they are created and destroyed, and what state they hold.

use std::ffi::c_uint;
use std::os::fd::RawFd;
use std::ptr;
use std::sync::atomic::AtomicU32;
use std::sync::{Arc, Mutex};

use libc::{c_int, c_void};
use spu_emulator::local_store::SIZE;

use crate::backend::{Backend, Choice, chosen};
use crate::emulated::Emulated;
use crate::error::{self, Errno};
use crate::machine::write_reports;
use crate::spufs::{Gang, Spufs};
use crate::stop_record::StopRecords;
use crate::types::{
    SPE_AFFINITY_MEMORY, SPE_CFG_SIGNOTIFY1_OR, SPE_CFG_SIGNOTIFY2_OR, SPE_EVENT_SPE_STOPPED,
    SPE_EVENTS_ENABLE, SPE_ISOLATE, SPE_ISOLATE_EMULATE, SPE_MAP_PS, SPE_NOSCHED,
    SPE_SIG_NOTIFY_2_AREA, SpeContext, SpeGangContext, SpeProgramHandle,
};

const KNOWN_FLAGS: c_uint = SPE_CFG_SIGNOTIFY1_OR
    | SPE_CFG_SIGNOTIFY2_OR
    | SPE_MAP_PS
    | SPE_ISOLATE
    | SPE_ISOLATE_EMULATE
    | SPE_EVENTS_ENABLE
    | SPE_AFFINITY_MEMORY
    | SPE_NOSCHED;

/// The object that a context pointer refers to. Every user holds a reference to it, so a program
/// may destroy a context while another thread still runs it.
pub(crate) struct Context {
    pub(crate) backend: Box<dyn Backend>,
    pub(crate) events_enabled: bool,
    /// Entry point of the program that was loaded last.
    pub(crate) entry: AtomicU32,
    pub(crate) stops: StopRecords,
    /// The program's data for each kind of event.
    pub(crate) event_data: Mutex<[u64; 4]>,
}

impl Context {
    /// The file whose readiness is this event, on spufs.
    pub(crate) fn event_file(&self, event: c_uint) -> Result<Option<RawFd>, Errno> {
        match event {
            SPE_EVENT_SPE_STOPPED => Ok(self.stops.file()),
            event => self.backend.event_file(event),
        }
    }
}

/// Returns the context that a pointer from the program refers to.
///
/// # Safety
/// `pointer` is NULL or came from `spe_context_create` and was not destroyed.
pub(crate) unsafe fn context(pointer: *mut SpeContext) -> Result<Arc<Context>, Errno> {
    if pointer.is_null() {
        return Err(Errno(libc::ESRCH));
    }
    // SAFETY: the caller vouches for the pointer. Its private part came from `Arc::into_raw`,
    // which holds a reference until the context is destroyed.
    unsafe {
        let shared: *const Context = (*pointer).base_private.cast();
        Arc::increment_strong_count(shared);
        Ok(Arc::from_raw(shared))
    }
}

/// # Safety
/// `gang` is NULL or a live gang.
unsafe fn gang_behind(gang: *mut SpeGangContext) -> Option<Arc<Gang>> {
    // SAFETY: the caller vouches for the pointer. Its private part is NULL, or came from
    // `Arc::into_raw`, which holds a reference until the gang is destroyed.
    unsafe {
        let shared: *const Gang = gang.as_ref()?.base_private.cast();
        if shared.is_null() {
            return None;
        }
        Arc::increment_strong_count(shared);
        Some(Arc::from_raw(shared))
    }
}

fn create(
    flags: c_uint,
    neighbor: Option<&Context>,
    gang: Option<Arc<Gang>>,
) -> Result<*mut SpeContext, Errno> {
    if flags & !KNOWN_FLAGS != 0 || flags & SPE_ISOLATE_EMULATE != 0 {
        return Err(Errno(libc::EINVAL));
    }
    let mut handle = Box::new(SpeContext {
        handle: SpeProgramHandle {
            handle_size: 0,
            elf_image: ptr::null_mut(),
            toe_shadow: ptr::null_mut(),
        },
        base_private: ptr::null_mut(),
        event_private: ptr::null_mut(),
    });
    let events_enabled = flags & SPE_EVENTS_ENABLE != 0;
    let (backend, stops): (Box<dyn Backend>, _) = match chosen()? {
        Choice::Emulator if neighbor.is_some() => return Err(Errno(libc::EINVAL)),
        Choice::Emulator => (Box::new(Emulated::create(flags)?), StopRecords::default()),
        Choice::Spufs => {
            let neighbor = neighbor.and_then(|neighbor| neighbor.backend.directory());
            let number = ptr::from_ref(&*handle).addr();
            let spufs = Spufs::create(flags, number, neighbor, gang)?;
            (Box::new(spufs), StopRecords::with_file()?)
        }
    };
    let context = Arc::new(Context {
        backend,
        events_enabled,
        entry: AtomicU32::new(0),
        stops,
        event_data: Mutex::new([0; 4]),
    });
    handle.base_private = Arc::into_raw(context).cast_mut().cast();
    Ok(Box::into_raw(handle))
}

/// Creates a context. `gang` may be NULL. On the emulator, a gang has no effect that a program
/// could see.
///
/// # Safety
/// `gang` is NULL or a live gang.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_context_create(
    flags: c_uint,
    gang: *mut SpeGangContext,
) -> *mut SpeContext {
    // SAFETY: the caller vouches for the pointer.
    error::pointer(|| create(flags, None, unsafe { gang_behind(gang) }))
}

/// Creates a context in a gang. A request for affinity fails with EINVAL on the emulator, as on a
/// PlayStation 3, whose kernel has no affinity tables.
///
/// # Safety
/// `neighbor` is NULL or a live context, `gang` NULL or a live gang.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_context_create_affinity(
    flags: c_uint,
    neighbor: *mut SpeContext,
    gang: *mut SpeGangContext,
) -> *mut SpeContext {
    error::pointer(|| {
        if gang.is_null() {
            return Err(Errno(libc::ESRCH));
        }
        let neighbor = if neighbor.is_null() {
            None
        } else {
            // SAFETY: the caller vouches for the pointer.
            Some(unsafe { context(neighbor)? })
        };
        // SAFETY: the caller vouches for the pointer.
        create(flags, neighbor.as_deref(), unsafe { gang_behind(gang) })
    })
}

/// Destroys a context. A thread that is running it continues.
///
/// # Safety
/// `spe` is NULL or a live context, which must not be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_context_destroy(spe: *mut SpeContext) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        // SAFETY: the box came from `Box::into_raw`, and the caller gives it up. Its private part
        // is the reference that `Arc::into_raw` left.
        let owned = unsafe {
            let owned = Box::from_raw(spe);
            drop(Arc::from_raw(owned.base_private.cast::<Context>()));
            owned
        };
        drop(context);
        // A context's folder is named by this address, so it goes first: another thread's context
        // may get the address at once.
        drop(owned);
        write_reports();
        Ok(0)
    })
}

/// Creates a gang. The flags are ignored, because libspe2 defines none.
///
/// # Safety
/// None beyond the C calling convention.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_gang_context_create(_flags: c_uint) -> *mut SpeGangContext {
    error::pointer(|| {
        let mut gang = Box::new(SpeGangContext {
            base_private: ptr::null_mut(),
            event_private: ptr::null_mut(),
        });
        if chosen()? == Choice::Spufs {
            let number = ptr::from_ref(&*gang).addr();
            let shared = Arc::new(Gang::create(number)?);
            gang.base_private = Arc::into_raw(shared).cast_mut().cast();
        }
        Ok(Box::into_raw(gang))
    })
}

/// Destroys a gang. Its contexts stay alive.
///
/// # Safety
/// `gang` is NULL or a live gang, which must not be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_gang_context_destroy(gang: *mut SpeGangContext) -> c_int {
    error::int(|| {
        if gang.is_null() {
            return Err(Errno(libc::ESRCH));
        }
        // SAFETY: it came from `Box::into_raw`, and the caller gives it up. Its private part is
        // NULL, or the reference that `Arc::into_raw` left.
        unsafe {
            let owned = Box::from_raw(gang);
            if !owned.base_private.is_null() {
                drop(Arc::from_raw(owned.base_private.cast::<Gang>()));
            }
        }
        Ok(0)
    })
}

/// Returns the mapping of local store: 256 KB, valid until the context is destroyed.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_ls_area_get(spe: *mut SpeContext) -> *mut c_void {
    error::pointer(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        let area = context.backend.local_store();
        area.expose_provenance();
        if let Some(simulation) = context.backend.simulation() {
            simulation.serialise();
        }
        Ok(area.cast())
    })
}

/// Returns the size of local store in bytes.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_ls_size_get(spe: *mut SpeContext) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        unsafe { context(spe)? };
        Ok(SIZE as c_int)
    })
}

/// Returns a problem-state area of a context with [`SPE_MAP_PS`]: registers that the program loads
/// and stores as 32-bit words.
///
/// # Safety
/// `spe` is NULL or a live context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_ps_area_get(spe: *mut SpeContext, area: c_uint) -> *mut c_void {
    error::pointer(|| {
        // SAFETY: the caller vouches for the pointer.
        let context = unsafe { context(spe)? };
        if area > SPE_SIG_NOTIFY_2_AREA {
            return Err(Errno(libc::EINVAL));
        }
        let area = context.backend.area(area as usize);
        area.ok_or(Errno(libc::EACCES))
    })
}
