//! PPE threads as actors: each host thread that uses the PPE's side of an SPE.
//!
//! A thread becomes an actor with its first call and stops being one when it ends. Calls within a
//! call belong to it. They cost nothing extra and need no turn of their own.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::{Arc, Weak};
use std::time::Duration;

use super::actor_table::WaitKey;
use super::scheduler::Actor;
use super::simulation::Simulation;
use super::time::{NEVER, cycles};

/// This thread as an actor of one machine.
pub(super) struct Thread {
    machine: Weak<()>,
    actor: Actor,
    call_depth: Cell<u32>,
    /// Cycles that the last call still costs after its act.
    remaining_cycles: Cell<u64>,
}

thread_local! {
    static THREADS: RefCell<Vec<Rc<Thread>>> = const { RefCell::new(Vec::new()) };
}

/// Ends a call when it is dropped.
struct CallGuard<'a>(&'a Cell<u32>);

impl<'a> CallGuard<'a> {
    fn enter(calls: &'a Cell<u32>) -> Self {
        calls.set(calls.get() + 1);
        Self(calls)
    }
}

impl Drop for CallGuard<'_> {
    fn drop(&mut self) {
        self.0.set(self.0.get() - 1);
    }
}

impl Thread {
    pub fn actor(&self) -> &Actor {
        &self.actor
    }

    /// The clock at which the thread continues now.
    pub fn resume(&self) -> u64 {
        let clock = self.actor.rejoin() + self.remaining_cycles.take();
        self.actor.progress(clock);
        clock
    }
}

impl Simulation {
    /// This thread's actor. If the thread is new to the machine, it is scheduled from `from` on.
    pub(super) fn this_thread(&self, from: Option<u64>) -> Rc<Thread> {
        let machine = Arc::downgrade(self.alive());
        let own = |thread: &&Rc<Thread>| Weak::ptr_eq(&thread.machine, &machine);
        let new = || {
            Rc::new(Thread {
                machine: machine.clone(),
                actor: Actor::ppe(self.scheduler(), from),
                call_depth: Cell::new(0),
                remaining_cycles: Cell::new(0),
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
            // A destructor makes a call while the thread ends. It gets an actor for this call
            // alone.
            .unwrap_or_else(|_| new())
    }

    /// A call of this thread. Executes `body` in its turn.
    pub fn act<T>(&self, body: impl FnOnce() -> T) -> T {
        let thread = self.this_thread(None);
        if thread.call_depth.get() == 0 {
            thread.actor.turn(thread.resume() + self.timing().ppe.call_cycles);
        }
        let _guard = CallGuard::enter(&thread.call_depth);
        body()
    }

    /// A call that sleeps until `poll` returns a value, or until `limit` of simulated time has
    /// passed. It polls again when another actor wakes `key`. With a limit of zero it polls once.
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
        let _guard = CallGuard::enter(&thread.call_depth);
        let end = limit.map(|limit| actor.clock().saturating_add(cycles(limit)));
        loop {
            let now = actor.sleep(key, end, limit);
            let found = poll();
            if found.is_some() {
                thread.remaining_cycles.set(self.timing().ppe.wake_cycles);
                return found;
            }
            // Where SPEs run in turn, all may sleep for ever.
            if now == NEVER || end.is_some_and(|end| now >= end) {
                return None;
            }
        }
    }

    /// This thread will not act before its next call, so no other actor waits for it.
    pub fn depart(&self) {
        self.this_thread(None).actor.leave();
    }
}
