//! The memory flow controller: queues, tags, list commands, atomic commands.
//!
//! Data moves when the queue's order and the [`Policy`] allow it. This module does not model how
//! long that takes. In simulated time, an implementation of the two traits in `timing.rs` does.

#[cfg(feature = "machine")]
pub(crate) mod command;
mod error;
#[cfg(feature = "machine")]
pub(crate) mod interconnect;
#[cfg(feature = "machine")]
mod line_locks;
#[cfg(feature = "machine")]
pub(crate) mod queue;
#[cfg(feature = "machine")]
pub(crate) mod spu_side;
#[cfg(feature = "machine")]
pub(crate) mod timing;

#[cfg(feature = "machine")]
pub use command::{MAX_TRANSFER, TAGS};
pub use error::DmaError;
#[cfg(feature = "machine")]
pub use queue::{PROXY_QUEUE_DEPTH, Policy, SPU_QUEUE_DEPTH};
#[cfg(feature = "machine")]
pub use timing::Commands;
