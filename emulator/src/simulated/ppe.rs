//! PPE threads in the race: each host thread that uses the PPE's side of an SPE.
//!
//! A thread becomes an actor with its first call and leaves when it ends. Calls within a call are
//! part of it: they cost nothing more and need no turn of their own.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::{Arc, Weak};
use std::time::Duration;

use super::race::WaitKey;
use super::simulation::Simulation;
use super::time::cycles;
use super::turnstile::Actor;

/// This thread in one machine's race.
pub(super) struct Thread {
    machine: Weak<()>,
    actor: Actor,
    calls_within: Cell<u32>,
    /// Cycles that the last call took after its act.
    owed: Cell<u64>,
}

thread_local! {
    static THREADS: RefCell<Vec<Rc<Thread>>> = const { RefCell::new(Vec::new()) };
}

/// Ends a call, however it is left.
struct Within<'a>(&'a Cell<u32>);

impl<'a> Within<'a> {
    fn enter(calls: &'a Cell<u32>) -> Self {
        calls.set(calls.get() + 1);
        Self(calls)
    }
}

impl Drop for Within<'_> {
    fn drop(&mut self) {
        self.0.set(self.0.get() - 1);
    }
}

impl Thread {
    pub fn actor(&self) -> &Actor {
        &self.actor
    }

    /// The thread's clock as it goes on now.
    pub fn resume(&self) -> u64 {
        let clock = self.actor.rejoin() + self.owed.take();
        self.actor.progress(clock);
        clock
    }
}

impl Simulation {
    /// This thread; if it is new to the machine, in the race from `from` on.
    pub(super) fn this_thread(&self, from: Option<u64>) -> Rc<Thread> {
        let machine = Arc::downgrade(self.alive());
        let own = |thread: &&Rc<Thread>| Weak::ptr_eq(&thread.machine, &machine);
        let new = || {
            Rc::new(Thread {
                machine: machine.clone(),
                actor: Actor::ppe(self.turnstile(), from),
                calls_within: Cell::new(0),
                owed: Cell::new(0),
            })
        };
        THREADS
            .try_with(|threads| {
                let mut threads = threads.borrow_mut();
                if let Some(thread) = threads.iter().find(own) {
                    return Rc::clone(thread);
                }
                threads.retain(|thread| thread.machine.strong_count() > 0);
                let thread = new();
                threads.push(Rc::clone(&thread));
                thread
            })
            // A call out of a destructor while the thread ends: an actor for this call alone.
            .unwrap_or_else(|_| new())
    }

    /// A call of this thread: `body` in its turn.
    pub fn act<T>(&self, body: impl FnOnce() -> T) -> T {
        let thread = self.this_thread(None);
        if thread.calls_within.get() == 0 {
            thread
                .actor
                .turn(thread.resume() + self.timing().ppe.call_cycles);
        }
        let _within = Within::enter(&thread.calls_within);
        body()
    }

    /// A call that sleeps until `poll` yields, or until `limit` of simulated time has passed. It
    /// looks again when somebody wakes `key`. A limit of no time makes it a look.
    pub fn wait<T>(
        &self,
        key: WaitKey,
        limit: Option<Duration>,
        mut poll: impl FnMut() -> Option<T>,
    ) -> Option<T> {
        let found = self.act(&mut poll);
        if found.is_some() || limit.is_some_and(|limit| limit.is_zero()) {
            return found;
        }
        let thread = self.this_thread(None);
        let actor = &thread.actor;
        let _within = Within::enter(&thread.calls_within);
        let end = limit.map(|limit| actor.clock().saturating_add(cycles(limit)));
        loop {
            let now = actor.sleep(key, end, limit);
            let found = poll();
            if found.is_some() {
                thread.owed.set(self.timing().ppe.wake_cycles);
                return found;
            }
            if end.is_some_and(|end| now >= end) {
                return None;
            }
        }
    }

    /// This thread does not act before its next call, and nobody need wait for it.
    pub fn depart(&self) {
        self.this_thread(None).actor.leave();
    }
}
