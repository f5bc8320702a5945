//! Ends a program that sleeps in a channel for longer than the allowed time.

use std::io;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::sync::{Arc, Weak};
use std::thread;
use std::time::{Duration, Instant};

use spu_emulator::spe::Spe;

use crate::failure::Failure;

/// What fails if the system has no more threads.
pub const THREAD: &str = "can't start the thread that watches the program";

/// The SPU is not in a channel.
const AWAKE: u64 = u64::MAX;
const LOOK_EVERY: Duration = Duration::from_millis(100);

/// A thread that checks the SPU now and then. Dropping this value ends the thread.
pub struct Watchdog {
    /// Milliseconds from `started` to the start of the channel instruction that is running, if one
    /// is.
    since: Arc<AtomicU64>,
    started: Instant,
    in_channel: bool,
    _alive: Sender<()>,
}

impl Watchdog {
    pub fn start(spe: &Arc<Spe>, patience: Duration) -> Result<Self, Failure> {
        let since = Arc::new(AtomicU64::new(AWAKE));
        let started = Instant::now();
        let (alive, ended) = mpsc::channel::<()>();
        let watched = Arc::clone(&since);
        let spe: Weak<Spe> = Arc::downgrade(spe);
        let watch = move || {
            while ended.recv_timeout(LOOK_EVERY) == Err(RecvTimeoutError::Timeout) {
                let since = watched.load(Relaxed);
                let slept = millis(started).saturating_sub(since);
                if since != AWAKE && u128::from(slept) >= patience.as_millis() {
                    if let Some(spe) = spe.upgrade() {
                        spe.request_stop();
                    }
                    break;
                }
            }
        };
        let spawned: io::Result<_> = thread::Builder::new().spawn(watch);
        spawned.map_err(Failure::of(THREAD))?;
        Ok(Self { since, started, in_channel: false, _alive: alive })
    }

    #[inline]
    pub fn awake(&mut self) {
        if self.in_channel {
            self.in_channel = false;
            self.since.store(AWAKE, Relaxed);
        }
    }

    pub fn perhaps_asleep(&mut self) {
        self.in_channel = true;
        self.since.store(millis(self.started), Relaxed);
    }
}

fn millis(since: Instant) -> u64 {
    u64::try_from(since.elapsed().as_millis()).unwrap_or(AWAKE - 1)
}
