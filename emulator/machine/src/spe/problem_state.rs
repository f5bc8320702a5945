//! The state that both sides of an SPE share: mailboxes, signals, events, the stop request.
//!
//! Invariant: every change that another thread may wait for is made under the lock and followed by
//! a wake-up, so a sleeper never misses one. Watchers are notified after the lock is released.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::SeqCst};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use crate::event::{self, Events};
use crate::lock::lock;
use crate::mailbox::{INBOUND_DEPTH, Mailbox, OUTBOUND_DEPTH};
use crate::mfc::DmaError;
use crate::mfc::interconnect::{Reservation, Unit};
use crate::signal::{Signal, SignalMode, SignalRegister};
use crate::simulated::{Simulation, WaitKey};

/// Is notified when something that the PPE can see of an SPE may have changed: a mailbox, a signal
/// register, a proxy tag, or the end of a run. It must return quickly and must not call the SPE.
pub trait Watcher: Send + Sync {
    /// Something may have changed.
    fn changed(&self);
}

pub(crate) struct State {
    pub inbound: Mailbox,
    pub outbound: Mailbox,
    pub outbound_interrupt: Mailbox,
    pub signals: [Signal; 2],
    /// The cycle of simulated time from which each signal can be read.
    pub signals_arrive: [u64; 2],
    pub events: Events,
    /// The error of a proxy command that failed. It stops the SPU.
    pub fault: Option<DmaError>,
    /// Whether the SPU found nothing in a blocking channel when it last looked, and sleeps. Unused
    /// in simulated time.
    pub sleeps: bool,
}

/// How a wait of the SPU ended.
pub(crate) enum WaitOutcome<T> {
    Ready(T),
    StopRequested,
    TimedOut,
}

pub(crate) struct ProblemState {
    state: Mutex<State>,
    changed: Condvar,
    /// Threads that sleep on `changed`. Written under the lock, so whoever made a change under it
    /// sees every thread that did not see the change. While none sleeps, which is nearly always, a
    /// wake-up needs no system call.
    sleeping: AtomicUsize,
    stop: AtomicBool,
    watchers: Mutex<Vec<Arc<dyn Watcher>>>,
    reservation: Arc<Reservation>,
    /// In simulated time: the key on which other actors sleep.
    sleepers: Option<(Arc<Simulation>, WaitKey)>,
}

impl ProblemState {
    pub(crate) fn new(
        signals: [SignalMode; 2],
        sleepers: Option<(Arc<Simulation>, WaitKey)>,
    ) -> Self {
        Self {
            state: Mutex::new(State {
                inbound: Mailbox::new(INBOUND_DEPTH),
                outbound: Mailbox::new(OUTBOUND_DEPTH),
                outbound_interrupt: Mailbox::new(OUTBOUND_DEPTH),
                signals: signals.map(Signal::new),
                signals_arrive: [0; 2],
                events: Events::default(),
                fault: None,
                sleeps: false,
            }),
            changed: Condvar::new(),
            sleeping: AtomicUsize::new(0),
            stop: AtomicBool::new(false),
            watchers: Mutex::default(),
            reservation: Arc::new(Reservation::new()),
            sleepers,
        }
    }

    fn wake(&self) {
        if self.sleeping.load(SeqCst) > 0 {
            self.changed.notify_all();
        }
        if let Some((simulation, key)) = &self.sleepers {
            simulation.wake(*key);
        }
    }

    /// Reads the state, or makes a change for which no other thread waits.
    pub(crate) fn with<T>(&self, body: impl FnOnce(&mut State) -> T) -> T {
        body(&mut lock(&self.state))
    }

    /// Changes the state, and wakes the threads that may wait for the change.
    pub(crate) fn change<T>(&self, body: impl FnOnce(&mut State) -> T) -> T {
        let result = self.with(body);
        self.announce();
        result
    }

