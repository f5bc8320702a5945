//! Waits for events of SPEs, which run meanwhile.

use std::ops::Sub;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::time::Duration;

use spu_emulator::machine::Machine;
use spu_emulator::simulated::{Simulation, WaitKey};
use spu_emulator::spe::{Spe, Watcher};

use super::super::{Event, SpeError};
use super::{Context, machine};

/// How long was waited in vain, in milliseconds.
static WAITED: AtomicU64 = AtomicU64::new(0);

/// A moment, by the time that was waited in vain before it.
#[derive(Clone, Copy, Debug)]
pub struct Instant(Duration);

impl Instant {
    /// The present moment.
    #[must_use]
    pub fn now() -> Self {
        Self(Duration::from_millis(WAITED.load(Relaxed)))
    }

    /// The time since then.
    #[must_use]
    pub fn elapsed(self) -> Duration {
        Self::now() - self
    }

    /// The time since an earlier moment.
    #[must_use]
    pub fn saturating_duration_since(self, earlier: Self) -> Duration {
        self - earlier
    }
}

impl Sub for Instant {
    type Output = Duration;

    fn sub(self, earlier: Self) -> Duration {
        self.0.saturating_sub(earlier.0)
    }
}

/// Wakes who waits in simulated time.
struct Bell(Arc<Simulation>, WaitKey);

impl Watcher for Bell {
    fn changed(&self) {
        self.0.wake(self.1);
    }
}

/// The SPEs whose events are waited for.
pub struct Events {
    machine: Arc<Machine>,
    bell: Option<Arc<Bell>>,
    spes: std::cell::RefCell<Vec<(u32, Arc<Spe>)>>,
}

impl Events {
    /// Creates a handler that waits for nothing yet.
    ///
    /// # Errors
    /// No machine was chosen.
    pub fn create() -> Result<Self, SpeError> {
        let machine = machine()?;
        let bell = machine.simulation().map(|simulation| {
            let simulation = Arc::clone(simulation);
            let key = simulation.new_key();
            Arc::new(Bell(simulation, key))
        });
        Ok(Self { machine, bell, spes: Default::default() })
    }

    /// Makes [`Events::wait`] report the events of this context under this number.
    ///
    /// # Errors
    /// None; other hosts have some.
    pub fn watch(&self, context: &Context, number: u32) -> Result<(), SpeError> {
        if let Some(bell) = &self.bell {
            context.spe.watch(bell.clone());
        }
        self.spes.borrow_mut().push((number, Arc::clone(&context.spe)));
        Ok(())
    }

    /// Lets the SPEs run until an event, and returns the context's number and the event; `None`
    /// after the timeout. Without simulated time, each SPE has one turn a millisecond.
    ///
    /// # Errors
    /// None; other hosts have some.
    pub fn wait(&self, timeout: Duration) -> Result<Option<(u32, Event)>, SpeError> {
        let limit = timeout.as_millis().clamp(1, u64::MAX.into()) as u64;
        let found = match (&self.bell, self.machine.turns()) {
            (Some(bell), _) => {
                let limit = Duration::from_millis(limit);
                bell.0.wait(bell.1, Some(limit), || self.event())
            }
            (None, Some(turns)) => (0..limit).find_map(|_| {
                self.event().or_else(|| {
                    turns.go_on();
                    None
                })
            }),
            (None, None) => None,
        };
        if found.is_none() {
            WAITED.fetch_add(limit, Relaxed);
        }
        Ok(found)
    }

    fn event(&self) -> Option<(u32, Event)> {
        self.spes.borrow().iter().find_map(|(number, spe)| {
            if spe.outbound_interrupt_waiting() > 0 {
                return Some((*number, Event::Reply));
            }
            spe.ended().map(|_| (*number, Event::Stopped))
        })
    }
}
