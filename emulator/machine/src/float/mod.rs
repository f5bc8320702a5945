//! The SPU's floating-point arithmetic, as pure functions on bit patterns.
//!
//! These functions depend neither on registers nor on instruction words. The interpreter calls
//! them, and so may any test or twin of a kernel that has to agree with the SPU bit for bit.
//! Nothing here depends on the host's treatment of NaN payloads. Of its `f32` and `f64` arithmetic,
//! only correctly rounded sums and products, fused or not, and exact conversions are used.

pub mod convert;
pub mod double;
pub mod estimate;
pub mod fpscr;
mod host_double;
pub mod ordinary;
#[cfg_attr(target_arch = "x86_64", path = "sign_x86_64.rs")]
mod sign;
pub mod single;
mod softfloat;
