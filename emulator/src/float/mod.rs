//! The SPU's floating-point arithmetic, as pure functions on bit patterns.
//!
//! It knows nothing of registers or instructions words; the interpreter calls it, and so may any
//! test or twin of a kernel that has to agree with the SPU bit for bit. Nothing here depends on
//! the host's rounding mode or on its treatment of NaN payloads; of the host's `f32` and `f64`
//! only correctly rounded sums, exact products and exact conversions are used.

pub mod convert;
pub mod double;
pub mod estimate;
pub mod fpscr;
pub mod ordinary;
#[cfg_attr(target_arch = "x86_64", path = "sign_x86_64.rs")]
mod sign;
pub mod single;
mod softfloat;
