//! The actors of a race and their order.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering::SeqCst};
use std::sync::{Arc, Condvar};

use super::absence::Patience;
use super::time::NEVER;

/// What a sleeper can be woken by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct WaitKey(u64);

impl WaitKey {
    pub(super) fn new(number: u64) -> Self {
        Self(number)
    }
}

/// Decides between equal clocks: SPEs by number, then PPE threads in the order of their first
/// calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Rank(u64);

const FIRST_PPE: u64 = 1 << 32;

impl Rank {
    pub fn spe(number: u64) -> Self {
        Self(number)
    }

    pub fn ppe(number: u64) -> Self {
        Self(FIRST_PPE + number)
    }
}

/// What an actor shows without a lock.
#[derive(Default)]
pub(super) struct Runner {
    pub clock: AtomicU64,
    /// The clock from which on it may run no further without a look at the others.
    pub limit: AtomicU64,
    pub called: Condvar,
}

/// Where an actor is.
pub(super) enum Status {
    Outside,
    /// Runs, or has the turn. With patience: may never come back.
    Free(Option<Patience>),
    Waiting {
        /// When it acts, unless it is woken before.
        wanted: u64,
        /// Since when it sleeps; it can't be woken to an earlier time.
        since: u64,
        /// What may wake it; nothing may once it is awake.
        key: Option<WaitKey>,
    },
}

/// An actor, as the others see it.
pub(super) struct Entry {
    pub runner: Arc<Runner>,
    pub status: Status,
}

impl Entry {
    /// Its place in the race, if it is in it.
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
pub(super) struct Race {
    pub actors: BTreeMap<Rank, Entry>,
    /// When the act that goes on, or was last, happens.
    pub now: u64,
    pub ppe_threads: u64,
    pub keys: u64,
    pub absences: u64,
}

impl Race {
    pub fn leader(&self) -> Option<(u64, Rank)> {
        self.actors
            .iter()
            .filter_map(|(&rank, entry)| Some((entry.place()?, rank)))
            .min()
    }

    /// Whether `me` sleeps, and nobody else is in the race who could wake it.
    pub fn sleeps_alone(&self, me: Rank) -> bool {
        self.actors.iter().all(|(&rank, entry)| {
            if rank == me {
                matches!(entry.status, Status::Waiting { key: Some(_), .. })
            } else {
                entry.place().is_none()
            }
        })
    }

    pub fn set(&mut self, rank: Rank, status: Status) {
        if let Some(entry) = self.actors.get_mut(&rank) {
            entry.status = status;
        }
    }
}
