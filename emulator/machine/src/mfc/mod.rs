//! The memory flow controller: queues, tags, list commands, atomic commands.
//!
//! Data moves when the queue's order and the [`Policy`] allow it. This module does not model how
//! long that takes. In simulated time, an implementation of the two traits in `timing.rs` does.

pub(crate) mod command;
mod error;
pub(crate) mod interconnect;
mod line_locks;
pub(crate) mod queue;
pub(crate) mod spu_side;
pub(crate) mod timing;

pub use command::{MAX_TRANSFER, TAGS};
pub use error::DmaError;
pub use queue::{PROXY_QUEUE_DEPTH, Policy, SPU_QUEUE_DEPTH};
pub use timing::Commands;