    /// Wakes the threads that may wait for a change that was just made.
    pub(crate) fn announce(&self) {
        self.wake();
        let watchers = lock(&self.watchers).clone();
        for watcher in watchers {
            watcher.changed();
        }
    }

    pub(crate) fn watch(&self, watcher: Arc<dyn Watcher>) {
        lock(&self.watchers).push(watcher);
    }

    pub(crate) fn unwatch(&self, watcher: &Arc<dyn Watcher>) {
        let mut watchers = lock(&self.watchers);
        if let Some(at) = watchers.iter().position(|w| Arc::ptr_eq(w, watcher)) {
            watchers.swap_remove(at);
        }
    }

    /// Raises events for the SPU, and wakes it if it sleeps on channel 0.
    pub(crate) fn raise(&self, events: u32) {
        if events != 0 {
            self.with(|state| state.events.raise(events));
            self.wake();
        }
    }

    pub(crate) fn request_stop(&self, fault: Option<DmaError>) {
        self.change(|state| {
            if state.fault.is_none() {
                state.fault = fault;
            }
            self.stop.store(true, SeqCst);
        });
    }

    pub(crate) fn stop_requested(&self) -> bool {
        self.stop.load(SeqCst)
    }

    /// Ends a stop request that has been obeyed.
    pub(crate) fn take_stop_request(&self) -> Option<DmaError> {
        self.with(|state| {
            self.stop.store(false, SeqCst);
            state.fault.take()
        })
    }

    /// The SPU sleeps until `poll` returns a value, a stop is requested, or `limit` has passed.
    pub(crate) fn wait_as_spu<T>(
        &self,
        limit: Option<Duration>,
        mut poll: impl FnMut(&mut State) -> Option<T>,
    ) -> WaitOutcome<T> {
        let deadline = limit.and_then(|limit| Instant::now().checked_add(limit));
        let result = self.wait(deadline, |state| {
            let outcome = match poll(state) {
                Some(value) => Some(WaitOutcome::Ready(value)),
                None if self.stop_requested() => Some(WaitOutcome::StopRequested),
                None => None,
            };
            state.sleeps = outcome.is_none();
            outcome
        });
        result.unwrap_or(WaitOutcome::TimedOut)
    }

    /// Sleeps until `poll` returns a value. Returns `None` if the deadline has passed.
    pub(crate) fn wait<T>(
        &self,
        deadline: Option<Instant>,
        mut poll: impl FnMut(&mut State) -> Option<T>,
    ) -> Option<T> {
        let mut state = lock(&self.state);
        loop {
            if let Some(value) = poll(&mut state) {
                return Some(value);
            }
            let left = match deadline {
                None => None,
                Some(deadline) => Some(deadline.checked_duration_since(Instant::now())?),
            };
            self.sleeping.fetch_add(1, SeqCst);
            state = match left {
                None => self.changed.wait(state).unwrap_or_else(PoisonError::into_inner),
                Some(left) => {
                    let woken = self.changed.wait_timeout(state, left);
                    woken.unwrap_or_else(PoisonError::into_inner).0
                }
            };
            self.sleeping.fetch_sub(1, SeqCst);
        }
    }
}

impl Unit for ProblemState {
    fn reservation(&self) -> &Arc<Reservation> {
        &self.reservation
    }

    fn reservation_lost(&self) {
        self.raise(event::RESERVATION_LOST);
    }

    fn signal_arrives(&self, register: SignalRegister, cycle: u64) {
        self.with(|state| {
            let arrives = &mut state.signals_arrive[register as usize];
            *arrives = cycle.max(*arrives);
        });
    }

    fn signal(&self, register: SignalRegister, word: u32) {
        let at = register as usize;
        let event = match register {
            SignalRegister::One => event::SIGNAL_1,
            SignalRegister::Two => event::SIGNAL_2,
        };
        self.change(|state| {
            if state.signals[at].write(word) {
                state.events.raise(event);
            }
        });
    }
}
