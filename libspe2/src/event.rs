//! Event handlers, with which one thread waits for many contexts at once.
//!
//! Events are level-triggered, not edge-triggered: a waiting thread checks each registered context
//! and then sleeps on the handler's bell until some context rings it. Invariant: the bell is read
//! before the check, so a change during the check ends the sleep at once.
//!
//! On spufs, an event is the readiness of a file, and a handler sleeps on an epoll descriptor.

use std::ptr;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use libc::{c_int, c_uint, c_void};
use spu_emulator::simulated::{Simulation, WaitKey};
use spu_emulator::spe::Watcher;

use crate::backend::{Choice, chosen};
use crate::context::{Context, context};
use crate::error::{self, Errno};
use crate::spufs::Epoll;
use crate::types::{
    SPE_EVENT_ALL_EVENTS, SPE_EVENT_IN_MBOX, SPE_EVENT_OUT_INTR_MBOX, SPE_EVENT_SPE_STOPPED,
    SPE_EVENT_TAG_GROUP, SpeContext, SpeEventData, SpeEventUnit,
};

/// The events in the order in which they are registered. Each can be registered separately.
const EVENTS: [c_uint; 4] =
    [SPE_EVENT_OUT_INTR_MBOX, SPE_EVENT_IN_MBOX, SPE_EVENT_TAG_GROUP, SPE_EVENT_SPE_STOPPED];

#[derive(Default)]
struct Bell {
    rings: Mutex<u64>,
    rung: Condvar,
    /// In simulated time, the key that waiters sleep on. It is set by the first registration.
    simulated: OnceLock<(Arc<Simulation>, WaitKey)>,
}

impl Bell {
    fn rings(&self) -> MutexGuard<'_, u64> {
        self.rings.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Sleeps until the bell has rung more than `seen` times. Returns `false` if the deadline
    /// passes first.
    fn wait(&self, seen: u64, deadline: Option<Instant>) -> bool {
        let mut rings = self.rings();
        while *rings == seen {
            rings = match deadline {
                None => self.rung.wait(rings).unwrap_or_else(PoisonError::into_inner),
                Some(deadline) => {
                    let Some(left) = deadline.checked_duration_since(Instant::now()) else {
                        return false;
                    };
                    let woken = self.rung.wait_timeout(rings, left);
                    woken.unwrap_or_else(PoisonError::into_inner).0
                }
            };
        }
        true
    }
}

impl Watcher for Bell {
    fn changed(&self) {
        *self.rings() += 1;
        self.rung.notify_all();
        if let Some((simulation, key)) = self.simulated.get() {
            simulation.wake(*key);
        }
    }
}

struct Registration {
    /// The pointer that the program has to the context.
    pointer: *mut SpeContext,
    context: Arc<Context>,
    /// Index in [`EVENTS`].
    event: usize,
    /// By which epoll names the registration.
    number: usize,
}

// SAFETY: the pointer is only returned to the program and never dereferenced.
unsafe impl Send for Registration {}

impl Registration {
    fn is_up(&self) -> bool {
        let spe = &self.context.backend;
        match EVENTS[self.event] {
            SPE_EVENT_OUT_INTR_MBOX => matches!(spe.outbound_interrupt_waiting(), Ok(1..)),
            SPE_EVENT_IN_MBOX => matches!(spe.inbound_free(), Ok(1..)),
            SPE_EVENT_TAG_GROUP => spe.tag_waiting(),
            _ => self.context.stops.waiting(),
        }
    }

    fn unit(&self) -> SpeEventUnit {
        let data = self.context.event_data.lock();
        SpeEventUnit {
            events: EVENTS[self.event],
            spe: self.pointer,
            data: SpeEventData { u64: data.unwrap_or_else(PoisonError::into_inner)[self.event] },
        }
    }
}

/// The object that an event handler pointer refers to.
struct Handler {
    bell: Arc<Bell>,
    registrations: Mutex<Vec<Registration>>,
    /// How the handler waits on spufs.
    epoll: Option<Epoll>,
}

impl Handler {
    fn registrations(&self) -> MutexGuard<'_, Vec<Registration>> {
        self.registrations.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn watcher(&self) -> Arc<dyn Watcher> {
        self.bell.clone()
    }

