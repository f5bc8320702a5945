//! Contexts and gangs: how they are created and destroyed, and what state they hold.

use std::ffi::c_uint;
use std::ptr;
use std::sync::atomic::AtomicU32;
use std::sync::{Arc, Mutex};

use libc::{c_int, c_void};
use spu_emulator::local_store::SIZE;
use spu_emulator::signal::SignalMode;
use spu_emulator::spe::{Config, Spe};

use crate::error::{self, Errno};
use crate::machine::{machine, policy, write_reports};
use crate::problem_state::{Areas, RunState};
use crate::process_memory::ProcessMemory;
use crate::stop_record::StopRecords;
use crate::types::{
    SPE_AFFINITY_MEMORY, SPE_CFG_SIGNOTIFY1_OR, SPE_CFG_SIGNOTIFY2_OR, SPE_EVENTS_ENABLE,
    SPE_ISOLATE, SPE_ISOLATE_EMULATE, SPE_MAP_PS, SPE_NOSCHED, SPE_SIG_NOTIFY_2_AREA, SpeContext,
    SpeGangContext, SpeProgramHandle,
};

const KNOWN_FLAGS: c_uint = SPE_CFG_SIGNOTIFY1_OR
    | SPE_CFG_SIGNOTIFY2_OR
    | SPE_MAP_PS
    | SPE_ISOLATE
    | SPE_ISOLATE_EMULATE
    | SPE_EVENTS_ENABLE
    | SPE_AFFINITY_MEMORY
    | SPE_NOSCHED;

/// The object behind a context pointer. Every user holds a reference to it, so a program may
/// destroy a context while another thread still runs it.
pub(crate) struct Context {
    pub(crate) spe: Arc<Spe>,
    pub(crate) events_enabled: bool,
    /// Entry point of the program that was loaded last.
    pub(crate) entry: AtomicU32,
    /// Proxy tags that were used and have not been reported complete.
    pub(crate) issued_tags: Mutex<u32>,
    pub(crate) stops: StopRecords,
    /// The program's data for each kind of event.
    pub(crate) event_data: Mutex<[u64; 4]>,
    /// The SPU's state as its registers show it.
    pub(crate) run_state: Arc<RunState>,
    /// The mapped problem state, if the program asked for it.
    pub(crate) areas: Option<Areas>,
}

/// Returns the context behind a pointer from the program.
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

fn create(flags: c_uint) -> Result<*mut SpeContext, Errno> {
    let has = |flag| flags & flag != 0;
    if flags & !KNOWN_FLAGS != 0 || has(SPE_ISOLATE_EMULATE) {
        return Err(Errno(libc::EINVAL));
    }
    if has(SPE_ISOLATE) {
        return Err(Errno(libc::ENODEV));
    }
    // A PlayStation 3 kernel does not know where its SPEs are, so affinity is not supported.
    if has(SPE_AFFINITY_MEMORY) {
        return Err(Errno(libc::EINVAL));
    }
    // SAFETY: geteuid can't fail and takes no pointers.
    if has(SPE_NOSCHED) && unsafe { libc::geteuid() } != 0 {
        return Err(Errno(libc::EPERM));
    }
    ProcessMemory::prepare().map_err(|_| Errno(libc::EFAULT))?;
    let mode = |flag| {
        if has(flag) {
            SignalMode::Or
        } else {
            SignalMode::Overwrite
        }
    };
    let config = Config {
        signal_modes: [mode(SPE_CFG_SIGNOTIFY1_OR), mode(SPE_CFG_SIGNOTIFY2_OR)],
        policy: policy()?,
    };
    let spe = Spe::new(&machine()?.emulated, config);
    let area = spe.local_store().as_ptr();
    spe.map_local_store(area.expose_provenance() as u64);
    let run_state = Arc::new(RunState::default());
    let areas = has(SPE_MAP_PS)
        .then(|| Areas::map(&spe, &run_state))
        .transpose()?;
    let context = Arc::new(Context {
        spe,
        run_state,
        areas,
        events_enabled: has(SPE_EVENTS_ENABLE),
        entry: AtomicU32::new(0),
        issued_tags: Mutex::new(0),
        stops: StopRecords::default(),
        event_data: Mutex::new([0; 4]),
    });
    Ok(Box::into_raw(Box::new(SpeContext {
        handle: SpeProgramHandle {
            handle_size: 0,
            elf_image: ptr::null_mut(),
            toe_shadow: ptr::null_mut(),
        },
        base_private: Arc::into_raw(context).cast_mut().cast(),
        event_private: ptr::null_mut(),
    })))
}

/// Creates a context. `gang` may be NULL. A gang has no effect that a program could see.
///
/// # Safety
/// `gang` is NULL or a live gang.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_context_create(
    flags: c_uint,
    _gang: *mut SpeGangContext,
) -> *mut SpeContext {
    error::pointer(|| create(flags))
}

/// Creates a context in a gang. A request for affinity fails with EINVAL, as on a PlayStation 3,
/// whose kernel has no affinity tables.
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
        if !neighbor.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        create(flags)
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
        unsafe {
            let owned = Box::from_raw(spe);
            drop(Arc::from_raw(owned.base_private.cast::<Context>()));
        }
        drop(context);
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
        Ok(Box::into_raw(Box::new(SpeGangContext {
            base_private: ptr::null_mut(),
            event_private: ptr::null_mut(),
        })))
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
        // SAFETY: it came from `Box::into_raw`, and the caller gives it up.
        drop(unsafe { Box::from_raw(gang) });
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
        let area = context.spe.local_store().as_ptr();
        area.expose_provenance();
        if let Some(simulation) = context.spe.simulation() {
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
        let areas = context.areas.as_ref().ok_or(Errno(libc::EACCES))?;
        areas.area(area as usize).ok_or(Errno(libc::EINVAL))
    })
}
