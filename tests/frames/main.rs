//! Whole frames on emulated SPUs: pictures, the work-unit protocol, and SPU programs that go wrong.

mod faults;
mod pictures;
mod protocol;
mod random;
mod recorder;
mod retained;
