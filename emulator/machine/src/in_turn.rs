//! SPEs that run one after another on the thread of their PPE, for hosts without threads, such as a
//! browser.
//!
//! [`Machine::in_turn`](crate::machine::Machine::in_turn) makes such a machine, with simulated time
//! or without. [`Spe::begin`](crate::spe::Spe::begin) starts a program and returns at once. The
//! SPEs go on while the PPE waits:
//!
//! - in simulated time within each call of the PPE, in the order of their clocks, so that they take
//!   the same cycles as on threads,
//! - without it in [`Turns::go_on`], a slice each.
//!
//! An SPU that would sleep in a channel returns from its run instead. The channel instruction has
//! had no effect, and runs again when the SPU goes on.
//!
//! Known weaknesses: an interrupt may come later than on threads, and SPUs whose local stores are
//! accessed from outside while they run do not run in the short slices that simulated time gives
//! them on threads.

use std::sync::{Arc, Mutex, Weak};

use crate::interp::Spu;
use crate::lock::lock;
use crate::spe::Spe;

/// The most instructions that an SPU runs before another one does. Small slices share work units
/// as SPUs that run at the same time would.
const SLICE: u64 = 4096;

/// The SPEs of a machine, in the order of their creation.
#[derive(Default)]
pub struct Turns(Mutex<Vec<Weak<Spe>>>);

impl Turns {
    pub(crate) fn add(&self, spe: &Arc<Spe>) {
        lock(&self.0).push(Arc::downgrade(spe));
    }

    /// The number of instructions that the SPEs have run.
    #[must_use]
    pub fn executed(&self) -> u64 {
        let spes = lock(&self.0).clone();
        spes.iter().filter_map(Weak::upgrade).map(|spe| spe.with_spu(Spu::executed)).sum()
    }

    /// Lets this SPE go on.
    pub(crate) fn resume(&self, number: u64) {
        let spe = lock(&self.0).get(number as usize).and_then(Weak::upgrade);
        if let Some(spe) = spe {
            spe.go_on(SLICE);
        }
    }

    /// Lets each SPE whose program has begun go on, until it waits, stops or has run for a slice.
    /// Returns whether any has run. In simulated time, SPEs go on within the calls of the PPE.
    pub fn go_on(&self) -> bool {
        let spes = lock(&self.0).clone();
        let spes = spes.iter().filter_map(Weak::upgrade);
        spes.fold(false, |any, spe| spe.go_on(SLICE) | any)
    }
}
