//! Disturbances by the host.

use crate::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::SeqCst};
use std::thread::JoinHandle;

/// Delays of the host that differ in every run.
pub struct Disturbance(AtomicU64);

impl Disturbance {
    pub fn new(seed: u64) -> Self {
        Self(AtomicU64::new(seed))
    }

    /// A delay of up to some milliseconds.
    pub fn delay(&self) -> Duration {
        let mixed = self.0.fetch_add(0x9e37_79b9_7f4a_7c15, SeqCst);
        let mixed = (mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        Duration::from_micros((mixed >> 32) % 4000)
    }

    pub fn sleep(&self) {
        thread::sleep(self.delay());
    }
}

/// Threads that compete for the host's processors.
pub struct Load {
    over: Arc<AtomicBool>,
    threads: Vec<JoinHandle<()>>,
}

impl Load {
    pub fn new(threads: usize) -> Self {
        let over = Arc::new(AtomicBool::new(false));
        let spin = || {
            let over = Arc::clone(&over);
            thread::spawn(move || while !over.load(SeqCst) {})
        };
        let threads = (0..threads).map(|_| spin()).collect();
        Self { over, threads }
    }
}

impl Drop for Load {
    fn drop(&mut self) {
        self.over.store(true, SeqCst);
        for thread in self.threads.drain(..) {
            thread.join().unwrap();
        }
    }
}
