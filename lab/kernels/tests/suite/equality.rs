//! Every kernel equals its twin.

use std::sync::{Mutex, PoisonError};
use std::thread;

use kernels::catalogue;
use kernels::prelude::*;

#[test]
fn kernels_equal_their_twins() {
    let comparisons = catalogue::kernels().map(|kernel| kernel.equal);
    let (random, comparisons) = (random(), Mutex::new(comparisons));
    let next = || comparisons.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        let mut bench = Bench::new();
        let (mut calls, mut faults) = (0, Vec::new());
        while let Some(equal) = next() {
            match equal(&mut bench, &mut random.clone()) {
                Ok(more) => calls += more,
                Err(fault) => faults.push(fault.to_string()),
            }
        }
        (calls, faults)
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let found: Vec<(usize, Vec<String>)> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().map(|worker| worker.join().expect("kernels keep the ABI")).collect()
    });
    let faults: Vec<&str> =
        found.iter().flat_map(|(_, faults)| faults).map(String::as_str).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let calls: usize = found.iter().map(|(calls, _)| calls).sum();
    println!("{calls} calls");
    assert!(calls > 5000, "{calls}");
}
