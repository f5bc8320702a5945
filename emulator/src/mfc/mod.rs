//! The memory flow controller: queues, tags, lists, atomic lines.
//!
//! Data moves when the queue's order and the [`Policy`] let it. How long that takes is not known
//! here: in simulated time, whoever knows it stands behind the two traits of `timing.rs`.

pub(crate) mod command;
mod error;
pub(crate) mod interconnect;
pub(crate) mod queue;
pub(crate) mod spu_side;
pub(crate) mod timing;

pub use command::{MAX_TRANSFER, TAGS};
pub use error::DmaError;
pub use queue::{PROXY_QUEUE_DEPTH, Policy, SPU_QUEUE_DEPTH};
pub use timing::Commands;
