//! Whitted's model on emulated SPUs, against the f64 reference.

#[path = "../frames/recorder.rs"]
mod recorder;

mod random;
mod tolerance;
