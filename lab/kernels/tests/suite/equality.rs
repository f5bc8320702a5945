//! Every described kernel equals its twin.

use std::sync::{Mutex, PoisonError};
use std::thread;

use kernels::bench::{Bench, random};
use kernels::catalogue;

#[test]
fn every_described_kernel_equals_its_twin() {
    let described = catalogue::kernels().filter_map(|kernel| kernel.equal);
    let (random, described) = (random(), Mutex::new(described));
    let next = || described.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        let mut bench = Bench::new();
        let mut calls = 0;
        while let Some(equal) = next() {
            calls +=
                equal(&mut bench, &mut random.clone()).unwrap_or_else(|error| panic!("{error}"));
        }
        calls
    };
    let calls: usize = thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().map(|worker| worker.join().expect("equal kernels")).sum()
    });
    println!("{calls} calls");
    assert!(calls > 5000, "{calls}");
}