    fn register(&self, registration: Registration) -> Result<(), Errno> {
        let mut registrations = self.registrations();
        let same = |other: &Registration| {
            other.event == registration.event && Arc::ptr_eq(&other.context, &registration.context)
        };
        if registrations.iter().any(same) {
            return Err(Errno(libc::EEXIST));
        }
        if let Some(epoll) = &self.epoll
            && let Some(file) = registration.context.event_file(EVENTS[registration.event])?
        {
            let out = EVENTS[registration.event] == SPE_EVENT_IN_MBOX;
            epoll.add(file, out, registration.number)?;
        }
        if EVENTS[registration.event] == SPE_EVENT_SPE_STOPPED {
            registration.context.stops.register();
        }
        if let Some(simulation) = registration.context.backend.simulation() {
            let key = || (Arc::clone(simulation), simulation.new_key());
            self.bell.simulated.get_or_init(key);
        }
        registration.context.backend.watch(self.watcher());
        registrations.push(registration);
        drop(registrations);
        // A sleeping waiter has to check the new registration.
        self.bell.changed();
        Ok(())
    }

    fn deregister(&self, context: &Arc<Context>, event: usize) -> Result<(), Errno> {
        let mut registrations = self.registrations();
        let at = registrations
            .iter()
            .position(|other| other.event == event && Arc::ptr_eq(&other.context, context))
            .ok_or(Errno(libc::ENOENT))?;
        let registration = registrations.remove(at);
        self.ended(&registration);
        Ok(())
    }

    fn ended(&self, registration: &Registration) {
        if let Some(epoll) = &self.epoll
            && let Ok(Some(file)) = registration.context.event_file(EVENTS[registration.event])
        {
            epoll.remove(file);
        }
        registration.context.backend.unwatch(&self.watcher());
        if EVENTS[registration.event] == SPE_EVENT_SPE_STOPPED {
            registration.context.stops.deregister();
        }
    }

    /// Returns the events that are up, at most `most` of them.
    fn up(&self, most: usize) -> Vec<SpeEventUnit> {
        self.registrations()
            .iter()
            .filter(|registration| registration.is_up())
            .map(Registration::unit)
            .take(most)
            .collect()
    }

    /// The events of the registrations with these numbers.
    fn numbered(&self, numbers: &[usize]) -> Vec<SpeEventUnit> {
        self.registrations()
            .iter()
            .filter(|registration| numbers.contains(&registration.number))
            .map(Registration::unit)
            .collect()
    }

    fn wait(&self, most: usize, limit: Option<Duration>) -> Result<Vec<SpeEventUnit>, Errno> {
        let Some(epoll) = &self.epoll else {
            return Ok(self.wait_for_bell(most, limit));
        };
        loop {
            let units = self.numbered(&epoll.wait(most, limit)?);
            // Without a limit, there are no units only if their registrations have just ended.
            if !units.is_empty() || limit.is_some() {
                return Ok(units);
            }
        }
    }

    fn wait_for_bell(&self, most: usize, limit: Option<Duration>) -> Vec<SpeEventUnit> {
        if let Some((simulation, key)) = self.bell.simulated.get() {
            let poll = || Some(self.up(most)).filter(|units| !units.is_empty());
            return simulation.wait(*key, limit, poll).unwrap_or_default();
        }
        let deadline = limit.map(|limit| Instant::now() + limit);
        loop {
            let seen = *self.bell.rings();
            let units = self.up(most);
            if !units.is_empty() || !self.bell.wait(seen, deadline) {
                return units;
            }
        }
    }
}

impl Drop for Handler {
    fn drop(&mut self) {
        let registrations = std::mem::take(&mut *self.registrations());
        for registration in &registrations {
            self.ended(registration);
        }
    }
}

/// Returns the handler that a pointer from the program refers to.
///
/// # Safety
/// `pointer` is NULL or came from `spe_event_handler_create` and was not destroyed.
unsafe fn handler<'a>(pointer: *mut c_void) -> Result<&'a Handler, Errno> {
    // SAFETY: the caller vouches for the pointer.
    unsafe { pointer.cast::<Handler>().as_ref() }.ok_or(Errno(libc::ESRCH))
}

/// Creates an event handler.
///
/// # Safety
/// None beyond the C calling convention.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_event_handler_create() -> *mut c_void {
    error::pointer(|| {
        let handler = Handler {
            bell: Arc::default(),
            registrations: Mutex::default(),
            epoll: match chosen()? {
                Choice::Emulator => None,
                Choice::Spufs => Some(Epoll::new()?),
            },
        };
        Ok(Box::into_raw(Box::new(handler)).cast())
    })
}

