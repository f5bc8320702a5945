//! The table of actors and their order.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering::SeqCst;
use std::sync::atomic::{AtomicU32, AtomicUsize};
use std::sync::{Arc, Condvar};

use portable_atomic::AtomicU64;

use super::host_threads::ThreadId;
use super::time::NEVER;
use super::timeout::Timeout;

/// A key on which actors sleep and by which they are woken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct WaitKey(u64);

impl WaitKey {
    pub(super) fn new(number: u64) -> Self {
        Self(number)
    }
}

/// The order of actors with equal clocks: SPEs by number, then PPE threads in the order of their
/// first calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Rank(u64);

const FIRST_PPE: u64 = 1 << 32;

impl Rank {
    pub fn spe(number: u64) -> Self {
        Self(number)
    }

    /// The number of the SPE, if it is one.
    pub fn spe_number(self) -> Option<u64> {
        (self.0 < FIRST_PPE).then_some(self.0)
    }

    pub fn ppe(number: u64) -> Self {
        Self(FIRST_PPE + number)
    }
}

/// The part of an actor that others can read without the lock.
#[derive(Default)]
pub(super) struct Runner {
    pub clock: AtomicU64,
    /// The clock at which it must check the other actors before it runs on.
    pub limit: AtomicU64,
    /// One more than the time of the last wait that it has run past and called; 0 if there was
    /// none.
    pub passed_wait: AtomicU64,
    pub called: Condvar,
    /// The host's thread that acts as it, or 0.
    pub thread: AtomicU32,
    /// How many of its acts are deferred.
    pub deferred: AtomicUsize,
    /// The clock of the last one that was.
    pub last_deferred: AtomicU64,
    /// The tags for whose deferred acts it waits.
    pub awaited: AtomicU32,
}

/// An act that its actor did not wait for.
pub(super) struct Deferred {
    pub tags: u32,
    /// `None` while a thread carries it out.
    pub act: Option<DeferredAct>,
}

/// What is done in a deferred act.
pub(crate) type DeferredAct = Box<dyn FnOnce() + Send>;

pub(super) enum Status {
    Outside,
    /// Runs, or has the turn. If it has a time-out, it may never act again.
    Free(Option<Timeout>),
    Waiting {
        /// When it acts, unless it is woken earlier.
        wanted: u64,
        /// When it fell asleep. It can't be woken to an earlier time.
        since: u64,
        /// The key that can wake it. `None` once it is awake.
        key: Option<WaitKey>,
    },
}

/// An actor, as the other actors see it.
pub(super) struct Entry {
    pub runner: Arc<Runner>,
    pub status: Status,
}

impl Entry {
    /// The earliest time at which it can act, if it is scheduled.
    pub fn place(&self) -> Option<u64> {
        match self.status {
            Status::Outside => None,
            Status::Free(_) => Some(self.runner.clock.load(SeqCst)),
            Status::Waiting { wanted, .. } => (wanted != NEVER).then_some(wanted),
        }
    }
}

/// All actors of a machine.
#[derive(Default)]
pub(super) struct ActorTable {
    pub actors: BTreeMap<Rank, Entry>,
    /// In the order of clock and rank. An SPU issues at most one command a cycle.
    pub deferred: BTreeMap<(u64, Rank), Deferred>,
    /// The time of the current act, or of the last one.
    pub now: u64,
    pub ppe_threads: u64,
    pub keys: u64,
    pub timeouts: u64,
}

impl ActorTable {
    pub fn leader(&self) -> Option<(u64, Rank)> {
        self.actors.iter().filter_map(|(&rank, entry)| Some((entry.place()?, rank))).min()
    }

    /// The first deferred act, if no actor can act before it.
    pub fn due(&mut self) -> Option<((u64, Rank), &mut Deferred)> {
        let leader = self.leader();
        let first = self.deferred.first_entry()?;
        let is_due = leader.is_none_or(|leader| *first.key() <= leader);
        is_due.then(|| (*first.key(), first.into_mut()))
    }

    /// Whether acts of this actor with some of these tags are deferred.
    pub fn is_deferred(&self, rank: Rank, tags: u32) -> bool {
        let mut deferred = self.deferred.iter();
        deferred.any(|((_, by), act)| *by == rank && act.tags & tags != 0)
    }

    /// Whether `me` sleeps and no other scheduled actor could wake it.
    pub fn sleeps_alone(&self, me: Rank) -> bool {
        self.actors.iter().all(|(&rank, entry)| {
            if rank == me {
                matches!(entry.status, Status::Waiting { key: Some(_), .. })
            } else {
                entry.place().is_none()
            }
        })
    }

    /// The host's threads that can't go on before `leader` does: those of waiting actors, and those
    /// that run SPUs, because the end of a run is an act.
    pub fn threads_after(&self, leader: Rank) -> Vec<ThreadId> {
        let later = |(&rank, entry): (&Rank, &Entry)| {
            let waits = matches!(entry.status, Status::Waiting { .. } | Status::Free(None));
            (rank != leader && waits).then(|| entry.runner.thread.load(SeqCst))
        };
        self.actors.iter().filter_map(later).collect()
    }

    /// The time-out of an actor, if it may never act again.
    pub fn timeout(&mut self, rank: Rank) -> Option<&mut Timeout> {
        match &mut self.actors.get_mut(&rank)?.status {
            Status::Free(timeout) => timeout.as_mut(),
            _ => None,
        }
    }

    pub fn set(&mut self, rank: Rank, status: Status) {
        if let Some(entry) = self.actors.get_mut(&rank) {
            entry.status = status;
        }
    }
}
