//! Whole frames on emulated SPUs: pictures, the work-unit protocol, SPU programs that go wrong,
//! and shaders of games.

mod faults;
mod pictures;
mod protocol;
mod random;
mod recorder;
mod retained;
mod shaders;