/// Destroys an event handler.
///
/// # Safety
/// `evhandler` is NULL or a live handler, which must not be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_event_handler_destroy(evhandler: *mut c_void) -> c_int {
    error::int(|| {
        if evhandler.is_null() {
            return Err(Errno(libc::ESRCH));
        }
        // SAFETY: it came from `Box::into_raw`, and the caller gives it up.
        drop(unsafe { Box::from_raw(evhandler.cast::<Handler>()) });
        Ok(0)
    })
}

/// Checks the arguments of registering and deregistering, and passes the events one by one to
/// `each`.
///
/// # Safety
/// `evhandler` is NULL or a live handler. `event` is NULL or a valid unit whose context is NULL or
/// live.
unsafe fn each_event(
    evhandler: *mut c_void,
    event: *mut SpeEventUnit,
    mut each: impl FnMut(&Handler, &SpeEventUnit, Arc<Context>, usize) -> Result<(), Errno>,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let handler = unsafe { handler(evhandler)? };
        // SAFETY: the caller vouches for the pointer.
        let unit = unsafe { event.as_ref() }.ok_or(Errno(libc::EINVAL))?;
        if unit.spe.is_null() {
            return Err(Errno(libc::EINVAL));
        }
        // SAFETY: the caller vouches for the context.
        let context = unsafe { context(unit.spe)? };
        let of_tags = context.backend.maps_areas() && unit.events & SPE_EVENT_TAG_GROUP != 0;
        if !context.events_enabled || unit.events & !SPE_EVENT_ALL_EVENTS != 0 || of_tags {
            return Err(Errno(libc::ENOTSUP));
        }
        for (index, bit) in EVENTS.into_iter().enumerate() {
            if unit.events & bit != 0 {
                each(handler, unit, Arc::clone(&context), index)?;
            }
        }
        Ok(0)
    })
}

/// Registers events of a context.
///
/// # Safety
/// `evhandler` is NULL or a live handler. `event` is NULL or a valid unit whose context is NULL or
/// live.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_event_handler_register(
    evhandler: *mut c_void,
    event: *mut SpeEventUnit,
) -> c_int {
    // SAFETY: the caller vouches for the pointers.
    unsafe {
        each_event(evhandler, event, |handler, unit, context, event| {
            static NUMBERS: AtomicUsize = AtomicUsize::new(0);
            let mut data = context.event_data.lock().unwrap_or_else(PoisonError::into_inner);
            data[event] = unit.data.u64;
            drop(data);
            handler.register(Registration {
                pointer: unit.spe,
                context,
                event,
                number: NUMBERS.fetch_add(1, Relaxed),
            })
        })
    }
}

/// Deregisters events of a context.
///
/// # Safety
/// `evhandler` is NULL or a live handler. `event` is NULL or a valid unit whose context is NULL or
/// live.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_event_handler_deregister(
    evhandler: *mut c_void,
    event: *mut SpeEventUnit,
) -> c_int {
    // SAFETY: the caller vouches for the pointers.
    unsafe {
        each_event(evhandler, event, |handler, _, context, event| {
            handler.deregister(&context, event)
        })
    }
}

/// Waits until a registered event is up. Fills in at most `max_events` units and returns their
/// number. `timeout` is in milliseconds: 0 only checks, and a negative one waits for ever.
///
/// # Safety
/// `evhandler` is NULL or a live handler, `events` NULL or a buffer for `max_events` units.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn spe_event_wait(
    evhandler: *mut c_void,
    events: *mut SpeEventUnit,
    max_events: c_int,
    timeout: c_int,
) -> c_int {
    error::int(|| {
        // SAFETY: the caller vouches for the pointer.
        let handler = unsafe { handler(evhandler)? };
        let most = match usize::try_from(max_events) {
            Ok(most) if most > 0 && !events.is_null() => most,
            _ => return Err(Errno(libc::EINVAL)),
        };
        let limit = u64::try_from(timeout).ok().map(Duration::from_millis);
        let units = handler.wait(most, limit)?;
        // SAFETY: the caller vouches for the buffer, and there are at most as many units.
        unsafe { ptr::copy_nonoverlapping(units.as_ptr(), events, units.len()) };
        Ok(units.len() as c_int)
    })
}
